//! The stencils of [`LANES`] tensors side by side. Neighbours mostly have equal obtuse superbases, which saves Selling's reduction.

use multiversion::multiversion;

use super::plane::{LANES, Lanes};
use super::selling::{OFFSETS, PrincipalAxes, Superbase, TRIPLES, Tensor};

/// The weights of tensors on cells of one size, group by group.
pub(super) struct StencilLanes {
    /// Width and height of a cell, in any common unit.
    cell: [f64; 2],
    /// The superbase of a tensor of the last group.
    superbase: Superbase,
    /// The last tensors, and the offsets that they use, as bits.
    known: Option<([PrincipalAxes; LANES], u32)>,
}

impl StencilLanes {
    /// Stencils for cells that are `cell[0]` wide and `cell[1]` high.
    pub(super) fn new(cell: [f64; 2]) -> Self {
        Self { cell, superbase: Superbase::of(&Tensor { xx: 1.0, xy: 0.0, yy: 1.0 }), known: None }
    }

    /// Writes the weights of the tensors with these `axes` by offset, equal to [`Tensor::stencil`] up to rounding; only for the
    /// offsets that some tensor uses, which are returned as bits. `weights` hold the values of the last group.
    pub(super) fn write(
        &mut self,
        axes: &[PrincipalAxes; LANES],
        weights: &mut [Lanes; OFFSETS.len()],
    ) -> u32 {
        if let Some((known, used)) = &self.known
            && known == axes
        {
            return *used;
        }
        let used = self.side_by_side(axes, weights).unwrap_or_else(|| self.one_by_one(axes, weights));
        self.known = Some((*axes, used));
        used
    }

    /// Writes the weights of tensors that all have the obtuse superbase of the last group.
    fn side_by_side(
        &self,
        axes: &[PrincipalAxes; LANES],
        weights: &mut [Lanes; OFFSETS.len()],
    ) -> Option<u32> {
        let products = products(axes, self.cell, &self.superbase.base);
        let mut used = 0;
        for (products, index) in products.iter().zip(self.superbase.indices) {
            let (mut any_positive, mut any_negative) = (false, false);
            for product in products {
                any_positive |= *product > 0.0;
                any_negative |= *product < 0.0;
            }
            if any_positive {
                return None;
            }
            if any_negative {
                let k = index?;
                weights[k] = Lanes(products.map(|product| if product < 0.0 { -product as f32 } else { 0.0 }));
                used |= 1 << k;
            }
        }
        Some(used)
    }

    /// Writes the weights of any tensors, one after the other.
    fn one_by_one(&mut self, axes: &[PrincipalAxes; LANES], weights: &mut [Lanes; OFFSETS.len()]) -> u32 {
        *weights = [Lanes([0.0; LANES]); OFFSETS.len()];
        let mut used = 0;
        for (lane, axes) in axes.iter().enumerate() {
            let tensor = axes.tensor().on_cells(self.cell);
            let stencil = tensor.stencil_of(&self.superbase).unwrap_or_else(|| {
                self.superbase = Superbase::of(&tensor);
                tensor.stencil()
            });
            for (k, weight) in stencil.into_iter().filter(|(_, weight)| *weight > 0.0) {
                weights[k].0[lane] = weight;
                used |= 1 << k;
            }
        }
        used
    }
}

/// By triple of the superbase, the product of two of its vectors in each tensor.
#[multiversion(targets("x86_64+avx2"))]
fn products(axes: &[PrincipalAxes; LANES], cell: [f64; 2], base: &[[f64; 2]; 3]) -> [[f64; LANES]; 3] {
    let [mut along, mut across, mut degrees] = [[0.0; LANES]; 3];
    for (lane, axes) in axes.iter().enumerate() {
        (along[lane], across[lane], degrees[lane]) = (axes.along, axes.across, axes.degrees);
    }
    let [mut xx, mut xy, mut yy] = [[0.0; LANES]; 3];
    for lane in 0..LANES {
        let tensor = Tensor::oriented(along[lane], across[lane], degrees[lane]).on_cells(cell);
        (xx[lane], xy[lane], yy[lane]) = (tensor.xx, tensor.xy, tensor.yy);
    }
    let mut products = [[0.0; LANES]; 3];
    for (products, (i, j, _)) in products.iter_mut().zip(TRIPLES) {
        for lane in 0..LANES {
            let tensor = Tensor { xx: xx[lane], xy: xy[lane], yy: yy[lane] };
            products[lane] = tensor.product(base[i], base[j]);
        }
    }
    products
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_have_the_stencils_that_their_tensors_have_one_by_one() {
        let cell = [1.0, 1.03];
        let mut lanes = StencilLanes::new(cell);
        let mut weights = [Lanes([0.0; LANES]); OFFSETS.len()];
        let mut mixed = 0;
        // In some groups neighbours are alike, in others they have all directions; every third group repeats the one before.
        for group in 0..900 {
            let of = group - group % 3 / 2;
            let spread = [0.0, 0.02, 0.3, 11.0][of / 3 % 4];
            let axes: [PrincipalAxes; LANES] = std::array::from_fn(|lane| {
                let stretch = 0.13 + 0.87 * (0.5 + 0.5 * libm::sin(0.37 * of as f64 + 0.01 * lane as f64));
                let degrees = 1.7 * of as f64 + spread * lane as f64;
                PrincipalAxes { along: 1.0 / stretch, across: stretch, degrees }
            });
            let used = lanes.write(&axes, &mut weights);
            let mut needed = 0;
            for (lane, axes) in axes.iter().enumerate() {
                let exact = axes.tensor().on_cells(cell).weights();
                for (k, exact) in exact.into_iter().enumerate() {
                    let found = if used & (1 << k) == 0 { 0.0 } else { weights[k].0[lane] };
                    assert!((found - exact).abs() <= 2e-6, "{axes:?}, offset {k}: {found} for {exact}");
                    needed |= u32::from(exact > 1e-5) << k;
                }
            }
            assert_eq!(used & needed, needed);
            mixed += u32::from(used.count_ones() > 3);
        }
        assert!((50..600).contains(&mixed), "{mixed} of 900 groups are mixed");
    }
}
