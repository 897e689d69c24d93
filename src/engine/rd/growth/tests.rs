//! Growth of every system: its pattern, and that only seed and parameters determine it.

use super::*;
use crate::grid::Edges;

/// About 30 spots or 8 stripes on a small torus.
fn small(system: System) -> (ParameterField, Growth) {
    let rate = system.definition().usual_rate;
    let maps = ParameterField::uniform(
        [90, 84],
        Edges::Wrap,
        Parameters { rate, ratio: 20.0, stretch: 0.6, direction: 30.0, pitch: 1.0 },
    );
    let growth = Growth::new(system, &maps, 3);
    (maps, growth)
}

#[test]
fn every_system_grows_its_pattern_from_a_seed() {
    for (system, cover) in [
        (System::TURING_SPOTS, 0.10..0.45),
        (System::MEINHARDT_SPOTS, 0.05..0.12),
        (System::MEINHARDT_STRIPES, 0.45..0.55),
        (System::MEINHARDT_LINES, 0.25..0.45),
    ] {
        let (_, mut growth) = small(system);
        growth.advance(growth.steps_in(30.0));
        let marks = growth.marks().values;
        let share = marks.iter().filter(|v| **v > 0.5).count() as f64 / marks.len() as f64;
        let lowest = marks.iter().copied().fold(f32::INFINITY, f32::min);
        let highest = marks.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        assert!(cover.contains(&share), "{system:?} covers {share}");
        // A line is higher at its end.
        let ends = if system == System::MEINHARDT_LINES { 1.3 } else { 1.15 };
        assert!((-0.1..0.15).contains(&lowest) && (0.85..ends).contains(&highest), "{lowest}..{highest}");
    }
}

#[test]
fn a_grown_pattern_is_stationary() {
    for system in System::ALL {
        let (maps, mut growth) = small(system);
        growth.advance(growth.steps_in(60.0));
        let before = growth.marks().values;
        let mut again = Growth::resumed(system, &maps, growth.concentrations()).expect("fits");
        again.advance(again.steps_in(5.0));
        let after = again.marks().values;
        let moved: f32 = before.iter().zip(&after).map(|(b, a)| (b - a).abs()).sum();
        let total: f32 = before.iter().sum();
        assert!(moved < 0.02 * total, "{system:?} moved by {}", moved / total);
    }
}

#[test]
fn marks_are_brought_up_to_date_and_compared_where_they_count() {
    let (_, mut growth) = small(System::MEINHARDT_SPOTS);
    let mut marks = growth.marks().values;
    let before = marks.clone();
    growth.advance(40);
    let count: Vec<bool> = (0..marks.len()).map(|cell| cell % 3 != 0).collect();
    let [moved, total] = growth.update_marks(&mut marks, &count);
    assert_eq!(marks, growth.marks().values);
    let counted = || (0..marks.len()).filter(|cell| count[*cell]);
    let expected: f64 = counted().map(|cell| f64::from((marks[cell] - before[cell]).abs())).sum();
    assert!((moved / expected - 1.0).abs() < 1e-9 && moved > 0.0, "{moved} {expected}");
    let expected: f64 = counted().map(|cell| f64::from(marks[cell].max(0.0))).sum();
    assert!((total / expected - 1.0).abs() < 1e-9, "{total} {expected}");
}

#[test]
fn a_resumed_growth_equals_an_uninterrupted_one_bit_for_bit() {
    for system in System::ALL {
        let (maps, mut growth) = small(system);
        growth.advance(40);
        let mut again = Growth::resumed(system, &maps, growth.concentrations()).expect("fits");
        growth.advance(25);
        again.advance(25);
        assert!(growth.concentrations() == again.concentrations(), "{system:?}");
    }
}

#[test]
fn frozen_cells_are_unchanged_and_affect_their_neighbours() {
    for system in System::ALL {
        let (_, mut growth) = small(system);
        growth.advance(50);
        let (before, mut free, mut plain) = (growth.concentrations(), growth.clone(), growth.clone());
        let frozen = |cell: usize| cell % 90 < 40 && cell / 90 > 20;
        growth.freeze(frozen);
        plain.freeze(frozen);
        growth.advance(30);
        plain.advance_plain(30);
        free.advance(30);
        assert!(growth.concentrations() == plain.concentrations(), "{system:?}");
        let beside = 90 * 50 + 40;
        for ((before, after), free) in before.iter().zip(growth.concentrations()).zip(free.concentrations()) {
            for (cell, value) in before.iter().enumerate().filter(|(cell, _)| frozen(*cell)) {
                assert_eq!(value.to_bits(), after[cell].to_bits(), "{system:?} {cell}");
            }
            assert!(before[beside] != after[beside] && free[beside] != after[beside], "{system:?}");
        }
    }
}

#[test]
fn concentrations_of_turings_system_stay_non_negative_where_a_step_overshoots() {
    // Found by tests/properties: room for one spot, at the largest rate that is looked up.
    let p = Parameters { rate: 0.38, ratio: 3.8, stretch: 0.3, direction: 0.7, pitch: 1.0 };
    let maps = ParameterField::uniform([8, 8], Edges::Wrap, p);
    let mut growth = Growth::new(System::TURING_SPOTS, &maps, 0);
    for _ in 0..12 {
        growth.advance(25);
        let concentrations = growth.concentrations();
        assert!(concentrations.iter().flatten().all(|value| value.is_finite() && *value >= 0.0));
    }
}

#[test]
fn concentrations_of_another_grid_are_refused() {
    let (maps, growth) = small(System::TURING_SPOTS);
    let mut concentrations = growth.concentrations();
    concentrations[0].pop();
    assert!(Growth::resumed(System::TURING_SPOTS, &maps, concentrations).is_none());
    assert!(Growth::resumed(System::MEINHARDT_STRIPES, &maps, growth.concentrations()).is_none());
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let grown = |system: System, threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let p = Parameters { rate: 2.0, ratio: 15.0, stretch: 0.5, direction: 70.0, pitch: 1.0 };
            let maps = ParameterField::uniform([300, 260], Edges::Closed, p);
            let mut growth = Growth::new(system, &maps, 9);
            growth.advance(50);
            growth.concentrations()
        })
    };
    for system in [System::MEINHARDT_SPOTS, System::MEINHARDT_LINES] {
        assert!(grown(system, 1) == grown(system, 4), "{system:?}");
    }
}
