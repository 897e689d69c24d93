//! A lit view of a material on a body: what its maps look like on a plane, a sphere or a cylinder.
//!
//! Each px casts rays to the body; where one hits, the maps are read at the surface's coordinates, and a directional light and a
//! sky are reflected: Lambert's law, and Cook and Torrance's with the distribution of Trowbridge and Reitz (GGX).
//!
//! R. Cook, K. Torrance, "A Reflectance Model for Computer Graphics", SIGGRAPH 1981. B. Walter et al., "Microfacet Models for
//! Refraction through Rough Surfaces", EGSR 2007.

use rayon::prelude::*;

/// A body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Body {
    /// A square piece of a plane, one repetition of the maps.
    #[default]
    Plane,
    /// A sphere.
    Sphere,
    /// A cylinder that stands upright, without its ends.
    Cylinder,
}

impl Body {
    /// All bodies and their names.
    pub const ALL: [(Self, &'static str); 3] =
        [(Self::Plane, "Plane"), (Self::Sphere, "Sphere"), (Self::Cylinder, "Cylinder")];
}

/// How a body is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Degrees about the vertical, to the right.
    pub yaw: f32,
    /// Degrees about the horizontal, −90..90; positive: seen from above.
    pub pitch: f32,
}

impl Default for Pose {
    fn default() -> Self {
        Self { yaw: -25.0, pitch: 20.0 }
    }
}

impl Pose {
    /// Turned by a drag over so many points.
    #[must_use]
    pub fn turned(self, [x, y]: [f32; 2]) -> Self {
        /// Degrees a point.
        const SPEED: f32 = 0.5;
        let yaw = (self.yaw + SPEED * x + 180.0).rem_euclid(360.0) - 180.0;
        Self { yaw, pitch: (self.pitch + SPEED * y).clamp(-85.0, 85.0) }
    }
}

/// A px of the maps. Numbers 0..1, colours linear.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Texel {
    colour: [f32; 3],
    opacity: f32,
    /// x to the right, y up, z out of the surface; not normalised between px.
    normal: [f32; 3],
    roughness: f32,
    /// The share of the sky that is seen.
    open: f32,
}

/// The maps of a material, ready to be lit.
#[derive(Clone, Debug)]
pub struct Maps {
    size: [usize; 2],
    texels: Vec<Texel>,
    /// Whether its border continues on the other side; otherwise the body shows it mirrored, without seams.
    wraps: bool,
}

/// The pictures of a material, 8 bits a channel, `size` px each: colour with opacity, the normal map (green up), roughness,
/// occlusion.
pub struct Pictures<'a> {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Red, green, blue, opacity.
    pub colour: &'a dyn Fn(usize) -> [u8; 4],
    /// x, y, z as red, green, blue.
    pub normal: &'a dyn Fn(usize) -> [u8; 3],
    /// 0 = a mirror, 255 = chalk.
    pub roughness: &'a dyn Fn(usize) -> u8,
    /// 255 = open to the sky.
    pub occlusion: &'a dyn Fn(usize) -> u8,
}

/// The longest side of the maps that are kept, px: about what a view can show.
const LONGEST: usize = 640;
/// The direction towards the light: from above, on the left, in front.
const LIGHT: [f32; 3] = [-0.48, 0.62, 0.62];
/// Strength of the light, of the sky, and of what the ground throws back.
const STRENGTH: [f32; 3] = [2.6, 0.55, 0.25];
/// The reflectance of insulators at normal incidence.
const F0: f32 = 0.04;
/// Half the height of the view, in radii of the sphere.
const REACH: f32 = 1.18;
/// Half the height and the radius of the cylinder.
const CYLINDER: [f32; 2] = [1.0, 0.62];

impl Maps {
    /// The maps of `pictures`; larger ones are reduced by the mean of their px.
    #[must_use]
    pub fn new(pictures: &Pictures, wraps: bool) -> Self {
        let [width, height] = pictures.size;
        let step = width.max(height).div_ceil(LONGEST).max(1);
        let size = [(width / step).max(1), (height / step).max(1)];
        let linear = linear_table();
        let texel = |at: usize| {
            let (x, y) = (at % size[0] * step, at / size[0] * step);
            let mut sum = [0.0f32; 9];
            let mut count = 0.0;
            for row in y..(y + step).min(height) {
                for column in x..(x + step).min(width) {
                    let px = row * width + column;
                    let [red, green, blue, opacity] = (pictures.colour)(px);
                    let normal = (pictures.normal)(px).map(|part| f32::from(part) / 127.5 - 1.0);
                    let colour = [red, green, blue].map(|channel| linear[usize::from(channel)]);
                    let [roughness, open] = [(pictures.roughness)(px), (pictures.occlusion)(px)];
                    let [opacity, roughness, open] =
                        [opacity, roughness, open].map(|part| f32::from(part) / 255.0);
                    let all = colour.into_iter().chain(normal).chain([opacity, roughness, open]);
                    sum.iter_mut().zip(all).for_each(|(sum, part)| *sum += part);
                    count += 1.0;
                }
            }
            let [r, g, b, x, y, z, opacity, roughness, open] = sum.map(|part| part / f32::max(count, 1.0));
            Texel { colour: [r, g, b], opacity, normal: [x, y, z], roughness, open }
        };
        Self { size, texels: (0..size[0] * size[1]).map(texel).collect(), wraps }
    }

    /// The maps at surface coordinates, one repetition each from 0 to 1, between four px.
    fn at(&self, [u, v]: [f32; 2]) -> Texel {
        let place = |share: f32, side: usize| {
            let whole = if self.wraps {
                share.rem_euclid(1.0)
            } else {
                // There and back.
                let twice = share.rem_euclid(2.0);
                if twice > 1.0 { 2.0 - twice } else { twice }
            };
            let at = whole * side as f32 - 0.5;
            let low = at.floor();
            let index = |offset: isize| {
                let index = low as isize + offset;
                let side = side as isize;
                (if self.wraps { index.rem_euclid(side) } else { index.clamp(0, side - 1) }) as usize
            };
            ([index(0), index(1)], at - low)
        };
        let ((columns, x), (rows, y)) = (place(u, self.size[0]), place(v, self.size[1]));
        let texel = |column: usize, row: usize| &self.texels[rows[row] * self.size[0] + columns[column]];
        let mix = |of: &dyn Fn(&Texel) -> f32| {
            let row = |row: usize| (1.0 - x) * of(texel(0, row)) + x * of(texel(1, row));
            (1.0 - y) * row(0) + y * row(1)
        };
        Texel {
            colour: [0, 1, 2].map(|channel| mix(&|texel| texel.colour[channel])),
            opacity: mix(&|texel| texel.opacity),
            normal: [0, 1, 2].map(|part| mix(&|texel| texel.normal[part])),
            roughness: mix(&|texel| texel.roughness),
            open: mix(&|texel| texel.open),
        }
    }

    /// Repetitions around a body and up it that keep the maps' proportions; around it a whole number, so that a seamless
    /// material has no seam there.
    fn repeats(&self, around: f32, up: f32) -> [f32; 2] {
        let aspect = self.size[0] as f32 / self.size[1] as f32;
        let rows = if around / up > 2.0 { 1.0 } else { 1.0f32.max((up / around).round()) };
        let columns = (around / up * rows / aspect).round().max(1.0);
        // Mirrored maps meet themselves after two repetitions.
        let columns = if self.wraps { columns } else { 2.0 * (0.5 * columns).round().max(1.0) };
        [columns, rows]
    }
}

/// A point of a body: surface coordinates, and the directions to the right and up along the surface and out of it.
struct Hit {
    uv: [f32; 2],
    frame: [[f32; 3]; 3],
}

/// The body seen in a square of `side` px: red, green, blue, opacity a px, sRGB, row by row. Each px is the mean of `samples` ×
/// `samples` rays.
#[must_use]
pub fn render(maps: &Maps, body: Body, pose: Pose, side: usize, samples: usize) -> Vec<u8> {
    let turn = Turn::new(pose);
    let mut pixels = vec![0; 4 * side * side];
    let samples = samples.max(1);
    pixels.par_chunks_mut((4 * side).max(1)).enumerate().for_each(|(row, line)| {
        for (column, px) in line.chunks_exact_mut(4).enumerate() {
            let mut sum = [0.0f32; 4];
            for sample in 0..samples * samples {
                let within = |index: usize| (index as f32 + 0.5) / samples as f32;
                let x = (column as f32 + within(sample % samples)) / side as f32 * 2.0 - 1.0;
                let y = 1.0 - (row as f32 + within(sample / samples)) / side as f32 * 2.0;
                let Some(hit) = cast(maps, body, &turn, [REACH * x, REACH * y]) else { continue };
                let texel = maps.at(hit.uv);
                let light = shade(&texel, &hit.frame);
                for (sum, part) in sum.iter_mut().zip(light) {
                    *sum += part * texel.opacity;
                }
                sum[3] += texel.opacity;
            }
            let opacity = sum[3] / (samples * samples) as f32;
            for (out, part) in px.iter_mut().zip(&sum[..3]) {
                *out = to_srgb(part / sum[3].max(1e-6));
            }
            px[3] = (255.0 * opacity).round() as u8;
        }
    });
    pixels
}

/// The rotation of a body.
struct Turn {
    yaw: [f32; 2],
    pitch: [f32; 2],
}

impl Turn {
    fn new(pose: Pose) -> Self {
        let of = |degrees: f32| {
            let (sin, cos) = libm::sincosf(degrees.to_radians());
            [sin, cos]
        };
        Self { yaw: of(pose.yaw), pitch: of(pose.pitch) }
    }

    /// From the body to the view.
    fn out(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let ([sin, cos], [down, level]) = (self.yaw, self.pitch);
        let [x, z] = [cos * x + sin * z, cos * z - sin * x];
        [x, level * y - down * z, level * z + down * y]
    }

    /// From the view to the body.
    fn back(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let ([sin, cos], [down, level]) = (self.yaw, self.pitch);
        let [y, z] = [level * y + down * z, level * z - down * y];
        [cos * x - sin * z, y, cos * z + sin * x]
    }
}

/// What the ray at a point of the view, which runs straight away from the viewer, meets first.
fn cast(maps: &Maps, body: Body, turn: &Turn, [x, y]: [f32; 2]) -> Option<Hit> {
    use std::f32::consts::{PI, TAU};
    let [from, along] = [turn.back([x, y, 4.0]), turn.back([0.0, 0.0, -1.0])];
    let at = |t: f32| [0, 1, 2].map(|axis| from[axis] + t * along[axis]);
    let (uv, right, normal) = match body {
        Body::Plane => {
            // Seen from behind it is the same.
            let t = -from[2] / along[2];
            let point = at(t);
            let aspect = maps.size[0] as f32 / maps.size[1] as f32;
            let half = if aspect > 1.0 { [1.0, 1.0 / aspect] } else { [aspect, 1.0] };
            if !t.is_finite() || point[0].abs() > half[0] || point[1].abs() > half[1] {
                return None;
            }
            let uv = [0.5 + 0.5 * point[0] / half[0], 0.5 - 0.5 * point[1] / half[1]];
            let front = if along[2] < 0.0 { 1.0 } else { -1.0 };
            (uv, [1.0, 0.0, 0.0], [0.0, 0.0, front])
        }
        Body::Sphere => {
            let b = dot(from, along);
            let root = b * b - (dot(from, from) - 1.0);
            let point = at(-b - (root >= 0.0).then(|| root.sqrt())?);
            let around = libm::atan2f(point[0], point[2]);
            let [columns, rows] = maps.repeats(2.0, 1.0);
            let up = libm::asinf(point[1].clamp(-1.0, 1.0)) / PI + 0.5;
            let right = normalised([point[2], 0.0, -point[0]]);
            ([columns * (0.5 + around / TAU), rows * (1.0 - up)], right, point)
        }
        Body::Cylinder => {
            let [half, radius] = CYLINDER;
            let a = along[0] * along[0] + along[2] * along[2];
            let b = from[0] * along[0] + from[2] * along[2];
            let root = b * b - a * (from[0] * from[0] + from[2] * from[2] - radius * radius);
            let root = (root >= 0.0 && a > 1e-9).then(|| root.sqrt())?;
            // The outside, else the inside through the open end.
            let hit = |sign: f32| Some(at((-b + sign * root) / a)).filter(|point| point[1].abs() <= half);
            let (point, out) = hit(-1.0).map(|point| (point, 1.0)).or_else(|| Some((hit(1.0)?, -1.0)))?;
            let around = libm::atan2f(point[0], point[2]);
            let [columns, rows] = maps.repeats(TAU * radius, 2.0 * half);
            let uv = [columns * (0.5 + around / TAU), rows * (0.5 - 0.5 * point[1] / half)];
            let normal = [out * point[0] / radius, 0.0, out * point[2] / radius];
            (uv, normalised([point[2], 0.0, -point[0]]), normal)
        }
    };
    let frame = [right, cross(normal, right), normal].map(|axis| turn.out(axis));
    Some(Hit { uv, frame })
}

/// The light that a point throws back to the viewer, linear.
fn shade(texel: &Texel, [right, up, out]: &[[f32; 3]; 3]) -> [f32; 3] {
    let [x, y, z] = texel.normal;
    let normal = normalised([0, 1, 2].map(|axis| x * right[axis] + y * up[axis] + z.max(0.05) * out[axis]));
    let light = normalised(LIGHT);
    let view = [0.0, 0.0, 1.0];
    let [key, sky, ground] = STRENGTH;
    let facing = dot(normal, light).max(0.0);
    // A point whose surface turns away from the light is in the body's own shadow.
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

/// The share of the light that is reflected as by a rough mirror.
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

fn dot(a: [f32; 3], b: [f32; 3]) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f32; 3], b: [f32; 3]) -> [f32; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn normalised(a: [f32; 3]) -> [f32; 3] {
    let length = dot(a, a).sqrt().max(1e-9);
    a.map(|part| part / length)
}

/// 8-bit sRGB → linear light.
fn linear_table() -> Vec<f32> {
    let linear = |channel: f32| {
        if channel <= 0.04045 { channel / 12.92 } else { libm::powf((channel + 0.055) / 1.055, 2.4) }
    };
    (0..=255u8).map(|channel| linear(f32::from(channel) / 255.0)).collect()
}

/// Linear light → 8-bit sRGB; bright light is rolled off instead of clipped.
fn to_srgb(light: f32) -> u8 {
    /// From here on light is compressed.
    const KNEE: f32 = 0.8;
    let over = (light - KNEE).max(0.0);
    let light = light.min(KNEE) + (1.0 - KNEE) * (over / (over + 1.0 - KNEE));
    let shown =
        if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * libm::powf(light, 1.0 / 2.4) - 0.055 };
    (255.0 * shown.clamp(0.0, 1.0)).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIDE: usize = 64;

    /// A flat material of one colour; the left half is red where `halves`.
    fn flat(roughness: u8, halves: bool) -> Maps {
        let colour = move |px: usize| {
            if halves && px % 16 < 8 { [200, 0, 0, 255] } else { [120, 120, 120, 255] }
        };
        let pictures = Pictures {
            size: [16, 16],
            colour: &colour,
            normal: &|_| [128, 128, 255],
            roughness: &move |_| roughness,
            occlusion: &|_| 255,
        };
        Maps::new(&pictures, true)
    }

    fn px(pixels: &[u8], x: usize, y: usize) -> [i32; 4] {
        let at = 4 * (y * SIDE + x);
        [0, 1, 2, 3].map(|channel| i32::from(pixels[at + channel]))
    }

    const AHEAD: Pose = Pose { yaw: 0.0, pitch: 0.0 };

    #[test]
    fn a_sphere_is_round_lit_from_the_upper_left_and_dark_on_the_other_side() {
        let seen = render(&flat(255, false), Body::Sphere, AHEAD, SIDE, 2);
        assert_eq!(px(&seen, 1, 1)[3], 0, "beside it there is nothing");
        assert_eq!(px(&seen, 32, 32)[3], 255);
        let [bright, dark] = [px(&seen, 22, 20)[0], px(&seen, 46, 48)[0]];
        assert!(bright > dark + 40, "{bright} {dark}");
    }

    #[test]
    fn the_left_of_the_maps_is_on_the_left_and_turns_with_the_body() {
        let maps = flat(255, true);
        for body in [Body::Plane, Body::Cylinder] {
            let seen = render(&maps, body, AHEAD, SIDE, 1);
            let is_red = |x: usize| px(&seen, x, 32)[0] > 2 * px(&seen, x, 32)[1];
            assert!(is_red(27) != is_red(37), "{body:?}");
        }
        let seen = render(&maps, Body::Plane, AHEAD, SIDE, 1);
        assert!(px(&seen, 20, 32)[0] > 2 * px(&seen, 20, 32)[1]);
        // Turned by 180°, what was on the left is on the right.
        let behind = render(&maps, Body::Plane, Pose { yaw: 180.0, pitch: 0.0 }, SIDE, 1);
        assert!(px(&behind, 44, 32)[0] > 2 * px(&behind, 44, 32)[1]);
        let edge_on = render(&maps, Body::Plane, Pose { yaw: 90.0, pitch: 0.0 }, SIDE, 1);
        assert!(edge_on.chunks(4).filter(|px| px[3] > 0).count() < 3 * SIDE, "a plane seen edge-on is thin");
    }

    #[test]
    fn a_smooth_sphere_has_a_highlight_and_a_rough_one_none() {
        let brightest = |roughness: u8| {
            let seen = render(&flat(roughness, false), Body::Sphere, AHEAD, SIDE, 2);
            seen.chunks(4).map(|px| i32::from(px[1])).max().unwrap_or(0)
        };
        assert!(brightest(50) > brightest(255) + 20, "{} {}", brightest(50), brightest(255));
    }

    #[test]
    fn a_slope_towards_the_light_is_brighter_than_one_away_from_it() {
        let slope = |x: u8| {
            let normal = move |_| [x, 128, 220];
            let pictures = Pictures {
                size: [4, 4],
                colour: &|_| [120, 120, 120, 255],
                normal: &normal,
                roughness: &|_| 255,
                occlusion: &|_| 255,
            };
            px(&render(&Maps::new(&pictures, true), Body::Plane, AHEAD, SIDE, 1), 32, 32)[0]
        };
        assert!(slope(60) > slope(196) + 20, "{} {}", slope(60), slope(196));
    }

    #[test]
    fn turning_there_and_back_is_the_identity_and_a_drag_stays_within_limits() {
        let turn = Turn::new(Pose { yaw: 33.0, pitch: -21.0 });
        let back = turn.back(turn.out([0.3, -0.5, 0.8]));
        assert!(back.iter().zip([0.3, -0.5, 0.8]).all(|(a, b)| (a - b).abs() < 1e-6), "{back:?}");
        let far = AHEAD.turned([1000.0, -1000.0]);
        assert!((-180.0..180.0).contains(&far.yaw) && far.pitch == -85.0, "{far:?}");
    }
}
