//! Super steps: several stages that together take more time than as many Euler steps.
//!
//! RKL1 (Meyer, Balsara & Aslam, Journal of Computational Physics 257, 2014): a super step of s stages takes the time of
//! (s² + s)/2 Euler steps and is as stable against diffusion as these. With E, an Euler step,
//!
//! ```text
//! yⱼ = yⱼ₋₁ + (1 − 1/j)(yⱼ₋₁ − yⱼ₋₂) + (2 − 1/j)(E(yⱼ₋₁) − yⱼ₋₁)      j = 1 … s
//! ```
//!
//! Its patterns at rest are those of Euler's. One stage is an Euler step.

/// Most stages of a super step: a sweep of the fast solver takes at least one super step (`Tiling`).
const MOST: usize = 6;

/// The coefficients of stage j.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stage {
    /// 1 − 1/j: the share of the change in the previous stage that is repeated.
    pub repeated: f32,
    /// 2 − 1/j: the factor of the change by reaction and diffusion.
    pub weight: f32,
}

impl Stage {
    /// The coefficients of the stage after `taken` others, in super steps of `stages`.
    #[must_use]
    pub fn after(taken: usize, stages: usize) -> Self {
        let inverse = 1.0 / (taken % stages + 1) as f32;
        Self { repeated: 1.0 - inverse, weight: 2.0 - inverse }
    }

    /// Whether the stage repeats nothing of the previous change.
    #[must_use]
    #[inline(always)]
    pub fn is_first(self) -> bool {
        self.repeated == 0.0
    }
}

/// Euler steps that take as long as a super step of `stages`.
#[must_use]
pub const fn euler_steps(stages: usize) -> usize {
    stages * (stages + 1) / 2
}

/// Euler steps that take as long as one stage of a super step of `stages`.
#[must_use]
pub fn euler_steps_a_stage(stages: usize) -> f64 {
    euler_steps(stages) as f64 / stages as f64
}

/// The largest number of stages with which the reactions stay accurate: a super step is at most `limit` long, and an Euler step
/// `step` (time × rate, where reactions are fastest).
#[must_use]
pub fn suited(step: f32, limit: f32) -> usize {
    (2..=MOST).take_while(|stages| euler_steps(*stages) as f32 * step <= limit).last().unwrap_or(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stages_of_a_super_step_take_the_time_of_its_euler_steps() {
        for stages in 1..=MOST {
            let (mut before, mut time) = (0.0, 0.0);
            for taken in 0..stages {
                let Stage { repeated, weight } = Stage::after(taken, stages);
                let next = time + repeated * (time - before) + weight;
                (before, time) = (time, next);
            }
            assert!((time - euler_steps(stages) as f32).abs() < 1e-4, "{stages}: {time}");
        }
    }

    #[test]
    fn a_super_step_is_as_long_as_its_limit_allows() {
        assert_eq!([0.5, 0.34, 0.33, 0.11].map(|step| suited(step, 1.0)), [1, 1, 2, 3]);
        assert_eq!(suited(1e-6, 1.0), MOST);
    }
}
