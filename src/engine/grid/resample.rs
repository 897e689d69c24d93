//! Reading a field between its cells: interpolating cubic B-splines.
//!
//! ```text
//! f(x) = Σₖ c[k]·β³(x − k)
//! c⁺[k] = 6·s[k] + z·c⁺[k−1],  c[k] = z·(c[k+1] − c⁺[k])
//! ```
//!
//! The coefficients c are such that f is s at the cells' centres. They come from the samples s by one recursion
//! forth and one back, with the pole z = √3 − 2.
//!
//! M. Unser, "Splines: a perfect fit for signal and image processing", IEEE Signal Processing Magazine 16
//! (1999), eq. (18) and box 2; the starting values follow from what lies beyond the border ([`Edges`]).

use std::ops::Range;

use multiversion::multiversion;
use rayon::prelude::*;

use crate::grid::{Edges, Field};

/// √3 − 2.
const POLE: f32 = -0.267_949_2;

/// Terms of a starting sum: |z|¹⁴ < 10⁻⁸, below the precision of f32.
const HORIZON: usize = 14;

/// The smooth surface through a field's values.
///
/// Holds one f32 a cell. It is exact at the cells' centres (to rounding), has continuous second derivatives,
/// and has an error of O(cell⁴) in between.
#[derive(Clone, Debug, Default)]
pub struct Spline {
    width: usize,
    height: usize,
    cell: [f64; 2],
    edges: Edges,
    coefficients: Vec<f32>,
}

/// The field on `width` × `height` cells over the same extent, read at the new cells' centres.
///
/// It interpolates and does not average: a pattern finer than the new cells is aliased. Neither size may be 0.
///
/// ```
/// use dapple_engine::grid::{Edges, Field, resample::resample};
///
/// let flat = Field::flat(8, 8, Edges::Wrap, 0.25);
/// let finer = resample(&flat, 16, 16);
/// assert_eq!(finer.extent(), [8.0, 8.0]);
/// assert!(finer.values.iter().all(|value| (value - 0.25).abs() < 1e-6));
/// ```
#[must_use]
pub fn resample(field: &Field, width: usize, height: usize) -> Field {
    let extent = field.extent();
    let values = if [width, height] == [field.width, field.height] {
        field.values.clone()
    } else {
        Spline::new(field).rows(0..height, width, height)
    };
    let cell = [extent[0] / width as f64, extent[1] / height as f64];
    Field { width, height, cell, edges: field.edges, values }
}

impl Spline {
    /// The surface through `field`'s values.
    #[must_use]
    pub fn new(field: &Field) -> Self {
        let (width, height, edges) = (field.width, field.height, field.edges);
        let mut coefficients = field.values.clone();
        let rows = coefficients.par_chunks_mut(ABREAST * width.max(1));
        rows.for_each_init(Vec::new, |turned, rows| filter_rows(rows, width, edges, turned));
        filter_columns(&mut coefficients, width, height, edges);
        Self { width, height, cell: field.cell, edges, coefficients }
    }

    /// Its value at a point, px; beyond the border as the edges say.
    #[must_use]
    pub fn at(&self, [x, y]: [f64; 2]) -> f32 {
        let (column, across) = tap(x / self.cell[0] - 0.5);
        let (row, down) = tap(y / self.cell[1] - 0.5);
        let columns = self.tapped(column, self.width);
        let mut sum = 0.0;
        for (row, weight) in self.tapped(row, self.height).into_iter().zip(down) {
            for (column, share) in columns.into_iter().zip(across) {
                sum += weight * share * self.coefficients[row * self.width + column];
            }
        }
        sum
    }

    /// Four cells of a row or column of `n` cells; those beyond the border as the edges say.
    fn tapped(&self, first: isize, n: usize) -> [usize; 4] {
        match usize::try_from(first) {
            Ok(first) if first + 4 <= n => std::array::from_fn(|i| first + i),
            _ => std::array::from_fn(|i| self.edges.index(first + i as isize, n)),
        }
    }

    /// Rows `rows` of the field that this surface gives on `width` × `height` cells over the same extent.
    ///
    /// Large outputs can be made in bands of rows; a band holds the same bits as those rows of the whole.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let columns = self.columns(width);
        let mut out = vec![0.0; rows.len() * width];
        let each = out.par_chunks_mut(width.max(1)).zip(rows.into_par_iter());
        each.for_each_init(Vec::new, |line, (out, y)| self.row(y, height, &columns, line, out));
        out
    }

    /// Columns at which [`Self::row`] reads `width` values.
    #[must_use]
    pub fn columns(&self, width: usize) -> Columns {
        match width.checked_div(self.width) {
            Some(times) if times > 0 && times <= MOST_TIMES && times * self.width == width => {
                Columns::Whole(taps(1, times))
            }
            _ => Columns::Any(taps(self.width, width)),
        }
    }

    /// Writes row `y` of `height` at `columns`; `line` is a buffer that is reused from row to row.
    pub fn row(&self, y: usize, height: usize, columns: &Columns, line: &mut Vec<f32>, out: &mut [f32]) {
        line.resize(self.width + 2 * PAD, 0.0);
        self.line((y as f64 + 0.5) * self.height as f64 / height as f64 - 0.5, line);
        match columns {
            Columns::Any(taps) => {
                for (out, (start, w)) in out.iter_mut().zip(taps) {
                    let c = &line[*start..*start + 4];
                    *out = w[0] * c[0] + w[1] * c[1] + w[2] * c[2] + w[3] * c[3];
                }
            }
            Columns::Whole(taps) => match taps.len() {
                1 => abreast::<1>(taps, line, out),
                2 => abreast::<2>(taps, line, out),
                3 => abreast::<3>(taps, line, out),
                4 => abreast::<4>(taps, line, out),
                5 => abreast::<5>(taps, line, out),
                6 => abreast::<6>(taps, line, out),
                7 => abreast::<7>(taps, line, out),
                _ => abreast::<MOST_TIMES>(taps, line, out),
            },
        }
    }

    /// Coefficients along x at height `position` (in rows), with `PAD` more on either side.
    fn line(&self, position: f64, line: &mut [f32]) {
        let (row, w) = tap(position);
        let [a, b, c, d] = [0, 1, 2, 3].map(|j| {
            let start = self.edges.index(row + j, self.height) * self.width;
            &self.coefficients[start..start + self.width]
        });
        for (x, out) in line[PAD..PAD + self.width].iter_mut().enumerate() {
            *out = w[0] * a[x] + w[1] * b[x] + w[2] * c[x] + w[3] * d[x];
        }
        for i in 0..PAD {
            line[i] = line[PAD + self.edges.index(i as isize - PAD as isize, self.width)];
            let right = PAD + self.width + i;
            line[right] = line[PAD + self.edges.index((self.width + i) as isize, self.width)];
        }
    }
}

/// The index of the first of four coefficients on a padded line, and their weights.
type Tap = (usize, [f32; 4]);

/// Where a row is read.
#[derive(Clone, Debug)]
pub enum Columns {
    /// For each value.
    Any(Vec<Tap>),
    /// For each value in the first cell, where all cells hold as many values: further cells are read in the same way.
    Whole(Vec<Tap>),
}

/// Values a cell at most that are read cell by cell.
const MOST_TIMES: usize = 8;

/// Writes the `N` values of each cell, one cell after the other.
#[multiversion(targets("x86_64+avx2"))]
fn abreast<const N: usize>(taps: &[Tap], line: &[f32], out: &mut [f32]) {
    // The values of a cell need four of five coefficients: from the first or from the second on. The fifth has the weight 0.
    let mut weights = [[0.0; N]; 5];
    for (k, (start, w)) in taps.iter().enumerate() {
        for (i, w) in w.iter().enumerate() {
            weights[start + i][k] = *w;
        }
    }
    for (out, c) in out.chunks_exact_mut(N).zip(line.windows(5)) {
        let mut sum = [0.0; N];
        for (c, weights) in c.iter().zip(&weights) {
            sum.iter_mut().zip(weights).for_each(|(sum, weight)| *sum += weight * c);
        }
        out.copy_from_slice(&sum);
    }
}

/// Cells beyond the border that are read between the outermost centre and the border.
const PAD: usize = 2;

/// The first of the four cells that matter at `position` (in cells from the first centre), and their weights.
fn tap(position: f64) -> (isize, [f32; 4]) {
    let base = position.floor();
    let t = position - base;
    let u = 1.0 - t;
    let inner = |t: f64| (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
    let weights = [u * u * u / 6.0, inner(t), inner(u), t * t * t / 6.0];
    (base as isize - 1, weights.map(|weight| weight as f32))
}

/// For each of `to` cells across `from` cells: where its four coefficients start on a padded line, and weights.
fn taps(from: usize, to: usize) -> Vec<Tap> {
    let place = |i: usize| tap((i as f64 + 0.5) * from as f64 / to as f64 - 0.5);
    (0..to).map(place).map(|(first, weights)| ((first + PAD as isize) as usize, weights)).collect()
}

/// Rows that are filtered side by side: each step along one waits for the step before.
const ABREAST: usize = 8;

/// Samples → coefficients along `rows` of so many values. `turned` is a buffer.
fn filter_rows(rows: &mut [f32], width: usize, edges: Edges, turned: &mut Vec<f32>) {
    let count = rows.len() / width;
    turned.resize(rows.len(), 0.0);
    for (k, row) in rows.chunks(width).enumerate() {
        turned.chunks_mut(count).zip(row).for_each(|(column, value)| column[k] = *value);
    }
    filter_columns(turned, count, width, edges);
    for (k, row) in rows.chunks_mut(width).enumerate() {
        turned.chunks(count).zip(row).for_each(|(column, value)| *value = column[k]);
    }
}

/// Samples → coefficients along the columns, a whole row at a time.
#[multiversion(targets("x86_64+avx2"))]
fn filter_columns(values: &mut [f32], width: usize, height: usize, edges: Edges) {
    let weighted = |values: &[f32], mut power: f32, row: &dyn Fn(usize) -> usize| {
        let mut sum = vec![0.0; width];
        for k in 0..HORIZON {
            let start = row(k) * width;
            sum.iter_mut().zip(&values[start..start + width]).for_each(|(sum, value)| *sum += power * value);
            power *= POLE;
        }
        sum
    };
    let start = weighted(values, 6.0, &|k| edges.index(-(k as isize), height));
    values[..width].copy_from_slice(&start);
    for y in 1..height {
        let (above, rest) = values.split_at_mut(y * width);
        let above = &above[(y - 1) * width..];
        rest[..width].iter_mut().zip(above).for_each(|(value, above)| *value = 6.0 * *value + POLE * above);
    }
    let last = (height - 1) * width;
    match edges {
        Edges::Closed => values[last..].iter_mut().for_each(|value| *value *= POLE / (POLE - 1.0)),
        Edges::Wrap => {
            let end = weighted(values, -POLE, &|k| (height - 1 + k) % height);
            values[last..].copy_from_slice(&end);
        }
    }
    for y in (0..height - 1).rev() {
        let (rest, below) = values.split_at_mut((y + 1) * width);
        let row = &mut rest[y * width..];
        row.iter_mut().zip(&below[..width]).for_each(|(value, below)| *value = POLE * (below - *value));
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use std::f64::consts::TAU;

    use super::*;

    fn noise(width: usize, height: usize, edges: Edges) -> Field {
        let mut state = 7_u32;
        Field::from_fn([width, height], [1.5, 0.75], edges, |_| {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (state >> 8) as f32 / (1 << 24) as f32
        })
    }

    /// A smooth function that is even about the closed border of a 1 × 1 canvas, or periodic on it.
    fn smooth(edges: Edges, [x, y]: [f64; 2]) -> f64 {
        match edges {
            Edges::Closed => (0.5 * TAU * x).cos() * (TAU * y).cos() + 0.5 * (1.5 * TAU * y).cos(),
            Edges::Wrap => (TAU * x + 0.3).sin() * (TAU * y).cos() + 0.5 * (2.0 * TAU * y + 1.0).sin(),
        }
    }

    #[test]
    fn a_constant_field_stays_constant() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let out = resample(&Field::flat(5, 3, edges, 0.7), 64, 37);
            assert!(out.values.iter().all(|value| (value - 0.7).abs() < 3e-7), "{edges:?}");
        }
    }

    #[test]
    fn the_surface_goes_through_the_samples() {
        for edges in [Edges::Closed, Edges::Wrap] {
            for (width, height) in [(1, 1), (2, 1), (3, 2), (17, 23)] {
                let field = noise(width, height, edges);
                let rows = Spline::new(&field).rows(0..height, width, height);
                for (a, b) in rows.iter().zip(&field.values) {
                    assert!((a - b).abs() < 1e-6, "{edges:?} {width}x{height}: {a} {b}");
                }
                assert_eq!(resample(&field, width, height), field);
            }
        }
    }

    #[test]
    fn the_error_falls_with_the_fourth_power_of_the_cell() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let error = |n: usize| {
                let cell = [1.0 / n as f64; 2];
                let field = Field::from_fn([n, n], cell, edges, |p| smooth(edges, p) as f32);
                let fine = resample(&field, 301, 307);
                let exact = Field::from_fn([301, 307], fine.cell, edges, |p| smooth(edges, p) as f32);
                let pairs = fine.values.iter().zip(&exact.values);
                pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
            };
            let order = (error(10) / error(20)).log2();
            assert!((3.6..4.6).contains(&order), "{edges:?}: order {order}");
        }
    }

    #[test]
    fn a_wrapped_field_moved_round_gives_the_surface_moved_round() {
        let field = noise(9, 6, Edges::Wrap);
        let mut moved = field.clone();
        for y in 0..6 {
            for x in 0..9 {
                moved.values[y * 9 + x] = field.get(x as isize - 4, y as isize - 5);
            }
        }
        let (a, b) = (resample(&field, 27, 18), resample(&moved, 27, 18));
        for y in 0..18 {
            for x in 0..27 {
                let there = a.get(x - 12, y - 15);
                assert!((b.get(x, y) - there).abs() < 2e-6);
            }
        }
    }

    proptest! {
        #[test]
        fn points_rows_and_bands_agree_and_a_mirror_commutes(
            width in 1..12_usize, height in 1..12_usize, w in 1..40_usize, h in 1..40_usize, wrap: bool,
        ) {
            let edges = if wrap { Edges::Wrap } else { Edges::Closed };
            let field = noise(width, height, edges);
            let whole = resample(&field, w, h);
            let spline = Spline::new(&field);
            if [w, h] != [width, height] {
                let half = h / 2;
                let bands = [spline.rows(0..half, w, h), spline.rows(half..h, w, h)].concat();
                prop_assert_eq!(&bands, &whole.values);
            }
            let mut mirrored = field.clone();
            mirrored.values.reverse();
            let turned = resample(&mirrored, w, h);
            for (k, value) in whole.values.iter().enumerate() {
                prop_assert!((turned.values[w * h - 1 - k] - value).abs() < 2e-6);
                let p = [((k % w) as f64 + 0.5) * whole.cell[0], ((k / w) as f64 + 0.5) * whole.cell[1]];
                prop_assert!((spline.at(p) - value).abs() < 2e-6);
            }
        }
    }
}
