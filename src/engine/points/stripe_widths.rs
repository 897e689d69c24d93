//! The widths of stripes and of the gaps between them, from the depths inside their edges.

use rayon::prelude::*;

use super::depth::Edges;
use crate::grid::blur::boxes;
use crate::grid::{Field, Grid};

/// Radius of the window in which widths are averaged, in periods: a period and a half across, so that it holds whole stripes and
/// gaps.
const WINDOW: f64 = 0.75;

/// The depth of each cell of `stripes`, 0..1 with edges at ½, inside the edge, px, negative outside; `None` without edges.
#[must_use]
pub fn depths(stripes: &Field) -> Option<Vec<f32>> {
    let edges = Edges::new(stripes)?;
    let depth = |cell: usize| edges.depth(cell).map_or(0.0, |(depth, _)| depth as f32);
    Some((0..stripes.values.len()).into_par_iter().map(depth).collect())
}

/// Widths of stripes and gaps around each place.
pub struct StripeWidths {
    /// Half widths of the stripes, and of the gaps between them, px.
    pub halves: [Vec<f32>; 2],
    /// Their means.
    pub mean: [f64; 2],
}

impl StripeWidths {
    /// The widths of stripes whose cells have these `depths`.
    #[must_use]
    pub fn new(depths: &[f32], grid: &Grid) -> Self {
        // The mean depth of a stripe is half of its half width.
        let sides = [1.0f32, -1.0].map(|side| {
            let within: Vec<f32> =
                depths.iter().map(|depth| f32::from(u8::from(side * depth > 0.0))).collect();
            let deep: Vec<f32> = depths.iter().map(|depth| (side * depth).max(0.0)).collect();
            (deep, within)
        });
        let sum = |values: &[f32]| values.iter().map(|value| f64::from(*value)).sum::<f64>();
        let mean = [0, 1].map(|side| 2.0 * sum(&sides[side].0) / sum(&sides[side].1).max(1.0));
        let window = WINDOW * 2.0 * (mean[0] + mean[1]) / grid.px_a_cell();
        let window = (window.round() as usize).clamp(1, grid.size[0].min(grid.size[1]));
        let halves = [0, 1].map(|side| {
            let (deep, within) = &sides[side];
            let [deep, within] = [deep, within].map(|values| boxes(values, grid.size, grid.edges, window));
            let half = |(deep, within): (&f32, &f32)| {
                if *within > 1e-3 { (2.0 * deep / within).max(1e-3) } else { mean[side] as f32 }
            };
            deep.iter().zip(&within).map(half).collect()
        });
        Self { halves, mean }
    }

    /// The mean distance of the stripes, px.
    #[must_use]
    pub fn period(&self) -> f64 {
        2.0 * (self.mean[0] + self.mean[1])
    }
}
