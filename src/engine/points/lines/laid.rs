//! The points of lines with their labels, and the field between them.

use crate::grid::{Field, Grid};
use crate::points::appearance::Appearance;
use crate::points::delaunay::Delaunay;
use crate::points::interpolation::{Weights, interpolate};

/// L of the interpolation, the same as for patches.
const LENGTH: f64 = 1.2;

/// The points of lines.
pub struct LaidLines {
    pub(super) graph: Delaunay,
    pub(super) values: Vec<f32>,
    /// The points from which the lines appear in a film.
    pub(super) starts: Vec<usize>,
}

impl LaidLines {
    /// The interpolated labels on `grid`, 0..1: lines above a level.
    #[must_use]
    pub fn field(&self, grid: &Grid) -> Field {
        self.spread(&self.values, grid)
    }

    /// The order in which the lines appear: streaks from their middles, cracks from some of the knots.
    #[must_use]
    pub fn appearance(&self) -> Appearance {
        Appearance::along(&self.graph, &self.values, &self.starts)
    }

    /// The labels on `grid` at the time `share`, 0..1, of the film in which they appear.
    #[must_use]
    pub fn appearing(&self, appearance: &Appearance, share: f64, grid: &Grid) -> Field {
        self.spread(&appearance.at(&self.values, share), grid)
    }

    fn spread(&self, values: &[f32], grid: &Grid) -> Field {
        interpolate(&self.graph, values, grid, &Weights { length: LENGTH, ..Weights::default() })
    }
}

/// For each chain, the point that is nearest to the mean of its points. A chain across the border of a tile may start at its end.
pub(super) fn middles(graph: &Delaunay, owner: &[Option<u32>]) -> Vec<usize> {
    let chains = owner.iter().flatten().max().map_or(0, |last| *last as usize + 1);
    let mut sums = vec![([0.0; 2], 0.0); chains];
    let of = |point: usize| owner[point].map(|chain| (chain as usize, graph.points[point]));
    for (chain, at) in (0..owner.len()).filter_map(of) {
        let (sum, count) = &mut sums[chain];
        (*sum, *count) = ([sum[0] + at[0], sum[1] + at[1]], *count + 1.0);
    }
    let mut nearest = vec![(f64::INFINITY, 0); chains];
    for (point, (chain, at)) in (0..owner.len()).filter_map(|point| Some((point, of(point)?))) {
        let (sum, count) = sums[chain];
        let square = (at[0] - sum[0] / count).powi(2) + (at[1] - sum[1] / count).powi(2);
        if square < nearest[chain].0 {
            nearest[chain] = (square, point);
        }
    }
    nearest.into_iter().map(|(_, point)| point).collect()
}
