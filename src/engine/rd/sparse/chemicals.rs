//! The concentrations on sparse rows with their reaction: generic over the number of chemicals, behind one dynamic call
//! for each step.

use std::fmt::Debug;

use super::layout::layout;
use super::problem::SparseProblem;
use super::slices::ROWS;
use super::{plain, step};
use crate::rd::chemicals::Clock;
use crate::rd::kinetics::Kinetics;
use crate::rd::solver::Solver;
use crate::rd::super_step::Stage;

/// Concentrations that can be stepped.
pub trait SparseChemicals: Debug + Send + Sync {
    /// Takes one stage by a solver; the bits do not depend on which one.
    fn step(&mut self, problem: &SparseProblem, clock: Clock, solver: Solver);

    /// One vector a chemical, in the order of the rows.
    fn rows(&self) -> Vec<Vec<f32>>;

    /// A copy.
    fn copied(&self) -> Box<dyn SparseChemicals>;
}

impl Clone for Box<dyn SparseChemicals> {
    fn clone(&self) -> Self {
        self.copied()
    }
}

/// Combines concentrations, one vector a chemical, with their reaction, in which a decay differs by the second argument from row to row;
/// empty = nowhere. `None` for another number of chemicals, or where they have different lengths.
pub type ReactingByRows = fn(&[Vec<f32>], &[f32]) -> Option<Box<dyn SparseChemicals>>;

/// Combines concentrations, one vector a chemical, with the reaction `kinetics`; `None` for another number of chemicals, or where
/// they have different lengths.
#[must_use]
pub fn reacting_by_rows<const N: usize, K: Kinetics<N>>(
    kinetics: K,
    rows: &[Vec<f32>],
) -> Option<Box<dyn SparseChemicals>> {
    let count = rows.first()?.len();
    if rows.len() != N || count == 0 || rows.iter().any(|chemical| chemical.len() != count) {
        return None;
    }
    let layout = layout::<N, K>();
    // Rows that fill up the last slice do not change, but their values must be finite.
    let value = |chemical: usize, row: usize| rows.get(chemical).map_or(0.0, |of| of[row.min(count - 1)]);
    let pairs: Vec<Vec<[f32; 2]>> = layout.pairs[..layout.count]
        .iter()
        .map(|pair| {
            (0..count.next_multiple_of(ROWS)).map(|row| pair.map(|chemical| value(chemical, row))).collect()
        })
        .collect();
    Some(Box::new(Reacting::<N, K> { kinetics, count, next: pairs.clone(), pairs }))
}

/// `N` chemicals that react by `K`.
#[derive(Clone, Debug)]
struct Reacting<const N: usize, K> {
    kinetics: K,
    /// Number of rows.
    count: usize,
    /// By pair, the current concentrations of each row.
    pairs: Vec<Vec<[f32; 2]>>,
    /// Buffer for the concentrations after the next step; holds those before the last step.
    next: Vec<Vec<[f32; 2]>>,
}

impl<const N: usize, K: Kinetics<N>> SparseChemicals for Reacting<N, K> {
    fn step(&mut self, problem: &SparseProblem, clock: Clock, solver: Solver) {
        let kinetics = self.kinetics.at(clock.after(0));
        let stage = Stage::after(clock.steps as usize, problem.stages);
        let (old, new) = (&self.pairs, &mut self.next);
        match solver {
            Solver::Plain => plain::step::<N, K>(problem, &kinetics, stage, old, new),
            Solver::Fast(instructions) => {
                step::step::<N, K>(problem, &kinetics, stage, old, new, instructions);
            }
        }
        std::mem::swap(&mut self.pairs, &mut self.next);
    }

    fn rows(&self) -> Vec<Vec<f32>> {
        let layout = layout::<N, K>();
        let mut rows = vec![Vec::new(); N];
        for (of, pairs) in layout.pairs.iter().zip(&self.pairs) {
            for (i, chemical) in of.iter().enumerate().filter(|(_, chemical)| **chemical < N) {
                rows[*chemical] = pairs[..self.count].iter().map(|pair| pair[i]).collect();
            }
        }
        rows
    }

    fn copied(&self) -> Box<dyn SparseChemicals> {
        Box::new(self.clone())
    }
}
