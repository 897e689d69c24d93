//! Systems of pairs: linear theory, comparison with the plain solver, and crossing threads of weaves.

use super::*;
use crate::grid::{Domain, Edges};
use crate::rd::wavefront::{Instructions, Tiling};

fn grid(side: usize) -> Grid {
    Grid::unit([side, side], Edges::Wrap)
}

fn maps(side: usize, pairs: &[(f32, f32)]) -> PairParameterField {
    let grid = grid(side);
    let field = |(direction, size): &(f32, f32)| {
        PairField::uniform(grid.cells(), *direction, *size, Blurs::Along(3.0))
    };
    PairParameterField {
        pairs: pairs.iter().map(field).collect(),
        grid,
        obstacles: Vec::new(),
        raised: Vec::new(),
    }
}

fn model(combination: Combination, threshold: f32) -> PairModel {
    PairModel {
        combination,
        ratio: 1.5,
        threshold: Course::Ramp { to: threshold, first: 4.0, each: 2.0 },
        softness: 0.05,
        weights: [1.0; MOST_PAIRS],
        gain: Course::Constant(1.0),
    }
}

/// A wave with `k` radians per cell along x and y: 0, ½ and 1 at its lowest, middle and highest.
fn wave(grid: &Grid, [kx, ky]: [f64; 2]) -> Vec<f32> {
    let at = |cell: usize| {
        let [x, y] = [(cell % grid.size[0]) as f64, (cell / grid.size[0]) as f64];
        (0.5 + 0.5 * (kx * x + ky * y).cos()) as f32
    };
    (0..grid.cells()).map(at).collect()
}

#[test]
fn a_held_wave_comes_out_with_the_gain_of_the_theory() {
    // λ± = 1 + kᵀA±k; D = R (1/λ₊ − 1/λ₋).
    let maps = maps(64, &[(0.0, 2.0)]);
    let model = model(Combination::Maximum, 0.0);
    let tau = std::f64::consts::TAU;
    for (kx, ky) in [(0.0, tau / 16.0), (tau / 16.0, 0.0), (tau / 32.0, tau / 16.0)] {
        let start = PairStart::Drawn(wave(&maps.grid, [kx, ky]));
        let grown = PairGrowth::new(&maps, &model, &start).expect("one pair");
        let difference = &grown.differences()[0].values;
        let swing = difference.iter().copied().fold(f32::MIN, f32::max)
            - difference.iter().copied().fold(f32::MAX, f32::min);
        // The symbol of the stencil replaces k² by 2 − 2cos k.
        let (x, y) = (2.0 - 2.0 * kx.cos(), 2.0 - 2.0 * ky.cos());
        let lambda = |across: f64| 1.0 + 4.0 * (9.0 * x + across * across * y);
        let wanted = 1.0 / lambda(1.0) - 1.0 / lambda(1.5);
        assert!((f64::from(swing) - wanted).abs() < 0.01 * 0.2, "{kx} {ky}: {swing} for {wanted}");
    }
}

#[test]
fn the_wavelength_with_the_largest_gain_is_that_of_the_theory() {
    let model = model(Combination::Maximum, 0.0);
    let gain = |k: f64| 1.0 / (1.0 + k * k) - 1.0 / (1.0 + 2.25 * k * k);
    let k = std::f64::consts::TAU / model.wavelength();
    assert!((gain(k) - f64::from(model.peak_gain())).abs() < 1e-6);
    assert!(gain(1.02 * k) < gain(k) && gain(0.98 * k) < gain(k));
}

#[test]
fn all_instructions_and_tilings_give_the_bits_of_the_plain_solver() {
    for (pairs, combination) in [
        (vec![(30.0, 1.5)], Combination::Maximum),
        (vec![(0.0, 1.5), (67.0, 2.0)], Combination::Maximum),
        (vec![(0.0, 1.5), (60.0, 1.5), (120.0, 1.5)], Combination::DifferenceOfAbsolutes),
        (vec![(0.0, 1.5), (36.0, 1.5), (72.0, 1.5), (108.0, 1.5), (144.0, 1.5)], Combination::Maximum),
    ] {
        let mut maps = maps(50, &pairs);
        // Directions and sizes that vary, and a closed border.
        maps.grid.edges = Edges::Closed;
        for (cell, size) in maps.pairs[0].size.iter_mut().enumerate() {
            *size += 0.01 * (cell % 50) as f32;
        }
        maps.obstacles = (0..2_500).map(|cell| cell % 50 < 5 && cell < 500).collect();
        if pairs.len() == 2 {
            maps.raised = (0..2_500).map(|cell| 0.01 * (cell % 50) as f32).collect();
        }
        let model = model(combination, 0.1);
        let mut plain = PairGrowth::new(&maps, &model, &PairStart::Noise(7)).expect("fits");
        let begun = plain.clone();
        plain.advance_plain(40);
        for instructions in Instructions::available() {
            for (time_steps, bands) in [(1, 1), (4, 2), (7, 3)] {
                let mut fast = begun.clone();
                fast.advance_as(40, Tiling { time_steps, bands }, instructions);
                assert_eq!(
                    fast.concentrations(),
                    plain.concentrations(),
                    "{instructions:?} {time_steps} {bands}"
                );
            }
        }
    }
}

/// Share of the cells at which the difference is above the threshold, for each pair.
fn shares(growth: &PairGrowth, threshold: f32) -> Vec<f64> {
    let share = |field: &crate::grid::Field| {
        field.values.iter().filter(|d| **d > threshold).count() as f64 / field.values.len() as f64
    };
    growth.differences().iter().map(share).collect()
}

#[test]
fn both_directions_of_a_weave_grow_and_cross() {
    let maps = maps(128, &[(0.0, 1.5), (90.0, 1.5)]);
    let model = model(Combination::Maximum, 0.15);
    let mut growth = PairGrowth::new(&maps, &model, &PairStart::Noise(1)).expect("two pairs");
    growth.advance(growth.steps_in(40.0));
    let threshold = 0.15 * model.peak_gain();
    // `facts.md` T: .28 each way.
    for share in shares(&growth, threshold) {
        assert!((0.24..0.33).contains(&share), "{share}");
    }
    let [warp, weft] = &growth.differences()[..] else { panic!("two pairs") };
    let both =
        warp.values.iter().zip(&weft.values).filter(|(a, b)| **a > threshold && **b > threshold).count();
    let share = both as f64 / warp.values.len() as f64;
    assert!((0.05..0.12).contains(&share), "threads cross on {share}");
}

#[test]
fn lines_of_a_maze_do_not_cross() {
    let mut maps = maps(128, &[(0.0, 1.5), (90.0, 1.5)]);
    maps.pairs.iter_mut().for_each(|pair| pair.blurs = Blurs::Along(2.0));
    let model =
        PairModel { threshold: Course::Constant(0.0), ..model(Combination::DifferenceOfAbsolutes, 0.0) };
    let mut growth = PairGrowth::new(&maps, &model, &PairStart::Noise(1)).expect("two pairs");
    growth.advance(growth.steps_in(40.0));
    let [a, b] = &growth.differences()[..] else { panic!("two pairs") };
    let level = 0.3 * model.peak_gain();
    let both = a.values.iter().zip(&b.values).filter(|(a, b)| **a > level && **b > level).count();
    assert!(both < a.values.len() / 50, "{both} of {}", a.values.len());
    for share in shares(&growth, level) {
        assert!(share > 0.08, "a direction died: {share}");
    }
}

#[test]
fn a_drawn_line_stays_where_it_is_and_nothing_else_grows() {
    // One line across a canvas, with a threshold at which no other line appears.
    let maps = maps(96, &[(0.0, 2.0), (90.0, 2.0)]);
    let threshold = Course::Constant(0.25);
    let model = PairModel { threshold, ..model(Combination::Maximum, 0.25) };
    let drawn = (0..96 * 96).map(|cell| f32::from(u8::from((40..45).contains(&(cell / 96))))).collect();
    let mut growth = PairGrowth::new(&maps, &model, &PairStart::Drawn(drawn)).expect("two pairs");
    growth.advance(growth.steps_in(30.0));
    let threshold = 0.25 * model.peak_gain();
    let [along, across] = &growth.differences()[..] else { panic!("two pairs") };
    let inside: Vec<usize> = (0..96).filter(|y| along.values[y * 96 + 50] > threshold).collect();
    assert!(inside.contains(&42) && inside.iter().all(|y| (37..=47).contains(y)), "{inside:?}");
    assert!(across.values.iter().all(|d| *d < threshold));
}

/// Mean width of the areas above `level` along the columns of a square field, cells, by linear interpolation.
fn width_along_columns(field: &crate::grid::Field, level: f32) -> f64 {
    let (side, mut covered, mut lines) = (field.width, 0.0, 0);
    for x in 0..side {
        for y in 0..side {
            let [here, next] = [y, (y + 1) % side].map(|y| f64::from(field.values[y * side + x] - level));
            let cut = here / (here - next);
            covered += match (here > 0.0, next > 0.0) {
                (true, true) => 1.0,
                (true, false) => cut,
                (false, true) => 1.0 - cut,
                (false, false) => 0.0,
            };
            lines += usize::from(here <= 0.0 && next > 0.0);
        }
    }
    covered / lines as f64
}

#[test]
fn drawn_threads_keep_their_width_at_the_size_of_the_law() {
    let threads = [Threads { width: 5.0, period: 16.0 }, Threads { width: 8.0, period: 48.0 }];
    let model = model(Combination::Maximum, 0.0);
    let found = |own: usize| {
        threads[own].threshold(&model, 1.0 - threads[1 - own].duty(), 0.2, 1.0).expect("not too dense")
    };
    let [(threshold, size), (other, other_size)] = [0, 1].map(found);
    assert!((0.08..0.22).contains(&threshold) && other > threshold, "{threshold} {other}");
    let sizes = [size, other_size];
    let maps = maps(96, &[(0.0, sizes[0] as f32), (90.0, sizes[1] as f32)]);
    let covered = |at: usize, threads: &Threads| at as f64 % threads.period < threads.width;
    let is_drawn = |cell: usize| covered(cell / 96, &threads[0]) || covered(cell % 96, &threads[1]);
    let drawn = (0..96 * 96).map(|cell| f32::from(u8::from(is_drawn(cell)))).collect();
    let smallest = sizes.iter().copied().fold(f64::INFINITY, f64::min) as f32;
    let softness = PairModel::softness_for(smallest, threshold as f32);
    let mut weights = model.weights;
    weights[1] = (threshold / other) as f32;
    let model = PairModel { threshold: Course::Constant(threshold as f32), softness, weights, ..model };
    let mut growth = PairGrowth::new(&maps, &model, &PairStart::Drawn(drawn)).expect("two pairs");
    growth.advance(growth.steps_in(20.0));
    let [level, other_level] = [threshold, other].map(|threshold| threshold as f32 * model.peak_gain());
    let differences = growth.differences();
    let turned = |field: &crate::grid::Field| {
        let values = (0..96 * 96).map(|cell| field.values[cell % 96 * 96 + cell / 96]).collect();
        crate::grid::Field { values, ..field.clone() }
    };
    let widths = [
        width_along_columns(&differences[0], level),
        width_along_columns(&turned(&differences[1]), other_level),
    ];
    for (width, threads) in widths.iter().zip(&threads) {
        assert!(
            (width / threads.width - 1.0).abs() < 0.08,
            "{width} for {threads:?} at {threshold}, {sizes:?}"
        );
    }
}

#[test]
fn threads_that_cover_too_much_have_no_threshold() {
    let model = model(Combination::Maximum, 0.0);
    let dense = Threads { width: 8.0, period: 10.0 };
    assert_eq!(dense.threshold(&model, 1.0 - dense.duty(), 0.2, 1.0), None);
    let alone = Threads { width: 5.0, period: 5_000.0 };
    let size = alone.size(&model, 0.2, 1.0).expect("a thread alone");
    // θ = ½ (e^(−w/ds) − e^(−w/s)) for a single thread.
    let x = 5.0 / size;
    assert!((0.5 * ((-x / 1.5).exp() - (-x).exp()) - 0.2 * 0.2).abs() < 1e-6, "{x}");
}

#[test]
fn a_course_goes_through_its_values() {
    let ramp = Course::Ramp { to: 0.4, first: 4.0, each: 2.0 };
    for (time, value) in
        [(0.0, 0.0), (3.9, 0.0), (4.1, 0.1), (6.1, 0.2), (8.1, 0.3), (10.1, 0.4), (99.0, 0.4)]
    {
        assert!((ramp.at(time) - value).abs() < 1e-6, "{time}");
    }
    let decay = Course::Decay { from: 3.0, rate: 0.5, until: 2.0 };
    assert!((decay.at(2.0) - 3.0 * (-1.0f32).exp()).abs() < 1e-6 && decay.at(5.0) == decay.at(2.0));
}

#[test]
fn maps_that_do_not_fit_are_refused() {
    let model = model(Combination::Maximum, 0.1);
    let grow = |maps: &PairParameterField, start: &PairStart| PairGrowth::new(maps, &model, start).is_some();
    assert!(grow(&maps(16, &[(0.0, 1.5)]), &PairStart::Noise(1)));
    assert!(!grow(&maps(16, &[]), &PairStart::Noise(1)));
    assert!(!grow(&maps(16, &[(0.0, 1.5); 6]), &PairStart::Noise(1)));
    assert!(!grow(&maps(16, &[(0.0, 1.5)]), &PairStart::Drawn(vec![0.0; 3])));
    assert!(!grow(&maps(16, &[(0.0, 1.5)]), &PairStart::Grown(vec![vec![0.0; 256]; 3])));
    let mut short = maps(16, &[(0.0, 1.5)]);
    short.pairs[0].size.pop();
    assert!(!grow(&short, &PairStart::Noise(1)));
}

#[test]
fn nothing_grows_where_the_threshold_is_raised() {
    let mut maps = maps(96, &[(0.0, 1.5)]);
    maps.raised = (0..96 * 96).map(|cell| if cell / 96 < 48 { 0.0 } else { 1.0 }).collect();
    let mut growth =
        PairGrowth::new(&maps, &model(Combination::Maximum, 0.1), &PairStart::Noise(1)).expect("one pair");
    growth.advance(growth.steps_in(30.0));
    let level = 0.1 * model(Combination::Maximum, 0.1).peak_gain();
    let difference = &growth.differences()[0].values;
    let share = |rows: std::ops::Range<usize>| {
        let cells = &difference[96 * rows.start..96 * rows.end];
        cells.iter().filter(|value| **value > level).count() as f64 / cells.len() as f64
    };
    assert!(share(6..42) > 0.3 && share(54..90) == 0.0, "{} {}", share(6..42), share(54..90));
    assert_eq!(growth.concentrations().len(), 2);
}

/// Drawn lines of two pairs; the second is `times` as large as the first.
fn of_two_sizes(times: f64) -> (PairParameterField, PairModel, PairStart) {
    let maps = maps(96, &[(0.0, 1.75), (90.0, (1.75 * times) as f32)]);
    let is_drawn = |cell: usize| cell / 96 % 16 < 5 || (cell % 96) as f64 % 48.0 < 4.0 * times;
    let drawn = (0..96 * 96).map(|cell| f32::from(u8::from(is_drawn(cell)))).collect();
    (
        maps,
        PairModel { threshold: Course::Constant(0.15), ..model(Combination::Maximum, 0.15) },
        PairStart::Drawn(drawn),
    )
}

#[test]
fn pairs_on_grids_of_their_own_grow_what_they_grow_on_one() {
    let (maps, model, start) = of_two_sizes(2.5);
    let level = 0.15 * model.peak_gain();
    let widths = [PairGrowth::new, PairGrowth::on_one_grid].map(|new| {
        let mut growth = new(&maps, &model, &start).expect("two pairs");
        growth.advance(growth.steps_in(12.0));
        let differences = growth.differences();
        let values = (0..96 * 96).map(|cell| differences[1].values[cell % 96 * 96 + cell / 96]).collect();
        let turned = crate::grid::Field { values, ..differences[1].clone() };
        [width_along_columns(&differences[0], level), width_along_columns(&turned, level)]
    });
    for (own, shared) in widths[0].iter().zip(&widths[1]) {
        assert!((own / shared - 1.0).abs() < 0.02, "{widths:?}");
    }
}

#[test]
fn pairs_on_grids_of_their_own_have_fewer_cells_and_steps() {
    let (maps, model, start) = of_two_sizes(2.5);
    let steps = [PairGrowth::new, PairGrowth::on_one_grid]
        .map(|new| new(&maps, &model, &start).expect("two pairs").steps_in(12.0));
    // Whole super steps are counted there.
    assert!(48 == steps[0] && steps[1] > 600, "{steps:?}");
    let (maps, model, start) = of_two_sizes(1.2);
    let steps = PairGrowth::new(&maps, &model, &start).expect("two pairs").steps_in(12.0);
    assert!(steps > 200, "sizes that hardly differ have one grid: {steps}");
}

#[test]
fn pairs_on_grids_of_their_own_have_the_bits_of_the_plain_solver() {
    let (mut maps, model, start) = of_two_sizes(2.0);
    maps.grid.edges = Edges::Closed;
    maps.raised = (0..96 * 96).map(|cell| 0.001 * (cell % 96) as f32).collect();
    let begun = PairGrowth::new(&maps, &model, &start).expect("two pairs");
    let mut plain = begun.clone();
    plain.advance_plain(5);
    for instructions in Instructions::available() {
        for bands in [1, 3] {
            let mut fast = begun.clone();
            fast.advance_as(5, Tiling { time_steps: 1, bands }, instructions);
            assert_eq!(fast.concentrations(), plain.concentrations(), "{instructions:?} {bands}");
        }
    }
    let grown = PairStart::Grown(plain.concentrations());
    let again = PairGrowth::new(&maps, &model, &grown).expect("two pairs");
    let [before, after] = [&plain, &again].map(PairGrowth::differences);
    let off = before[0].values.iter().zip(&after[0].values).map(|(a, b)| (a - b).abs());
    assert!(off.fold(0.0, f32::max) < 0.01 * model.peak_gain());
}
