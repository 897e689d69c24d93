//! Means over the neighbourhood of each cell.

use rayon::prelude::*;

use crate::grid::Edges;

/// Passes of a box: three are a bell to a few per cent.
const PASSES: usize = 3;

/// `values` of `nx` × `ny` cells under a bell of standard deviation √(r² + r), `r` the cells of `radius`.
#[must_use]
pub fn blurred(values: &[f32], [nx, ny]: [usize; 2], edges: Edges, radius: usize) -> Vec<f32> {
    let mut rows = values.to_vec();
    smooth(&mut rows, nx, edges, radius);
    let mut columns = transposed(&rows, nx, ny);
    smooth(&mut columns, ny, edges, radius);
    transposed(&columns, ny, nx)
}

/// Smooths each row of `n` cells.
fn smooth(values: &mut [f32], n: usize, edges: Edges, radius: usize) {
    let reach = radius as isize;
    let share = 1.0 / (2 * radius + 1) as f64;
    values.par_chunks_mut(n).for_each_init(Vec::new, |before: &mut Vec<f32>, row| {
        for _ in 0..PASSES {
            before.clear();
            before.extend_from_slice(row);
            let at = |i: isize| f64::from(before[edges.index(i, n)]);
            let mut sum: f64 = (-reach..=reach).map(at).sum();
            for (i, value) in row.iter_mut().enumerate() {
                *value = (sum * share) as f32;
                let i = i as isize;
                sum += at(i + reach + 1) - at(i - reach);
            }
        }
    });
}

fn transposed(values: &[f32], nx: usize, ny: usize) -> Vec<f32> {
    let mut out = vec![0.0; values.len()];
    out.par_chunks_mut(ny).enumerate().for_each(|(x, column)| {
        for (y, value) in column.iter_mut().enumerate() {
            *value = values[y * nx + x];
        }
    });
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_constant_is_unchanged_and_a_point_becomes_a_bell() {
        for edges in [Edges::Closed, Edges::Wrap] {
            assert!(blurred(&[0.7; 30], [6, 5], edges, 2).iter().all(|v| (v - 0.7).abs() < 1e-6));
            let mut point = vec![0.0; 41 * 41];
            point[20 * 41 + 20] = 1.0;
            let bell = blurred(&point, [41, 41], edges, 3);
            let sum: f32 = bell.iter().sum();
            let variance: f32 = (0..41 * 41).map(|i| (i as f32 % 41.0 - 20.0).powi(2) * bell[i]).sum();
            assert!((sum - 1.0).abs() < 1e-4 && (variance - 12.0).abs() < 0.01, "{sum} {variance}");
        }
    }

    #[test]
    fn a_tile_is_smoothed_across_its_border() {
        let mut point = vec![0.0; 12];
        point[0] = 1.0;
        let bell = blurred(&point, [12, 1], Edges::Wrap, 1);
        assert_eq!(bell[11], bell[1]);
    }
}
