//! Concentrations of lines along curves, as a share of the peak of lines nearby.

use crate::grid::Grid;
use rayon::prelude::*;

use crate::grid::blur::boxes;
use crate::synth::marks::plan::offset_curves::{Curves, blur_radius};

/// Share of the usual peak below which a line counts as vanished, and is not raised.
pub const LEAST: f32 = 0.2;

impl Curves {
    /// The concentration `marks` as a share of the peak of lines nearby: lines are lower where three meet, and where other lines or
    /// marks are close. `width` is the width of the lines, px.
    #[must_use]
    pub fn levelled(&self, marks: &[f32], grid: &Grid, width: &[f32]) -> Vec<f32> {
        // A quarter of the width: where lines meet, the height of the saddle between them is used, not the height of the lines.
        let radius = (blur_radius(width, grid) / 2).max(1);
        let highest = highest(marks, grid, radius);
        let on = |value: &dyn Fn(usize) -> f32| -> Vec<f32> {
            self.curve.iter().enumerate().map(|(cell, on)| if *on { value(cell) } else { 0.0 }).collect()
        };
        let peaks = boxes(&on(&|cell| highest[cell].max(LEAST)), grid.size, grid.edges, radius);
        let there = boxes(&on(&|_| 1.0), grid.size, grid.edges, radius);
        marks
            .par_iter()
            .zip(peaks.par_iter().zip(&there))
            .map(|(mark, (peak, there))| if *there > 1e-6 { mark * there / peak } else { *mark })
            .collect()
    }
}

/// The highest of `values` within `radius` cells along x and y.
fn highest(values: &[f32], grid: &Grid, radius: usize) -> Vec<f32> {
    let [nx, ny] = grid.size;
    let reach = radius as isize;
    let along = |values: &[f32], at: &(dyn Fn(usize, isize) -> usize + Sync)| -> Vec<f32> {
        (0..nx * ny)
            .into_par_iter()
            .map(|cell| (-reach..=reach).map(|i| values[at(cell, i)]).fold(f32::NEG_INFINITY, f32::max))
            .collect()
    };
    let rows = along(values, &|cell, i| cell - cell % nx + grid.edges.index((cell % nx) as isize + i, nx));
    along(&rows, &|cell, i| grid.edges.index((cell / nx) as isize + i, ny) * nx + cell % nx)
}
