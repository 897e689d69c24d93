//! One patch of the map, which is grown and then classified.

use dapple_engine::grid::resample::Spline;
use dapple_engine::grid::{Edges, Field};
use dapple_engine::rd::{Growth, ParameterField, Parameters, System};

/// Cells along a side, for five marks.
const CELLS: usize = 50;
/// Cells from mark to mark, the same as for layers.
const APART: f64 = 10.0;
/// px along a side.
pub const SIDE: usize = 48;
/// Normalised time: the share of ink is within 0.01 of its limit by then (`facts.md` V).
const TIME: f64 = 20.0;
/// px per cell where shares and pieces are counted: on single cells, the share of ink would be up to 0.04 too high
/// (`facts.md` V).
const FINE: usize = 4;
/// Seed of all patches. They all start alike, so that they can be compared.
const SEED: u64 = 1;
/// The pattern value of an edge, where b = 3.
const EDGE: f32 = 0.5;
/// A pattern with a smaller range than this has no marks.
const FLAT: f32 = 0.1;
/// The pattern value, for b = 27, above which b has diverged; this happens where b grows late, when there is much a. In
/// marks b is at most 20.
const BURST: f32 = 0.9;
/// A share of ink above this counts as all ink.
const ALL: f64 = 0.995;
/// Dots: the largest piece of ink has at most this share of all ink. Holes: the same for the ground.
const LARGEST: f64 = 0.15;

/// What grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// No pattern: b disappears, or diverges in some places.
    Empty,
    /// Separate pieces of ink.
    Dots,
    /// Neither ink nor ground is in separate pieces.
    Worms,
    /// Separate pieces of ground.
    Holes,
    /// No ground.
    Full,
}

impl Kind {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Empty => "nothing",
            Self::Dots => "dots",
            Self::Worms => "worms",
            Self::Holes => "holes",
            Self::Full => "all ink",
        }
    }
}

/// A patch that has grown.
pub struct Patch {
    /// The pattern b ÷ (b + 3) of [`SIDE`]² px.
    pub pattern: Vec<f32>,
    /// What has grown.
    pub kind: Kind,
    /// The share of ink.
    pub ink: f64,
}

impl Patch {
    /// Grows a patch, seamless.
    pub fn grown(growth: f32, decay: f32) -> Self {
        let system = System::with_growth();
        let root = (system.definition().laws.spacing)(1.0) / APART;
        let rate = (root * root) as f32;
        let parameters = Parameters { rate, ratio: 1.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };
        let maps = ParameterField::uniform([CELLS; 2], Edges::Wrap, parameters);
        let maps = ParameterField { g: vec![growth; CELLS * CELLS], decay: Some(decay), ..maps };
        let mut growth = Growth::new(system, &maps, SEED);
        let steps = growth.steps_in(TIME);
        growth.advance(steps);
        let marks = growth.marks();
        let fine = CELLS * FINE;
        let spline = Spline::new(&marks);
        let values = spline.rows(0..fine, fine, fine);
        let is_ink: Vec<bool> = values.iter().map(|value| *value >= EDGE).collect();
        let ink = is_ink.iter().filter(|ink| **ink).count() as f64 / is_ink.len() as f64;
        Self { pattern: spline.rows(0..SIDE, SIDE, SIDE), kind: kind(&marks, &is_ink, ink), ink }
    }
}

fn kind(marks: &Field, is_ink: &[bool], ink: f64) -> Kind {
    let [low, high] = [f32::min, f32::max].map(|of| marks.values.iter().copied().reduce(of).unwrap_or(0.0));
    if ink >= ALL || (high - low <= FLAT && ink > 0.5) {
        return Kind::Full;
    }
    if high - low <= FLAT || high > BURST || ink == 0.0 {
        return Kind::Empty;
    }
    let is_in_pieces = |ink: bool| {
        let sizes = pieces(is_ink, ink);
        let (all, largest) = (sizes.iter().sum::<usize>(), sizes.iter().copied().max().unwrap_or(0));
        largest as f64 <= LARGEST * all as f64
    };
    match [true, false].map(is_in_pieces) {
        [true, _] => Kind::Dots,
        [false, true] => Kind::Holes,
        [false, false] => Kind::Worms,
    }
}

/// The area, px, of each connected piece of `ink` (or of ground) on a seamless square.
fn pieces(is_ink: &[bool], ink: bool) -> Vec<usize> {
    let side = CELLS * FINE;
    let mut seen = vec![false; is_ink.len()];
    let mut sizes = Vec::new();
    for start in 0..is_ink.len() {
        if seen[start] || is_ink[start] != ink {
            continue;
        }
        let mut size = 0;
        seen[start] = true;
        let mut left = vec![start];
        while let Some(px) = left.pop() {
            size += 1;
            let [x, y] = [px % side, px / side];
            let beside = [(x + 1, y), (x + side - 1, y), (x, y + 1), (x, y + side - 1)];
            for (x, y) in beside {
                let next = y % side * side + x % side;
                if !seen[next] && is_ink[next] == ink {
                    seen[next] = true;
                    left.push(next);
                }
            }
        }
        sizes.push(size);
    }
    sizes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_growth_makes_dots_then_worms_then_holes_then_nothing_but_ink() {
        let found = [13.0, 18.0, 23.0, 27.5, 31.0].map(|growth| Patch::grown(growth, 20.0).kind);
        assert_eq!(found, [Kind::Empty, Kind::Dots, Kind::Worms, Kind::Holes, Kind::Full]);
    }

    #[test]
    fn pieces_are_counted_across_the_seam() {
        let side = CELLS * FINE;
        // A band along the seam, and a dot.
        let is_ink: Vec<bool> = (0..side * side)
            .map(|px| {
                let [x, y] = [px % side, px / side];
                y < 3 || y >= side - 3 || (x.abs_diff(50) < 4 && y.abs_diff(50) < 4)
            })
            .collect();
        assert_eq!(pieces(&is_ink, true), [6 * side, 49]);
        assert_eq!(pieces(&is_ink, false), [side * (side - 6) - 49]);
    }
}
