//! The light that falls on a photographed surface, which gets darker towards one side or the corners.

use nalgebra::{SMatrix, SVector};

use super::lab::Lab;

/// 1 on the ground, 1 on marks, then x, y, x², xy and y².
const TERMS: usize = 7;
/// The quantile of the light that counts as full light: a vignette darkens the rest.
const FULL: f64 = 0.97;
/// Weight that holds the terms of place at 0, as a share of all weights: it matters only if nothing else determines them.
const RIDGE: f64 = 1e-6;
/// Cells among which that quantile is sought.
const SAMPLES: usize = 4096;
/// Darker cells give no information about the light (L of OKLab).
const BLACK: f32 = 0.02;
/// Light is never taken to be darker than this share of the full light.
const LEAST: f32 = 0.1;

/// The light of each cell ÷ the full light, as a factor of L, a and b: OKLab consists of cube roots, so that less light multiplies
/// all three equally.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Columns and rows.
    size: [usize; 2],
    /// Factors of x, y, x², xy and y² in its logarithm.
    factors: [f64; TERMS - 2],
    /// The logarithm of full light.
    full: f64,
}

impl Light {
    /// The light on cells far inside ground and marks: one quadratic function of place for both, fitted to the logarithms of L by
    /// weighted least squares. Bright cells have more weight: noise changes their logarithms less. A blur of the ground's
    /// brightness would flatten a vignette by half.
    pub fn of(lab: &Lab, far_inside: [&[usize]; 2]) -> Self {
        let mut normal = SMatrix::<f64, TERMS, TERMS>::zeros();
        let mut right = SVector::<f64, TERMS>::zeros();
        for (group, cells) in far_inside.iter().enumerate() {
            for &cell in *cells {
                let l = lab.planes[0][cell];
                if l <= BLACK {
                    continue;
                }
                let mut row = SVector::<f64, TERMS>::zeros();
                row[group] = 1.0;
                row.as_mut_slice()[2..].copy_from_slice(&terms(lab.size, cell));
                let weight = f64::from(l) * f64::from(l);
                normal += weight * row * row.transpose();
                right += weight * libm::log(f64::from(l)) * row;
            }
        }
        // If too few cells determine a term, it is 0.
        for term in 2..TERMS {
            normal[(term, term)] += RIDGE * normal.trace();
        }
        let solved = normal.svd(true, true).solve(&right, 1e-9 * normal.trace()).unwrap_or_default();
        let mut factors = [0.0; TERMS - 2];
        factors.copy_from_slice(&solved.as_slice()[2..]);
        let mut light = Self { size: lab.size, factors, full: 0.0 };
        light.full = light.quantile(FULL);
        light
    }

    /// The quantile of its logarithm.
    fn quantile(&self, share: f64) -> f64 {
        let cells = self.size[0] * self.size[1];
        let step = (cells / SAMPLES).max(1) | 1;
        let mut all: Vec<f64> = (0..cells).step_by(step).map(|cell| self.logarithm(cell)).collect();
        let rank = (all.len().saturating_sub(1) as f64 * share) as usize;
        if all.is_empty() { 0.0 } else { *all.select_nth_unstable_by(rank, f64::total_cmp).1 }
    }

    fn logarithm(&self, cell: usize) -> f64 {
        self.factors.iter().zip(terms(self.size, cell)).map(|(factor, term)| factor * term).sum()
    }

    /// L, a and b of a cell in full light.
    pub fn divided_out(&self, lab: &Lab, cell: usize) -> [f32; 3] {
        let light = libm::exp(self.logarithm(cell) - self.full) as f32;
        lab.at(cell).map(|value| value / light.max(LEAST))
    }
}

/// x, y, x², xy and y² of a cell, counted from the middle in sides of the picture.
fn terms([width, height]: [usize; 2], cell: usize) -> [f64; TERMS - 2] {
    let x = ((cell % width) as f64 + 0.5) / width as f64 - 0.5;
    let y = ((cell / width) as f64 + 0.5) / height as f64 - 0.5;
    [x, y, x * x, x * y, y * y]
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [usize; 2] = [120, 80];

    /// Alternating columns of ground and marks, 10 cells each, of L 0.8 and 0.3, in light divided by `darker`.
    fn columns(darker: impl Fn([f64; 2]) -> f64) -> (Lab, [Vec<usize>; 2]) {
        let cells = 0..SIZE[0] * SIZE[1];
        let group = |cell: usize| cell % SIZE[0] / 10 % 2;
        let l = |cell: usize| {
            let [x, y, ..] = terms(SIZE, cell);
            ([0.8, 0.3][group(cell)] / darker([x, y])) as f32
        };
        let planes = [1.0, 0.1, -0.2].map(|factor| cells.clone().map(|cell| factor * l(cell)).collect());
        let of = |wanted: usize| cells.clone().filter(|cell| group(*cell) == wanted).collect();
        (Lab { size: SIZE, factor: 1, planes }, [of(0), of(1)])
    }

    #[test]
    fn a_vignette_is_divided_out_of_ground_and_marks() {
        // Half as bright in the corners.
        let (lab, [ground, marks]) = columns(|[x, y]| libm::exp(1.4 * (x * x + y * y)));
        let light = Light::of(&lab, [&ground, &marks]);
        for (cells, wanted) in [(&ground, 0.8), (&marks, 0.3)] {
            for &cell in cells {
                let [l, a, b] = light.divided_out(&lab, cell);
                assert!((l / wanted - 1.0).abs() < 0.02, "{cell}: {l}");
                assert!((a - 0.1 * l).abs() < 1e-5 && (b + 0.2 * l).abs() < 1e-5);
            }
        }
    }

    #[test]
    fn even_light_changes_nothing_and_missing_marks_are_no_error() {
        let (lab, [ground, marks]) = columns(|_| 1.0);
        for far_inside in [[&ground[..], &marks], [&ground, &[]], [&[], &[]], [&ground[..1], &[]]] {
            let light = Light::of(&lab, far_inside);
            for cell in [0, 15, 119, 9_599] {
                let off = light.divided_out(&lab, cell)[0] - lab.planes[0][cell];
                assert!(off.abs() < 1e-4, "{off}");
            }
        }
    }
}
