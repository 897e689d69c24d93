//! Pictures that show neither spots nor stripes: noise, gradients, chessboards, text, faces, things. All are drawn
//! here.

use image::{Rgb, RgbImage};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::photos::degrade::{fractal, normal};

/// Width and height, px.
const SIDE: usize = 320;

/// A function from a place in 0..1 × 0..1 to a tone 0..1.
type Tone<'a> = &'a dyn Fn(f64, f64) -> f64;

/// All pictures, with their names.
pub fn others() -> Vec<(String, RgbImage)> {
    let mut all = Vec::new();
    all.extend(noises());
    all.extend(gradients());
    all.extend(boards());
    all.extend(texts());
    all.extend(faces());
    all.extend(things());
    all
}

/// A picture whose tones lie between two colours.
fn drawn(tone: Tone) -> RgbImage {
    let (dark, light) = ([52.0, 40.0, 35.0], [236.0, 224.0, 206.0]);
    RgbImage::from_fn(SIDE as u32, SIDE as u32, |x, y| {
        let place = |px: u32| (f64::from(px) + 0.5) / SIDE as f64;
        let tone = tone(place(x), place(y)).clamp(0.0, 1.0);
        Rgb([0, 1, 2].map(|k: usize| (dark[k] + tone * (light[k] - dark[k]) + 0.5_f64) as u8))
    })
}

fn at(values: &[f64], x: f64, y: f64) -> f64 {
    let cell = |place: f64| ((place * SIDE as f64) as usize).min(SIDE - 1);
    values[cell(y) * SIDE + cell(x)]
}

fn noises() -> Vec<(String, RgbImage)> {
    let mut all = Vec::new();
    for seed in 0..3 {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let white: Vec<f64> = (0..SIDE * SIDE).map(|_| 0.5 + 0.15 * normal(&mut random)).collect();
        all.push((format!("noise-{seed}"), drawn(&|x, y| at(&white, x, y))));
        let fractal = fractal([SIDE; 2], &mut random);
        all.push((format!("clouds-{seed}"), drawn(&|x, y| 0.5 + 0.25 * at(&fractal, x, y))));
        // Blurred noise has blobs of one size, of all heights and shapes.
        let sigma = [2.0, 4.0, 7.0][seed as usize];
        let picture =
            image::GrayImage::from_fn(SIDE as u32, SIDE as u32, |_, _| image::Luma([random.random::<u8>()]));
        let blurred = image::imageops::blur(&picture, sigma);
        let contrast = 0.35 * f64::from(sigma);
        let tone = |x: f64, y: f64| {
            let px = blurred.get_pixel((x * SIDE as f64) as u32, (y * SIDE as f64) as u32);
            0.5 + contrast * (f64::from(px.0[0]) / 127.5 - 1.0)
        };
        all.push((format!("blurred-noise-{seed}"), drawn(&tone)));
    }
    all
}

fn gradients() -> Vec<(String, RgbImage)> {
    let ramps: [(&str, Tone); 6] = [
        ("gradient-across", &|x, _| x),
        ("gradient-down", &|_, y| y),
        ("gradient-diagonal", &|x, y| 0.5 * (x + y)),
        ("gradient-round", &|x, y| 1.0 - 1.4 * (x - 0.5).hypot(y - 0.5)),
        ("horizon", &|x, y| if y < 0.6 { 0.9 - 0.3 * y } else { 0.2 + 0.1 * x }),
        ("one-tone", &|_, _| 0.6),
    ];
    ramps.iter().map(|(name, tone)| ((*name).to_owned(), drawn(*tone))).collect()
}

fn boards() -> Vec<(String, RgbImage)> {
    let mut all = Vec::new();
    for fields in [8.0, 12.0, 20.0, 32.0] {
        let parity = |x: f64, y: f64| ((fields * x).floor() + (fields * y).floor()).rem_euclid(2.0);
        all.push((format!("chessboard-{fields}"), drawn(&parity)));
    }
    let (sin, cos) = 0.4_f64.sin_cos();
    let turned = |x: f64, y: f64| {
        let (u, v) = (14.0 * (x * cos + y * sin), 14.0 * (y * cos - x * sin));
        (u.floor() + v.floor()).rem_euclid(2.0)
    };
    all.push(("chessboard-turned".to_owned(), drawn(&turned)));
    let bricks = |x: f64, y: f64| {
        let row = (12.0 * y).floor();
        let column = (5.0 * x + 0.5 * row.rem_euclid(2.0)).rem_euclid(1.0);
        if (12.0 * y).rem_euclid(1.0) < 0.15 || column < 0.06 { 0.9 } else { 0.3 }
    };
    all.push(("bricks".to_owned(), drawn(&bricks)));
    let squared = |x: f64, y: f64| {
        let line = |z: f64| (16.0 * z).rem_euclid(1.0) < 0.12;
        if line(x) || line(y) { 0.3 } else { 0.95 }
    };
    all.push(("squared-paper".to_owned(), drawn(&squared)));
    all
}

/// Letters of 5 × 7 dots; each number is a row.
const LETTERS: [[u8; 7]; 12] = [
    [14, 17, 17, 31, 17, 17, 17],
    [30, 17, 17, 30, 17, 17, 30],
    [14, 17, 16, 16, 16, 17, 14],
    [30, 17, 17, 17, 17, 17, 30],
    [31, 16, 16, 30, 16, 16, 31],
    [14, 17, 16, 23, 17, 17, 14],
    [17, 17, 17, 31, 17, 17, 17],
    [31, 4, 4, 4, 4, 4, 31],
    [17, 18, 20, 24, 20, 18, 17],
    [16, 16, 16, 16, 16, 16, 31],
    [17, 27, 21, 17, 17, 17, 17],
    [14, 17, 17, 17, 17, 17, 14],
];

fn texts() -> Vec<(String, RgbImage)> {
    let mut all = Vec::new();
    for (k, size) in [12.0, 16.0, 22.0, 30.0, 44.0].into_iter().enumerate() {
        let mut random = Pcg64Mcg::seed_from_u64(90 + k as u64);
        // One of three characters is a gap between words.
        let line: Vec<Vec<usize>> = (0..60)
            .map(|_| (0..60).map(|_| random.random_range(0..LETTERS.len() * 5 / 4)).collect())
            .collect();
        let tone = |x: f64, y: f64| {
            let (u, v) = (x * SIDE as f64 / (0.75 * size), y * SIDE as f64 / (1.5 * size));
            let letter = line[v as usize % 60][u as usize % 60];
            let (dot, row) = ((u.fract() * 6.0) as usize, (v.fract() * 12.0) as usize);
            let inked =
                letter < LETTERS.len() && dot < 5 && row < 7 && LETTERS[letter][row] >> (4 - dot) & 1 == 1;
            if inked { 0.05 } else { 0.95 }
        };
        all.push((format!("text-{size}"), drawn(&tone)));
    }
    all
}

/// Heads with hair, eyes, brows, nose and mouth, lit from one side.
fn faces() -> Vec<(String, RgbImage)> {
    let inside = |x: f64, y: f64, [cx, cy, rx, ry]: [f64; 4]| {
        (1.0 - ((x - cx) / rx).powi(2) - ((y - cy) / ry).powi(2)).max(-1.0)
    };
    let mut all = Vec::new();
    for seed in 0..8_u64 {
        let mut random = Pcg64Mcg::seed_from_u64(30 + seed);
        let mut vary = |middle: f64, by: f64| middle + by * (2.0 * random.random::<f64>() - 1.0);
        let head = [vary(0.5, 0.06), vary(0.52, 0.04), vary(0.27, 0.04), vary(0.37, 0.04)];
        let (eyes, eye, lips) = (vary(0.11, 0.02), vary(0.035, 0.01), vary(0.09, 0.03));
        let (hair, ground, light) = (vary(0.3, 0.2), vary(0.6, 0.3), vary(0.0, 0.4));
        let curls = fractal([SIDE; 2], &mut Pcg64Mcg::seed_from_u64(seed));
        let tone = |x: f64, y: f64| {
            let [cx, cy, rx, ry] = head;
            let mut tone = ground + 0.03 * at(&curls, x, y);
            if inside(x, y, [cx, cy - 0.08, 1.25 * rx, 1.1 * ry]) > 0.0 {
                tone = hair + 0.06 * at(&curls, x, y);
            }
            let face = inside(x, y, head);
            if face > 0.0 && y > cy - 0.62 * ry {
                tone = 0.65 + 0.2 * face.sqrt() + light * (x - cx);
            }
            for side in [-1.0, 1.0] {
                if inside(x, y, [cx + side * eyes, cy - 0.06, 1.5 * eye, eye]) > 0.0 {
                    tone = if inside(x, y, [cx + side * eyes, cy - 0.06, 0.6 * eye, 0.6 * eye]) > 0.0 {
                        0.1
                    } else {
                        0.95
                    };
                }
                if inside(x, y, [cx + side * eyes, cy - 0.13, 1.8 * eye, 0.35 * eye]) > 0.0 {
                    tone = 0.25;
                }
            }
            if inside(x, y, [cx, cy + 0.07, 0.03, 0.06]) > 0.6 {
                tone -= 0.12;
            }
            if inside(x, y, [cx, cy + 0.2, lips, 0.022]) > 0.0 { 0.4 } else { tone }
        };
        all.push((format!("face-{seed}"), drawn(&tone)));
    }
    all
}

fn things() -> Vec<(String, RgbImage)> {
    let mut all = Vec::new();
    for seed in 0..4_u64 {
        let mut random = Pcg64Mcg::seed_from_u64(60 + seed);
        let boxes: Vec<[f64; 5]> = (0..60)
            .map(|_| {
                let mut next = || random.random::<f64>();
                [next(), next(), 0.02 + 0.25 * next().powi(2), 0.02 + 0.25 * next().powi(2), next()]
            })
            .collect();
        let pile = |x: f64, y: f64| {
            let on = boxes.iter().rev().find(|[cx, cy, w, h, _]| (x - cx).abs() < *w && (y - cy).abs() < *h);
            on.map_or(0.5, |on| on[4])
        };
        all.push((format!("boxes-{seed}"), drawn(&pile)));
        let discs = |x: f64, y: f64| {
            let on = boxes.iter().rev().find(|[cx, cy, r, _, _]| (x - cx).hypot(y - cy) < *r);
            on.map_or(0.5, |on| on[4])
        };
        all.push((format!("discs-of-all-sizes-{seed}"), drawn(&discs)));
    }
    let few: [(&str, Tone); 3] = [
        ("one-disc", &|x, y| if (x - 0.5).hypot(y - 0.5) < 0.3 { 0.1 } else { 0.9 }),
        ("cross", &|x, y| if (x - 0.5).abs() < 0.08 || (y - 0.5).abs() < 0.08 { 0.1 } else { 0.9 }),
        ("two-bars", &|x, _| if (x - 0.3).abs() < 0.06 || (x - 0.7).abs() < 0.06 { 0.1 } else { 0.9 }),
    ];
    all.extend(few.iter().map(|(name, tone)| ((*name).to_owned(), drawn(*tone))));
    all
}
