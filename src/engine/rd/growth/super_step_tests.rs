//! Super steps against Euler steps (`docs/facts.md` S).

use super::*;
use crate::grid::Edges;
use crate::rd::benchmark::Case;

const SIDE: usize = 48;

/// Two growths from one start, by super steps and by Euler steps, with `rate` times the usual rate.
fn both(system: System, rate: f32) -> [Growth; 2] {
    let usual = Case { system, stretch: 1.0 }.maps(16).parameters[0];
    let maps = ParameterField::uniform(
        [SIDE; 2],
        Edges::Wrap,
        Parameters { rate: rate * usual.rate, direction: 0.0, ..usual },
    );
    let growth = Growth::new(system, &maps, 1);
    [growth.clone(), growth.with_stages(1)]
}

/// The mean difference of the marks after `time`, ÷ their mean, between two growths; NaN where one diverges.
fn difference(mut growths: [Growth; 2], time: f64) -> f32 {
    growths.iter_mut().for_each(|growth| growth.advance(growth.steps_in(time)));
    let [a, b] = growths.each_ref().map(|growth| growth.marks().values);
    let difference: f32 = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).sum();
    difference / b.iter().map(|value| value.abs()).sum::<f32>()
}

#[test]
fn super_steps_end_in_the_pattern_of_euler_steps_in_less_than_two_thirds_of_their_number() {
    for (system, rate, time) in [
        (System::TURING_SPOTS, 1.0, 40.0),
        (System::TURING_SPOTS, 0.5, 30.0),
        (System::MEINHARDT_SPOTS, 1.0, 10.0),
        (System::MEINHARDT_LINES, 1.0, 40.0),
        (System::MEINHARDT_STRIPES, 1.0, 40.0),
    ] {
        let growths = both(system, rate);
        let [steps, euler] = growths.each_ref().map(|growth| growth.steps_in(time));
        assert!(3 * steps <= 2 * euler + 30, "{system:?}: {steps} of {euler}");
        let found = difference(growths, time);
        assert!(found < 0.02, "{system:?}, {rate}: {found}");
    }
}

#[test]
fn super_steps_that_are_too_long_for_the_reaction_do_not() {
    for (system, rate, stages) in [(System::MEINHARDT_STRIPES, 2.5, 4), (System::TURING_SPOTS, 1.0, 8)] {
        let [growth, euler] = both(system, rate);
        let found = difference([growth.with_stages(stages), euler], 20.0);
        assert!(found.is_nan() || found > 0.1, "{system:?}: {found}");
    }
}

#[test]
fn super_steps_by_the_fast_solver_give_the_bits_of_the_plain_one() {
    for system in System::ALL {
        let [growth, _] = both(system, 1.0);
        let mut plain = growth.clone();
        plain.advance_plain(50);
        for (time_steps, bands) in [(1, 1), (4, 3), (12, 2)] {
            let mut fast = growth.clone();
            fast.advance_as(50, Tiling { time_steps, bands }, Instructions::best());
            assert!(fast.concentrations() == plain.concentrations(), "{system:?} {time_steps} {bands}");
            assert_eq!((fast.steps(), fast.time()), (plain.steps(), plain.time()));
        }
    }
}
