//! Distance transform: from each cell of a grid to the nearest of some cells, and which one that is.
//!
//! d²(x, y) = min over covered (x′, y′) of ((x − x′)·w)² + ((y − y′)·h)², of cells w × h px: first along the columns,
//! then the lower envelope of one parabola a column along each row.
//!
//! Felzenszwalb & Huttenlocher, "Distance transforms of sampled functions", Theory of Computing 8 (2012); exact.

use rayon::prelude::*;

use super::cells::Grid;
use super::edges::Edges;

/// [columns, rows] from each cell of `grid` to the nearest one that is `covered`, row by row. On a wrapped grid the shortest
/// displacement may cross the border. `None` where no cell is covered.
#[must_use]
pub fn nearest(covered: &[bool], grid: &Grid) -> Option<Vec<[i32; 2]>> {
    if !covered.contains(&true) {
        return None;
    }
    let ([nx, ny], edges) = (grid.size, grid.edges);
    let down = along_columns(covered, [nx, ny], edges);
    let mut offsets = vec![[0; 2]; nx * ny];
    let rows = offsets.par_chunks_mut(nx).zip(down.par_chunks(nx));
    rows.for_each_init(Vec::new, |envelope, (row, down)| along_row(row, down, grid.cell, edges, envelope));
    Some(offsets)
}

/// Length of such an offset, px.
#[must_use]
pub fn length([columns, rows]: [i32; 2], grid: &Grid) -> f64 {
    let [x, y] = grid.to_px([columns, rows].map(f64::from));
    (x * x + y * y).sqrt()
}

/// No covered cell in this column.
const NONE: i32 = i32::MAX;

/// Rows to the nearest covered cell of the same column.
fn along_columns(covered: &[bool], [nx, ny]: [usize; 2], edges: Edges) -> Vec<i32> {
    let mut down = vec![NONE; nx * ny];
    // Two rounds where the last row is next to the first.
    let rounds = if edges == Edges::Wrap { 2 * ny as i32 } else { ny as i32 };
    // All columns together, row by row: neighbours in a row are neighbours in memory.
    for upward in [false, true] {
        let mut last = vec![NONE; nx];
        for step in 0..rounds {
            let at = if upward { rounds - 1 - step } else { step };
            let row = at as usize % ny * nx;
            let cells = down[row..row + nx].iter_mut().zip(&covered[row..row + nx]);
            for ((down, covered), last) in cells.zip(&mut last) {
                if *covered {
                    *last = at;
                }
                let displacement = if *last == NONE { NONE } else { *last - at };
                if displacement.saturating_abs() < down.saturating_abs() {
                    *down = displacement;
                }
            }
        }
    }
    down
}

/// A parabola of the lower envelope: its column, how far down its cell is, and from where on it is the lowest.
struct Parabola {
    column: i32,
    down: i32,
    height: f64,
    from: f64,
}

fn along_row(row: &mut [[i32; 2]], down: &[i32], cell: [f64; 2], edges: Edges, envelope: &mut Vec<Parabola>) {
    let nx = down.len() as i32;
    let columns = if edges == Edges::Wrap { -nx..2 * nx } else { 0..nx };
    envelope.clear();
    for column in columns {
        let down = down[column.rem_euclid(nx) as usize];
        if down == NONE {
            continue;
        }
        // In units of columns.
        let high = f64::from(down) * cell[1] / cell[0];
        let height = high * high + f64::from(column) * f64::from(column);
        let mut from = f64::NEG_INFINITY;
        while let Some(before) = envelope.last() {
            from = (height - before.height) / (2.0 * f64::from(column - before.column));
            if from > before.from {
                break;
            }
            envelope.pop();
            from = f64::NEG_INFINITY;
        }
        envelope.push(Parabola { column, down, height, from });
    }
    let mut at = 0;
    for (x, offset) in row.iter_mut().enumerate() {
        while envelope.get(at + 1).is_some_and(|next| next.from <= x as f64) {
            at += 1;
        }
        *offset = [envelope[at].column - x as i32, envelope[at].down];
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Distances to the nearest covered cell, found by trying all of them.
    fn slow(covered: &[bool], grid: &Grid) -> Vec<f64> {
        let [nx, ny] = grid.size.map(|n| n as i32);
        let around: &[i32] = if grid.edges == Edges::Wrap { &[-1, 0, 1] } else { &[0] };
        let to = |x: i32, y: i32| {
            let all = (0..nx * ny).filter(|i| covered[*i as usize]).flat_map(|i| {
                let shifts = around.iter().flat_map(|j| around.iter().map(move |i| [*i, *j]));
                shifts.map(move |[sx, sy]| [i % nx + sx * nx - x, i / nx + sy * ny - y])
            });
            all.map(|offset| length(offset, grid)).fold(f64::INFINITY, f64::min)
        };
        (0..nx * ny).map(|i| to(i % nx, i / nx)).collect()
    }

    #[test]
    fn the_distance_without_covered_cells_is_infinite() {
        assert_eq!(nearest(&[false; 6], &Grid::unit([3, 2], Edges::Wrap)), None);
    }

    #[test]
    fn the_distance_is_measured_across_the_border_of_a_tile() {
        let covered = [true, false, false, false, false];
        let closed = nearest(&covered, &Grid::unit([5, 1], Edges::Closed)).unwrap();
        assert_eq!(closed.iter().map(|offset| offset[0]).collect::<Vec<_>>(), [0, -1, -2, -3, -4]);
        let wrap = nearest(&covered, &Grid::unit([5, 1], Edges::Wrap)).unwrap();
        assert_eq!(wrap.iter().map(|offset| offset[0]).collect::<Vec<_>>(), [0, -1, -2, 2, 1]);
    }

    proptest! {
        #[test]
        fn the_distance_is_that_to_the_nearest_covered_cell(seed: u32, wrap: bool, nx in 1..14_usize, ny in 1..11_usize, long in 0.9..1.1) {
            let edges = if wrap { Edges::Wrap } else { Edges::Closed };
            let mut state = seed;
            let covered: Vec<bool> = (0..nx * ny).map(|_| {
                state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
                state >> 28 == 0
            }).collect();
            prop_assume!(covered.contains(&true));
            let grid = Grid { size: [nx, ny], cell: [long, 1.0], edges };
            let found = nearest(&covered, &grid).unwrap();
            let slow = slow(&covered, &grid);
            for (i, (offset, slow)) in found.iter().zip(slow).enumerate() {
                prop_assert!((length(*offset, &grid) - slow).abs() < 1e-9, "{} {:?} {}", i, offset, slow);
                let to = [(i % nx) as i32 + offset[0], (i / nx) as i32 + offset[1]];
                let to = to[1].rem_euclid(ny as i32) as usize * nx + to[0].rem_euclid(nx as i32) as usize;
                prop_assert!(covered[to]);
            }
        }
    }
}
