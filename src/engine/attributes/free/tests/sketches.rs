//! Sketches with fixed seeds.

use std::f64::consts::TAU;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::marks::{Ellipse, Line, Mark, Path};

pub const SIDE: f64 = 512.0;

pub fn ellipse(center: [f64; 2], area: f64, aspect: f64, angle: f64) -> Mark {
    Mark::Ellipse(Ellipse::from_area(center, area, aspect, angle))
}

pub fn line(from: [f64; 2], to: [f64; 2], width: f64) -> Mark {
    Mark::Line(Line { from, to, width })
}

/// The path through `at(t)` for t from 0 to 1.
pub fn curve(count: usize, width: f64, at: impl Fn(f64) -> [f64; 2]) -> Mark {
    Mark::Path(Path { points: (0..=count).map(|i| at(i as f64 / count as f64)).collect(), width })
}

/// A point `radius` px from the middle of the canvas.
pub fn polar(radius: f64, degrees: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(degrees.to_radians());
    [0.5 * SIDE + radius * c, 0.5 * SIDE + radius * s]
}

/// `count` ellipses on a circle about the middle of the canvas, turned by `turned` from its radii.
pub fn ring(count: usize, radius: f64, turned: f64) -> Vec<Mark> {
    let degrees = |i: usize| 360.0 * i as f64 / count as f64;
    (0..count).map(|i| ellipse(polar(radius, degrees(i)), 400.0, 0.45, degrees(i) + turned)).collect()
}

/// Random numbers of one seed.
pub struct Random(Pcg64Mcg);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.random_range(low..high)
    }

    pub fn count(&mut self, low: usize, high: usize) -> usize {
        self.0.random_range(low..=high)
    }

    /// Of mean 0 and variance 1.
    pub fn normal(&mut self) -> f64 {
        let (u, v) = (self.between(0.0, 1.0), self.between(0.0, TAU));
        (-2.0 * libm::log(1.0 - u)).sqrt() * libm::cos(v)
    }

    pub fn place(&mut self) -> [f64; 2] {
        [self.between(0.0, SIDE), self.between(0.0, SIDE)]
    }

    /// Places that keep some distance from each other.
    pub fn scatter(&mut self, count: usize) -> Vec<[f64; 2]> {
        let gap = 0.6 * SIDE / (count as f64).sqrt();
        let mut places: Vec<[f64; 2]> = Vec::new();
        while places.len() < count {
            let place = self.place();
            let far = |other: &[f64; 2]| (place[0] - other[0]).hypot(place[1] - other[1]) > gap;
            if places.iter().all(far) {
                places.push(place);
            }
        }
        places
    }

    /// Three clusters of marks that do not touch.
    fn clusters(&mut self) -> Vec<[f64; 2]> {
        let mut places: Vec<[f64; 2]> = Vec::new();
        for _ in 0..3 {
            let middle = [self.between(80.0, 432.0), self.between(80.0, 432.0)];
            for _ in 0..self.count(3, 8) {
                let place = self.near(middle, 35.0);
                if places.iter().all(|other| (place[0] - other[0]).hypot(place[1] - other[1]) > 20.0) {
                    places.push(place);
                }
            }
        }
        places
    }

    fn near(&mut self, [x, y]: [f64; 2], by: f64) -> [f64; 2] {
        [x + by * self.normal(), y + by * self.normal()]
    }
}

/// Ellipses in scatter, at uniformly random places, in a ring, an array, rows or clusters; alike, along circles, of random
/// shapes or in waves.
pub fn random_ellipses(seed: u64) -> Vec<Mark> {
    let mut random = Random::new(seed);
    let count = random.count(1, 30);
    let places: Vec<[f64; 2]> = match seed % 6 {
        0 => random.scatter(count.max(8)),
        1 => (0..count).map(|_| random.place()).collect(),
        2 => (0..count).map(|i| random.near(polar(150.0, 360.0 * i as f64 / count as f64), 4.0)).collect(),
        3 => (0..25)
            .map(|i| random.near([60.0 + 75.0 * (i % 5) as f64, 60.0 + 75.0 * (i / 5) as f64], 3.0))
            .collect(),
        4 => (0..8 * random.count(1, 3))
            .map(|i| random.near([40.0 + 55.0 * (i % 8) as f64, 100.0 + 100.0 * (i / 8) as f64], 3.0))
            .collect(),
        _ => random.clusters(),
    };
    let style = random.count(0, 3);
    let (area, aspect, angle) =
        (random.between(60.0, 1500.0), random.between(0.3, 0.9), random.between(0.0, 180.0));
    let mut mark = |place: [f64; 2]| {
        let [x, y] = [place[0] / SIDE - 0.5, place[1] / SIDE - 0.5];
        match style {
            0 => {
                let (size, shape) = (libm::exp(0.15 * random.normal()), 0.05 * random.normal());
                ellipse(place, area * size, (aspect + shape).clamp(0.2, 1.0), angle + 8.0 * random.normal())
            }
            1 => {
                let round = libm::atan2(y, x).to_degrees() + 90.0;
                ellipse(place, area * libm::exp(1.5 * x), (aspect + 0.2 * y).clamp(0.2, 1.0), round)
            }
            2 => {
                let (area, aspect) = (random.between(60.0, 1500.0), random.between(0.35, 1.0));
                ellipse(place, area, aspect, random.between(0.0, 180.0))
            }
            _ => ellipse(place, area * libm::exp(libm::sin(5.0 * x)), aspect, angle + 180.0 * x),
        }
    };
    places.into_iter().map(&mut mark).collect()
}

/// The kinds of [`random_strokes`].
pub const STROKES: [&str; 8] = [
    "lines side by side",
    "concentric arcs",
    "S-curves side by side",
    "a spiral",
    "concentric rings",
    "radiating lines",
    "chevrons",
    "a herringbone",
];

/// Strokes of kind `seed` mod 8, see [`STROKES`].
pub fn random_strokes(seed: u64) -> Vec<Mark> {
    let mut random = Random::new(seed);
    let width = random.between(4.0, 16.0);
    let period = width * random.between(1.8, 5.0);
    let count = random.count(2, 6);
    let angle = random.between(0.0, 360.0);
    let widths: Vec<f64> = (0..count).map(|_| width * libm::exp(0.1 * random.normal())).collect();
    let each = || (0..count).map(|k| (k as f64, widths[k]));
    match seed % 8 {
        0 => {
            let (s, c) = libm::sincos(angle.to_radians());
            let at = |t: f64, k: f64| [256.0 + t * c - k * period * s, 256.0 + t * s + k * period * c];
            each().map(|(k, width)| line(at(-110.0, k), at(110.0, k), width)).collect()
        }
        1 => each()
            .map(|(k, width)| curve(24, width, |t| polar((3.0 + k) * period, angle + 150.0 * t)))
            .collect(),
        2 => each()
            .map(|(k, width)| {
                curve(40, width, |t| [40.0 + 430.0 * t, 130.0 + period * k + 50.0 * libm::sin(TAU * t)])
            })
            .collect(),
        3 => vec![curve(120, width, |t| polar((1.5 + 2.5 * t) * period, angle + 900.0 * t))],
        4 => each().map(|(k, width)| curve(48, width, |t| polar((1.5 + k) * period, 360.0 * t))).collect(),
        5 => {
            let inner = (width * (count + 6) as f64 / 4.0).max(40.0);
            let degrees = |i: usize| angle + 360.0 * i as f64 / (count + 6) as f64;
            (0..count + 6).map(|i| line(polar(inner, degrees(i)), polar(210.0, degrees(i)), width)).collect()
        }
        6 => each()
            .map(|(k, width)| {
                let y = 80.0 + 1.3 * period * k;
                Mark::Path(Path { points: vec![[90.0, y], [256.0, y + 110.0], [420.0, y]], width })
            })
            .collect(),
        _ => (0..3)
            .flat_map(|column| each().map(move |(k, width)| (column, k, width)))
            .map(|(column, k, width)| {
                let (x, y) = (60.0 + 130.0 * f64::from(column), 80.0 + 1.3 * period * k);
                let [left, right] = if column % 2 == 0 { [0.0, 80.0] } else { [80.0, 0.0] };
                line([x, y + left], [x + 100.0, y + right], width)
            })
            .collect(),
    }
}
