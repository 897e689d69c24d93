//! Local directions: the structure tensor.
//!
//! J = G_ρ ∗ (∇u_σ ∇u_σᵀ),  u_σ = G_σ ∗ u
//!
//! The gradient runs across the stripes. With the double-angle vector (J₁₁ − J₂₂, 2J₁₂) of its direction, the
//! direction along them is the opposite vector; its length ÷ (J₁₁ + J₂₂) is the coherence, 0..1.
//!
//! J. Bigün & G. H. Granlund, "Optimal orientation detection of linear symmetry", ICCV 1987; names of σ and ρ as
//! in J. Weickert, "Coherence-enhancing diffusion filtering", IJCV 31 (1999).

use multiversion::multiversion;
use rayon::prelude::*;

use crate::grid::{Edges, Field, atan2};
use crate::marks::axial;

/// ρ ÷ wavelength: a window of about one wavelength, wide enough to hold both sides of a stripe.
const RHO: f64 = 0.3;

/// σ ÷ wavelength, where that is more than one cell.
const SIGMA: f64 = 0.05;

/// Blocks of a place along each side: gradients are summed over blocks of cells before they are blurred.
const BLOCKS: usize = 2;

/// Places with less than this share of the mean energy have no direction.
const FLOOR: f64 = 1e-3;

/// Local directions on a grid of places ρ apart: J hardly changes within ρ.
#[derive(Clone, Debug)]
pub struct Directions {
    /// Places in a row.
    columns: usize,
    /// px from one to the next.
    apart: [f64; 2],
    /// coherence · (cos 2θ, sin 2θ) of the direction θ along the stripes, by place.
    vectors: Vec<[f64; 2]>,
}

/// Deviation of local directions from wanted ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Coherence-weighted axial mean, degrees in −90..90.
    pub mean: f64,
    /// Coherence-weighted root mean square, degrees.
    pub rms: f64,
    /// Sum of the weights.
    pub weight: f64,
}

impl Directions {
    /// Local directions of `field`, whose stripes repeat after about `wavelength` px.
    ///
    /// σ = 0.05 and ρ = 0.3 wavelengths, σ at least one cell. Gradients within 2σ of a closed border, which
    /// mirrored values would distort, are left out. Memory: some 50 bytes a block, of which 2 × 2 cover ρ².
    #[must_use]
    pub fn measure(field: &Field, wavelength: f64) -> Self {
        let size = [field.width, field.height];
        let sigma = field.cell.map(|cell| (SIGMA * wavelength / cell).max(1.0));
        let rho = field.cell.map(|cell| (RHO * wavelength / cell).max(1.0));
        let along = [0, 1].map(|axis| Blocks::new(size[axis], rho[axis]));
        let sums = block_sums(field, sigma, along.map(Blocks::count));
        let spread = [0, 1].map(|axis| {
            let block = size[axis] as f64 / along[axis].count() as f64;
            // The sums over blocks have blurred J already.
            (rho[axis] * rho[axis] - (block * block - 1.0) / 12.0).sqrt() / block
        });
        let tensor = blur(&sums, along, spread, field.edges);
        let mean = tensor.iter().map(|j| j[0] + j[2]).sum::<f64>() / tensor.len() as f64;
        let vector = |j: &[f64; 3]| {
            let energy = j[0] + j[2] + FLOOR * mean;
            if energy > 0.0 { [(j[2] - j[0]) / energy, -2.0 * j[1] / energy] } else { [0.0, 0.0] }
        };
        let extent = field.extent();
        let apart = [0, 1].map(|axis| extent[axis] / along[axis].places as f64);
        Self { columns: along[0].places, apart, vectors: tensor.iter().map(vector).collect() }
    }

    /// Coherence-weighted axial mean of the direction, degrees, and its resultant, 0..1; `None` without any.
    #[must_use]
    pub fn mean(&self) -> Option<(f64, f64)> {
        let (mut sum, mut weight) = ([0.0, 0.0], 0.0);
        for [c, s] in &self.vectors {
            sum = [sum[0] + c, sum[1] + s];
            weight += (c * c + s * s).sqrt();
        }
        let angle = axial(0.5 * libm::atan2(sum[1], sum[0]).to_degrees());
        (weight > 0.0).then(|| (angle, (sum[0] * sum[0] + sum[1] * sum[1]).sqrt() / weight))
    }

    /// Mean coherence over the canvas, 0..1.
    #[must_use]
    pub fn coherence(&self) -> f64 {
        let sum: f64 = self.vectors.iter().map(|[c, s]| (c * c + s * s).sqrt()).sum();
        sum / self.vectors.len() as f64
    }

    /// `value` at each place, px, in their order; evaluated in parallel.
    pub fn at_places<T: Send>(&self, value: impl Fn([f64; 2]) -> T + Sync) -> Vec<T> {
        (0..self.vectors.len()).into_par_iter().map(|k| value(self.place(k))).collect()
    }

    /// For each place, in their order, the centres of the quarters of its rectangle, px.
    pub fn quarters(&self) -> impl Iterator<Item = [[f64; 2]; 4]> {
        let quarter = |at: [f64; 2], x: f64, y: f64| [at[0] + x * self.apart[0], at[1] + y * self.apart[1]];
        (0..self.vectors.len()).map(move |k| {
            let at = self.place(k);
            [[-0.25, -0.25], [0.25, -0.25], [-0.25, 0.25], [0.25, 0.25]].map(|[x, y]| quarter(at, x, y))
        })
    }

    /// By region, the deviation of the directions from the wanted ones; `None` for a region without any direction. `places` holds,
    /// in the order of [`Self::at_places`], the region and (cos 2θ, sin 2θ) of the wanted direction θ.
    #[must_use]
    pub fn deviations(&self, places: &[(usize, [f64; 2])], regions: usize) -> Vec<Option<Deviation>> {
        // For each place: the double-angle vector of its deviation, and coherence · deviation².
        let each: Vec<([f64; 2], f64, f64)> = self
            .vectors
            .par_iter()
            .zip(places)
            .map(|([c, s], (_, [cos, sin]))| {
                let turned = [c * cos + s * sin, s * cos - c * sin];
                let weight = (c * c + s * s).sqrt();
                let turn = 0.5 * atan2(turned[1], turned[0]).to_degrees();
                (turned, weight, weight * turn * turn)
            })
            .collect();
        let mut sums = vec![([0.0, 0.0], 0.0, 0.0); regions];
        for ((turned, weight, square), (region, _)) in each.iter().zip(places) {
            let sum = &mut sums[*region];
            *sum = ([sum.0[0] + turned[0], sum.0[1] + turned[1]], sum.1 + weight, sum.2 + square);
        }
        let deviation = |([c, s], weight, square): ([f64; 2], f64, f64)| {
            let mean = 0.5 * libm::atan2(s, c).to_degrees();
            (weight > 0.0).then(|| Deviation { mean, rms: (square / weight).sqrt(), weight })
        };
        sums.into_iter().map(deviation).collect()
    }

    /// The coherence-weighted axial mean of the direction in each region, degrees; `places` as for
    /// [`Self::deviations`].
    #[must_use]
    pub fn means(&self, places: &[(usize, [f64; 2])], regions: usize) -> Vec<Option<f64>> {
        let mut sums = vec![[0.0, 0.0]; regions];
        for ([c, s], (region, _)) in self.vectors.iter().zip(places) {
            let sum = &mut sums[*region];
            *sum = [sum[0] + c, sum[1] + s];
        }
        let mean = |[c, s]: [f64; 2]| axial(0.5 * libm::atan2(s, c).to_degrees());
        sums.into_iter().map(|sum| (sum != [0.0, 0.0]).then(|| mean(sum))).collect()
    }

    fn place(&self, k: usize) -> [f64; 2] {
        let (x, y) = ((k % self.columns) as f64, (k / self.columns) as f64);
        [(x + 0.5) * self.apart[0], (y + 0.5) * self.apart[1]]
    }
}

/// The layout of blocks along one side.
#[derive(Clone, Copy)]
struct Blocks {
    /// Places at which J is known: in the middle of the blocks of each.
    places: usize,
    /// Blocks of a place, 1 or [`BLOCKS`].
    each: usize,
}

impl Blocks {
    /// Places about `rho` cells apart along `cells` cells.
    fn new(cells: usize, rho: f64) -> Self {
        let each = BLOCKS.min(cells);
        Self { places: ((cells as f64 / rho).round() as usize).clamp(1, cells / each), each }
    }

    fn count(self) -> usize {
        self.places * self.each
    }

    /// Weights of the blocks about a place, of a Gaussian with the standard deviation `spread`, blocks; and how many blocks lie
    /// before the first one of the place.
    fn weights(self, spread: f64) -> (Vec<f32>, isize) {
        let reach = (4.0 * spread).ceil() as isize;
        // Position of the first block of a place, from the centre of the place.
        let first = 0.5 - 0.5 * self.each as f64;
        let bell = |k: isize| {
            let at = (k as f64 + first) / spread;
            libm::exp(-0.5 * at * at)
        };
        let bells: Vec<f64> = (-reach..reach + self.each as isize).map(bell).collect();
        let total: f64 = bells.iter().sum();
        (bells.iter().map(|bell| (bell / total) as f32).collect(), reach)
    }
}

/// Weights of a Gaussian out to four standard deviations (in cells), with the sum 1; or of its derivative, scaled so that a ramp
/// has its own slope.
fn gaussian(sigma: f64, derivative: bool) -> Vec<f32> {
    let reach = (4.0 * sigma).ceil() as isize;
    let at = |i: isize| i as f64 / sigma;
    let bell = |i: isize| libm::exp(-0.5 * at(i) * at(i));
    let shape = |i: isize| if derivative { i as f64 * bell(i) } else { bell(i) };
    let response = |i: isize| if derivative { i as f64 * shape(i) } else { shape(i) };
    let total: f64 = (-reach..=reach).map(response).sum();
    (-reach..=reach).map(|i| (shape(i) / total) as f32).collect()
}

/// Σ of (gx², gx·gy, gy²) over the cells of each block; gradients in 1/px.
fn block_sums(field: &Field, sigma: [f64; 2], [columns, rows]: [usize; 2]) -> Vec<[f64; 3]> {
    let smooth = sigma.map(|sigma| gaussian(sigma, false));
    let slope = sigma.map(|sigma| gaussian(sigma, true));
    let away = match field.edges {
        Edges::Wrap => [0, 0],
        Edges::Closed => [0, 1].map(|k| {
            let margin = (2.0 * sigma[k]).ceil() as usize;
            if 4 * margin < [field.width, field.height][k] { margin } else { 0 }
        }),
    };
    let mut sums = vec![[0.0; 3]; columns * rows];
    sums.par_chunks_mut(columns).enumerate().for_each_init(
        || [(); 4].map(|()| vec![0.0_f32; field.width]),
        |[smoothed, sloped, across, down], (row, sums)| {
            let (from, to) = (row * field.height / rows, (row + 1) * field.height / rows);
            for y in from.max(away[1])..to.min(field.height - away[1]) {
                column_sums(field, y, &smooth[1], smoothed);
                column_sums(field, y, &slope[1], sloped);
                row_sums(smoothed, &slope[0], field.edges, across);
                row_sums(sloped, &smooth[0], field.edges, down);
                for (column, sum) in sums.iter_mut().enumerate() {
                    let [from, to] = [column, column + 1].map(|k| (k * field.width).div_ceil(columns));
                    let inside = from.max(away[0])..to.min(field.width - away[0]);
                    if inside.is_empty() {
                        continue;
                    }
                    for (across, down) in across[inside.clone()].iter().zip(&down[inside]) {
                        let gx = f64::from(*across) / field.cell[0];
                        let gy = f64::from(*down) / field.cell[1];
                        *sum = [sum[0] + gx * gx, sum[1] + gx * gy, sum[2] + gy * gy];
                    }
                }
            }
        },
    );
    sums
}

/// Weighted sums along each column, about row `y`.
#[multiversion(targets("x86_64+avx2"))]
fn column_sums(field: &Field, y: usize, weights: &[f32], out: &mut [f32]) {
    out.fill(0.0);
    for (k, weight) in weights.iter().enumerate() {
        let from = field.edges.index(y as isize + k as isize - (weights.len() / 2) as isize, field.height);
        let row = &field.values[from * field.width..(from + 1) * field.width];
        out.iter_mut().zip(row).for_each(|(out, value)| *out += weight * value);
    }
}

/// Weighted sums along a row, about each of its places.
#[multiversion(targets("x86_64+avx2"))]
fn row_sums(row: &[f32], weights: &[f32], edges: Edges, out: &mut [f32]) {
    let (n, reach) = (row.len(), weights.len() / 2);
    out.fill(0.0);
    // Away from the ends all places are processed at once, one weight after the other.
    let inner = reach.min(n)..n.saturating_sub(reach).max(reach.min(n));
    // A row may be shorter than the weights: then none is away from the ends.
    if !inner.is_empty() {
        for (k, weight) in weights.iter().enumerate() {
            let out = out[inner.clone()].iter_mut();
            out.zip(&row[k..]).for_each(|(out, value)| *out += weight * value);
        }
    }
    for x in (0..inner.start).chain(inner.end..n) {
        let at = |k: usize| row[edges.index(x as isize + k as isize - reach as isize, n)];
        out[x] = weights.iter().enumerate().map(|(k, weight)| weight * at(k)).sum();
    }
}

/// The values of blocks, blurred by a Gaussian of `spread` blocks along x and y, at the places among them. Beyond a closed border
/// they are mirrored.
fn blur(sums: &[[f64; 3]], along: [Blocks; 2], spread: [f64; 2], edges: Edges) -> Vec<[f64; 3]> {
    let [columns, rows] = along.map(Blocks::count);
    let [(across, left), (down, above)] = [0, 1].map(|axis| along[axis].weights(spread[axis]));
    let mut blurred = vec![[0.0; 3]; along[0].places * along[1].places];
    let each = blurred.par_chunks_mut(along[0].places).enumerate();
    each.for_each_init(Default::default, |(row, padded): &mut (Vec<_>, Vec<_>), (y, out)| {
        row.clear();
        row.resize(columns, [0.0; 3]);
        for (k, weight) in (-above..).zip(&down) {
            let from = edges.index((y * along[1].each) as isize + k, rows) * columns;
            add_weighted(row, &sums[from..from + columns], *weight);
        }
        padded.clear();
        padded.extend((-left..columns as isize + left).map(|x| row[edges.index(x, columns)]));
        for (x, sum) in out.iter_mut().enumerate() {
            *sum = weighted(&padded[x * along[0].each..], &across);
        }
    });
    blurred
}

/// Adds `weight` × `row`.
#[multiversion(targets("x86_64+avx2"))]
fn add_weighted(out: &mut [[f64; 3]], row: &[[f64; 3]], weight: f32) {
    let row = row.as_flattened();
    out.as_flattened_mut().iter_mut().zip(row).for_each(|(out, value)| *out += f64::from(weight) * value);
}

/// The sum of the first of `blocks` by these `weights`.
fn weighted(blocks: &[[f64; 3]], weights: &[f32]) -> [f64; 3] {
    let add = |sum: [f64; 3], (block, weight): (&[f64; 3], &f32)| {
        std::array::from_fn(|k| sum[k] + f64::from(*weight) * block[k])
    };
    blocks.iter().zip(weights).fold([0.0; 3], add)
}
