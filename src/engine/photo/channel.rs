//! Converts three planes of colour to the channel in which marks and ground differ most.
//!
//! The channel is the first principal axis of the colours after their slow variation has been subtracted: light that falls off
//! towards a corner changes all colours, and must not determine the axis.

use rayon::prelude::*;

use super::coarse::wide;
use super::lab::Lab;
use crate::grid::Edges;
use crate::grid::blur::gaussian;

/// Standard deviation of the blur before the axis is computed, cells: otherwise noise of single px would contribute.
const FINE: f64 = 1.0;
/// Rounds of the power iteration; the ratio of the first two eigenvalues is at least 2 in textures, and 2⁻⁵⁰ is below rounding
/// errors.
const ROUNDS: usize = 50;

/// The direction of L, a, b in which the picture varies most at lengths up to `sigma` cells; unit length, L not negative.
#[must_use]
pub fn axis(lab: &Lab, sigma: f64) -> [f64; 3] {
    let planes: Vec<Vec<f32>> = (0..3)
        .map(|k| {
            let (mut fine, slow) = (
                gaussian(&lab.planes[k], lab.size, FINE, Edges::Closed),
                wide(&lab.planes[k], lab.size, sigma),
            );
            fine.iter_mut().zip(&slow).for_each(|(fine, slow)| *fine -= slow);
            fine
        })
        .collect();
    // Rows are summed separately, and their sums in order, so that the result does not depend on the number of threads.
    let rows: Vec<[f64; 6]> = (0..lab.size[1])
        .into_par_iter()
        .map(|y| {
            let mut sums = [0.0; 6];
            let row = y * lab.size[0]..(y + 1) * lab.size[0];
            let [l, a, b] = [0, 1, 2].map(|k| planes[k][row.clone()].iter().map(|value| f64::from(*value)));
            for ((l, a), b) in l.zip(a).zip(b) {
                let products = [l * l, l * a, l * b, a * a, a * b, b * b];
                products.iter().zip(&mut sums).for_each(|(product, sum)| *sum += product);
            }
            sums
        })
        .collect();
    let mut sums = [0.0; 6];
    rows.iter().for_each(|row| (0..6).for_each(|k| sums[k] += row[k]));
    first_eigenvector(sums)
}

/// The first eigenvector of the symmetric matrix [xx, xy, xz, yy, yz, zz]; the first axis if the matrix is 0.
pub(super) fn first_eigenvector([xx, xy, xz, yy, yz, zz]: [f64; 6]) -> [f64; 3] {
    let mut v = [1.0, 0.2, 0.1];
    for _ in 0..ROUNDS {
        let next = [
            xx * v[0] + xy * v[1] + xz * v[2],
            xy * v[0] + yy * v[1] + yz * v[2],
            xz * v[0] + yz * v[1] + zz * v[2],
        ];
        let length = (next[0] * next[0] + next[1] * next[1] + next[2] * next[2]).sqrt();
        if length <= f64::MIN_POSITIVE {
            return [1.0, 0.0, 0.0];
        }
        v = next.map(|x| x / length);
    }
    if v[0] < 0.0 { v.map(|x| -x) } else { v }
}

/// The colours along the axis.
#[must_use]
pub fn channel(lab: &Lab, axis: [f64; 3]) -> Vec<f32> {
    let [l, a, b] = axis.map(|x| x as f32);
    let cells = lab.planes[0].par_iter().zip(&lab.planes[1]).zip(&lab.planes[2]);
    cells.map(|((x, y), z)| l * x + a * y + b * z).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_axis_follows_the_marks_and_not_the_light() {
        // Marks of another hue every 8 cells; lightness falls off by far more across the picture.
        let size = [96, 64];
        let mark = |k: usize| if ((k % size[0]) / 4).is_multiple_of(2) { 0.05 } else { -0.05 };
        let cells = 0..size[0] * size[1];
        let planes = [
            cells.clone().map(|k| 0.2 + 0.6 * (k % size[0]) as f32 / size[0] as f32).collect(),
            cells.clone().map(mark).collect(),
            cells.map(|k| -0.5 * mark(k)).collect(),
        ];
        let lab = Lab { size, factor: 1, planes };
        let [l, a, b] = axis(&lab, 8.0);
        assert!(l.abs() < 0.3 && (b / a + 0.5).abs() < 0.05, "{l} {a} {b}");
    }

    #[test]
    fn a_picture_of_one_colour_has_the_axis_of_lightness() {
        assert_eq!(first_eigenvector([0.0; 6]), [1.0, 0.0, 0.0]);
    }
}
