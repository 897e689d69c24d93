//! The shadow of a model on the floor under it.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::light::{Lights, STRENGTHS};
use super::shadow::{Map, Sphere};
use super::vector::Vector;

/// Squares along a side of the floor.
const SIDE: usize = 96;
/// The floor's side in radii of the sphere around the model.
const RADII: f64 = 5.0;
/// Factor of the shadow: share of the light taken by the model that is really removed from the floor.
const SHOWN: f64 = 0.85;

/// For each square, the relative decrease of the light, 0..1.
pub struct Floor {
    pub height: f64,
    corner: [f64; 2],
    side: f64,
    shadows: Vec<f64>,
}

impl Floor {
    pub fn new(height: f64, lights: &Lights, sphere: Sphere, triangles: &[[Vector; 3]]) -> Self {
        let side = RADII * sphere.radius / SIDE as f64;
        let corner = [0, 2].map(|axis| sphere.middle[axis] - 0.5 * RADII * sphere.radius);
        let place = |at: usize| {
            let [x, z] = [at % SIDE, at / SIDE].map(|at| (at as f64 + 0.5) * side);
            [corner[0] + x, height, corner[1] + z]
        };
        let roofs = roofs(height, 0.75 * side, sphere, triangles);
        let squares = || (0..SIDE * SIDE).into_par_iter();
        let key: Vec<f64> = squares().map(|at| lights.key_on_floor(place(at))).collect();
        let free = lights.free_key_on_floor();
        let shadow = |at: usize| {
            let taken = STRENGTHS[0] * sky_taken(place(at), &roofs) + free - mean_around(&key, at);
            SHOWN * taken / (STRENGTHS[0] + free)
        };
        Self { height, corner, side, shadows: squares().map(shadow).collect() }
    }

    /// The relative decrease of the light at a place of the floor, 0..1.
    pub fn shadow(&self, place: Vector) -> f64 {
        let [x, z] = [0, 1].map(|axis| (place[2 * axis] - self.corner[axis]) / self.side - 0.5);
        let end = (SIDE - 1) as f64;
        if !(x >= 0.0 && z >= 0.0 && x < end && z < end) {
            return 0.0;
        }
        let [column, row] = [x as usize, z as usize];
        let [u, v] = [x - column as f64, z - row as f64];
        let at = row * SIDE + column;
        let [near, far] =
            [at, at + SIDE].map(|at| self.shadows[at] + u * (self.shadows[at + 1] - self.shadows[at]));
        // Fades out at the border, which may be in the picture.
        let border = [x, z, end - x, end - z].into_iter().fold(f64::MAX, f64::min);
        (near + v * (far - near)) * (border / (0.3 * end)).min(1.0)
    }
}

/// The mean of a square and its neighbours, so that the few directions of the key light do not show.
fn mean_around(values: &[f64], at: usize) -> f64 {
    let near = |at: usize| at.saturating_sub(BLUR)..(at + BLUR + 1).min(SIDE);
    let [columns, rows] = [near(at % SIDE), near(at / SIDE)];
    let count = (columns.len() * rows.len()) as f64;
    rows.flat_map(|row| &values[row * SIDE..][columns.clone()]).sum::<f64>() / count
}

/// Number of squares on either side over which the key light is averaged.
const BLUR: usize = 2;

/// A piece of the model's underside: where it is, its height above the floor, its area.
struct Roof {
    place: [f64; 2],
    height: f64,
    area: f64,
}

/// The underside of the model as squares of a map seen from below. Their height above the floor is at least `least`.
fn roofs(height: f64, least: f64, sphere: Sphere, triangles: &[[Vector; 3]]) -> Vec<Roof> {
    let map = Map::new([0.0, -1.0, 0.0], sphere, triangles);
    let roof = |(place, area): (Vector, f64)| {
        // Parts that touch the floor have no distance from it: they would darken only the point under them.
        Roof { place: [place[0], place[2]], height: (place[1] - height).max(least), area }
    };
    map.seen(ROOF).map(roof).collect()
}

/// Samples of the map along a side of a square of the underside.
const ROOF: usize = 4;

/// The share of an even sky that the underside hides from a place of the floor: the sum of the form factors of its squares.
fn sky_taken(place: Vector, roofs: &[Roof]) -> f64 {
    let taken: f64 = roofs
        .iter()
        .map(|roof| {
            let [x, z] = [roof.place[0] - place[0], roof.place[1] - place[2]];
            let height = roof.height * roof.height;
            let square = x * x + z * z + height;
            roof.area * height / (PI * square * square)
        })
        .sum();
    taken.min(1.0)
}
