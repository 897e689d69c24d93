//! Moving single spots, or pieces of stripes, of a pattern while it grows.
//!
//! ```text
//! c′(x) = c(x − Σₖ wₖ sₖ Δₖ ÷ Σₖ sₖ),  sₖ = exp(−dₖ² ÷ 2τ²)
//! ```
//!
//! dₖ is the distance from spot k in its own metric, in pitches of the room that it needs itself; wₖ is 1 up to the inner
//! distance, 0 from the outer on, smooth between. The sums are over all spots, those that stay (Δₖ = 0) included, so that a
//! spot does not take its neighbours along. All chemicals move alike: only the ground between spots is drawn out.

use crate::grid::resample::Spline;
use crate::grid::{Domain, Field, Grid, turned};
use crate::rd::System;
use crate::rd::maps::{Maps, Parameters};
use crate::rd::nucleus::Nucleus;
use crate::rd::prolongation::within_range;
use crate::rd::shepard::TAU;

/// A spot to move, or to keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalWarp<P = [f64; 2]> {
    /// Its place, cells.
    pub at: P,
    /// The parameters at its place, in the frame of this place.
    pub own: Parameters,
    /// The displacement, cells, in the frame of its place.
    pub by: [f64; 2],
}

/// Up to this distance, pitches, everything moves together: a spot reaches to 0.2–0.28 pitches.
const INNER: f64 = 0.3;
/// Beyond this nothing moves: slightly more than half way to the nearest neighbours.
const OUTER: f64 = 0.6;

/// The cells of a chemical with these spots moved.
#[must_use]
pub fn warped(system: System, maps: &Maps, chemical: &[f32], warps: &[LocalWarp]) -> Vec<f32> {
    let shifts = shifts(system, maps, warps);
    let field = Field::new(&Grid::unit(maps.domain.size, maps.domain.edges), chemical.to_vec());
    let surface = Spline::new(&field);
    let mut cells = chemical.to_vec();
    for (cell, [x, y]) in shifts {
        let [to_x, to_y] = maps.domain.center(cell);
        let from = [to_x - x, to_y - y];
        cells[cell] = within_range(surface.at(from), &field, from);
    }
    cells
}

/// The cells whose content moves, with their displacements in the frame of each.
pub(super) fn shifts<D: Domain>(
    system: System,
    maps: &Maps<D>,
    warps: &[LocalWarp<D::Place>],
) -> Vec<(usize, [f64; 2])> {
    let domain = &maps.domain;
    let mut sums = vec![[0.0f64; 3]; domain.cells()];
    for LocalWarp { at, own, by } in warps {
        let spot = Nucleus::new(own, domain, domain.cell_at(*at), *at, system.spacing(own)).alone();
        for (cell, delta) in domain.near(*at, OUTER * spot.reach, 0..domain.cells()) {
            let distance2 = spot.distance2(delta);
            let weight = fading(distance2.sqrt(), [INNER, OUTER]);
            if weight > 0.0 && !maps.is_obstacle(cell) {
                let share = libm::exp(-0.5 * distance2 / (TAU * TAU));
                let by = turned(*by, domain.turn(spot.cell, cell));
                let [x, y, total] = &mut sums[cell];
                *x += share * weight * by[0];
                *y += share * weight * by[1];
                *total += share;
            }
        }
    }
    let moved = sums.into_iter().enumerate().filter(|(_, [x, y, _])| *x != 0.0 || *y != 0.0);
    moved.map(|(cell, [x, y, total])| (cell, [x / total, y / total])).collect()
}

/// 1 up to the inner distance, 0 from the outer one on, smooth between.
pub(super) fn fading(distance: f64, [inner, outer]: [f64; 2]) -> f64 {
    let t = ((outer - distance) / (outer - inner)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    const P: Parameters = Parameters { rate: 3.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };

    /// A bell at a place on a ground of 1, on 60 × 50 cells.
    fn bell(at: [f64; 2]) -> Vec<f32> {
        let maps = Maps::uniform([60, 50], Edges::Closed, P);
        let cell = |cell| {
            let [x, y] = maps.domain.center(cell);
            let away2 = (x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1]);
            1.0 + 5.0 * libm::exp(-0.5 * away2 / 6.0) as f32
        };
        (0..60 * 50).map(cell).collect()
    }

    #[test]
    fn a_moved_spot_is_at_its_new_place_and_everything_else_is_unchanged() {
        for (edges, at) in [(Edges::Closed, [30.0, 25.0]), (Edges::Wrap, [1.0, 25.0])] {
            let maps = Maps::uniform([60, 50], edges, P);
            let warp = LocalWarp { at, own: P, by: [1.3, -0.8] };
            let moved = warped(System::MEINHARDT_SPOTS, &maps, &bell(at), &[warp]);
            if edges == Edges::Closed {
                let wanted = bell([31.3, 24.2]);
                let worst = moved.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(worst < 0.06, "{worst}");
            }
            let still = moved.iter().zip(&bell(at)).filter(|(a, b)| a.to_bits() == b.to_bits()).count();
            assert!(still > 60 * 50 / 2, "{still}");
        }
    }

    #[test]
    fn obstacle_cells_are_unchanged() {
        let mut maps = Maps::uniform([60, 50], Edges::Closed, P);
        maps.obstacles = (0..60 * 50).map(|cell| cell % 60 > 31).collect();
        let warp = LocalWarp { at: [30.0, 25.0], own: P, by: [1.0, 0.0] };
        let before = bell([30.0, 25.0]);
        let moved = warped(System::MEINHARDT_SPOTS, &maps, &before, &[warp]);
        let same = |cell: &usize| moved[*cell].to_bits() == before[*cell].to_bits();
        assert!((0..60 * 50).filter(|cell| maps.obstacles[*cell]).all(|cell| same(&cell)));
        assert!((0..60 * 50).any(|cell| !same(&cell)));
    }
}
