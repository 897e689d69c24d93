//! Shadows of the model in the light of distant sources: maps of depth, one for each direction.

use rayon::prelude::*;

use super::raster::Samples;
use super::vector::{Vector, cross, dot, minus, plus, unit};

/// Samples along a side of a map.
const SIDE: usize = 256;

/// The sphere around the model.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    pub middle: Vector,
    pub radius: f64,
}

impl Sphere {
    pub fn around([low, high]: [Vector; 2]) -> Self {
        let half = minus(high, low).map(|side| 0.5 * side);
        Self { middle: plus(low, 1.0, half), radius: dot(half, half).sqrt().max(f64::MIN_POSITIVE) }
    }

    /// Side of a sample of a map, in units of length.
    pub fn sample(&self) -> f64 {
        2.0 * self.radius / (SIDE - 4) as f64
    }
}

/// The first surfaces hit by the light from one direction.
pub struct Map {
    /// Directions across the light.
    axes: [Vector; 2],
    /// Direction toward the light.
    pub toward: Vector,
    sphere: Sphere,
    /// By sample: the height toward the light of the first surface hit, in samples.
    heights: Vec<f32>,
}

impl Map {
    pub fn new(toward: Vector, sphere: Sphere, triangles: &[[Vector; 3]]) -> Self {
        let aside = if toward[1].abs() < 0.9 { [0.0, 1.0, 0.0] } else { [1.0, 0.0, 0.0] };
        let right = unit(cross(aside, toward));
        let mut map = Self { axes: [right, cross(toward, right)], toward, sphere, heights: Vec::new() };
        let mut samples = Samples::new(SIDE, 0..SIDE);
        for triangle in triangles {
            samples.draw(&triangle.map(|place| map.at(place)), 0);
        }
        map.heights = samples.near().iter().map(|near| *near as f32).collect();
        map
    }

    /// Place in the map, and height toward the light; all in samples.
    fn at(&self, place: Vector) -> [f64; 3] {
        let from = minus(place, self.sphere.middle);
        let scale = 1.0 / self.sphere.sample();
        let middle = 0.5 * SIDE as f64;
        [
            middle + scale * dot(from, self.axes[0]),
            middle + scale * dot(from, self.axes[1]),
            scale * dot(from, self.toward),
        ]
    }

    /// The surfaces hit, in squares with `samples` samples along each side: the mean place of each square and its area across the
    /// light.
    pub fn seen(&self, samples: usize) -> impl Iterator<Item = (Vector, f64)> {
        let squares = SIDE / samples;
        (0..squares * squares).filter_map(move |at| {
            let [column, row] = [at % squares, at / squares].map(|at| at * samples);
            let met = (0..samples * samples)
                .map(|at| [column + at % samples, row + at / samples])
                .filter_map(|[x, y]| {
                    let height = self.heights[y * SIDE + x];
                    height.is_finite().then(|| [x as f64 + 0.5, y as f64 + 0.5, f64::from(height)])
                });
            let (sum, count) =
                met.fold(([0.0; 3], 0.0), |(sum, count), met| (plus(sum, 1.0, met), count + 1.0));
            (count > 0.0).then(|| {
                let sample = self.sphere.sample();
                let [x, y, height] = sum.map(|sum| sum / count);
                let [x, y] = [x, y].map(|at| (at - 0.5 * SIDE as f64) * sample);
                let across = plus(plus(self.sphere.middle, x, self.axes[0]), y, self.axes[1]);
                (plus(across, height * sample, self.toward), count * sample * sample)
            })
        })
    }

    /// The share of the light that reaches a place, 0..1: the mean of the four samples around it.
    pub fn reaches(&self, place: Vector) -> f64 {
        let [x, y, height] = self.at(place);
        let [x, y] = [x - 0.5, y - 0.5];
        if !(x >= 0.0 && y >= 0.0 && x < (SIDE - 1) as f64 && y < (SIDE - 1) as f64) {
            return 1.0;
        }
        let [column, row] = [x as usize, y as usize];
        let [u, v] = [x - column as f64, y - row as f64];
        let lit = |at: usize| (1.0 - (f64::from(self.heights[at]) - height)).clamp(0.0, 1.0);
        let at = row * SIDE + column;
        let [above, below] = [at, at + SIDE].map(|at| lit(at) + u * (lit(at + 1) - lit(at)));
        above + v * (below - above)
    }
}

/// The maps of several directions.
pub fn maps(directions: &[Vector], sphere: Sphere, triangles: &[[Vector; 3]]) -> Vec<Map> {
    directions.par_iter().map(|toward| Map::new(*toward, sphere, triangles)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_roof_hides_what_is_under_it() {
        let roof = [[-1.0, 1.0, -1.0], [1.0, 1.0, -1.0], [0.0, 1.0, 1.0]];
        let sphere = Sphere::around([[-1.0, 0.0, -1.0], [1.0, 1.0, 1.0]]);
        let maps = maps(&[[0.0, 1.0, 0.0], unit([1.0, 0.05, 0.0])], sphere, &[roof]);
        let reaches = |place: Vector| [maps[0].reaches(place), maps[1].reaches(place)];
        assert_eq!(reaches([0.0, 0.0, 0.0]), [0.0, 1.0]);
        assert_eq!(reaches([0.9, 0.0, 0.9]), [1.0, 1.0]);
        assert_eq!(reaches([0.0, 1.1, 0.0]), [1.0, 1.0]);
    }
}
