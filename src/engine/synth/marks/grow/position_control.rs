//! Drawn marks are moved back to their places while they form.
//!
//! ```text
//!  spots ──▶ spot control ───┐
//!                            ├─▶ warps (rd) ─▶ the pattern goes on growing
//!  strokes ─▶ stroke control ┘
//! ```

use crate::grid::{Field, Grid};
use crate::rd::{LocalWarp, ParameterField};
use crate::synth::marks::grow::corrections::Corrections;
use crate::synth::marks::grow::spot_control::SpotControl;
use crate::synth::marks::grow::stroke_control::StrokeControl;
use crate::synth::marks::plan::laid_out::Plan;

/// Normalised time between two corrections of strokes: in a time of 2, the tension of a stripe pulls it across a bent stroke by
/// about 0.1 periods.
const STROKES_EVERY: f64 = 0.5;
/// Normalised time between two corrections of spots, which push each other. With 0.5 (and 1 for spots that hardly move) a sketch of
/// 18 spots took a tenth more time to grow, and the mean errors of 115 documents at 300 px hardly differed (area 1.77 instead of
/// 1.61 %, spacing 3.74 instead of 3.77 %).
const SPOTS_EVERY: f64 = 0.75;
/// Normalised time between two corrections of spots that hardly move.
const CALM_SPOTS_EVERY: f64 = 1.5;

/// The intended and the current places of the drawn marks of a layer.
#[derive(Clone, Debug)]
pub enum PositionControl {
    /// Control of spots.
    Spots(SpotControl),
    /// Control of lines and paths.
    Strokes(StrokeControl),
}

impl PositionControl {
    /// `None` where no mark is pinned.
    #[must_use]
    pub fn new(plan: &Plan, corrections: &Corrections) -> Option<Self> {
        let strokes = || StrokeControl::new(plan).map(Self::Strokes);
        SpotControl::new(plan, corrections).map(Self::Spots).or_else(strokes)
    }

    /// Whether the marks never rest, because they push each other while they are moved back.
    #[must_use]
    pub fn keeps_moving(&self) -> bool {
        matches!(self, Self::Spots(_))
    }

    /// Normalised time until the next correction.
    #[must_use]
    pub fn every(&self) -> f64 {
        match self {
            Self::Spots(spots) if spots.is_calm() => CALM_SPOTS_EVERY,
            Self::Spots(_) => SPOTS_EVERY,
            Self::Strokes(_) => STROKES_EVERY,
        }
    }

    /// Warps that move the marks in `field`, grown in `maps`, towards their places; none where no mark has to move.
    #[must_use]
    pub fn warps(&mut self, field: &Field, maps: &ParameterField) -> Vec<LocalWarp> {
        match self {
            Self::Spots(spots) => spots.warps(field, maps),
            Self::Strokes(strokes) => strokes.warps(field, maps),
        }
    }

    /// Assumes that the `lost` spots are at their places again. Returns where they were last seen, cells of `grid`.
    pub fn forget(&mut self, lost: &[usize], grid: &Grid) -> Vec<[f64; 2]> {
        match self {
            Self::Spots(spots) => spots.forget(lost, grid),
            Self::Strokes(_) => Vec::new(),
        }
    }
}
