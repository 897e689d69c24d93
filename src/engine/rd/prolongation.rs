//! Transfer of concentrations from a coarse grid to a finer one.

use rayon::prelude::*;

use crate::grid::resample::Spline;
use crate::grid::{Edges, Field, Grid};

/// The value of a spline is kept between the lowest of the four cells around it and this factor times the highest. A spline
/// overshoots between a steep spot and the ground by far more than the values on the ground, and marks begin wherever the activator
/// exceeds the inhibitor. At the peak of a mark that is four cells across the spline is 1.2 times the highest cell.
const OVERSHOOT: f32 = 1.5;

/// A chemical on `from` cells, brought to `to` cells over the same canvas.
///
/// Values of the cubic spline through the cells (`facts.md` I: linear interpolation is as good), limited to the range of the cells
/// around: positive values stay positive, and zeros among zeros stay zero. Constants are unchanged, and so are linear fields away
/// from the border, up to rounding.
#[must_use]
pub fn prolongate(cells: Vec<f32>, from: [usize; 2], to: [usize; 2], edges: Edges) -> Vec<f32> {
    if from == to {
        return cells;
    }
    let field = Field::new(&Grid::unit(from, edges), cells);
    let spline = Spline::new(&field);
    let columns = spline.columns(to[0]);
    let [left, above] = [0, 1].map(|axis| before(from[axis], to[axis]));
    let cells_of = |row: isize| {
        let row = edges.index(row, from[1]);
        &field.values[row * from[0]..(row + 1) * from[0]]
    };
    let mut fine = vec![0.0; to[0] * to[1]];
    let rows = fine.par_chunks_mut(to[0]).zip(above).enumerate();
    rows.for_each_init(Default::default, |(line, ranges): &mut (Vec<f32>, Ranges), (y, (row, above))| {
        spline.row(y, to[1], &columns, line, row);
        ranges.find([cells_of(above), cells_of(above + 1)], edges);
        ranges.keep(row, &left);
    });
    fine
}

/// For each of `to` cells, the last of `from` cells whose centre is not beyond its centre, along one axis; −1 before the first
/// centre.
fn before(from: usize, to: usize) -> Vec<isize> {
    let place = |index: usize| ((index as f64 + 0.5) * from as f64 / to as f64 - 0.5).floor() as isize;
    (0..to).map(place).collect()
}

/// The lowest and the highest value of the four cells around the places between two rows of cells: first for the places before the
/// first column, then for the places after each column.
#[derive(Default)]
struct Ranges {
    between: [Vec<f32>; 2],
    /// A buffer.
    columns: Vec<f32>,
}

impl Ranges {
    /// Between the rows `above` and `below`.
    fn find(&mut self, rows: [&[f32]; 2], edges: Edges) {
        extremes(rows, edges, &mut self.columns, &mut self.between[0], f32::min);
        extremes(rows, edges, &mut self.columns, &mut self.between[1], f32::max);
    }

    /// Keeps each value within the range after the column `left` of it.
    fn keep(&self, values: &mut [f32], left: &[isize]) {
        let [lowest, highest] = &self.between;
        for (value, left) in values.iter_mut().zip(left) {
            let after = (left + 1) as usize;
            *value = kept_within(*value, [lowest[after], highest[after]]);
        }
    }
}

/// The spline's `value` at a point, cells, limited to the range of the `field` around.
#[must_use]
pub fn within_range(value: f32, field: &Field, point: [f64; 2]) -> f32 {
    kept_within(value, field.range_around(point))
}

/// A value of the spline between cells with the `lowest` and the `highest` value.
fn kept_within(value: f32, [lowest, highest]: [f32; 2]) -> f32 {
    value.max(lowest).min(OVERSHOOT * highest)
}

/// The extremes, by `choose`, of the four cells around, for [`Ranges`]. `columns` is a buffer.
fn extremes(
    [above, below]: [&[f32]; 2],
    edges: Edges,
    columns: &mut Vec<f32>,
    between: &mut Vec<f32>,
    choose: impl Fn(f32, f32) -> f32,
) {
    let n = above.len();
    let both = |column: usize| choose(above[column], below[column]);
    columns.clear();
    columns.push(both(edges.index(-1, n)));
    columns.extend(above.iter().zip(below).map(|(above, below)| choose(*above, *below)));
    columns.push(both(edges.index(n as isize, n)));
    between.clear();
    between.extend(columns.array_windows().map(|[left, right]| choose(*left, *right)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_constant_is_unchanged() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let fine = prolongate(vec![0.3; 35], [7, 5], [20, 11], edges);
            assert!(fine.len() == 220 && fine.iter().all(|value| (value - 0.3).abs() < 2e-7), "{edges:?}");
        }
    }

    #[test]
    fn a_slope_is_unchanged_away_from_the_border() {
        let slope = |x: f64, y: f64| (2.0 + 0.5 * x - 0.25 * y) as f32;
        let at = |i: usize, n: usize| (i as f64 + 0.5) * 40.0 / n as f64;
        let coarse: Vec<f32> = (0..1600).map(|i| slope(at(i % 40, 40), at(i / 40, 40))).collect();
        let fine = prolongate(coarse, [40, 40], [80, 100], Edges::Closed);
        for y in 40..60 {
            for x in 30..50 {
                assert!((fine[y * 80 + x] - slope(at(x, 80), at(y, 100))).abs() < 1e-5, "{x} {y}");
            }
        }
    }

    #[test]
    fn the_ground_far_from_a_steep_spot_stays_as_it_was() {
        let mut cells = vec![1e-12; 40 * 40];
        cells[20 * 40 + 20] = 1.0;
        let fine = prolongate(cells, [40, 40], [90, 90], Edges::Closed);
        let far = |index: &usize| (index % 90).abs_diff(46) > 6 || (index / 90).abs_diff(46) > 6;
        let ground = (0..90 * 90).filter(far).map(|index| fine[index]);
        assert!(
            ground.clone().count() > 7_000 && ground.into_iter().all(|value| (1e-12..2e-12).contains(&value))
        );
    }

    proptest! {
        #[test]
        fn what_is_positive_stays_positive(seed: u32, wrap: bool, nx in 1..9_usize, ny in 1..9_usize) {
            let edges = if wrap { Edges::Wrap } else { Edges::Closed };
            let mut state = seed;
            let cells: Vec<f32> = (0..nx * ny).map(|_| {
                state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
                // Steep: from a millionth to one.
                libm::expf(-14.0 * (state >> 8) as f32 / (1 << 24) as f32)
            }).collect();
            let fine = prolongate(cells, [nx, ny], [2 * nx + 1, 3 * ny], edges);
            prop_assert!(fine.iter().all(|value| *value > 0.0 && value.is_finite()));
        }
    }
}
