//! The light on a model: a soft key light from above left of the viewer, and a sky that is darker toward the floor. Both cast soft
//! shadows.

use std::f64::consts::TAU;
use std::ops::Range;

use super::shadow::{Map, Sphere, maps};
use super::vector::{Vector, cross, dot, plus, unit};

/// Number of directions of the sky.
const SKY: usize = 40;
/// Number of directions of the key light.
const KEY: usize = 16;
/// The radius of the key light, as a tangent.
const WIDTH: f64 = 0.22;
/// The light of the sky on surfaces that face upward, and of the key light on surfaces that face it.
pub const STRENGTHS: [f64; 2] = [0.40, 0.78];
/// The light from the floor, as a share of the sky's.
const FROM_THE_FLOOR: f64 = 0.36;

/// All lights with their shadows.
pub struct Lights {
    maps: Vec<Map>,
    /// For each map, its light on surfaces that face it.
    strengths: Vec<f64>,
    sphere: Sphere,
}

/// Directions that are spread evenly over the sphere (a Fibonacci lattice).
fn spread(count: usize) -> impl Iterator<Item = Vector> {
    (0..count).map(move |at| {
        let height = 1.0 - (2 * at + 1) as f64 / count as f64;
        let (sin, cos) = libm::sincos(TAU * 0.618_033_988_749_894_9 * at as f64);
        let radius = (1.0 - height * height).sqrt();
        [radius * cos, height, radius * sin]
    })
}

impl Lights {
    /// `axes`: rightward, upward, and toward the viewer.
    pub fn new(axes: [Vector; 3], sphere: Sphere, triangles: &[[Vector; 3]]) -> Self {
        let mut directions: Vec<Vector> = spread(SKY).collect();
        let radiance =
            |toward: &Vector| FROM_THE_FLOOR + (1.0 - FROM_THE_FLOOR) * (0.5 + 0.5 * toward[1]).sqrt();
        let mut strengths: Vec<f64> = directions.iter().map(radiance).collect();
        let upward: f64 =
            directions.iter().zip(&strengths).map(|(toward, strength)| strength * toward[1].max(0.0)).sum();
        strengths.iter_mut().for_each(|strength| *strength *= STRENGTHS[0] / upward);
        let level = unit([axes[2][0], 0.0, axes[2][2]]);
        let key = unit(plus(plus([0.0, 1.05, 0.0], -0.62, axes[0]), 0.75, level));
        let right = unit(cross([0.0, 1.0, 0.0], key));
        let above = cross(key, right);
        for at in 0..KEY {
            let radius = WIDTH * ((at as f64 + 0.5) / KEY as f64).sqrt();
            let (sin, cos) = libm::sincos(TAU * 0.618_033_988_749_894_9 * at as f64);
            directions.push(unit(plus(plus(key, radius * cos, right), radius * sin, above)));
            strengths.push(STRENGTHS[1] / KEY as f64);
        }
        Self { maps: maps(&directions, sphere, triangles), strengths, sphere }
    }

    /// The light on a place with this normal.
    pub fn on(&self, place: Vector, normal: Vector) -> f64 {
        // Slightly off the surface, so that the surface does not shade itself.
        let place = plus(place, 1.5 * self.sphere.sample(), normal);
        self.sum(normal, &(0..SKY + KEY), |map| map.reaches(place))
    }

    /// The light on a normal without shadows.
    pub fn free(&self, normal: Vector) -> f64 {
        self.sum(normal, &(0..SKY + KEY), |_| 1.0)
    }

    /// The key light on a place of the floor.
    pub fn key_on_floor(&self, place: Vector) -> f64 {
        self.sum([0.0, 1.0, 0.0], &(SKY..SKY + KEY), |map| map.reaches(place))
    }

    /// The key light on the floor far from the model.
    pub fn free_key_on_floor(&self) -> f64 {
        self.sum([0.0, 1.0, 0.0], &(SKY..SKY + KEY), |_| 1.0)
    }

    fn sum(&self, normal: Vector, lights: &Range<usize>, reaches: impl Fn(&Map) -> f64) -> f64 {
        let all = self.maps.iter().zip(&self.strengths);
        let facing = all
            .take(lights.end)
            .skip(lights.start)
            .map(|(map, strength)| (map, strength * dot(map.toward, normal)));
        facing.filter(|(_, light)| *light > 0.0).map(|(map, light)| light * reaches(map)).sum()
    }
}
