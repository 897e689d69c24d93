//! The blur of a photograph at the edges of its marks. It mixes the colours of ground and marks up to their middles if these are
//! thin.

use super::lab::Lab;
use super::light::Light;
use crate::grid::Edges;
use crate::grid::blur::gaussian;

/// Steps between the standard deviations of the blur that are compared, cells, and their number.
const STEP: f64 = 0.25;
const STEPS: usize = 12;
/// The blur is the widest one that leaves at most this multiple of the unexplained variance of the best one. Of thin stripes only
/// one wave is left, for which a wide blur with strong colours explains as much as a narrow one with weak colours. Photographed
/// objects have clear colours, and edges that noise has moved already account for a part of the blur.
const AS_GOOD: f64 = 1.03;
/// Side of the central part that is analysed, cells.
const SIDE: usize = 768;
/// Share of another mark in a cell, through the widest blur, from which on the cell is beside that mark.
const BESIDE: f32 = 0.02;
/// Least difference between the shares of two groups of cells for their colours to be separated.
const APART: f32 = 0.3;

/// The share of the marks' colour in that of each cell.
#[derive(Clone, Debug)]
pub struct Shares(Vec<f32>);

impl Shares {
    /// The shares from the widest Gaussian blur that explains the lightness about as well as the best one, if ground and marks have
    /// one lightness each. Ignored are cells for which `is_other` holds (marks that may have another lightness), and cells beside
    /// them.
    pub fn of_marks(lab: &Lab, is_mark: &[bool], is_other: &[bool], light: &Light) -> Self {
        let share = |is: &bool| f32::from(u8::from(*is));
        let hard: Vec<f32> = is_mark.iter().map(share).collect();
        let middle = Middle::of(lab.size);
        let others: Vec<f32> = middle.cells().map(|cell| share(&is_other[cell])).collect();
        let beside = gaussian(&others, middle.size, STEP * STEPS as f64, Edges::Closed);
        let counts = |all: &[f32]| -> Vec<f32> {
            all.iter().zip(&beside).filter(|(_, beside)| **beside < BESIDE).map(|(value, _)| *value).collect()
        };
        let brightness: Vec<f32> = middle.cells().map(|cell| light.divided_out(lab, cell)[0]).collect();
        let brightness = counts(&brightness);
        let part: Vec<f32> = middle.cells().map(|cell| hard[cell]).collect();
        let unexplained: Vec<f64> = (0..=STEPS)
            .map(|k| {
                unexplained(
                    &brightness,
                    &counts(&gaussian(&part, middle.size, STEP * k as f64, Edges::Closed)),
                )
            })
            .collect();
        let best = unexplained.iter().copied().fold(f64::INFINITY, f64::min);
        let widest = unexplained.iter().rposition(|left| *left <= AS_GOOD * best).unwrap_or(0);
        Self(gaussian(&hard, lab.size, STEP * widest as f64, Edges::Closed))
    }

    /// The colours of ground and marks, from those of two groups of cells: the first has more of the ground, the second more of
    /// marks. If the groups hardly differ, their colours are returned unchanged.
    pub fn separated(&self, cells: [&[usize]; 2], colours: [[f32; 3]; 2]) -> [[f32; 3]; 2] {
        let mean = |cells: &[usize]| {
            cells.iter().map(|cell| f64::from(self.0[*cell])).sum::<f64>() as f32 / cells.len() as f32
        };
        let [low, high] = cells.map(mean);
        // Without cells the means are NaN.
        if low.is_nan() || high.is_nan() || high - low < APART {
            return colours;
        }
        let at = |share: f32| {
            [0, 1, 2].map(|k| colours[0][k] + (share - low) / (high - low) * (colours[1][k] - colours[0][k]))
        };
        [at(0.0), at(1.0)]
    }
}

/// The part of a picture that is analysed.
struct Middle {
    size: [usize; 2],
    first: [usize; 2],
    width: usize,
}

impl Middle {
    fn of(all: [usize; 2]) -> Self {
        let size = all.map(|side| side.min(SIDE));
        Self { size, first: [0, 1].map(|k| (all[k] - size[k]) / 2), width: all[0] }
    }

    /// Its cells by their numbers in the whole picture, row by row.
    fn cells(&self) -> impl Iterator<Item = usize> {
        let ([columns, rows], [left, top], width) = (self.size, self.first, self.width);
        (0..columns * rows).map(move |k| (top + k / columns) * width + left + k % columns)
    }
}

/// The residual variance of `values` after the best fit a + b · `shares`, × their number.
fn unexplained(values: &[f32], shares: &[f32]) -> f64 {
    let count = values.len().max(1) as f64;
    let mean = |of: &dyn Fn(usize) -> f64| (0..values.len()).map(of).sum::<f64>() / count;
    let [value, share] = [values, shares].map(|all| mean(&|k| f64::from(all[k])));
    let [of_values, of_shares] = [(values, value), (shares, share)]
        .map(|(all, middle)| mean(&|k| (f64::from(all[k]) - middle).powi(2)));
    let both = mean(&|k| (f64::from(values[k]) - value) * (f64::from(shares[k]) - share));
    let explained = if of_shares > 0.0 { both * both / of_shares } else { 0.0 };
    count * (of_values - explained)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    const SIZE: [usize; 2] = [180, 120];

    /// Stripes of L 0.9 and 0.3, `wide` cells each, blurred by `sigma`, with some noise; which cells are marks.
    fn stripes(wide: usize, sigma: f64) -> (Lab, Vec<bool>) {
        let is_mark: Vec<bool> = (0..SIZE[0] * SIZE[1]).map(|cell| cell % SIZE[0] / wide % 2 == 1).collect();
        let l: Vec<f32> = is_mark.iter().map(|mark| if *mark { 0.3 } else { 0.9 }).collect();
        let mut random = Pcg64Mcg::seed_from_u64(1);
        let noisy = |value: f32| value + 0.04 * (random.random::<f32>() - 0.5);
        let l: Vec<f32> = gaussian(&l, SIZE, sigma, Edges::Closed).into_iter().map(noisy).collect();
        let none = vec![0.0; l.len()];
        (Lab { size: SIZE, factor: 1, planes: [l, none.clone(), none] }, is_mark)
    }

    #[test]
    fn thin_stripes_have_the_colours_that_the_blur_has_mixed() {
        for (wide, sigma) in [(4, 1.5), (4, 0.0), (5, 1.5), (9, 2.0), (20, 1.0)] {
            let (lab, is_mark) = stripes(wide, sigma);
            let far = |group: usize| -> Vec<usize> {
                let column = |cell: &usize| cell % SIZE[0];
                let is_middle = |cell: &usize| column(cell) % wide == wide / 2;
                (0..is_mark.len()).filter(is_middle).filter(|cell| column(cell) / wide % 2 == group).collect()
            };
            let groups = [far(0), far(1)];
            let light = Light::of(&lab, [&[], &[]]);
            let mean = |cells: &[usize]| {
                cells.iter().map(|cell| lab.planes[0][*cell]).sum::<f32>() / cells.len() as f32
            };
            let seen = [0, 1].map(|k| [mean(&groups[k]), 0.0, 0.0]);
            let shares = Shares::of_marks(&lab, &is_mark, &vec![false; is_mark.len()], &light);
            let found = shares.separated([&groups[0], &groups[1]], seen);
            for (found, wanted) in found.iter().zip([0.9, 0.3]) {
                assert!((found[0] - wanted).abs() < 0.03, "{wide}, {sigma}: {found:?} of {seen:?}");
            }
        }
    }

    #[test]
    fn one_group_alone_keeps_its_colour() {
        let (lab, is_mark) = stripes(4, 1.5);
        let no_others = vec![false; is_mark.len()];
        let shares = Shares::of_marks(&lab, &is_mark, &no_others, &Light::of(&lab, [&[], &[]]));
        let colours = [[0.5, 0.1, 0.2], [0.0; 3]];
        assert_eq!(shares.separated([&[2, 3], &[]], colours), colours);
    }
}
