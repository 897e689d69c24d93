//! The light that a surface reflects.

use super::maps::Texel;
use super::vector::{dot, normalised};

/// The direction towards the light: from above, on the left, in front.
const LIGHT: [f32; 3] = [-0.48, 0.62, 0.62];
/// Strength of the light, of the sky, and of the light that the ground reflects.
const STRENGTH: [f32; 3] = [2.6, 0.55, 0.25];
/// The reflectance of insulators at normal incidence.
const F0: f32 = 0.04;

/// The light that a point reflects to the viewer, linear.
pub(super) fn shade(texel: &Texel, [right, up, out]: &[[f32; 3]; 3]) -> [f32; 3] {
    let [x, y, z] = texel.normal;
    let normal = normalised([0, 1, 2].map(|axis| x * right[axis] + y * up[axis] + z.max(0.05) * out[axis]));
    let light = normalised(LIGHT);
    let view = [0.0, 0.0, 1.0];
    let [key, sky, ground] = STRENGTH;
    let facing = dot(normal, light).max(0.0);
    // A point whose surface faces away from the light is in the body's own shadow.
    let lit = (8.0 * dot(*out, light)).clamp(0.0, 1.0);
    let share = 0.5 + 0.5 * normal[1];
    let around = (ground + (sky - ground) * share) * texel.open;
    let half = normalised([0, 1, 2].map(|axis| light[axis] + view[axis]));
    let seen = dot(normal, view).max(1e-3);
    let [across, along] = [dot(view, half), dot(normal, half)].map(|cos| cos.max(0.0));
    let gloss = specular(texel.roughness, facing, seen, along, across);
    let edge = F0 + (1.0 - texel.roughness) * (1.0 - F0) * libm::powf(1.0 - seen, 5.0);
    let direct = key * facing * lit;
    texel.colour.map(|colour| {
        let diffuse = colour * (direct / std::f32::consts::PI * 1.6 + around);
        diffuse + direct * gloss + around * edge * 0.6
    })
}

/// The share of the light that is reflected specularly, as by a rough mirror.
fn specular(roughness: f32, facing: f32, seen: f32, half: f32, across: f32) -> f32 {
    if facing <= 0.0 {
        return 0.0;
    }
    let alpha = (roughness * roughness).max(0.02);
    let squared = alpha * alpha;
    let base = half * half * (squared - 1.0) + 1.0;
    let distribution = squared / (std::f32::consts::PI * base * base);
    let k = 0.5 * alpha;
    let hidden = |cos: f32| cos / (cos * (1.0 - k) + k);
    let fresnel = F0 + (1.0 - F0) * libm::powf(1.0 - across, 5.0);
    distribution * hidden(facing) * hidden(seen) * fresnel / (4.0 * facing * seen)
}

/// Linear light → 8-bit sRGB; bright light is compressed instead of clipped.
pub(super) fn to_srgb(light: f32) -> u8 {
    /// Light above this value is compressed.
    const KNEE: f32 = 0.8;
    let over = (light - KNEE).max(0.0);
    let light = light.min(KNEE) + (1.0 - KNEE) * (over / (over + 1.0 - KNEE));
    let shown =
        if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * libm::powf(light, 1.0 / 2.4) - 0.055 };
    (255.0 * shown.clamp(0.0, 1.0)).round() as u8
}
