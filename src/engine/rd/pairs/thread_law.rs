//! The law of the threads of a weave: the size of a pair whose lines have the width and the distance that were drawn.
//!
//! Lines of width w that repeat after p are a pulse train. At their edges a blur with the decay length ℓ is
//!
//! E(ℓ) = (sinh q − sinh(q − w/ℓ)) ÷ (2 sinh q), q = p ÷ 2ℓ
//!
//! The difference of the pair is E(s) − E(d·s), times the share of each line that no other thread covers, Π (1 − fⱼ) with the
//! duties fⱼ = wⱼ ÷ pⱼ of the other threads: a blur is long along its direction, so that it averages over the threads that it
//! crosses. A line keeps its width if the difference at its edge is the threshold θ. Measured in `facts.md` T.

use super::PairModel;

/// Wanted width and distance of the threads of one direction, in any unit of length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threads {
    /// Width of a thread.
    pub width: f64,
    /// Distance from one thread to the next.
    pub period: f64,
}

impl Threads {
    /// The share of the canvas that they cover.
    #[must_use]
    pub fn duty(&self) -> f64 {
        self.width / self.period
    }

    /// The sizes s, in units of the width, between which the size is sought: for lines far apart the width is 1.2 to 13 sizes.
    const SIZES: [f64; 2] = [0.02, 1.0];

    /// The size s of the pair that grows these threads at a threshold of θ/K₀, if the other threads leave the share `uncovered` of
    /// them free, 0..1. `None` if no size does: the threshold is too high, or the threads are too dense.
    #[must_use]
    pub fn size(&self, model: &PairModel, threshold: f64, uncovered: f64) -> Option<f64> {
        let wanted = threshold * f64::from(model.peak_gain());
        let lacks = |s: f64| self.difference_at_edge(model, s, uncovered) - wanted;
        // The difference rises with the size from 0 to its maximum, beyond which lines are not stable: the smaller solution is the
        // right one.
        let [mut below, most] = Self::SIZES.map(|size| size * self.width);
        const STEP: f64 = 1.05;
        while lacks(STEP * below) < 0.0 {
            below *= STEP;
            if below > most {
                return None;
            }
        }
        let mut above = STEP * below;
        for _ in 0..40 {
            let middle = 0.5 * (below + above);
            *(if lacks(middle) < 0.0 { &mut below } else { &mut above }) = middle;
        }
        Some(above)
    }

    /// The highest threshold θ/K₀, up to `most`, at which these threads are at least 0.9 wavelengths Λ apart, if the other threads
    /// leave the share `uncovered` of them free; with the size s of their pair by the law. At a higher threshold the threads
    /// vanish, at a lower one they would need a smaller size, and so a finer grid. The pair is `factor` times as large as the law
    /// says. `None` if there is none: the threads are too dense.
    #[must_use]
    pub fn threshold(&self, model: &PairModel, uncovered: f64, most: f64, factor: f64) -> Option<(f64, f64)> {
        let steps = ((most - LEAST) / THRESHOLD_STEP).floor().max(0.0) as usize;
        (0..=steps).map(|step| most - THRESHOLD_STEP * step as f64).find_map(|threshold| {
            let size = self.size(model, threshold, uncovered)?;
            (self.period >= DENSEST * model.wavelength() * factor * size).then_some((threshold, size))
        })
    }

    /// The difference C₊ − C₋ of a pair of size `s` at the edges of these threads, at k = 1, where the other threads leave the
    /// share `uncovered` of them free.
    #[must_use]
    pub fn difference_at_edge(&self, model: &PairModel, s: f64, uncovered: f64) -> f64 {
        uncovered * (self.edge(s) - self.edge(f64::from(model.ratio) * s))
    }

    /// E(ℓ): the blur at the edge of a line, where the reaction in it is 1.
    fn edge(&self, decay: f64) -> f64 {
        let q = 0.5 * self.period / decay;
        // sinh(a)/sinh(q) without overflow.
        let share = |a: f64| (libm::exp(a - q) - libm::exp(-a - q)) / (1.0 - libm::exp(-2.0 * q));
        0.5 * (1.0 - share(q - self.width / decay))
    }
}

/// Period ÷ Λ of the densest threads: closer threads vanish (`facts.md` T).
const DENSEST: f64 = 0.9;
/// Lowest threshold θ/K₀ of a weave.
const LEAST: f64 = 0.03;
/// Step width of the search for the threshold.
const THRESHOLD_STEP: f64 = 0.005;
