//! The structure tensor of a picture: the directions of its edges, and their strength.
//!
//! ```text
//! J = G_σ₂ * (∇ḡ ∇ḡᵀ),  ḡ = G_σ₁ * g
//! J + WIDE · (J with 4σ₂) + share · mean(tr J) · n nᵀ
//! ```
//!
//! J. Bigün & G. Granlund, "Optimal orientation detection of linear symmetry", ICCV 1987. n is across the direction of the sketch:
//! where the picture is flat, lines have the drawn direction.

use rayon::prelude::*;

use crate::grid::Edges;
use crate::grid::blur::gaussian;

/// σ₁ and σ₂ in wavelengths (3 and 7.5 of the 11.6 cells that a wavelength had, `facts.md` V).
const SIGMAS: [f64; 2] = [0.26, 0.65];
/// Weight of the tensor that is blurred four times as far. Without it, directions in flat parts between edges are irregular.
const WIDE: f32 = 0.15;
/// Factor of the wider blur.
const WIDER: f64 = 4.0;

/// A direction wanted everywhere, and its weight.
pub struct Constant<'a> {
    /// Degrees, at each cell.
    pub direction: &'a (dyn Fn(usize) -> f64 + Sync),
    /// Its weight, in means of the picture's own tensor.
    pub share: f64,
}

/// A symmetric tensor at each cell: xx, xy, yy.
#[derive(Clone, Debug)]
pub struct Tensors {
    /// Cells along x and y.
    pub size: [usize; 2],
    /// Whether the borders wrap around.
    pub edges: Edges,
    /// xx, xy, yy.
    pub parts: [Vec<f32>; 3],
}

/// The tensor of `gray` on `size` cells: the gradient is that of the picture blurred by `sigmas[0]` cells, and its products are
/// blurred by `sigmas[1]`.
#[must_use]
pub fn structure(gray: &[f32], size: [usize; 2], sigmas: [f64; 2], edges: Edges) -> Tensors {
    let [width, height] = size;
    let smooth = gaussian(gray, size, sigmas[0], edges);
    let at = |x: isize, y: isize| smooth[edges.index(y, height) * width + edges.index(x, width)];
    let gradient = |cell: usize| {
        let [x, y] = [cell % width, cell / width].map(|k| k as isize);
        [at(x + 1, y) - at(x - 1, y), at(x, y + 1) - at(x, y - 1)]
    };
    let part = |of: fn([f32; 2]) -> f32| {
        let raw: Vec<f32> = (0..width * height).into_par_iter().map(|cell| of(gradient(cell))).collect();
        gaussian(&raw, size, sigmas[1], edges)
    };
    Tensors { size, edges, parts: [part(|[x, _]| x * x), part(|[x, y]| x * y), part(|[_, y]| y * y)] }
}

/// The tensor of a picture for lines that are `wavelength` cells apart.
#[must_use]
pub fn edges_of(gray: &[f32], size: [usize; 2], wavelength: f64, edges: Edges) -> Tensors {
    structure(gray, size, SIGMAS.map(|sigma| sigma * wavelength), edges)
}

impl Tensors {
    /// tr J: the energy of the gradient.
    #[must_use]
    pub fn energy(&self, cell: usize) -> f32 {
        self.parts[0][cell] + self.parts[2][cell]
    }

    /// The mean energy.
    #[must_use]
    pub fn mean_energy(&self) -> f64 {
        let cells = self.parts[0].len();
        (0..cells).map(|cell| f64::from(self.energy(cell))).sum::<f64>() / cells.max(1) as f64
    }

    /// This tensor plus a part of itself that is blurred farther, so that flat places have the directions of their surroundings.
    #[must_use]
    pub fn spread(mut self, wavelength: f64) -> Self {
        let sigma = WIDER * SIGMAS[1] * wavelength;
        for part in &mut self.parts {
            let wide = gaussian(part, self.size, sigma, self.edges);
            part.iter_mut().zip(wide).for_each(|(own, wide)| *own += WIDE * wide);
        }
        self
    }

    /// This tensor plus a constant one.
    #[must_use]
    pub fn plus(mut self, constant: &Constant) -> Self {
        let mean = self.mean_energy();
        // A picture without any edge still has directions.
        let weight = constant.share * if mean > 0.0 { mean } else { 1.0 };
        for cell in 0..self.parts[0].len() {
            let across = (constant.direction)(cell).to_radians();
            let [x, y] = [-libm::sin(across), libm::cos(across)];
            for (part, product) in self.parts.iter_mut().zip([x * x, x * y, y * y]) {
                part[cell] += (weight * product) as f32;
            }
        }
        self
    }

    /// The direction along the edges, degrees from −90 to 90, and how coherent it is, 0..1.
    #[must_use]
    pub fn along(&self, cell: usize) -> (f64, f64) {
        let [xx, xy, yy] = [0, 1, 2].map(|part| f64::from(self.parts[part][cell]));
        // The direction across the edges is ½ atan2(2 xy, xx − yy); along them it is 90° more.
        let angle = 0.5 * libm::atan2(-2.0 * xy, yy - xx).to_degrees();
        let difference = ((xx - yy) * (xx - yy) + 4.0 * xy * xy).sqrt();
        let sum = xx + yy;
        (angle, if sum > 0.0 { difference / sum } else { 0.0 })
    }
}

/// The directions and coherences at all cells.
#[must_use]
pub fn directions_of(tensors: &Tensors) -> Vec<(f64, f64)> {
    (0..tensors.parts[0].len()).into_par_iter().map(|cell| tensors.along(cell)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn waves(size: [usize; 2], angle: f64, wavelength: f64) -> Vec<f32> {
        let (s, c) = angle.to_radians().sin_cos();
        let at = |cell: usize| {
            let [x, y] = [cell % size[0], cell / size[0]].map(|k| k as f64);
            (TAU * (y * c - x * s) / wavelength).cos() as f32
        };
        (0..size[0] * size[1]).map(at).collect()
    }

    #[test]
    fn directions_run_along_the_waves_of_a_picture() {
        let size = [60, 50];
        for angle in [-70.0, 0.0, 25.0, 90.0] {
            let tensors = edges_of(&waves(size, angle, 15.0), size, 8.0, Edges::Closed);
            let (found, coherence) = tensors.along(25 * 60 + 30);
            let off = (found - angle + 90.0).rem_euclid(180.0) - 90.0;
            assert!(off.abs() < 1.0 && coherence > 0.9, "{angle}: {found} {coherence}");
        }
    }

    #[test]
    fn a_flat_picture_has_the_directions_of_the_sketch() {
        let size = [40, 30];
        let constant = Constant { direction: &|_| 33.0, share: 0.1 };
        let tensors = edges_of(&[0.5; 1200], size, 8.0, Edges::Closed).spread(8.0).plus(&constant);
        assert!(directions_of(&tensors).iter().all(|(angle, _)| (angle - 33.0).abs() < 1e-3));
    }
}
