//! The reactions of `N` morphogens: C₊ and C₋ of the first pair, then of the second, and so on. If `N` is odd, the last plane is no
//! morphogen: it holds the increase of the threshold at each cell.

use rayon::prelude::*;

use super::{Combination, PairModel};
use crate::rd::chemicals::{Chemicals, reacting};
use crate::rd::kinetics::{Kinetics, Spreading};
use crate::rd::plane::{Plane, RowLayout};
use crate::rd::sparse::{SparseChemicals, reacting_by_rows};
use crate::rd::vector::Number;

/// Each of the first `moving` morphogens spreads by a tensor of its own, the others not at all.
const fn spreading<const N: usize>(moving: usize) -> [Spreading; N] {
    let mut all = [Spreading::Still; N];
    let mut i = 0;
    while i < moving {
        all[i] = Spreading::Tensor { tensor: i, mobility: 0 };
        i += 1;
    }
    all
}

/// The reaction of a system of pairs.
#[derive(Clone, Copy, Debug)]
struct PairReaction<const N: usize> {
    model: PairModel,
    /// θ, w and k at the current time.
    threshold: f32,
    half_width: f32,
    gain: f32,
}

impl<const N: usize> PairReaction<N> {
    fn new(model: PairModel) -> Self {
        Self { model, threshold: 0.0, half_width: 1.0, gain: 1.0 }.at(0.0)
    }
}

impl<const N: usize> Kinetics<N> for PairReaction<N> {
    const SPREAD: [Spreading; N] = spreading(N / 2 * 2);

    fn at(&self, time: f64) -> Self {
        let gain = self.model.gain.at(time);
        let unit = self.model.peak_gain() * gain;
        let threshold = unit * self.model.threshold.at(time);
        Self { threshold, half_width: unit * self.model.softness, gain, ..*self }
    }

    #[inline(always)]
    fn react<V: Number>(&self, c: [V; N]) -> [V; N] {
        let weights = &self.model.weights;
        let mut largest = V::splat(weights[0]) * (c[0] - c[1]);
        let mut least = largest;
        for pair in 1..N / 2 {
            let difference = V::splat(weights[pair]) * (c[2 * pair] - c[2 * pair + 1]);
            largest = largest.larger(difference);
            least = least.smaller(difference);
        }
        let mut x = combined(self.model.combination, largest, least);
        if N % 2 == 1 {
            x = x - c[N - 1];
        }
        let r = V::splat(self.gain) * x.soft_step(V::splat(self.threshold), V::splat(self.half_width));
        let mut change = [V::splat(0.0); N];
        for i in 0..N / 2 * 2 {
            change[i] = r - c[i];
        }
        change
    }
}

/// X, by the largest and the least difference.
#[inline(always)]
fn combined<V: Number>(combination: Combination, largest: V, least: V) -> V {
    match combination {
        Combination::Maximum => largest,
        Combination::DifferenceOfAbsolutes => largest.absolute() - least.absolute(),
    }
}

/// R at each cell at `time`, by the difference of each pair there; `raised` is the increase of the threshold by cell, empty = 0
/// everywhere.
pub(super) fn reaction(model: &PairModel, differences: &[Vec<f32>], raised: &[f32], time: f64) -> Vec<f32> {
    let PairReaction { threshold, half_width, gain, .. } = PairReaction::<2>::new(*model).at(time);
    let at = |cell: usize| {
        let x = combination_at(model, differences, cell) - increase(raised, cell);
        gain * x.soft_step(threshold, half_width)
    };
    (0..differences[0].len()).into_par_iter().with_min_len(CELLS_A_THREAD).map(at).collect()
}

/// R at each cell at `time`, like [`reaction`]; but where X changes within a cell by more than the softness, R is the share of the
/// cell in which X is above the threshold. X is taken as linear there: it changes by |∂X/∂x| + |∂X/∂y| over a cell, by central
/// differences. So an edge has a place between the cells, where a step would put it on the border of one.
pub(super) fn reaction_by_shares(
    model: &PairModel,
    differences: &[Vec<f32>],
    raised: &[f32],
    time: f64,
    layout: &RowLayout,
) -> Vec<f32> {
    let PairReaction { threshold, half_width, gain, .. } = PairReaction::<2>::new(*model).at(time);
    let cells = 0..differences[0].len();
    let x = |cell: usize| combination_at(model, differences, cell);
    let x: Vec<f32> = cells.clone().into_par_iter().with_min_len(CELLS_A_THREAD).map(x).collect();
    let at = |cell: usize| {
        let [column, row] = [cell % layout.nx, cell / layout.nx].map(|k| k as isize);
        let value = |column: isize, row: isize| {
            x[layout.row(row) * layout.nx + layout.edges.index(column, layout.nx)]
        };
        let change = 0.5 * (value(column + 1, row) - value(column - 1, row)).absolute()
            + 0.5 * (value(column, row + 1) - value(column, row - 1)).absolute();
        let above = x[cell] - increase(raised, cell);
        gain * above.soft_step(threshold, half_width.larger(0.5 * change))
    };
    cells.into_par_iter().with_min_len(CELLS_A_THREAD).map(at).collect()
}

/// X at a cell.
fn combination_at(model: &PairModel, differences: &[Vec<f32>], cell: usize) -> f32 {
    let weighted = |pair: usize| model.weights[pair] * differences[pair][cell];
    let others = (1..differences.len()).map(weighted);
    let [largest, least] = others.fold([weighted(0); 2], |[largest, least], difference| {
        [largest.larger(difference), least.smaller(difference)]
    });
    combined(model.combination, largest, least)
}

/// Increase of the threshold at a cell.
fn increase(raised: &[f32], cell: usize) -> f32 {
    raised.get(cell).copied().unwrap_or(0.0)
}

/// Fewest cells that a thread is given.
const CELLS_A_THREAD: usize = 1 << 14;

/// The kinetics of pairs with a reaction that is held constant: it is the last plane.
#[derive(Clone, Copy, Debug)]
struct HeldReaction<const N: usize>;

impl<const N: usize> Kinetics<N> for HeldReaction<N> {
    const SPREAD: [Spreading; N] = spreading(N - 1);

    #[inline(always)]
    fn react<V: Number>(&self, c: [V; N]) -> [V; N] {
        let mut change = [V::splat(0.0); N];
        for i in 0..N - 1 {
            change[i] = c[N - 1] - c[i];
        }
        change
    }
}

/// The planes of one to five pairs, and perhaps one with the increase of the threshold, with the reaction of `model`; `None` for
/// another number of planes.
#[must_use]
pub(super) fn reacting_pairs(model: PairModel, planes: Vec<Plane>) -> Option<Box<dyn Chemicals>> {
    match planes.len() {
        2 => reacting(PairReaction::<2>::new(model), planes),
        4 => reacting(PairReaction::<4>::new(model), planes),
        6 => reacting(PairReaction::<6>::new(model), planes),
        8 => reacting(PairReaction::<8>::new(model), planes),
        10 => reacting(PairReaction::<10>::new(model), planes),
        3 => reacting(PairReaction::<3>::new(model), planes),
        5 => reacting(PairReaction::<5>::new(model), planes),
        7 => reacting(PairReaction::<7>::new(model), planes),
        9 => reacting(PairReaction::<9>::new(model), planes),
        11 => reacting(PairReaction::<11>::new(model), planes),
        _ => None,
    }
}

/// The planes of one to five pairs and one of the reaction, which is held; `None` for another number of planes.
#[must_use]
pub(super) fn held_pairs(planes: Vec<Plane>) -> Option<Box<dyn Chemicals>> {
    match planes.len() {
        3 => reacting(HeldReaction::<3>, planes),
        5 => reacting(HeldReaction::<5>, planes),
        7 => reacting(HeldReaction::<7>, planes),
        9 => reacting(HeldReaction::<9>, planes),
        11 => reacting(HeldReaction::<11>, planes),
        _ => None,
    }
}

/// C₊ and C₋ of one pair by vertex of a surface, with the reaction of `model`; `None` for another number of vectors.
#[must_use]
pub fn reacting_pair_by_rows(model: PairModel, rows: &[Vec<f32>]) -> Option<Box<dyn SparseChemicals>> {
    reacting_by_rows(PairReaction::<2>::new(model), rows)
}

/// C₊ and C₋ of one pair by vertex of a surface, and a reaction that is held; `None` for another number of vectors.
#[must_use]
pub fn held_pair_by_rows(rows: &[Vec<f32>]) -> Option<Box<dyn SparseChemicals>> {
    reacting_by_rows(HeldReaction::<3>, rows)
}
