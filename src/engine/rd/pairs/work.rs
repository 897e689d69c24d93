//! The work of a growth of pairs, estimated before it begins.
//!
//! The time of a step falls with the square of the largest size, and the number of cells grows with the square of the smallest: the
//! work goes with the fourth power of the ratio of the sizes.

use super::Blurs;
use super::own_grids::OwnGrids;
use super::shared_grid::{STEP_LIMIT, SUPER_STEP_LIMIT};
use crate::rd::super_step::{euler_steps_a_stage, suited};

/// Work of a super step on grids of their own in addition to the stages, in updates of each cell of the finest grid by each pair:
/// the difference is interpolated there, and the reaction is averaged.
const AROUND: f64 = 10.0;

/// The sizes of one pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// The smallest and the largest s, cells.
    pub range: [f64; 2],
    /// The form of its blurs.
    pub blurs: Blurs,
}

impl Sizes {
    /// The sizes of a pair with one size everywhere.
    #[must_use]
    pub fn even(size: f64, blurs: Blurs) -> Self {
        Self { range: [size; 2], blurs }
    }

    /// Longest stable Euler step, in 1/b, on cells that are `larger` times as large. The weights of a stencil add up to at most the
    /// trace of its tensor.
    fn step(&self, ratio: f64, larger: f64) -> f32 {
        let lengths = self.blurs.lengths(ratio);
        let square = |[along, across]: [f64; 2]| along * along + across * across;
        let largest = square(lengths[0]).max(square(lengths[1])) * (self.range[1] / larger).powi(2);
        STEP_LIMIT / (4.0 * largest as f32 + 1.0)
    }
}

/// Updates of one morphogen in one cell in a growth for `time`, in 1/b, on a grid of this number of `cells`. `ratio` is that of the
/// model. `shared`: all pairs are on one grid, as they are with obstacle cells.
#[must_use]
pub fn updates(cells: f64, pairs: &[Sizes], ratio: f64, time: f64, shared: bool) -> f64 {
    let least = pairs.iter().map(|pair| pair.range[0]);
    let (finest, coarsest) = (least.clone().fold(f64::INFINITY, f64::min), least.fold(0.0, f64::max));
    if shared || !OwnGrids::are_worth(finest, coarsest) {
        let step = pairs.iter().map(|pair| pair.step(ratio, 1.0)).fold(f32::INFINITY, f32::min);
        let stage = f64::from(step) * euler_steps_a_stage(suited(step, SUPER_STEP_LIMIT));
        return 2.0 * pairs.len() as f64 * cells * (time / stage).ceil();
    }
    let of_pair = |pair: &Sizes| {
        let larger = OwnGrids::coarser(pair.range[0]);
        let step = pair.step(ratio, larger);
        // The root of s² + s = 2n, rounded up.
        let stages = (0.5 * ((8.0 * f64::from(SUPER_STEP_LIMIT / step) + 1.0).sqrt() - 1.0)).ceil().max(1.0);
        2.0 * stages * cells / (larger * larger) + AROUND * cells
    };
    (time / OwnGrids::STEP).ceil() * pairs.iter().map(of_pair).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Domain, Edges, Grid};
    use crate::rd::pairs::{PairField, PairGrowth, PairParameterField, PairStart, polygons};

    const TIME: f64 = 4.0;
    const ROUND: Blurs = Blurs::Round;

    /// Steps that a growth of pairs of these sizes takes.
    fn steps(sizes: &[[f64; 2]]) -> f64 {
        let grid = Grid::unit([48, 40], Edges::Closed);
        let pair = |[small, large]: &[f64; 2]| {
            let mut pair = PairField::uniform(grid.cells(), 0.0, *small as f32, ROUND);
            pair.size[7] = *large as f32;
            pair
        };
        let pairs = sizes.iter().map(pair).collect();
        let maps = PairParameterField { grid, pairs, obstacles: Vec::new(), raised: Vec::new() };
        let growth = PairGrowth::new(&maps, &polygons::model(), &PairStart::Noise(1)).expect("pairs");
        growth.steps_in(TIME) as f64
    }

    fn predicted(sizes: &[[f64; 2]]) -> f64 {
        let sizes: Vec<Sizes> = sizes.iter().map(|range| Sizes { range: *range, blurs: ROUND }).collect();
        updates(48.0 * 40.0, &sizes, 1.5, TIME, false)
    }

    #[test]
    fn the_work_on_one_grid_is_known_before_it_begins() {
        for sizes in [vec![[1.75, 1.75]], vec![[1.75, 40.0]], vec![[2.0, 9.0], [2.2, 3.0]]] {
            let taken = steps(&sizes) * 2.0 * sizes.len() as f64 * 48.0 * 40.0;
            let predicted = predicted(&sizes);
            assert!((predicted / taken - 1.0).abs() < 0.02, "{sizes:?}: {predicted}, {taken}");
        }
    }

    #[test]
    fn pairs_on_grids_of_their_own_take_less_work_than_on_one_grid() {
        let sizes = [Sizes::even(1.75, ROUND), Sizes::even(14.0, ROUND)];
        let [own, one] = [false, true].map(|shared| updates(1e4, &sizes, 1.5, TIME, shared));
        assert!(own < 0.2 * one, "{own}, {one}");
        // The finer pair alone takes stages on all of its grid.
        assert!(own > (TIME / OwnGrids::STEP) * 2.0 * 1e4, "{own}");
    }
}
