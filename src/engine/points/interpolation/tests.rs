use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::grid::Edges;
use crate::points::extent::Extent;

/// Random points with random values and directions on a canvas of 130 × 90 px.
struct Case {
    graph: Delaunay,
    values: Vec<f32>,
    directions: Vec<[f64; 2]>,
    grid: Grid,
}

fn case(wrap: [bool; 2], count: usize, cell: f64) -> Case {
    let mut rng = Pcg64Mcg::seed_from_u64(count as u64);
    let extent = Extent { size: [130.0, 90.0], wrap };
    let points: Vec<[f64; 2]> =
        (0..count).map(|_| [130.0 * rng.random::<f64>(), 90.0 * rng.random::<f64>()]).collect();
    let values = (0..count).map(|_| rng.random::<f32>()).collect();
    let direction = |turn: f64| [libm::cos(turn), libm::sin(turn)];
    let directions = (0..count).map(|_| direction(6.3 * rng.random::<f64>())).collect();
    let size = [130.0, 90.0].map(|side| (side / cell) as usize);
    let edges = if wrap == [true; 2] { Edges::Wrap } else { Edges::Closed };
    Case {
        graph: Delaunay::new(&points, extent),
        values,
        directions,
        grid: Grid { size, cell: [cell; 2], edges },
    }
}

/// The weight of a point at `displacement` from it, directly by equations 1, 2 and 4.
fn weight(graph: &Delaunay, point: usize, displacement: [f64; 2], weights: &Weights) -> f64 {
    let mut product = 1.0;
    for axis in graph.axes(point) {
        let square =
            axis.displacement[0] * axis.displacement[0] + axis.displacement[1] * axis.displacement[1];
        let p = (displacement[0] * axis.displacement[0] + displacement[1] * axis.displacement[1])
            / (weights.length * square);
        let p = p.clamp(0.0, 1.0);
        product *= (1.0 - p) * (1.0 - p) * (1.0 + 2.0 * p);
    }
    let away = libm::hypot(displacement[0], displacement[1]);
    let Some(Orientation { strength, directions }) = weights.orientation.filter(|_| away > 0.0) else {
        return product;
    };
    let k =
        strength * (displacement[0] * directions[point][0] + displacement[1] * directions[point][1]) / away;
    libm::pow(product, if k >= 0.0 { 1.0 - k } else { 1.0 / (1.0 + k) })
}

/// Reference for [`interpolate`] that adds every point and every image near the canvas at every px. Returns the value, the sum of
/// weights and the number of supports.
fn plain(case: &Case, at: [f64; 2], weights: &Weights) -> (f64, f64, usize) {
    let (mut sum, mut total, mut supports) = (0.0, 0.0, 0);
    let shifts = |axis: usize| if case.graph.extent.wrap[axis] { -3..=3 } else { 0..=0 };
    for (point, center) in case.graph.points.iter().enumerate() {
        for down in shifts(1) {
            for across in shifts(0) {
                let shift = [f64::from(across) * 130.0, f64::from(down) * 90.0];
                let displacement = [0, 1].map(|axis| at[axis] - center[axis] - shift[axis]);
                let weight = weight(&case.graph, point, displacement, weights);
                sum += weight * f64::from(case.values[point]);
                total += weight;
                supports += usize::from(weight > 0.0);
            }
        }
    }
    (sum / total, total, supports)
}

#[test]
fn the_fast_sum_agrees_with_the_direct_one() {
    for (wrap, count, cell) in [
        ([true; 2], 60, 1.0),
        ([false; 2], 60, 2.0),
        ([true, false], 9, 1.0),
        ([true; 2], 2, 2.0),
        ([false; 2], 1, 5.0),
    ] {
        let case = case(wrap, count, cell);
        for length in [0.6, 1.0, 1.2, 2.0] {
            for shifted in [false, true] {
                let orientation =
                    shifted.then_some(Orientation { strength: 0.5, directions: &case.directions });
                let weights = Weights { length, orientation };
                let field = interpolate(&case.graph, &case.values, &case.grid, &weights);
                for (cell, value) in field.values.iter().enumerate().step_by(37) {
                    let (expected, total, _) = plain(&case, case.grid.center_px(cell), &weights);
                    // Where the sum of the weights is tiny, at L = .6, an f32 product is not accurate.
                    let allowed = if total > 1e-3 { 2e-5 } else { 0.05 };
                    let apart = (f64::from(*value) - expected).abs();
                    assert!(apart < allowed, "{wrap:?}, {count}, L {length}, {shifted}: {value}, {expected}");
                }
            }
        }
    }
}

#[test]
fn each_px_lies_in_4_l_squared_supports() {
    for (count, length) in [(40, 1.0), (400, 1.0), (60, 2.0)] {
        let case = case([true; 2], count, 2.0);
        let weights = Weights { length, ..Weights::default() };
        let supports = Supports::new(&case.graph, &case.grid, &weights);
        let mut found = 0;
        for band in 0..case.grid.size[1].div_ceil(BAND) {
            let rows = band * BAND..((band + 1) * BAND).min(case.grid.size[1]);
            supports.each_run(rows, |_, _, run, _| found += run.len());
        }
        let mean = found as f64 / (case.grid.size[0] * case.grid.size[1]) as f64;
        assert!((mean / (4.0 * length * length) - 1.0).abs() < 0.02, "{count}, L {length}: {mean}");
        let by_place = |cell: usize| plain(&case, case.grid.center_px(cell), &weights).2;
        let some = (0..case.grid.size[0] * case.grid.size[1]).step_by(23);
        let mean = some.clone().map(by_place).sum::<usize>() as f64 / some.count() as f64;
        assert!((mean / (4.0 * length * length) - 1.0).abs() < 0.1, "{count}, L {length}: {mean}");
    }
}

#[test]
fn values_are_exact_at_the_points_for_axes_of_length_1() {
    let case = case([true; 2], 80, 1.0);
    for (point, at) in case.graph.points.iter().enumerate() {
        let (value, ..) = plain(&case, *at, &Weights::default());
        assert!((value - f64::from(case.values[point])).abs() < 1e-9);
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let case = case([true; 2], 300, 0.5);
    let weights = Weights { length: 1.2, ..Weights::default() };
    let run = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| {
            let field = interpolate(&case.graph, &case.values, &case.grid, &weights);
            (field, highest_weight(&case.graph, &case.grid, &weights))
        })
    };
    assert!(run(1) == run(3));
}

#[test]
fn a_tile_has_no_seam() {
    // The same points moved by a whole number of px give the field moved by the same number.
    let case = case([true; 2], 70, 1.0);
    let moved: Vec<[f64; 2]> = case.graph.points.iter().map(|[x, y]| [x + 40.0, y + 25.0]).collect();
    let moved = Delaunay::new(&moved, case.graph.extent);
    let weights = Weights::default();
    let [one, other] =
        [&case.graph, &moved].map(|graph| interpolate(graph, &case.values, &case.grid, &weights));
    for y in 0..90 {
        for x in 0..130 {
            let apart = one.get(x, y) - other.get(x + 40, y + 25);
            assert!(apart.abs() < 1e-5, "{x}, {y}: {apart}");
        }
    }
}

#[test]
fn the_point_of_the_highest_weight_is_mostly_the_nearest_and_not_always() {
    let case = case([true; 2], 60, 1.0);
    let owners = highest_weight(&case.graph, &case.grid, &Weights::default());
    let nearest = |at: [f64; 2]| {
        let square = |center: &[f64; 2]| {
            let displacement = case.graph.extent.shortest([at[0] - center[0], at[1] - center[1]]);
            displacement[0] * displacement[0] + displacement[1] * displacement[1]
        };
        let squares: Vec<f64> = case.graph.points.iter().map(square).collect();
        (0..squares.len()).min_by(|a, b| squares[*a].total_cmp(&squares[*b])).expect("points") as u32
    };
    let others =
        (0..owners.len()).filter(|cell| owners[*cell] != nearest(case.grid.center_px(*cell))).count();
    let share = others as f64 / owners.len() as f64;
    assert!((0.005..0.12).contains(&share), "{share}");
}

#[test]
fn a_canvas_without_points_is_0() {
    let case = case([true; 2], 1, 5.0);
    let none = Delaunay::new(&[], case.graph.extent);
    assert!(
        interpolate(&none, &[], &case.grid, &Weights::default()).values.iter().all(|value| *value == 0.0)
    );
    assert!(highest_weight(&none, &case.grid, &Weights::default()).iter().all(|owner| *owner == NOBODY));
}

#[test]
fn an_updated_field_equals_a_field_interpolated_anew() {
    let case = case([true; 2], 60, 1.0);
    let interpolator = Interpolator::new(&case.graph, &case.grid, &Weights::default());
    let old: Vec<f32> = (0..60u8).map(|point| f32::from(point % 7)).collect();
    let mut new = old.clone();
    (new[3], new[41]) = (9.0, -2.0);
    let changed: Vec<bool> = old.iter().zip(&new).map(|(old, new)| old != new).collect();
    let mut field = interpolator.field(&old);
    assert_ne!(field, interpolator.field(&new));
    interpolator.update(&mut field, &new, &changed);
    assert_eq!(field, interpolator.field(&new));
}
