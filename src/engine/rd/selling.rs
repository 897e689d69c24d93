//! A diffusion tensor as a non-negative stencil.
//!
//! ∇·D∇u ≈ Σₖ wₖ (u(x + eₖ) + u(x − eₖ) − 2u(x)), wₖ ≥ 0, with at most three offsets eₖ a cell.
//! Selling's reduction of an obtuse superbase; Fehrenbach & Mirebeau, "Sparse non-negative stencils for
//! anisotropic diffusion", JMIV 49 (2014). Unlike a 3×3 mask it stays non-negative at any angle.

use super::parameter_field::Parameters;
use crate::grid::sin_cos_degrees;
use crate::surface::Stretch;

/// The offsets for tensors of stretch ≥ [`MIN_STRETCH`], in cells (each with its opposite): the first eight suffice down to 0.25.
#[rustfmt::skip]
pub const OFFSETS: [[isize; 2]; 20] = [
    [1, 0], [0, 1], [1, 1], [1, -1], [2, 1], [1, 2], [2, -1], [1, -2],
    [3, 1], [1, 3], [3, -1], [1, -3], [3, 2], [2, 3], [3, -2], [2, -3], [4, 1], [1, 4], [4, -1], [1, -4],
];

/// Largest component of an offset, cells.
pub const REACH: usize = 4;

/// The thinnest stretch (minor ÷ major) for which [`OFFSETS`] suffice at every angle.
///
/// On square cells they suffice down to 0.124; the margin leaves room for cells that are up to 4 % longer than wide.
pub const MIN_STRETCH: f32 = 0.13;

/// A symmetric positive tensor [[xx, xy], [xy, yy]].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tensor {
    /// Along x.
    pub xx: f64,
    /// Mixed.
    pub xy: f64,
    /// Along y.
    pub yy: f64,
}

/// A tensor by its eigenvalues and the direction of the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// Eigenvalue along the direction.
    pub along: f64,
    /// Eigenvalue across it.
    pub across: f64,
    /// The direction from +x towards +y, degrees.
    pub degrees: f64,
}

impl PrincipalAxes {
    /// Axes of a diffusion tensor of determinant 1 with these parameters: spots keep their area at any stretch.
    #[must_use]
    pub fn of_unit_determinant(p: &Parameters) -> Self {
        let stretch = f64::from(p.stretch.max(MIN_STRETCH));
        Self { along: 1.0 / stretch, across: stretch, degrees: f64::from(p.direction) }
    }

    /// Axes of a diffusion tensor that is 1 across its long axis: stripes keep their width at any stretch.
    #[must_use]
    pub fn of_unit_width(p: &Parameters) -> Self {
        let stretch = f64::from(p.stretch.max(MIN_STRETCH));
        Self { along: 1.0 / (stretch * stretch), across: 1.0, degrees: f64::from(p.direction) }
    }

    /// The ratio of the axes, minor ÷ major, of the ellipse that the tensor makes of a circle, with the direction of the major one;
    /// and the ratio of the tensor to that of determinant 1.
    #[must_use]
    pub fn parted(self) -> (Stretch, f64) {
        let (ratio, quarter) = if self.along < self.across {
            (self.along / self.across, 90.0)
        } else {
            (self.across / self.along, 0.0)
        };
        let stretch = Stretch { ratio: ratio.sqrt() as f32, degrees: (self.degrees + quarter) as f32 };
        (stretch, (self.along * self.across).sqrt())
    }

    /// The tensor.
    #[must_use]
    pub fn tensor(self) -> Tensor {
        Tensor::oriented(self.along, self.across, self.degrees)
    }
}

impl Tensor {
    /// Eigenvalues `along` the direction `degrees` and `across` it.
    #[inline]
    #[must_use]
    pub fn oriented(along: f64, across: f64, degrees: f64) -> Self {
        let (s, c) = sin_cos_degrees(degrees);
        Self {
            xx: along * c * c + across * s * s,
            xy: (along - across) * c * s,
            yy: along * s * s + across * c * c,
        }
    }

    /// This diffusion tensor on cells that are `cell[0]` wide and `cell[1]` high (in any common unit).
    #[inline]
    #[must_use]
    pub fn on_cells(self, [x, y]: [f64; 2]) -> Self {
        let area = x * y;
        Self { xx: self.xx * area / (x * x), xy: self.xy, yy: self.yy * area / (y * y) }
    }

    /// uᵀDv.
    #[inline(always)]
    pub(super) fn product(&self, [ux, uy]: [f64; 2], [vx, vy]: [f64; 2]) -> f64 {
        ux * (self.xx * vx + self.xy * vy) + uy * (self.xy * vx + self.yy * vy)
    }

    /// The weight of each of [`OFFSETS`], as [`Self::stencil`] gives them.
    #[must_use]
    pub fn weights(self) -> [f32; OFFSETS.len()] {
        let mut weights = [0.0; OFFSETS.len()];
        self.stencil().into_iter().for_each(|(k, weight)| weights[k] += weight);
        weights
    }

    /// Three indices k of [`OFFSETS`] with their weights wₖ ≥ 0, so that Σ wₖ eₖeₖᵀ = this tensor. An index
    /// with weight 0 has no meaning.
    ///
    /// A tensor that needs longer offsets is first made rounder, in steps of 1 %, until these offsets suffice.
    #[must_use]
    pub fn stencil(mut self) -> [(usize, f32); 3] {
        loop {
            if let Some(stencil) = self.reduced() {
                return stencil;
            }
            let mean = 0.5 * (self.xx + self.yy);
            self.xx += 0.01 * (mean - self.xx);
            self.yy += 0.01 * (mean - self.yy);
            self.xy *= 0.99;
        }
    }

    fn reduced(&self) -> Option<[(usize, f32); 3]> {
        self.stencil_of(&Superbase::of(self))
    }

    /// The stencil of this tensor by a superbase that may be obtuse for it; `None` if it is not, or needs another offset.
    pub(super) fn stencil_of(&self, Superbase { base, indices }: &Superbase) -> Option<[(usize, f32); 3]> {
        let mut stencil = [(0, 0.0); 3];
        for (entry, ((i, j, _), index)) in stencil.iter_mut().zip(TRIPLES.into_iter().zip(indices)) {
            let product = self.product(base[i], base[j]);
            if product > 0.0 {
                return None;
            }
            if product < 0.0 {
                *entry = ((*index)?, -product as f32);
            }
        }
        Some(stencil)
    }
}

/// Three vectors (i, j, k) of a superbase: the product of the first two is the weight of the offset across the third.
pub(super) const TRIPLES: [(usize, usize, usize); 3] = [(0, 1, 2), (1, 2, 0), (2, 0, 1)];

/// Three vectors of whole numbers with the sum 0, two of which span the grid.
#[derive(Clone, Copy, Debug)]
pub(super) struct Superbase {
    pub(super) base: [[f64; 2]; 3],
    /// By triple, the index in [`OFFSETS`] of the offset across its third vector.
    pub(super) indices: [Option<usize>; 3],
}

impl Superbase {
    /// An obtuse superbase of `tensor`: no product of two of its vectors is positive. Selling's reduction.
    pub(super) fn of(tensor: &Tensor) -> Self {
        // Small whole numbers.
        let mut base = [[1.0, 0.0], [0.0, 1.0], [-1.0, -1.0]];
        'reduce: for _ in 0..32 {
            for (i, j, k) in TRIPLES {
                let (bi, bj) = (base[i], base[j]);
                if tensor.product(bi, bj) > 0.0 {
                    base[i] = [-bi[0], -bi[1]];
                    base[k] = [bi[0] - bj[0], bi[1] - bj[1]];
                    continue 'reduce;
                }
            }
            break;
        }
        let indices = TRIPLES.map(|(_, _, k)| index_of([-base[k][1] as isize, base[k][0] as isize]));
        Self { base, indices }
    }
}

/// Offsets from −[`REACH`] to [`REACH`] along an axis.
const SIDE: usize = 2 * REACH + 1;

/// The index of each offset and of its opposite in [`OFFSETS`], by place in the square of [`SIDE`]; of any other offset the length of
/// [`OFFSETS`].
const INDICES: [u8; SIDE * SIDE] = {
    let mut indices = [OFFSETS.len() as u8; SIDE * SIDE];
    let mut k = 0;
    while k < OFFSETS.len() {
        let [x, y] = OFFSETS[k];
        let middle = (SIDE * SIDE / 2) as isize;
        let from_middle = y * SIDE as isize + x;
        indices[(middle + from_middle) as usize] = k as u8;
        indices[(middle - from_middle) as usize] = k as u8;
        k += 1;
    }
    indices
};

/// The index in [`OFFSETS`] of an offset or of its opposite.
fn index_of(offset: [isize; 2]) -> Option<usize> {
    let [x, y] = offset.map(|along| (along + REACH as isize) as usize);
    if x >= SIDE || y >= SIDE {
        return None;
    }
    Some(usize::from(INDICES[y * SIDE + x])).filter(|index| *index < OFFSETS.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tensors() -> impl Iterator<Item = Tensor> {
        (0..90).flat_map(|i| {
            [1.0f64, 0.7, 0.5, 0.35, 0.26, 0.18, 0.13]
                .map(|r| Tensor::oriented(1.0 / r, r, 2.0 * f64::from(i)))
        })
    }

    #[test]
    fn weights_are_non_negative_and_sum_up_to_the_tensor() {
        for t in tensors() {
            let w = t.weights();
            let sum = |f: fn(f64, f64) -> f64| {
                (0..OFFSETS.len())
                    .map(|k| f64::from(w[k]) * f(OFFSETS[k][0] as f64, OFFSETS[k][1] as f64))
                    .sum::<f64>()
            };
            assert!(w.iter().all(|w| *w >= 0.0), "{t:?}: {w:?}");
            assert!((sum(|x, _| x * x) - t.xx).abs() < 1e-5, "{t:?}: {w:?}");
            assert!((sum(|x, y| x * y) - t.xy).abs() < 1e-5, "{t:?}: {w:?}");
            assert!((sum(|_, y| y * y) - t.yy).abs() < 1e-5, "{t:?}: {w:?}");
            assert!(w.iter().filter(|w| **w > 0.0).count() <= 3);
        }
    }

    #[test]
    fn the_stencil_turns_with_the_tensor_by_90_degrees() {
        // (x, y) → (−y, x) sends offset k to this one.
        let turned = [1, 0, 3, 2, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12, 19, 18, 17, 16];
        for t in tensors() {
            let quarter = Tensor { xx: t.yy, xy: -t.xy, yy: t.xx };
            let (w, v) = (t.weights(), quarter.weights());
            for k in 0..OFFSETS.len() {
                assert!((w[k] - v[turned[k]]).abs() < 1e-5, "{t:?}: {w:?} {v:?}");
            }
        }
    }

    #[test]
    fn offsets_and_their_opposites_are_found_and_no_others() {
        let reach = REACH as isize + 1;
        for x in -reach..=reach {
            for y in -reach..=reach {
                let is = |o: &[isize; 2]| *o == [x, y] || *o == [-x, -y];
                assert_eq!(index_of([x, y]), OFFSETS.iter().position(is), "{x} {y}");
            }
        }
    }

    #[test]
    fn a_too_narrow_tensor_is_made_rounder() {
        let w = Tensor::oriented(20.0, 0.05, 17.0).weights();
        assert!(w.iter().all(|w| w.is_finite() && *w >= 0.0) && w.iter().sum::<f32>() > 0.0);
    }

    #[test]
    fn isotropic_diffusion_on_square_cells_is_the_five_point_stencil() {
        assert_eq!(Tensor::oriented(1.0, 1.0, 33.0).weights()[..2], [1.0, 1.0]);
    }
}
