//! Thresholds of single spots: the last per cents of the area of each drawn spot come from the threshold of its own edge.
//!
//! ```text
//! ln f(x) = Σₖ wₖ ln fₖ ÷ (w₀ + Σₖ wₖ),  wₖ = exp(−2 qₖ²)
//! ```
//!
//! qₖ is the distance from the centre of grown spot k ÷ its radius in that direction: 1 at its edge. fₖ is 1 for spots that
//! were not drawn.

use std::ops::Range;

use multiversion::multiversion;
use rayon::prelude::*;

use crate::grid::{Domain, Grid, exp};
use crate::measure::Spot;

/// w₀: from twice the radius on, a spot's own factor decreases.
const GROUND: f64 = 3.4e-4;
/// Distance from which on a spot has no weight, in radii.
const REACH: f64 = 3.0;

/// Factors of the threshold at every cell of `grid`, whose size is that of the canvas in px, from spots with a factor.
#[must_use]
pub fn own_levels(grid: &Grid, spots: &[(&Spot, f64)]) -> Vec<f64> {
    let kernels: Vec<Kernel> = spots.iter().map(|(spot, factor)| Kernel::new(spot, *factor, grid)).collect();
    let mut levels = vec![0.0; grid.cells()];
    let part = grid.part();
    levels.par_chunks_mut(part).enumerate().for_each(|(index, levels)| {
        let cells = index * part..index * part + levels.len();
        let (mut sums, mut weights) = (vec![(GROUND, 0.0); levels.len()], Vec::new());
        for kernel in kernels.iter().filter(|kernel| grid.may_reach(kernel.at, kernel.far, &cells)) {
            kernel.add(grid, &cells, &mut weights, &mut sums);
        }
        // Most cells are far from all spots with a factor.
        let level = |(weight, sum): (f64, f64)| if sum == 0.0 { 1.0 } else { exp(sum / weight) };
        levels.iter_mut().zip(sums).for_each(|(own, sums)| *own = level(sums));
    });
    levels
}

/// The weights of a spot.
struct Kernel {
    /// Its centre, cells.
    at: [f64; 2],
    /// Its radii, px.
    radii: [f64; 2],
    /// Cosine and sine of its angle.
    axis: [f64; 2],
    /// Distance beyond which cells have no weight, cells.
    far: f64,
    /// ln f.
    log_factor: f64,
}

impl Kernel {
    fn new(spot: &Spot, factor: f64, grid: &Grid) -> Self {
        let (radii, angle) = (spot.ellipse.radii, spot.ellipse.angle.to_radians());
        Self {
            at: grid.to_cells(spot.ellipse.center),
            radii,
            axis: [libm::cos(angle), libm::sin(angle)],
            far: REACH * radii[0].max(radii[1]) / grid.px_a_cell() + 1.0,
            log_factor: libm::log(factor),
        }
    }

    /// Adds w and w ln f to the `sums` of these cells. `weights` is a buffer.
    fn add(&self, grid: &Grid, cells: &Range<usize>, weights: &mut Vec<f64>, sums: &mut [(f64, f64)]) {
        for (run, displacement) in grid.runs_near(self.at, self.far, cells.clone()) {
            weights.resize(run.len(), 0.0);
            side_by_side(self, grid.cell, displacement, weights);
            let sums = &mut sums[run.start - cells.start..run.end - cells.start];
            for ((total, sum), weight) in sums.iter_mut().zip(weights.iter()) {
                *total += weight;
                *sum += weight * self.log_factor;
            }
        }
    }
}

/// The weights at adjacent cells with sides `cell`, px; the first one is at `displacement`, cells.
#[multiversion(targets("x86_64+avx2"))]
fn side_by_side(kernel: &Kernel, cell: [f64; 2], displacement: [f64; 2], weights: &mut [f64]) {
    let ([a, b], [c, s]) = (kernel.radii, kernel.axis);
    for (k, weight) in weights.iter_mut().enumerate() {
        let (x, y) = ((displacement[0] + k as f64) * cell[0], displacement[1] * cell[1]);
        let (along, across) = ((x * c + y * s) / a, (y * c - x * s) / b);
        let q2 = along * along + across * across;
        *weight = if q2 < REACH * REACH { exp(-2.0 * q2) } else { 0.0 };
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::marks::Ellipse;

    #[test]
    fn a_spot_has_its_own_level_up_to_its_edge_and_another_keeps_its_own() {
        let grid = Grid { size: [60, 40], cell: [2.0, 2.0], edges: Edges::Closed };
        let spot = |x: f64| Spot {
            ellipse: Ellipse::from_area([x, 40.0], 314.0, 1.0, 0.0),
            whole: true,
            endless: false,
            contour: 0.0,
            fill: 1.0,
            peak: 1.0,
        };
        let (one, other) = (spot(31.0), spot(71.0));
        let levels = own_levels(&grid, &[(&one, 1.2), (&other, 1.0)]);
        let at = |x: usize| levels[20 * 60 + x];
        assert!((at(15) - 1.2).abs() < 1e-3 && (at(19) - 1.2).abs() < 0.01, "{} {}", at(15), at(19));
        assert!((at(35) - 1.0).abs() < 1e-6 && (at(31) - 1.0).abs() < 0.01, "{} {}", at(35), at(31));
        assert!((at(55) - 1.0).abs() < 1e-3);
    }
}
