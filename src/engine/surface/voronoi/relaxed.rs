//! Random points, and their relaxation by repulsion until they are evenly spread.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64;
use rayon::prelude::*;

use super::near::Near;
use crate::grid::Domain;
use crate::surface::{Surface, SurfacePoint};

/// The displacement of a point in an iteration as a share of the sum of forces, in radii of repulsion: Turk's k, "some small
/// scaling value". Not tuned: with larger ones points jump over each other.
const SCALE: f64 = 0.1;

/// Points that are evenly spread over a surface.
#[derive(Clone, Debug)]
pub struct RelaxedPoints {
    /// Their places.
    pub places: Vec<SurfacePoint>,
    /// The radius of repulsion r = 2 √(a/n), for the area a of the surface and n points; in lengths of the surface.
    pub radius: f64,
}

/// `number` random points, uniformly distributed by area.
#[must_use]
pub fn random_points(surface: &Surface, number: usize, seed: u64) -> Vec<SurfacePoint> {
    let mut sums = Vec::with_capacity(surface.cells());
    let mut area = 0.0;
    for cell in 0..surface.cells() {
        area += surface.cell_area(cell);
        sums.push(area);
    }
    let mut random = Pcg64::seed_from_u64(seed);
    let place = |_| {
        let at = random.random::<f64>() * area;
        let cell = sums.partition_point(|sum| *sum <= at).min(sums.len() - 1);
        surface.place_in(cell, [random.random(), random.random()])
    };
    (0..number).map(place).collect()
}

impl RelaxedPoints {
    /// `number` random points after `iterations` of repulsion; Turk takes 40. The cells of the surface should be no larger than the
    /// distance of the points.
    #[must_use]
    pub fn new(surface: &Surface, number: usize, iterations: usize, seed: u64) -> Self {
        let radius = 2.0 * (surface.mesh.area() / number.max(1) as f64).sqrt();
        let mut places = random_points(surface, number, seed);
        for _ in 0..iterations {
            let near = Near::new(surface, &places);
            let moved = |(index, place): (usize, &SurfacePoint)| {
                let force = force(&near.around(index, radius), radius);
                surface.walk(*place, force.map(|part| SCALE * radius * part))
            };
            places = places.par_iter().enumerate().map(moved).collect();
        }
        Self { places, radius }
    }
}

/// The sum of the forces of points around, each 1 at the place itself and decreasing linearly to 0 at the radius.
fn force(around: &[(usize, [f64; 2])], radius: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for (_, [x, y]) in around {
        let distance = (x * x + y * y).sqrt();
        if distance > 0.0 {
            let strength = (1.0 - distance / radius) / distance;
            sum = [sum[0] - strength * x, sum[1] - strength * y];
        }
    }
    sum
}
