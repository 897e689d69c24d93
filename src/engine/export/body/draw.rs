//! Models → a picture, by a z-buffer with 16 samples a px.
//!
//! The colour is computed for each sample, so that sharp edges of patterns are smooth; the light once for each triangle in a px. Bands
//! of rows are drawn in parallel, and what is in a band does not depend on the others.

use std::ops::Range;

use rayon::prelude::*;

use super::camera::{Camera, View};
use super::curved::{Cubic, slopes};
use super::floor::Floor;
use super::light::Lights;
use super::paint::{Paint, Painted};
use super::raster::{Corners, NONE, Plane, Samples};
use super::shadow::Sphere;
use super::vector::{Vector, cross, dot, minus, plus, unit};
use crate::export::srgb_from_linear;

/// Samples along a side of a px.
const SAMPLES: usize = 4;
/// Rows of px that are drawn together.
const BAND: usize = 16;
/// Where the normals of a corner and of its triangle differ by more, as cosine, the edge is sharp: 37 degrees.
const SHARP: f64 = 0.8;
/// The most px of a triangle on which the light is interpolated between its corners.
const SMALL: f64 = 400.0;

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
    let bins = scene.bins(size[1].div_ceil(BAND));
    let codes: Vec<u8> = (0..=CODES).map(|code| code_of(code as f64 / CODES as f64)).collect();
    let bands = rgba.par_chunks_mut(4 * BAND * size[0].max(1));
    bands.zip(&bins).enumerate().for_each(|(band, (rgba, triangles))| {
        let rows = band * BAND..(band * BAND + BAND).min(size[1]);
        scene.draw_band(rows, triangles, |px, light| {
            for (code, value) in rgba[4 * px..][..4].iter_mut().zip(scene.composed(light)) {
                *code = codes[(value.clamp(0.0, 1.0) * CODES as f64) as usize];
            }
            rgba[4 * px + 3] = (255.0 * if view.background.is_some() { 1.0 } else { light[3] }).round() as u8;
        });
    });
    Picture { size, rgba }
}

/// The most fields of a pattern; further ones are not read.
const MOST_FIELDS: usize = 8;

/// Steps of linear light for which the codes are tabulated.
const CODES: usize = 1 << 15;

fn code_of(light: f64) -> u8 {
    (255.0 * srgb_from_linear(light)).round() as u8
}

/// A triangle as it is seen.
struct Seen {
    plane: Plane,
    near: [f64; 3],
}

impl Seen {
    fn new(corners: Corners) -> Option<Self> {
        Some(Self { plane: Plane::new(&corners)?, near: corners.map(|corner| corner[2]) })
    }

    /// The corners' shares in a sample: in perspective those of the flat picture times the corners' nearness.
    fn shares(&self, sample: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.plane.weights(sample);
        let [a, b, c] = [a.max(0.0) * self.near[0], b.max(0.0) * self.near[1], c.max(0.0) * self.near[2]];
        let scale = 1.0 / (a + b + c);
        [scale * a, scale * b, scale * c]
    }
}

struct Scene<'a> {
    parts: &'a [Painted<'a>],
    view: &'a View,
    camera: Camera,
    lights: Lights,
    /// By part: its first triangle and its first vertex among all.
    starts: Vec<[usize; 2]>,
    places: Vec<Vector>,
    normals: Vec<Vector>,
    triangles: Vec<[usize; 3]>,
    /// By vertex: where it is in the picture, in samples.
    seen: Vec<[f64; 3]>,
    /// By part and field: the slopes at the vertices.
    slopes: Vec<Vec<Vec<Vector>>>,
    /// By vertex: the light on it, seen from outside.
    light: Vec<f64>,
    floor: Option<Floor>,
}

impl<'a> Scene<'a> {
    fn new(parts: &'a [Painted<'a>], view: &'a View) -> Self {
        let mut starts = Vec::new();
        let mut places: Vec<Vector> = Vec::new();
        let mut triangles = Vec::new();
        for part in parts {
            let start = places.len();
            starts.push([triangles.len(), start]);
            places.extend(part.mesh.positions.iter().map(|place| view.up.upright(*place)));
            triangles.extend(part.mesh.faces.iter().map(|face| face.map(|vertex| start + vertex as usize)));
        }
        let is_finite = |triangle: &[usize; 3]| {
            triangle.iter().all(|vertex| places[*vertex].iter().all(|value| value.is_finite()))
        };
        let solid: Vec<[Vector; 3]> = triangles
            .iter()
            .filter(|triangle| is_finite(triangle))
            .map(|triangle| triangle.map(|vertex| places[vertex]))
            .collect();
        let corners: Vec<Vector> = solid.iter().flatten().copied().collect();
        let bounds = bounds(&corners);
        let camera = Camera::new(view, &corners);
        let sphere = Sphere::around(bounds);
        let lights = Lights::new(camera.axes, sphere, &solid);
        let floor = view.shadow.then(|| Floor::new(bounds[0][1], &lights, sphere, &solid));
        let normals: Vec<Vector> = parts
            .iter()
            .flat_map(|part| part.normals.iter().map(|normal| view.up.upright(*normal)))
            .collect();
        let light =
            places.par_iter().zip(&normals).map(|(place, normal)| lights.on(*place, *normal)).collect();
        let seen = |place: &Vector| {
            let [x, y, near] = camera.seen(*place);
            [SAMPLES as f64 * x, SAMPLES as f64 * y, near]
        };
        let seen = places.iter().map(seen).collect();
        let slopes = parts.par_iter().map(|part| match part.paint {
            Paint::Pattern { fields, .. } => fields.iter().map(|values| slopes(part.mesh, values)).collect(),
            Paint::Plain(_) | Paint::Colours(_) => Vec::new(),
        });
        let slopes = slopes.collect();
        Self { parts, view, camera, lights, starts, places, triangles, normals, seen, slopes, light, floor }
    }

    fn corners(&self, triangle: usize) -> Corners {
        self.triangles[triangle].map(|vertex| self.seen[vertex])
    }

    /// The triangles that each band of rows may show, in order.
    fn bins(&self, bands: usize) -> Vec<Vec<u32>> {
        let mut bins = vec![Vec::new(); bands];
        let height = (SAMPLES * BAND) as f64;
        for triangle in 0..self.triangles.len() {
            let [a, b, c] = self.corners(triangle).map(|corner| corner[1] / height);
            let [low, high] = [a.min(b).min(c), a.max(b).max(c)];
            if low.is_finite() && high >= 0.0 {
                for bin in
                    bins.iter_mut().take(high.min(bands as f64) as usize + 1).skip(low.max(0.0) as usize)
                {
                    bin.push(triangle as u32);
                }
            }
        }
        bins
    }

    /// Gives each px of some rows, counted from the first of them, its light multiplied by its opacity, and its opacity.
    fn draw_band(&self, rows: Range<usize>, triangles: &[u32], mut set: impl FnMut(usize, [f64; 4])) {
        let width = self.view.size[0] as usize;
        let mut samples = Samples::new(SAMPLES * width, SAMPLES * rows.start..SAMPLES * rows.end);
        for &triangle in triangles {
            samples.draw(&self.corners(triangle as usize), triangle);
        }
        let mut px_samples = [(NONE, [0.0; 2]); SAMPLES * SAMPLES];
        for row in rows.clone() {
            for column in 0..width {
                for (at, sample) in px_samples.iter_mut().enumerate() {
                    let [x, y] =
                        [SAMPLES * column + at % SAMPLES, SAMPLES * (row - rows.start) + at / SAMPLES];
                    let place = [x as f64 + 0.5, (SAMPLES * rows.start + y) as f64 + 0.5];
                    *sample = (samples.triangles[y * samples.width + x], place);
                }
                let mut light = self.px(&px_samples);
                if light[3] < 1.0 {
                    light[3] += (1.0 - light[3]) * self.shadow([column, row]);
                }
                set((row - rows.start) * width + column, light);
            }
        }
    }

    /// The mean of the samples of a px.
    fn px(&self, samples: &[(u32, [f64; 2]); SAMPLES * SAMPLES]) -> [f64; 4] {
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
            if let Some(light) = self.shown(triangle as usize, &places[..count]) {
                sum = [0, 1, 2, 3]
                    .map(|channel| sum[channel] + if channel < 3 { light[channel] } else { count as f64 });
            }
        }
        sum.map(|value| value / samples.len() as f64)
    }

    /// The sum of the light of some samples of a triangle.
    fn shown(&self, triangle: usize, samples: &[[f64; 2]]) -> Option<[f64; 3]> {
        let seen = Seen::new(self.corners(triangle))?;
        let count = samples.len() as f64;
        let middle = [0, 1].map(|axis| samples.iter().map(|sample| sample[axis]).sum::<f64>() / count);
        let shares = seen.shares(middle);
        let part = self.part(triangle);
        let vertices = self.triangles[triangle].map(|vertex| vertex - self.starts[part][1]);
        let colour = match self.parts[part].paint {
            Paint::Plain(colour) => colour.map(|light| count * f64::from(light)),
            Paint::Colours(colours) => {
                let mean = |channel: usize| {
                    (0..3).map(|at| shares[at] * f64::from(colours[vertices[at]][channel])).sum::<f64>()
                };
                [0, 1, 2].map(|channel| count * mean(channel))
            }
            Paint::Pattern { fields, colour } => {
                let cubics = self.cubics(part, vertices, fields);
                let mut values = [0.0; MOST_FIELDS];
                let mut sum = [0.0; 3];
                for sample in samples {
                    let shares = seen.shares(*sample).map(|share| share as f32);
                    for (value, cubic) in values.iter_mut().zip(&cubics[..fields.len().min(MOST_FIELDS)]) {
                        *value = cubic.at(shares);
                    }
                    let colour = colour(&values[..fields.len().min(MOST_FIELDS)]);
                    for channel in 0..3 {
                        sum[channel] += f64::from(colour[channel]);
                    }
                }
                sum
            }
        };
        let light = self.light(triangle, shares);
        Some(colour.map(|value| value * light))
    }

    /// The values of the fields on a triangle.
    fn cubics(&self, part: usize, vertices: [usize; 3], fields: &[&[f32]]) -> [Cubic; MOST_FIELDS] {
        let mut cubics = [Cubic::default(); MOST_FIELDS];
        let places = vertices.map(|vertex| self.parts[part].mesh.positions[vertex]);
        for ((cubic, values), slopes) in cubics.iter_mut().zip(fields).zip(&self.slopes[part]) {
            *cubic = Cubic::new(
                places,
                vertices.map(|vertex| values[vertex]),
                vertices.map(|vertex| slopes[vertex]),
            );
        }
        cubics
    }

    fn part(&self, triangle: usize) -> usize {
        self.starts.partition_point(|[first, _]| *first <= triangle) - 1
    }

    /// The light on a place of a triangle, given by its corners' shares.
    fn light(&self, triangle: usize, shares: [f64; 3]) -> f64 {
        let vertices = self.triangles[triangle];
        let [a, b, c] = vertices.map(|vertex| self.places[vertex]);
        let flat = unit(cross(minus(b, a), minus(c, a)));
        let is_back = dot(flat, minus(self.camera.eye, a)) < 0.0;
        let is_sharp = vertices.map(|vertex| dot(self.normals[vertex], flat) < SHARP);
        if !is_back && is_sharp == [false; 3] && self.is_small(triangle) {
            return (0..3).map(|at| shares[at] * self.light[vertices[at]]).sum();
        }
        let place = [0, 1, 2].map(|axis| shares[0] * a[axis] + shares[1] * b[axis] + shares[2] * c[axis]);
        let normals = [0, 1, 2].map(|at| if is_sharp[at] { flat } else { self.normals[vertices[at]] });
        let normal = unit((0..3).fold([0.0; 3], |sum, at| plus(sum, shares[at], normals[at])));
        self.lights.on(place, if is_back { normal.map(|value| -value) } else { normal })
    }

    fn is_small(&self, triangle: usize) -> bool {
        let [a, b, c] = self.corners(triangle);
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs();
        area <= SMALL * (SAMPLES * SAMPLES) as f64
    }

    /// How much darker the floor is in a px.
    fn shadow(&self, px: [usize; 2]) -> f64 {
        let Some(floor) = &self.floor else { return 0.0 };
        let ray = self.camera.ray(px.map(|at| at as f64 + 0.5));
        let length = (floor.height - self.camera.eye[1]) / ray[1];
        let is_floor = ray[1] < 0.0 && length > 0.0 && length.is_finite();
        if is_floor { floor.shadow(plus(self.camera.eye, length, ray)).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// What is in the picture: light that is multiplied by its opacity over the background, or not multiplied without one.
    fn composed(&self, [red, green, blue, opacity]: [f64; 4]) -> [f64; 3] {
        match self.view.background {
            Some(behind) => {
                let behind = behind.map(|light| f64::from(light) * (1.0 - opacity));
                [red + behind[0], green + behind[1], blue + behind[2]]
            }
            None if opacity > 0.0 => [red, green, blue].map(|light| light / opacity),
            None => [0.0; 3],
        }
    }
}

/// The least and the greatest coordinates; 0 for no places.
fn bounds(places: &[Vector]) -> [Vector; 2] {
    let Some(first) = places.first() else { return [[0.0; 3]; 2] };
    places.iter().fold([*first; 2], |[low, high], place| {
        [[0, 1, 2].map(|axis| low[axis].min(place[axis])), [0, 1, 2].map(|axis| high[axis].max(place[axis]))]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::body::{Up, normals};
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
    fn up_may_be_z() {
        let (mesh, normals) = body("animal");
        let turned = Mesh {
            positions: mesh.positions.iter().map(|[x, y, z]| [*x, -*z, *y]).collect(),
            ..mesh.clone()
        };
        let turned_normals: Vec<Vector> = normals.iter().map(|[x, y, z]| [*x, -*z, *y]).collect();
        let view = View::new(40.0, 20.0, [80, 60]);
        assert_eq!(
            plain(&mesh, &normals, &view),
            plain(&turned, &turned_normals, &View { up: Up::Z, ..view })
        );
    }

    #[test]
    fn nothing_and_corners_that_are_no_numbers_leave_the_background() {
        let view = View::new(0.0, 10.0, [30, 20]);
        let empty = draw(&[], &view);
        assert!(empty.rgba.chunks(4).all(|px| px == &empty.rgba[..4]));
        let positions = vec![[f64::NAN; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [f64::MAX; 3], [2.0; 3]];
        let mesh = Mesh { positions, faces: vec![[0, 1, 2], [1, 1, 2], [1, 2, 3], [4, 4, 4]] };
        let _ = plain(&mesh, &normals(&mesh), &view);
        let _ = plain(&mesh, &normals(&mesh), &View { size: [0, 0], ..view });
    }
}
