//! Plans of weaves: the threshold of each direction, and the size of its pair by the law of threads.

use rayon::prelude::*;

use super::learnt::{angles_at, weave_answer};
use super::{base_model, threads_at};
use crate::attributes::regions::RegionGrid;
use crate::learn::PairSet;
use crate::rd::pairs::{Course, MOST_PAIRS, PairModel, PairParameterField, Threads};
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// e of the pair of a weave with the largest size: with 2, three directions merged to pebbles (`facts.md` H). The blurs of the
/// other pairs have this length, too, up to the second value of e.
const ELONGATIONS: [f64; 2] = [3.0, 8.0];
/// Highest θ/K₀ of two directions (near 0.25 threads were lost), and of more (at 0.2 they vanished) (`facts.md` T).
const HIGHEST: [f64; 2] = [0.2, 0.12];
/// Highest θ/K₀ ÷ the share of a thread that the others leave free, for two directions and for more: the part that the others cover
/// does not contribute to the difference of the pair. At 0.33, sparse threads across dense ones broke and vanished.
const HIGHEST_FREE: [f64; 2] = [0.27, 0.21];
/// θ/K₀ of threads for which none is found.
const LOWEST: f64 = 0.03;
/// Least share that three and more directions leave free: at 0.33 threads were a tenth too wide and gaps became round, at 0.44
/// widths were right within two hundredths.
const LEAST_FREE: f64 = 0.4;
/// The periods of threads that cover too much are widened in these steps, up to this factor.
const WIDENED: [f64; 2] = [1.04, 4.0];

/// The part of a plan that only weaves have.
#[derive(Clone, Debug)]
pub struct WeaveForm {
    /// θ/K₀ of each direction.
    pub thresholds: Vec<f64>,
}

impl WeaveForm {
    /// The thresholds for these threads. Threads that leave no gaps are moved apart, with a note.
    pub(super) fn new(
        threads: &mut [ThreadMap],
        nodes: &RegionGrid,
        rows: Option<&PairSet>,
        notes: &mut Vec<String>,
    ) -> Self {
        let mut widened = 1.0;
        let thresholds = loop {
            if let Some(found) = thresholds(nodes, threads, rows) {
                break found;
            }
            widened *= WIDENED[0];
            threads.iter_mut().for_each(|threads| threads.widened = widened);
            if widened > WIDENED[1] {
                break vec![LOWEST; threads.len()];
            }
        };
        if widened > 1.0 {
            let covered: f64 = threads.iter().map(|threads| threads.mean().duty() * widened).sum();
            notes.push(format!(
                "threads that cover {:.0} % of the canvas together leave no gaps: they are {widened:.2} times as far apart as drawn",
                100.0 * covered
            ));
        }
        Self { thresholds }
    }

    /// The size s of pair `pair` of `all` threads at one place, px, for threads of `factor` times the wanted width.
    pub(super) fn size(&self, all: &[Threads], pair: usize, factor: f64) -> f64 {
        let asked = Threads { width: all[pair].width * factor, ..all[pair] };
        let fits = asked.size(&base_model(), self.thresholds[pair], uncovered(all, pair));
        // For threads that keep no width at this threshold: the size at which their period has the largest gain.
        fits.unwrap_or(asked.period / base_model().wavelength())
    }

    /// e of a pair whose largest size is `largest`; `of_all` is the largest size of all pairs.
    pub(super) fn elongation(largest: f64, of_all: f64) -> f32 {
        (ELONGATIONS[0] * of_all / largest).clamp(ELONGATIONS[0], ELONGATIONS[1]) as f32
    }

    /// The threshold of the difference of each pair at the edges of its threads.
    pub(super) fn levels(&self) -> Vec<f32> {
        self.thresholds.iter().map(|threshold| *threshold as f32 * base_model().peak_gain()).collect()
    }

    /// The reaction, for pairs of these `maps`.
    pub(super) fn model(&self, maps: &PairParameterField) -> PairModel {
        let least = maps.least_size();
        let highest = self.thresholds.iter().copied().fold(LOWEST, f64::max);
        let threshold = highest as f32;
        let mut weights = [1.0; MOST_PAIRS];
        for (weight, own) in weights.iter_mut().zip(&self.thresholds) {
            *weight = (highest / own) as f32;
        }
        PairModel {
            threshold: Course::Constant(threshold),
            softness: PairModel::softness_for(least, threshold),
            weights,
            ..base_model()
        }
    }
}

/// The share of thread `pair` that the others leave free.
fn uncovered(all: &[Threads], pair: usize) -> f64 {
    let others = all.iter().enumerate().filter(|(other, _)| *other != pair);
    others.map(|(_, threads)| 1.0 - threads.duty()).product()
}

/// The highest threshold θ/K₀ of each direction that suits its threads at every node; `None` where there is none.
fn thresholds(nodes: &RegionGrid, threads: &[ThreadMap], rows: Option<&PairSet>) -> Option<Vec<f64>> {
    let of_node = |index: usize| {
        let at = nodes.center(nodes.place(index));
        let (all, angles) = (threads_at(threads, at), angles_at(threads, at));
        let free: f64 = all.iter().map(|threads| 1.0 - threads.duty()).product();
        if all.len() > 2 && free < LEAST_FREE {
            return None;
        }
        let many = usize::from(all.len() > 2);
        let own = |(pair, threads): (usize, &Threads)| {
            let factor = rows.map_or(1.0, |rows| weave_answer(rows, &all, &angles, pair).values[0]);
            let free = uncovered(&all, pair);
            let most = HIGHEST[many].min(HIGHEST_FREE[many] * free);
            let (threshold, _) = threads.threshold(&base_model(), free, most, factor)?;
            Some(threshold)
        };
        all.iter().enumerate().map(own).collect::<Option<Vec<f64>>>()
    };
    let all: Option<Vec<Vec<f64>>> = (0..nodes.len()).into_par_iter().map(of_node).collect();
    let all = all?;
    let lowest = |pair: usize| all.iter().map(|node| node[pair]).fold(f64::INFINITY, f64::min);
    Some((0..threads.len()).map(lowest).collect())
}
