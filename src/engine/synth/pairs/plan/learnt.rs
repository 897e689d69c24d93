//! Factors between the sizes of pairs and their laws, from the rows of their system.

use super::thread_map::ThreadMap;
use super::{PairForm, PairPlan};
use crate::learn::{PairAnswer, PairSet};
use crate::marks::turn;
use crate::rd::pairs::Threads;

/// The factor of each pair at each node of `plan`.
pub(super) fn factors(plan: &PairPlan, rows: &PairSet) -> Vec<Vec<f64>> {
    let of_node = |node: usize| answers(plan, rows, node).iter().map(|answer| answer.values[0]).collect();
    let all: Vec<Vec<f64>> = (0..plan.nodes.len()).map(of_node).collect();
    (0..plan.threads.len()).map(|pair| all.iter().map(|node| node[pair]).collect()).collect()
}

/// The answers of `rows` for each pair at node number `node`.
fn answers(plan: &PairPlan, rows: &PairSet, node: usize) -> Vec<PairAnswer> {
    let at = plan.nodes.center(plan.nodes.place(node));
    let threads = super::threads_at(&plan.threads, at);
    let angles = angles_at(&plan.threads, at);
    let answer = |pair: usize| match &plan.form {
        PairForm::Weave(_) => weave_answer(rows, &threads, &angles, pair),
        PairForm::Maze(_) => {
            let long = plan.length_of_pieces() / threads[pair].period;
            rows.ask(threads.len(), &[threads[pair].duty(), long, least_between(&angles)])
        }
        PairForm::Stripes => rows.ask(threads.len(), &[threads[pair].duty(), angles[pair]]),
        PairForm::Stucco(stucco) => rows.ask(threads.len(), &[stucco.decay]),
    };
    (0..threads.len()).map(answer).collect()
}

/// The directions of all threads at a point, px, in degrees.
pub(super) fn angles_at(threads: &[ThreadMap], at: [f64; 2]) -> Vec<f64> {
    threads.iter().map(|threads| threads.at(at).angle).collect()
}

/// The answer of `rows` for thread `pair` of all `threads` of a weave, which have these `angles` in degrees.
pub(super) fn weave_answer(rows: &PairSet, threads: &[Threads], angles: &[f64], pair: usize) -> PairAnswer {
    let Crossed { others, unequal } = crossed(threads, pair);
    rows.ask(threads.len(), &[threads[pair].duty(), others, unequal, least_between(angles)])
}

impl PairPlan {
    /// The answers of `rows` for each pair in the middle of the canvas.
    #[must_use]
    pub fn answers(&self, rows: &PairSet) -> Vec<PairAnswer> {
        answers(self, rows, self.nodes.len() / 2)
    }
}

/// The threads that a thread crosses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossed {
    /// The share of it that the other threads cover.
    pub others: f64,
    /// The geometric mean of the periods of the other threads ÷ its own.
    pub unequal: f64,
}

/// The threads that thread `pair` of all `threads` crosses.
#[must_use]
pub fn crossed(threads: &[Threads], pair: usize) -> Crossed {
    let others = || threads.iter().enumerate().filter(|(other, _)| *other != pair).map(|(_, other)| other);
    let free: f64 = others().map(|other| 1.0 - other.duty()).product();
    let logs: f64 = others().map(|other| libm::log(other.period / threads[pair].period)).sum();
    Crossed { others: 1.0 - free, unequal: libm::exp(logs / others().count().max(1) as f64) }
}

/// The smallest angle between two of these directions, degrees; 90 for a single one.
#[must_use]
pub fn least_between(angles: &[f64]) -> f64 {
    let pairs =
        angles.iter().enumerate().flat_map(|(index, a)| angles[..index].iter().map(move |b| (*a, *b)));
    pairs.map(|(a, b)| turn(a, b).abs()).fold(90.0, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_thread_crosses_is_the_share_and_the_mean_period_of_the_others() {
        let threads = |width: f64, period: f64| Threads { width, period };
        let all = [threads(5.0, 20.0), threads(4.0, 10.0), threads(8.0, 40.0)];
        let found = crossed(&all, 0);
        assert!((found.others - (1.0 - 0.6 * 0.8)).abs() < 1e-12 && (found.unequal - 1.0).abs() < 1e-12);
        assert!((least_between(&[10.0, 170.0, 80.0]) - 20.0).abs() < 1e-9);
        assert!((least_between(&[0.0]) - 90.0).abs() < 1e-12);
    }
}
