//! The numbers that are measured on drawn marks, and their limits.

use super::Kind;
use super::attempt::Attempt;

/// A number that is measured on marks, at places along strokes, or on sketches.
pub struct Measure {
    /// Its name.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// The factor from a value to this unit.
    pub factor: f64,
    /// Its values in one sketch.
    pub values: fn(&Attempt) -> Vec<f64>,
    /// Limits of the median and the 95th percentile of its absolute value, in that unit.
    pub limits: fn(Kind) -> Option<[f64; 2]>,
}

/// The limits for kinds of sketches with ellipses; `None` for other kinds.
fn spots(kind: Kind, limits: [f64; 2]) -> Option<[f64; 2]> {
    (!kind.is_striped()).then_some(limits)
}

/// The limits for kinds of sketches with strokes; `None` for other kinds.
fn strokes(kind: Kind, limits: [f64; 2]) -> Option<[f64; 2]> {
    kind.is_striped().then_some(limits)
}

/// The mean difference of the aspects, over the ellipses that are there.
fn mean_aspect(attempt: &Attempt) -> Option<f64> {
    let all: Vec<f64> = attempt.spots.iter().filter_map(|spot| spot.aspect).collect();
    (!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64)
}

/// All measured numbers.
pub const MEASURES: [Measure; 8] = [
    Measure {
        name: "distance",
        unit: "radii",
        factor: 1.0,
        values: |attempt| attempt.spots.iter().filter_map(|spot| spot.distance).collect(),
        limits: |kind| spots(kind, [0.05, 0.2]),
    },
    Measure {
        name: "area",
        unit: "%",
        factor: 100.0,
        values: |attempt| attempt.spots.iter().filter_map(|spot| spot.area).collect(),
        limits: |kind| spots(kind, [5.0, 20.0]),
    },
    Measure {
        name: "aspect",
        unit: "",
        factor: 1.0,
        values: |attempt| attempt.spots.iter().filter_map(|spot| spot.aspect).collect(),
        limits: |kind| spots(kind, [0.03, 0.12]),
    },
    Measure {
        name: "mean aspect of a sketch",
        unit: "",
        factor: 1.0,
        values: |attempt| mean_aspect(attempt).into_iter().collect(),
        limits: |kind| (kind == Kind::C).then_some([0.02, 0.06]),
    },
    Measure {
        name: "angle",
        unit: "°",
        factor: 1.0,
        values: |attempt| attempt.spots.iter().filter_map(|spot| spot.angle).collect(),
        limits: |kind| spots(kind, [2.0, 8.0]),
    },
    Measure {
        name: "direction along strokes",
        unit: "°",
        factor: 1.0,
        values: |attempt| attempt.strokes.iter().flat_map(|stroke| stroke.directions.clone()).collect(),
        limits: |kind| strokes(kind, [4.0, 15.0]),
    },
    Measure {
        name: "period",
        unit: "%",
        factor: 100.0,
        values: |attempt| attempt.strokes.iter().flat_map(|stroke| stroke.periods.clone()).collect(),
        limits: |kind| strokes(kind, [4.0, 12.0]),
    },
    Measure {
        name: "width",
        unit: "%",
        factor: 100.0,
        values: |attempt| attempt.strokes.iter().filter_map(|stroke| stroke.width).collect(),
        limits: |kind| strokes(kind, [3.0, 10.0]),
    },
];

/// The largest allowed share of missing marks.
pub const MISSING: f64 = 0.01;
/// The largest allowed CPU time with the default spread ÷ that without spread.
pub const SLOWER: f64 = 4.0;
/// The largest allowed CPU time of a sketch, s.
pub const SECONDS: f64 = 8.0;
