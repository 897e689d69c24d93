//! Models → a picture, by a z-buffer with 16 samples a px.
//!
//! Bands of rows are drawn in parallel; each band is independent of the others.

use std::ops::Range;

use rayon::prelude::*;

use super::camera::View;
use super::paint::Painted;
use super::raster::{NONE, Samples};
use super::scene::{SAMPLES, Scene};
use crate::export::srgb_from_linear;

/// Rows of px that are drawn together.
const BAND: usize = 16;

/// A picture, 8-bit sRGB with opacity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Red, green, blue, opacity by px, row by row; the colours are not multiplied by the opacity.
    pub rgba: Vec<u8>,
}

impl Picture {
    /// Red, green and blue by px, without the opacity.
    #[must_use]
    pub fn rgb(&self) -> Vec<u8> {
        self.rgba.chunks_exact(4).flat_map(|px| [px[0], px[1], px[2]]).collect()
    }
}

/// Draws models that are lit from above, with smooth edges, soft shadows and a floor if the view has a shadow. A triangle with a
/// corner that is no number is left out.
///
/// # Panics
/// If an index of a triangle is not of a vertex, or normals or colours are missing.
#[must_use]
pub fn draw(parts: &[Painted], view: &View) -> Picture {
    let scene = Scene::new(parts, view);
    let size = view.size.map(|side| side as usize);
    let mut rgba = vec![0; 4 * size[0] * size[1]];
    let bins = bins(&scene, size[1].div_ceil(BAND));
    let codes: Vec<u8> = (0..=CODES).map(|code| code_of(code as f64 / CODES as f64)).collect();
    let bands = rgba.par_chunks_mut(4 * BAND * size[0].max(1));
    bands.zip(&bins).enumerate().for_each(|(band, (rgba, triangles))| {
        let rows = band * BAND..(band * BAND + BAND).min(size[1]);
        draw_band(&scene, rows, triangles, |px, light| {
            for (code, value) in rgba[4 * px..][..4].iter_mut().zip(scene.composed(light)) {
                *code = codes[(value.clamp(0.0, 1.0) * CODES as f64) as usize];
            }
            rgba[4 * px + 3] = (255.0 * if view.background.is_some() { 1.0 } else { light[3] }).round() as u8;
        });
    });
    Picture { size, rgba }
}

/// Number of values of linear light for which the 8-bit codes are tabulated.
const CODES: usize = 1 << 15;

fn code_of(light: f64) -> u8 {
    (255.0 * srgb_from_linear(light)).round() as u8
}

/// The triangles that may appear in each band of rows, in order.
fn bins(scene: &Scene, bands: usize) -> Vec<Vec<u32>> {
    let mut bins = vec![Vec::new(); bands];
    let height = (SAMPLES * BAND) as f64;
    for triangle in 0..scene.triangles.len() {
        let [a, b, c] = scene.corners(triangle).map(|corner| corner[1] / height);
        let [low, high] = [a.min(b).min(c), a.max(b).max(c)];
        if low.is_finite() && high >= 0.0 {
            for bin in bins.iter_mut().take(high.min(bands as f64) as usize + 1).skip(low.max(0.0) as usize) {
                bin.push(triangle as u32);
            }
        }
    }
    bins
}

/// For each px of some rows, counted from the first row: its light multiplied by its opacity, and its opacity.
fn draw_band(scene: &Scene, rows: Range<usize>, triangles: &[u32], mut set: impl FnMut(usize, [f64; 4])) {
    let width = scene.view.size[0] as usize;
    let mut samples = Samples::new(SAMPLES * width, SAMPLES * rows.start..SAMPLES * rows.end);
    for &triangle in triangles {
        samples.draw(&scene.corners(triangle as usize), triangle);
    }
    let mut px_samples = [(NONE, [0.0; 2]); SAMPLES * SAMPLES];
    for row in rows.clone() {
        for column in 0..width {
            for (at, sample) in px_samples.iter_mut().enumerate() {
                let [x, y] = [SAMPLES * column + at % SAMPLES, SAMPLES * (row - rows.start) + at / SAMPLES];
                let place = [x as f64 + 0.5, (SAMPLES * rows.start + y) as f64 + 0.5];
                *sample = (samples.triangles[y * samples.width + x], place);
            }
            let mut light = mean(scene, &px_samples);
            if light[3] < 1.0 {
                light[3] += (1.0 - light[3]) * scene.shadow([column, row]);
            }
            set((row - rows.start) * width + column, light);
        }
    }
}

/// The mean of the samples of a px.
fn mean(scene: &Scene, samples: &[(u32, [f64; 2]); SAMPLES * SAMPLES]) -> [f64; 4] {
    let mut sum = [0.0; 4];
    let mut is_done = [false; SAMPLES * SAMPLES];
    for at in 0..samples.len() {
        let triangle = samples[at].0;
        if is_done[at] || triangle == NONE {
            continue;
        }
        let mut places = [[0.0; 2]; SAMPLES * SAMPLES];
        let mut count = 0;
        for other in at..samples.len() {
            if samples[other].0 == triangle {
                is_done[other] = true;
                places[count] = samples[other].1;
                count += 1;
            }
        }
        if let Some(light) = scene.shown(triangle as usize, &places[..count]) {
            sum = [0, 1, 2, 3]
                .map(|channel| sum[channel] + if channel < 3 { light[channel] } else { count as f64 });
        }
    }
    sum.map(|value| value / samples.len() as f64)
}

#[cfg(test)]
mod tests {
    use super::super::paint::Paint;
    use super::super::vector::Vector;
    use super::*;
    use crate::export::body::normals;
    use crate::surface::{Mesh, built_in};

    fn body(name: &str) -> (Mesh, Vec<Vector>) {
        let mesh = built_in(name).unwrap().mesh(&[]).unwrap();
        let normals = normals(&mesh);
        (mesh, normals)
    }

    fn plain(mesh: &Mesh, normals: &[Vector], view: &View) -> Picture {
        draw(&[Painted { mesh, normals, paint: Paint::Plain([0.8; 3]) }], view)
    }

    #[test]
    fn the_bytes_do_not_depend_on_the_number_of_threads() {
        let (mesh, normals) = body("torus");
        let view = View::new(30.0, 25.0, [97, 61]);
        let on = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| plain(&mesh, &normals, &view))
        };
        assert_eq!(on(1), on(5));
    }

    #[test]
    fn a_sphere_is_round_lit_from_above_left_and_opaque_inside() {
        let (mesh, normals) = body("sphere");
        let view = View { background: None, shadow: false, ..View::new(0.0, 0.0, [100, 100]) };
        let picture = plain(&mesh, &normals, &view);
        let px = |x: usize, y: usize| &picture.rgba[4 * (100 * y + x)..][..4];
        let covered: f64 = picture.rgba.chunks(4).map(|px| f64::from(px[3]) / 255.0).sum();
        let expected = std::f64::consts::PI * 43.0 * 43.0;
        assert!((covered - expected).abs() < 0.01 * expected, "{covered} px of {expected}");
        assert_eq!((px(50, 50)[3], px(2, 2)), (255, &[0, 0, 0, 0][..]));
        assert!(px(35, 30)[0] > px(50, 50)[0] && px(50, 50)[0] > px(70, 80)[0] + 20);
    }

    #[test]
    fn edges_of_a_pattern_are_sharp_though_triangles_are_large() {
        let (mesh, normals) = body("sphere");
        let values: Vec<f32> = mesh.positions.iter().map(|place| place[0] as f32).collect();
        let colours: Vec<[f32; 3]> = values.iter().map(|value| [f32::from(*value > 0.013); 3]).collect();
        let view = View { shadow: false, ..View::new(0.0, 0.0, [400, 400]) };
        let sharp = |value: &[f32]| [f32::from(value[0] > 0.013); 3];
        let fields = [&values[..]];
        let between = |paint: Paint| {
            let picture = draw(&[Painted { mesh: &mesh, normals: &normals, paint }], &view);
            let row = &picture.rgba[4 * 400 * 200..][..4 * 400];
            row.chunks(4).skip(150).take(100).filter(|px| (20..150).contains(&px[0])).count()
        };
        assert!(between(Paint::Pattern { fields: &fields, colour: &sharp }) <= 1);
        assert!(between(Paint::Colours(&colours)) > 3);
    }

    #[test]
    fn there_is_a_shadow_under_a_body_and_none_far_from_it() {
        let (mesh, normals) = body("cube");
        let view = View::new(20.0, 20.0, [120, 120]);
        let [with, without] =
            [true, false].map(|shadow| plain(&mesh, &normals, &View { shadow, ..view }).rgba);
        let darker = |row: usize| {
            (480 * row..480 * (row + 1)).filter(|at| with[*at] < without[*at].saturating_sub(15)).count() / 3
        };
        assert!((80..110).map(darker).sum::<usize>() > 120);
        assert_eq!((0..20).map(darker).sum::<usize>(), 0);
        let plain = code_of(f64::from(0.76_f32));
        assert_eq!((&without[..3], &with[..3]), (&[plain; 3][..], &[plain; 3][..]));
        assert!(with.chunks(4).all(|px| px[3] == 255));
    }

    #[test]
    fn an_empty_model_and_corners_that_are_no_numbers_leave_the_background() {
        let view = View::new(0.0, 10.0, [30, 20]);
        let empty = draw(&[], &view);
        assert!(empty.rgba.chunks(4).all(|px| px == &empty.rgba[..4]));
        let positions = vec![[f64::NAN; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [f64::MAX; 3], [2.0; 3]];
        let mesh = Mesh { positions, faces: vec![[0, 1, 2], [1, 1, 2], [1, 2, 3], [4, 4, 4]] };
        let _ = plain(&mesh, &normals(&mesh), &view);
        let _ = plain(&mesh, &normals(&mesh), &View { size: [0, 0], ..view });
    }
}
