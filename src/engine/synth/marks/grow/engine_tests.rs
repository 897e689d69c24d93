//! The engine: the pattern does not depend on how it is advanced or read.

use super::*;
use crate::grid::{Edges, Grid};
use crate::rd::Growth;
use crate::rd::Parameters;

/// Spots (stripes) whose area (squared width) increases by the factor `times` from left to right.
fn graded(system: System, [nx, ny]: [usize; 2], edges: Edges, times: f32) -> ParameterField {
    let rates = [
        (System::TURING_SPOTS, 0.12),
        (System::MEINHARDT_SPOTS, 3.4),
        (System::MEINHARDT_STRIPES, 25.6),
        (System::MEINHARDT_LINES, 9.0),
    ];
    let own = rates.iter().find(|(of, _)| *of == system);
    let rate = own.map_or_else(|| system.definition().usual_rate, |(_, rate)| *rate);
    let parameters = (0..nx * ny)
        .map(|i| {
            let t = (2.0 * ((i % nx) as f32 + 0.5) / nx as f32 - 0.5).clamp(0.0, 1.0);
            let rate = rate * libm::powf(times, -t);
            Parameters { rate, ratio: 12.0, stretch: 0.6, direction: 20.0 + 30.0 * t, pitch: 1.0 }
        })
        .collect();
    ParameterField::new(Grid::unit([nx, ny], edges), parameters)
}

/// A canvas with several grids under it.
fn engine(system: System) -> Engine {
    Engine::from_maps(system, graded(system, [150, 90], Edges::Closed, 9.0), 5)
}

fn bits(engine: &Engine) -> Vec<u32> {
    engine.marks().values.iter().map(|value| value.to_bits()).collect()
}

fn finished(mut engine: Engine, budget: u64) -> Engine {
    while engine.advance(budget) {}
    engine
}

#[test]
fn the_result_does_not_depend_on_the_steps_taken_at_a_time() {
    for system in System::ALL {
        let whole = finished(engine(system), u64::MAX);
        assert!(whole.grid_level()[1] > 1, "{system:?} has one grid only");
        let pieces = finished(engine(system), 30_011);
        assert!(bits(&whole) == bits(&pieces), "{system:?}");
        assert_eq!((whole.steps(), whole.settled()), (pieces.steps(), pieces.settled()));
    }
}

#[test]
fn reading_the_state_changes_no_bit() {
    let seen = {
        let mut engine = engine(System::MEINHARDT_SPOTS);
        while engine.advance(200_000) {
            let marks = engine.marks();
            assert!(marks.values.iter().all(|value| value.is_finite()));
            // On any grid the field covers the canvas.
            assert!((marks.extent()[0] - 150.0).abs() < 1e-9 && (marks.extent()[1] - 90.0).abs() < 1e-9);
        }
        engine
    };
    assert!(bits(&seen) == bits(&finished(engine(System::MEINHARDT_SPOTS), u64::MAX)));
}

#[test]
fn a_growth_started_again_after_a_cancel_equals_a_new_one() {
    let mut left = engine(System::MEINHARDT_SPOTS);
    left.advance(1_000_000);
    drop(left);
    let [a, b] = [0, 1].map(|_| finished(engine(System::MEINHARDT_SPOTS), u64::MAX));
    assert!(bits(&a) == bits(&b));
    let other = Engine::from_maps(
        System::MEINHARDT_SPOTS,
        graded(System::MEINHARDT_SPOTS, [150, 90], Edges::Closed, 9.0),
        6,
    );
    assert!(bits(&a) != bits(&finished(other, u64::MAX)));
}

#[test]
fn a_copy_continues_like_its_original() {
    let mut one = engine(System::TURING_SPOTS);
    one.advance(3_000_000);
    let copy = one.clone();
    assert!(bits(&finished(one, 100_000)) == bits(&finished(copy, 1_000_000)));
}

#[test]
fn progress_rises_to_one_and_a_small_budget_is_kept() {
    for system in System::ALL {
        let mut engine = engine(system);
        let (mut last, mut calls) = (0.0, 0);
        while engine.advance(500_000) {
            assert!(engine.growing() && !engine.settled());
            assert!((last..=1.0).contains(&engine.progress()), "{system:?} {last}..{}", engine.progress());
            last = engine.progress();
            calls += 1;
        }
        assert!(engine.settled() && engine.progress() == 1.0, "{system:?}");
        assert!(calls as f64 >= 13_500.0 * engine.steps() as f64 / 600_000.0, "{system:?}: {calls} calls");
    }
}

#[test]
fn spots_of_thirty_times_the_area_settle_in_a_few_times_the_steps_of_the_smallest() {
    let system = System::MEINHARDT_SPOTS;
    let maps = graded(system, [300, 150], Edges::Wrap, 30.0);
    let plain = Growth::new(system, &maps, 1).steps_in(15.0);
    let grown = finished(Engine::from_maps(system, maps, 1), u64::MAX);
    assert!(grown.settled() && plain > 25 * grown.steps(), "{} of {plain}", grown.steps());
    let marks = grown.marks();
    assert_eq!([marks.width, marks.height], [300, 150]);
    // Peaks are everywhere: both ends have grown.
    for columns in [0..75, 225..300] {
        let peak = |x: usize| (0..150).map(|y| marks.values[y * 300 + x]).fold(0.0, f32::max);
        let highest = columns.clone().map(peak).fold(0.0, f32::max);
        assert!((0.85..1.15).contains(&highest), "{columns:?}: {highest}");
    }
}

#[test]
fn marks_too_small_for_a_coarser_grid_have_one_grid() {
    let p = Parameters { rate: 9.0, ratio: 12.0, stretch: 0.6, direction: 0.0, pitch: 1.0 };
    let engine =
        Engine::from_maps(System::MEINHARDT_SPOTS, ParameterField::uniform([80, 70], Edges::Wrap, p), 1);
    assert_eq!(engine.grid_level(), [1, 1]);
    assert!(finished(engine, u64::MAX).settled());
}

#[test]
fn an_engine_can_be_sent_to_another_thread() {
    fn sent<T: Send>(_: &T) {}
    sent(&engine(System::MEINHARDT_STRIPES));
}
