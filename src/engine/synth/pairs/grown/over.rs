//! The thread on top at each crossing of a weave, and the heights of threads between crossings.
//!
//! Threads are numbered by the phases along which they grew: thread i of one direction lies between the phases i − ½ and i + ½, in
//! periods. Where thread i crosses thread j, the [order](Over) decides which is over. The lift of a thread is 1 at the crossings
//! where it is over, −1 where it is under, and changes smoothly between.

use std::ops::Range;

use rayon::prelude::*;

use crate::document::Over;
use crate::grid::Bounds;
use crate::rd::pairs::MOST_PAIRS;
use crate::synth::pairs::grown::phase::ThreadPhase;
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// The largest height of a thread above its edges, in pattern values, where it is under another; where it is over, it rises by ½.
/// Its slope at the edges is not changed, so that they stay where they are.
const UNDER: f32 = 0.15;
/// Least weight of the crossings with other threads, so that the lift is known everywhere.
const FAR: f32 = 1e-3;

/// The order of the threads at all crossings of a weave.
#[derive(Clone, Debug)]
pub struct OverUnder {
    order: Over,
    seed: u64,
    phases: Vec<ThreadPhase>,
}

impl OverUnder {
    /// The crossings of these `threads`; `None` if all have the same height, or if threads of one direction cannot be numbered
    /// because they run in circles or as rays.
    #[must_use]
    pub fn new(order: Over, seed: u64, threads: &[ThreadMap], canvas: &Bounds) -> Option<Self> {
        if order == Over::Level {
            return None;
        }
        let phases = threads.iter().map(|threads| ThreadPhase::new(threads, canvas));
        Some(Self { order, seed, phases: phases.collect::<Option<_>>()? })
    }

    /// A note on the border of a tile: threads are numbered along the canvas, and the order begins again at the border.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let every = match self.order {
            Over::Level => 1,
            Over::Plain => 2,
            Over::Twill21 => 3,
            Over::Twill22 => 4,
            // On either side each thread has a number of its own.
            Over::Random => i64::MAX,
        };
        let periods: Vec<[i64; 2]> = self.phases.iter().filter_map(ThreadPhase::periods_round_tile).collect();
        let closes = |axis: usize| {
            let each = periods.iter().map(|periods| periods[axis]);
            let mut sums =
                each.clone().enumerate().flat_map(|(k, a)| each.clone().skip(k + 1).map(move |b| a + b));
            sums.all(|sum| sum.rem_euclid(every) == 0)
        };
        let closes = periods.is_empty() || (closes(0) && closes(1));
        (!closes).then(|| {
            let numbers = "the numbers of threads that cross the borders of the tile do not suit the order of crossings";
            format!("{numbers}: it has a seam there; make the canvas a thread wider or higher, or choose another order")
        })
    }

    /// The pattern of rows `rows` at `width` × `height` px: the highest thread at each px, from the pattern of each direction
    /// `alone`.
    #[must_use]
    pub fn rows(&self, alone: &[Vec<f32>], rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let phases = self.phases.iter().map(|phase| phase.rows(rows.clone(), width, height));
        let phases: Vec<Vec<f32>> = phases.collect();
        let value = |px: usize| {
            let here = |of: &[Vec<f32>]| -> [f32; MOST_PAIRS] {
                let mut all = [0.0; MOST_PAIRS];
                all.iter_mut().zip(of).for_each(|(all, of)| *all = of[px]);
                all
            };
            self.highest(&here(alone)[..alone.len()], &here(&phases)[..alone.len()])
        };
        (0..rows.len() * width).into_par_iter().map(value).collect()
    }

    /// The pattern value of the highest thread at a place, where the directions have the pattern values `alone` and these
    /// `phases`, in periods.
    fn highest(&self, alone: &[f32], phases: &[f32]) -> f32 {
        let value = |(pair, value): (usize, &f32)| match *value > 0.5 {
            // There is nothing to lift beside threads, so that edges stay where they are.
            false => *value,
            true => {
                let (height, over) = (value - 0.5, 0.5 + 0.5 * self.lift(pair, phases));
                let flat = height / (1.0 + (height / UNDER) * (height / UNDER)).sqrt();
                0.5 + over * height + (1.0 - over) * flat
            }
        };
        alone.iter().enumerate().map(value).fold(0.0, f32::max)
    }

    /// The lift of the thread of direction `pair` at a place with these `phases`, −1..1.
    fn lift(&self, pair: usize, phases: &[f32]) -> f32 {
        let own = phases[pair].round() as i64;
        let [mut sum, mut weights] = [0.0; 2];
        for (other, phase) in phases.iter().enumerate().filter(|(other, _)| *other != pair) {
            let (before, way) = (phase.floor() as i64, phase - phase.floor());
            let smooth = way * way * (3.0 - 2.0 * way);
            let side = |crossed: i64| if self.is_over([pair, other], [own, crossed]) { 1.0 } else { -1.0 };
            let near = (2.0 * way - 1.0) * (2.0 * way - 1.0);
            let weight = near * near + FAR;
            sum += weight * (side(before) * (1.0 - smooth) + side(before + 1) * smooth);
            weights += weight;
        }
        sum / weights.max(f32::MIN_POSITIVE)
    }

    /// Whether the first of two threads, of the directions `pairs` and with these numbers, lies over the second.
    fn is_over(&self, pairs: [usize; 2], numbers: [i64; 2]) -> bool {
        if pairs[0] > pairs[1] {
            return !self.is_over([pairs[1], pairs[0]], [numbers[1], numbers[0]]);
        }
        let [i, j] = numbers;
        match self.order {
            Over::Level => true,
            Over::Plain => (i + j).rem_euclid(2) == 0,
            Over::Twill21 => (i + j).rem_euclid(3) < 2,
            Over::Twill22 => (i + j).rem_euclid(4) < 2,
            Over::Random => {
                let place = (i as u64).rotate_left(32) ^ (j as u64) ^ ((pairs[1] as u64) << 20);
                // The last round of SplitMix64, as in the seeds of layers.
                let mut z = (self.seed ^ place).wrapping_mul(0xbf58_476d_1ce4_e5b9);
                z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
                (z >> 63) == 0
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Number of crossings, of the 144 of 12 and 12 threads, where a thread of the first direction is on top.
    fn over(order: Over) -> usize {
        let over = OverUnder { order, seed: 3, phases: Vec::new() };
        let crossings = (0..144i64).map(|k| [k / 12 - 6, k % 12 - 6]);
        crossings
            .filter(|[i, j]| {
                let first = over.is_over([0, 1], [*i, *j]);
                assert_ne!(first, over.is_over([1, 0], [*j, *i]), "one of the two is over");
                first
            })
            .count()
    }

    #[test]
    fn of_each_crossing_one_thread_is_over_as_often_as_the_order_says() {
        assert_eq!(over(Over::Plain), 72);
        assert_eq!(over(Over::Twill21), 96);
        assert_eq!(over(Over::Twill22), 72);
        assert!((52..=92).contains(&over(Over::Random)), "{}", over(Over::Random));
    }

    #[test]
    fn a_thread_is_high_at_the_crossings_where_it_is_over_and_low_where_it_is_under() {
        let plain = OverUnder { order: Over::Plain, seed: 0, phases: Vec::new() };
        for (phases, lift) in [([0.0, 0.0], 1.0), ([0.0, 1.0], -1.0), ([1.0, 1.0], 1.0), ([0.0, 0.5], 0.0)] {
            assert!((plain.lift(0, &phases) - lift).abs() < 1e-6, "{phases:?}: {}", plain.lift(0, &phases));
            // At a crossing the lift of the other thread is the opposite.
            assert!((plain.lift(1, &phases) + lift).abs() < 1e-6 || phases[1] == 0.5, "{phases:?}");
        }
    }
}
