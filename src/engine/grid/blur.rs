//! Blurs of values on a grid, mirrored about a closed border: by a Gaussian, and by boxes, whose time does not grow with the width.

use rayon::prelude::*;

use super::edges::Edges;

/// Weights reach this many standard deviations: what is left out is 5·10⁻⁴ of the sum.
const REACH: f64 = 3.5;

/// Passes of a box: three are a bell to a few per cent.
const PASSES: usize = 3;

/// Weights of a Gaussian of `sigma` cells about their middle, with the sum 1.
fn weights(sigma: f64) -> Vec<f32> {
    let reach = (REACH * sigma).ceil() as i32;
    let bell = |i: i32| libm::exp(-0.5 * (f64::from(i) / sigma) * (f64::from(i) / sigma));
    let total: f64 = (-reach..=reach).map(bell).sum();
    (-reach..=reach).map(|i| (bell(i) / total) as f32).collect()
}

/// `values` on `size` cells, blurred by a Gaussian of `sigma` cells. Its time grows with `sigma`.
///
/// ```
/// use dapple_engine::grid::{Edges, blur};
///
/// let blurred = blur::gaussian(&[0.5; 64], [8, 8], 2.0, Edges::Wrap);
/// assert!(blurred.iter().all(|value| (value - 0.5).abs() < 1e-5));
/// ```
#[must_use]
pub fn gaussian(values: &[f32], [width, height]: [usize; 2], sigma: f64, edges: Edges) -> Vec<f32> {
    if sigma <= 0.0 || values.is_empty() {
        return values.to_vec();
    }
    let weights = weights(sigma);
    let reach = weights.len() / 2;
    let mut blurred = vec![0.0; values.len()];
    blurred.par_chunks_mut(width).enumerate().for_each_init(
        || vec![0.0_f32; width + 2 * reach],
        |padded, (y, out)| {
            let column = |k: usize| edges.index(k as isize - reach as isize, width);
            padded.fill(0.0);
            for (j, weight) in weights.iter().enumerate() {
                let from = edges.index((y + j) as isize - reach as isize, height) * width;
                let row = &values[from..from + width];
                padded[reach..reach + width]
                    .iter_mut()
                    .zip(row)
                    .for_each(|(sum, value)| *sum += weight * value);
            }
            for k in (0..reach).chain(reach + width..width + 2 * reach) {
                padded[k] = padded[reach + column(k)];
            }
            out.fill(0.0);
            for (i, weight) in weights.iter().enumerate() {
                out.iter_mut().zip(&padded[i..]).for_each(|(sum, value)| *sum += weight * value);
            }
        },
    );
    blurred
}

/// `values` of `nx` × `ny` cells under a bell of standard deviation √(r² + r), `r` the cells of `radius`.
#[must_use]
pub fn boxes(values: &[f32], [nx, ny]: [usize; 2], edges: Edges, radius: usize) -> Vec<f32> {
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

    /// The sums of [`gaussian`], one px at a time in f64.
    fn plain(values: &[f32], [width, height]: [usize; 2], sigma: f64) -> Vec<f64> {
        let weights = weights(sigma);
        let reach = (weights.len() / 2) as isize;
        let mut blurred = Vec::new();
        for y in 0..height as isize {
            for x in 0..width as isize {
                let mut sum = 0.0;
                for j in -reach..=reach {
                    for i in -reach..=reach {
                        let at =
                            Edges::Closed.index(y + j, height) * width + Edges::Closed.index(x + i, width);
                        let weight = f64::from(weights[(i + reach) as usize])
                            * f64::from(weights[(j + reach) as usize]);
                        sum += weight * f64::from(values[at]);
                    }
                }
                blurred.push(sum);
            }
        }
        blurred
    }

    #[test]
    fn what_wraps_around_is_blurred_alike_wherever_its_border_is() {
        let size = [12, 7];
        let values: Vec<f32> = (0..84).map(|k| ((k * 37) % 101) as f32).collect();
        let turned: Vec<f32> = (0..84).map(|k| values[k / 12 * 12 + (k % 12 + 5) % 12]).collect();
        let blurred = [values, turned].map(|values| gaussian(&values, size, 2.0, Edges::Wrap));
        for (k, found) in blurred[1].iter().enumerate() {
            assert!((found - blurred[0][k / 12 * 12 + (k % 12 + 5) % 12]).abs() < 1e-3, "{k}");
        }
    }

    #[test]
    fn it_is_the_weighted_sum_over_the_mirrored_picture() {
        for (size, sigma) in [([17, 11], 0.8), ([5, 9], 2.5), ([1, 3], 1.0)] {
            let values: Vec<f32> = (0..size[0] * size[1]).map(|k| ((k * 37) % 101) as f32 / 101.0).collect();
            let found = gaussian(&values, size, sigma, Edges::Closed);
            for (found, wanted) in found.iter().zip(plain(&values, size, sigma)) {
                assert!((f64::from(*found) - wanted).abs() < 1e-5, "{size:?} {sigma}: {found} {wanted}");
            }
        }
    }

    #[test]
    fn a_constant_is_unchanged_and_a_point_becomes_a_bell() {
        for edges in [Edges::Closed, Edges::Wrap] {
            assert!(boxes(&[0.7; 30], [6, 5], edges, 2).iter().all(|v| (v - 0.7).abs() < 1e-6));
            let mut point = vec![0.0; 41 * 41];
            point[20 * 41 + 20] = 1.0;
            let bell = boxes(&point, [41, 41], edges, 3);
            let sum: f32 = bell.iter().sum();
            let variance: f32 = (0..41 * 41).map(|i| (i as f32 % 41.0 - 20.0).powi(2) * bell[i]).sum();
            assert!((sum - 1.0).abs() < 1e-4 && (variance - 12.0).abs() < 0.01, "{sum} {variance}");
        }
    }

    #[test]
    fn a_tile_is_smoothed_across_its_border() {
        let mut point = vec![0.0; 12];
        point[0] = 1.0;
        let bell = boxes(&point, [12, 1], Edges::Wrap, 1);
        assert_eq!(bell[11], bell[1]);
    }
}
