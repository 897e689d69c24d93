//! The projected scene: where triangles are in the picture, their colours and the light on them.
//!
//! The colour is computed for each sample, so that sharp edges of patterns are smooth; the light once for each triangle in a px.

use rayon::prelude::*;

use super::blurred::OF_A_PX;
use super::camera::{Camera, View};
use super::curved::{Cubic, slopes};
use super::floor::Floor;
use super::light::Lights;
use super::paint::{Look, Paint, Painted};
use super::raster::{Corners, Plane};
use super::shadow::Sphere;
use super::vector::{Vector, cross, dot, minus, plus, unit};

/// Samples along a side of a px.
pub const SAMPLES: usize = 4;
/// Cosine of the angle between the normals of a corner and of its triangle below which the edge is sharp: 37 degrees.
const SHARP: f64 = 0.8;
/// The most px of a triangle on which the light is interpolated between its corners.
const SMALL: f64 = 400.0;
/// The least cosine between a normal and the way to the viewer with which a blur is reckoned: what is seen more aslant is a rim.
const SLANTING: f64 = 0.2;
/// All samples of a px, and four of them, one in each row and each column.
const ALL: usize = SAMPLES * SAMPLES;
const LOOKED: [usize; 4] = [1, 7, 8, 14];
/// The least and the greatest change of the light by a relief.
const RELIEF: [f64; 2] = [0.35, 1.6];
/// The largest number of fields of a pattern; further ones are not read.
const MOST_FIELDS: usize = 8;

/// A projected triangle.
struct Seen {
    plane: Plane,
    near: [f64; 3],
}

impl Seen {
    fn new(corners: Corners) -> Option<Self> {
        Some(Self { plane: Plane::new(&corners)?, near: corners.map(|corner| corner[2]) })
    }

    /// The shares of the corners in a sample, in perspective: the shares in the flat picture times the corners' nearness.
    fn shares(&self, sample: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.plane.weights(sample);
        let [a, b, c] = [a.max(0.0) * self.near[0], b.max(0.0) * self.near[1], c.max(0.0) * self.near[2]];
        let scale = 1.0 / (a + b + c);
        [scale * a, scale * b, scale * c]
    }
}

/// Parts of models, projected for a view.
pub struct Scene<'a> {
    parts: &'a [Painted<'a>],
    pub view: &'a View,
    camera: Camera,
    lights: Lights,
    /// By part: its first triangle and its first vertex among all.
    starts: Vec<[usize; 2]>,
    places: Vec<Vector>,
    normals: Vec<Vector>,
    pub triangles: Vec<[usize; 3]>,
    /// By vertex: its position in the picture, in samples.
    seen: Vec<[f64; 3]>,
    /// By part and field: the slopes at the vertices.
    slopes: Vec<Vec<Vec<Vector>>>,
    /// By vertex: the light on its outer side.
    light: Vec<f64>,
    floor: Option<Floor>,
}

impl<'a> Scene<'a> {
    pub fn new(parts: &'a [Painted<'a>], view: &'a View) -> Self {
        let mut starts = Vec::new();
        let mut places: Vec<Vector> = Vec::new();
        let mut triangles = Vec::new();
        for part in parts {
            let start = places.len();
            starts.push([triangles.len(), start]);
            places.extend(&part.mesh.positions);
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
        let normals: Vec<Vector> = parts.iter().flat_map(|part| part.normals.iter().copied()).collect();
        let light =
            places.par_iter().zip(&normals).map(|(place, normal)| lights.on(*place, *normal)).collect();
        let seen = |place: &Vector| {
            let [x, y, near] = camera.seen(*place);
            [SAMPLES as f64 * x, SAMPLES as f64 * y, near]
        };
        let seen = places.iter().map(seen).collect();
        let slopes = parts.par_iter().map(|part| match part.paint {
            Paint::Pattern { fields, .. } => fields.iter().map(|values| slopes(part.mesh, values)).collect(),
            Paint::Plain(_)
            | Paint::Colours(_)
            | Paint::Blurred(_)
            | Paint::Look(_)
            | Paint::Texture { .. } => Vec::new(),
        });
        let slopes = slopes.collect();
        Self { parts, view, camera, lights, starts, places, triangles, normals, seen, slopes, light, floor }
    }

    pub fn corners(&self, triangle: usize) -> Corners {
        self.triangles[triangle].map(|vertex| self.seen[vertex])
    }

    /// The sum of the light of some samples of a triangle.
    pub fn shown(&self, triangle: usize, samples: &[[f64; 2]]) -> Option<[f64; 3]> {
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
            Paint::Blurred(blurred) => {
                let deviation = OF_A_PX * self.footprint(triangle, shares);
                blurred.at(vertices, shares, deviation).map(|light| count * f64::from(light))
            }
            Paint::Look(look) => return Some(self.looked(part, triangle, &seen, samples, look)),
            Paint::Texture { uvs, mips } => {
                let corners = vertices.map(|vertex| uvs[vertex]);
                let uv = [0, 1].map(|axis| (0..3).map(|at| shares[at] * corners[at][axis]).sum::<f64>());
                let texels = self.texels(triangle, corners, mips.size());
                mips.at(uv, texels).map(|light| count * f64::from(light))
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

    /// The sum of the light of some samples of a triangle whose look is computed: at four of the samples of a px, for a quarter of it.
    fn looked(
        &self,
        part: usize,
        triangle: usize,
        seen: &Seen,
        samples: &[[f64; 2]],
        look: &dyn Look,
    ) -> [f64; 3] {
        let count = samples.len().min(LOOKED.len());
        let chosen = |index: usize| match samples.len() {
            ALL => LOOKED[index],
            several => index * several / count,
        };
        let own = triangle - self.starts[part][0];
        let mut sum = [0.0; 3];
        for index in 0..count {
            let shares = seen.shares(samples[chosen(index)]);
            let depth: f64 = (0..3).map(|at| shares[at] / seen.near[at]).sum();
            // Four looks share a px.
            let (colour, slope) = look.at(own, shares, 0.5 * self.camera.px(1.0 / depth));
            let light = self.light(triangle, shares) * self.relief(triangle, shares, slope);
            sum = [0, 1, 2].map(|channel| sum[channel] + light * f64::from(colour[channel]));
        }
        sum.map(|light| light * samples.len() as f64 / count as f64)
    }

    /// How many times as much light a relief of this slope gets as a surface without.
    fn relief(&self, triangle: usize, shares: [f64; 3], slope: Vector) -> f64 {
        let normals = self.triangles[triangle].map(|vertex| self.normals[vertex]);
        let normal = unit((0..3).fold([0.0; 3], |sum, at| plus(sum, shares[at], normals[at])));
        let free = self.lights.free(normal);
        let raised = self.lights.free(unit(minus(normal, slope)));
        if free > 0.0 { (raised / free).clamp(RELIEF[0], RELIEF[1]) } else { 1.0 }
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

    /// The longer side of what a px shows of a place of a triangle.
    fn footprint(&self, triangle: usize, shares: [f64; 3]) -> f64 {
        let vertices = self.triangles[triangle];
        let near: f64 = (0..3).map(|at| shares[at] / self.seen[vertices[at]][2]).sum();
        let [a, b, c] = vertices.map(|vertex| self.places[vertex]);
        let (flat, to_eye) = (unit(cross(minus(b, a), minus(c, a))), unit(minus(self.camera.eye, a)));
        self.camera.px(1.0 / near) / dot(flat, to_eye).abs().max(SLANTING)
    }

    /// The longer side of what a px shows of a triangle, texels of a picture of this `size`.
    fn texels(&self, triangle: usize, uvs: [[f64; 2]; 3], size: [usize; 2]) -> f64 {
        let [a, b, c] = self.corners(triangle);
        let [u, v] = [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]];
        let texels = |corner: usize| [0, 1].map(|i| (uvs[corner][i] - uvs[0][i]) * size[i] as f64);
        let (s, t) = (texels(1), texels(2));
        let area = u[0] * v[1] - u[1] * v[0];
        // Columns of the derivative of texels by samples.
        let x = [0, 1].map(|i| (s[i] * v[1] - t[i] * u[1]) / area);
        let y = [0, 1].map(|i| (t[i] * u[0] - s[i] * v[0]) / area);
        // Its larger singular value.
        let (squares, product) =
            (x[0] * x[0] + x[1] * x[1] + y[0] * y[0] + y[1] * y[1], x[0] * y[1] - x[1] * y[0]);
        let larger = 0.5 * (squares + (squares * squares - 4.0 * product * product).max(0.0).sqrt());
        if larger.is_finite() { SAMPLES as f64 * larger.sqrt() } else { 1.0 }
    }

    fn is_small(&self, triangle: usize) -> bool {
        let [a, b, c] = self.corners(triangle);
        let area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs();
        area <= SMALL * (SAMPLES * SAMPLES) as f64
    }

    /// The relative decrease of the light on the floor in a px, 0..1.
    pub fn shadow(&self, px: [usize; 2]) -> f64 {
        let Some(floor) = &self.floor else { return 0.0 };
        let ray = self.camera.ray(px.map(|at| at as f64 + 0.5));
        let length = (floor.height - self.camera.eye[1]) / ray[1];
        let is_floor = ray[1] < 0.0 && length > 0.0 && length.is_finite();
        if is_floor { floor.shadow(plus(self.camera.eye, length, ray)).clamp(0.0, 1.0) } else { 0.0 }
    }

    /// The colours of the picture. With a background: opaque light. Without one: light that is not multiplied by its opacity.
    pub fn composed(&self, [red, green, blue, opacity]: [f64; 4]) -> [f64; 3] {
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

/// The least and the greatest coordinates of places; 0 if there are none.
fn bounds(places: &[Vector]) -> [Vector; 2] {
    let Some(first) = places.first() else { return [[0.0; 3]; 2] };
    places.iter().fold([*first; 2], |[low, high], place| {
        [[0, 1, 2].map(|axis| low[axis].min(place[axis])), [0, 1, 2].map(|axis| high[axis].max(place[axis]))]
    })
}
