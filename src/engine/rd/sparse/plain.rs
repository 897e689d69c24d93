//! The plain solver: explicit steps, row by row. The fast solver is tested against it.

use super::layout::layout;
use super::problem::SparseProblem;
use super::sparse_rows::SparseRows;
use crate::rd::kinetics::{Kinetics, stepped};
use crate::rd::super_step::Stage;

/// Takes one stage, from `old` into `new`, which holds the chemicals before `old`; in the first stage its contents do not
/// matter.
pub fn step<const N: usize, K: Kinetics<N>>(
    problem: &SparseProblem,
    kinetics: &K,
    stage: Stage,
    old: &[Vec<[f32; 2]>],
    new: &mut [Vec<[f32; 2]>],
) {
    let layout = const { layout::<N, K>() };
    for row in 0..problem.operators.vertices() {
        let (mut u, mut from, mut spread) = ([0.0; N], [0.0; N], [0.0; N]);
        for pair in 0..layout.count {
            let own = old[pair][row];
            let sums = layout.operators[pair]
                .map_or([0.0; 2], |operator| spread_of(&problem.operators.rows[operator], &old[pair], row));
            for i in 0..2 {
                let chemical = layout.pairs[pair][i];
                if chemical < N {
                    u[chemical] = own[i];
                    spread[chemical] = sums[i];
                    from[chemical] = own[i];
                    if !stage.is_first() {
                        from[chemical] = own[i] + stage.repeated * (own[i] - new[pair][row][i]);
                    }
                }
            }
        }
        let mobility = [stage.weight * problem.mobility[0][row], stage.weight * problem.mobility[1][row]];
        let next =
            stepped::<N, K, f32>(kinetics, [u, from], spread, mobility, stage.weight * problem.rate[row]);
        for (to, [a, b]) in new.iter_mut().zip(layout.pairs) {
            to[row] = [next[a], if b < N { next[b] } else { 0.0 }];
        }
    }
}

/// The diffusion term of both chemicals of a pair at one row, without mobility.
#[inline]
fn spread_of(rows: &SparseRows, values: &[[f32; 2]], row: usize) -> [f32; 2] {
    let entries = rows.row(row);
    let own = values[row];
    let mut sums = [0.0; 2];
    for (weight, column) in rows.weights[entries.clone()].iter().zip(&rows.columns[entries]) {
        let there = values[*column as usize];
        sums[0] += weight * (there[0] - own[0]);
        sums[1] += weight * (there[1] - own[1]);
    }
    sums
}
