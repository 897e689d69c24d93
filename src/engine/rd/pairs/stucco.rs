//! Stucco: blotches of one round pair from noise, which its falling gain breaks up.
//!
//! A. Witkin & M. Kass let k fall from 3 to 0.6 in a time of 40/b while θ = 0.03 stays. Counted in K₀k, the threshold rises from
//! θ₀ to θ₀ ÷ (1 − decay), decay = 1 − the last k ÷ the first: worms break up into dots.

use super::Course;

/// The gain of stucco.
pub struct Stucco;

impl Stucco {
    /// The decay of the paper: 1 − 0.6 ÷ 3.
    pub const DECAY: f64 = 0.8;
    /// The largest decay: above it the last blotches die.
    pub const MOST_DECAY: f64 = 0.85;
    /// θ₀/K₀k: 0.03 ÷ (0.2 · 3).
    const FIRST: f64 = 0.05;
    /// The time in which the gain falls, in 1/b.
    const FALLING: f64 = 8.0;

    /// θ/K₀k by time.
    #[must_use]
    pub fn threshold(decay: f64) -> Course {
        let rate = (libm::log(1.0 - decay) / Self::FALLING) as f32;
        Course::Decay { from: Self::FIRST as f32, rate, until: Self::FALLING as f32 }
    }

    /// θ/K₀k at the end.
    #[must_use]
    pub fn last_threshold(decay: f64) -> f64 {
        Self::FIRST / (1.0 - decay)
    }
}
