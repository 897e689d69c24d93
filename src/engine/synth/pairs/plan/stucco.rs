//! Plans of stucco: one isotropic pair that grows from noise.

use super::base_model;
use super::cut::{Sorted, cut};
use crate::grid::Field;
use crate::marks::{Mark, Path};
use crate::rd::pairs::{PairModel, PairParameterField, Stucco, Threads};

/// Share of the canvas that blotches from noise cover at decay 0.
const COVERED: f64 = 0.46;
/// Decrease of this share from decay 0 to decay 1.
const UNCOVERED: f64 = 0.2;
/// Distance of worms from noise ÷ Λ.
const PERIOD: f64 = 0.935;

/// The part of a plan that only stucco has.
#[derive(Clone, Copy, Debug)]
pub struct StuccoForm {
    /// 1 − the last gain ÷ the first.
    pub decay: f64,
}

impl StuccoForm {
    /// The share of the canvas that blotches cover.
    pub(super) fn duty(self) -> f64 {
        COVERED - UNCOVERED * self.decay
    }

    /// The difference, scaled so that 1 is the last threshold, at which the edges of blotches lie.
    pub(super) fn shown(self, difference: &Field) -> Field {
        let level = Stucco::last_threshold(self.decay) as f32 * base_model().peak_gain();
        cut(difference, &Sorted::new(difference), |_| level)
    }

    /// The reaction, for a pair of these `maps`.
    pub(super) fn model(self, maps: &PairParameterField) -> PairModel {
        let softness = 1.0 / (3.0 * maps.least_size());
        PairModel { threshold: Stucco::threshold(self.decay), softness, ..base_model() }
    }
}

/// The size s of the pair of these blotches, px.
pub(super) fn size(threads: &Threads) -> f64 {
    threads.period / (PERIOD * base_model().wavelength())
}

/// A line with the width of a mark: for an ellipse its longer axis, with the width of the shorter one.
pub(super) fn line(mark: &Mark) -> Path {
    match mark.ellipse() {
        None => mark.path().unwrap_or(Path { points: Vec::new(), width: 1.0 }),
        Some(ellipse) => {
            let (s, c) = libm::sincos(ellipse.angle.to_radians());
            let end =
                |side: f64| [0, 1].map(|axis| ellipse.center[axis] + side * ellipse.radii[0] * [c, s][axis]);
            Path { points: vec![end(-1.0), end(1.0)], width: 2.0 * ellipse.radii[1] }
        }
    }
}
