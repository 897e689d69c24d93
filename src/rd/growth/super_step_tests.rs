//! Super-time-stepping against Euler steps: a measurement, not used by the engine (`docs/facts.md` S).
//!
//! RKL1 (Meyer, Balsara & Aslam, Journal of Computational Physics 257, 2014): a super step of s stages takes the time of
//! (s² + s)/2 Euler steps. With E, an Euler step,
//!
//! ```text
//! yⱼ = yⱼ₋₁ + (1 − 1/j)(yⱼ₋₁ − yⱼ₋₂) + (2 − 1/j)(E(yⱼ₋₁) − yⱼ₋₁)      j = 1 … s
//! ```
//!
//! Its patterns at rest are those of Euler's.

use super::*;
use crate::grid::Edges;
use crate::rd::benchmark::Case;

const SIDE: usize = 48;

/// Takes a super step of `stages`. A concentration that would be negative is 0.
fn super_step(growth: &mut Growth, stages: usize) {
    let mut before = growth.concentrations();
    let mut now = before.clone();
    for stage in 1..=stages {
        growth.advance_plain(1);
        let stepped = growth.concentrations();
        let share = 1.0 / stage as f32;
        for ((before, now), stepped) in before.iter_mut().zip(&mut now).zip(&stepped) {
            for ((before, now), stepped) in before.iter_mut().zip(now).zip(stepped) {
                let next = *now + (1.0 - share) * (*now - *before) + (2.0 - share) * (stepped - *now);
                *before = std::mem::replace(now, next.max(0.0));
            }
        }
        let rows = growth.problem.grid.ny;
        for (plane, cells) in growth.chemicals.planes_mut().iter_mut().zip(&now) {
            (0..rows).for_each(|y| plane.set_row(y, &cells[y * SIDE..(y + 1) * SIDE]));
        }
    }
}

/// The mean difference of the marks after `time`, ÷ their mean, between super steps of `stages` and Euler steps; NaN where they
/// diverge. `rate` times the usual rate.
fn difference(system: System, rate: f32, stages: usize, time: f64) -> f32 {
    let usual = Case { system, stretch: 1.0 }.maps(16).parameters[0];
    let maps = Maps::uniform(
        [SIDE; 2],
        Edges::Wrap,
        Parameters { rate: rate * usual.rate, direction: 0.0, ..usual },
    );
    let (mut euler, mut super_steps) = (Growth::new(system, &maps, 1), Growth::new(system, &maps, 1));
    let a_super_step = (stages * stages + stages) / 2;
    let count = euler.steps_in(time).div_ceil(a_super_step as u64);
    euler.advance(count * a_super_step as u64);
    (0..count).for_each(|_| super_step(&mut super_steps, stages));
    let [euler, other] = [&euler, &super_steps].map(|growth| growth.marks().values);
    let difference: f32 = euler.iter().zip(&other).map(|(a, b)| (a - b).abs()).sum();
    difference / euler.iter().map(|value| value.abs()).sum::<f32>()
}

#[test]
fn super_steps_end_in_the_pattern_of_euler_steps() {
    for (system, stages, time) in [
        (System::TURING_SPOTS, 3, 30.0),
        (System::MEINHARDT_SPOTS, 6, 10.0),
        (System::MEINHARDT_STRIPES, 3, 40.0),
    ] {
        let found = difference(system, 1.0, stages, time);
        assert!(found < 0.02, "{}: {found}", system.name());
    }
}

#[test]
fn super_steps_that_are_too_long_for_the_reaction_do_not() {
    let found = difference(System::MEINHARDT_STRIPES, 2.5, 4, 20.0);
    assert!(found.is_nan() || found > 0.1, "{found}");
    let found = difference(System::TURING_SPOTS, 1.0, 8, 20.0);
    assert!(found.is_nan() || found > 0.1, "{found}");
}
