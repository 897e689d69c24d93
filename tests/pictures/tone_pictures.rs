//! Gray pictures from formulas: values of linear light 0..1 on the unit square, as 8-bit sRGB.

use image::GrayImage;

/// Width and height, px.
pub const SIDE: u32 = 256;

/// The picture of `light` at points of the unit square.
pub fn picture(size: [u32; 2], light: impl Fn(f64, f64) -> f64) -> GrayImage {
    GrayImage::from_fn(size[0], size[1], |x, y| image::Luma([px(size, [x, y], &light)]))
}

/// One px of that picture.
pub fn px([width, height]: [u32; 2], [x, y]: [u32; 2], light: impl Fn(f64, f64) -> f64) -> u8 {
    let [u, v] = [(f64::from(x) + 0.5) / f64::from(width), (f64::from(y) + 0.5) / f64::from(height)];
    let light = light(u, v).clamp(0.0, 1.0);
    let coded = if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 };
    (255.0 * coded).round() as u8
}

/// 1 inside, 0 outside, with a soft transition of width 2 · `soft`.
fn inside(distance: f64, soft: f64) -> f64 {
    let t = (0.5 - 0.5 * distance / soft).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

fn mix(a: f64, b: f64, share: f64) -> f64 {
    a + share * (b - a)
}

/// The approximate distance from an ellipse, negative inside.
fn ellipse(u: f64, v: f64, [x, y]: [f64; 2], [a, b]: [f64; 2]) -> f64 {
    let [p, q] = [(u - x) / a, (v - y) / b];
    (p.hypot(q) - 1.0) * a.min(b)
}

/// A ball in a light from the upper left, and its shadow on a wall.
pub fn sphere(u: f64, v: f64) -> f64 {
    let wall = mix(0.75, 0.45, v) * (1.0 - 0.6 * inside(ellipse(u, v, [0.6, 0.62], [0.3, 0.28]), 0.12));
    let [x, y] = [(u - 0.46) / 0.3, (v - 0.46) / 0.3];
    let z = (1.0 - x * x - y * y).max(0.0).sqrt();
    let lit = 0.05 + 0.85 * (-0.5 * x - 0.55 * y + 0.67 * z).max(0.0);
    mix(wall, lit, inside(x.hypot(y) - 1.0, 0.02))
}

/// A sinking sun: a vertical ramp with a disc.
pub fn ramp(u: f64, v: f64) -> f64 {
    mix(mix(0.05, 0.8, v * v), 0.95, inside(ellipse(u, v, [0.65, 0.6], [0.16, 0.16]), 0.02))
}

/// Rings around a place.
pub fn rings(u: f64, v: f64) -> f64 {
    0.45 + 0.35 * (16.0 * std::f64::consts::PI * (u - 0.45).hypot(v - 0.55) * 0.5).cos()
}

/// A large letter A on a bright ground.
pub fn letter(u: f64, v: f64) -> f64 {
    let leg = |lean: f64| ((u - 0.5) - lean * (v - 0.12) * 0.42).abs() - 0.065;
    let bar = ((v - 0.62).abs() - 0.05).max((u - 0.5).abs() - 0.22);
    let letter = leg(1.0).min(leg(-1.0)).min(bar).max((v - 0.5).abs() - 0.38);
    mix(mix(0.8, 0.5, u), 0.06, inside(letter, 0.012))
}

/// Clouds: sums of waves of many directions.
pub fn clouds(u: f64, v: f64) -> f64 {
    let wave = |k: i32| {
        let (s, c) = (2.4 * f64::from(k)).sin_cos();
        let often = 3.0 * 1.28f64.powi(k);
        (often * (u * c + v * s) * 2.0 + f64::from(k * k)).sin() * 0.8f64.powi(k)
    };
    0.42 + 0.17 * (0..9).map(wave).sum::<f64>()
}

/// An eye under a brow.
pub fn eye(u: f64, v: f64) -> f64 {
    let skin = 0.62 - 0.3 * ((u - 0.35).powi(2) + (v - 0.75).powi(2));
    let brow = inside(ellipse(u, v + 0.5 * (u - 0.5).powi(2), [0.5, 0.2], [0.36, 0.05]), 0.03);
    let lids =
        inside(ellipse(u, v, [0.5, 0.70], [0.44, 0.36]).max(ellipse(u, v, [0.5, 0.36], [0.44, 0.36])), 0.012);
    let away = (u - 0.5).hypot(v - 0.53);
    let iris = mix(0.3, 0.12, (away / 0.14).min(1.0));
    let ball = mix(0.85, iris, inside(away - 0.14, 0.008));
    let ball = mix(ball, 0.01, inside(away - 0.06, 0.006));
    let ball = mix(ball, 1.0, inside(ellipse(u, v, [0.46, 0.49], [0.02, 0.02]), 0.008));
    mix(mix(skin, 0.08, brow), ball * (0.6 + 0.4 * (v - 0.3).clamp(0.0, 0.4) / 0.4), lids)
}

/// A face of ellipses in a soft light.
pub fn face(u: f64, v: f64) -> f64 {
    let ground = mix(0.35, 0.6, u);
    let head = ellipse(u, v, [0.5, 0.5], [0.27, 0.36]);
    let light = (0.75 - 0.9 * (u - 0.4).powi(2) * 6.0 - 0.3 * (v - 0.4).powi(2)).max(0.08);
    let hair = ellipse(u, v, [0.5, 0.42], [0.31, 0.36]).max(-ellipse(u, v, [0.5, 0.58], [0.25, 0.32]));
    let mut face = mix(ground, light, inside(head, 0.02));
    for side in [-0.11, 0.11] {
        let at = [0.5 + side, 0.46];
        face = mix(face, 0.85, inside(ellipse(u, v, at, [0.055, 0.028]), 0.006));
        face = mix(face, 0.03, inside(ellipse(u, v, at, [0.024, 0.026]), 0.006));
        face = mix(face, 0.1, inside(ellipse(u, v, [at[0], 0.40], [0.07, 0.014]), 0.01));
    }
    face = mix(face, 0.4 * light, inside(ellipse(u, v, [0.53, 0.57], [0.02, 0.08]), 0.03));
    face = mix(face, 0.14, inside(ellipse(u, v, [0.5, 0.70], [0.09, 0.022]), 0.012));
    mix(face, 0.06, inside(hair, 0.015))
}

/// A ground under a square lamp, in the shadows of four balls, seen from above.
pub fn illumination(u: f64, v: f64) -> f64 {
    // Place, radius, height.
    const BALLS: [([f64; 2], f64, f64); 4] = [
        ([0.36, 0.34], 0.14, 0.15),
        ([0.64, 0.58], 0.10, 0.11),
        ([0.28, 0.70], 0.07, 0.08),
        ([0.74, 0.26], 0.05, 0.30),
    ];
    let reaching = |k: i32| {
        let part = |k: i32| 0.22 * (f64::from(k) + 0.5) / 8.0;
        let to = [0.15 + part(k / 8) - u, 0.05 + part(k % 8) - v, 0.9];
        let far = to.iter().map(|part| part * part).sum::<f64>();
        let hides = |([x, y], radius, height): ([f64; 2], f64, f64)| {
            let ball = [x - u, y - v, height];
            let share = (0..3).map(|axis| ball[axis] * to[axis]).sum::<f64>() / far;
            let off = (0..3).map(|axis| (ball[axis] - share * to[axis]).powi(2)).sum::<f64>();
            share > 0.0 && off < radius * radius
        };
        if BALLS.into_iter().any(hides) { 0.0 } else { 0.567 / (far * far) }
    };
    let open = |([x, y], radius, height): ([f64; 2], f64, f64)| {
        let far = (x - u).powi(2) + (y - v).powi(2) + height * height;
        1.0 - 0.9 * radius * radius * height / far.powf(1.5)
    };
    let lamp = (0..64).map(reaching).sum::<f64>() / 64.0;
    0.75 * lamp + 0.22 * BALLS.into_iter().map(open).product::<f64>()
}

/// A picture by its name.
pub type Named = (&'static str, fn(f64, f64) -> f64);

/// All pictures.
pub const ALL: [Named; 7] = [
    ("sphere", sphere),
    ("ramp", ramp),
    ("rings", rings),
    ("letter", letter),
    ("clouds", clouds),
    ("eye", eye),
    ("face", face),
];
