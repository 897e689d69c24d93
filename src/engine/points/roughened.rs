//! Ragged edges on any pattern: noise at the scale of the marks, added where the pattern has its edges.
//!
//! ```text
//! p′ = p + amp·(n − n̄)·4·p·(1 − p)
//! ```
//! n is noise of two octaves, interpolated from random values at Poisson discs of radius .7·r and half of it, where r is half of
//! the width of the marks around the place. n̄ is the least-squares fit of n by 1, cos θ, sin θ, cos 2θ and sin 2θ along the edge
//! of the mark nearest to the place, where θ is the direction from its centre (for stripes only the mean): so each mark nearly
//! keeps its area, place, aspect and direction. Where two marks are close to each other, p is not raised between them. Then the
//! level of the edge is found again, so that the total area stays the same. Fragments, and holes within a mark, are removed: pieces
//! of less than half of a mark that are not its largest one, and holes of this size (`parts`).
//!
//! The raggedness of the edges depends on the slope of the pattern there, which differs between systems: the amplitude is found by
//! measuring. Noise that displaces the places instead would change the area.

mod parts;

use nalgebra::{SMatrix, SVector};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::delaunay::Delaunay;
use super::discs::poisson_discs;
use super::extent::Extent;
use super::interpolation::{Weights, interpolate};
use super::level::{relevel, share_above};
use super::metric::Metric;
use crate::grid::distance::{length, nearest};
use crate::grid::{Field, Grid};
use parts::Parts;

/// Radius of the discs of the noise, in radii of the marks: half of the wavelength.
pub const SCALE: f64 = 0.7;
/// Weights of the octaves, each with half the radius of the previous one. One octave makes lobes; a third one makes no visible
/// difference.
const OCTAVES: [f32; 2] = [1.0, 0.5];
/// Factor that normalises the noise: the sum of the octaves, each uniform in ±1 at its discs, has a standard deviation of .5.
const NORMALISED: f32 = 2.0;
/// Width of the frame beyond a closed border, in radii of the discs: a place on the canvas is in supports of at most 2 radii, and
/// the neighbours of their points are 2 farther.
const MARGIN: f64 = 4.0;
/// Difference between the seeds of successive octaves; an odd number, so that none repeats (2⁶⁴ ÷ the golden ratio).
const OCTAVE_SEED: u64 = 0x9E37_79B9_7F4A_7C15;
/// Rounds of finding the level and removing parts: removed parts change the level for the next round.
const ROUNDS: usize = 5;
/// Relative error below which a share of the canvas counts as reached.
const FOUND: f64 = 1e-3;

/// The noise that roughens the edges of a pattern.
pub struct Roughening {
    /// n − n̄ of each cell.
    noise: Vec<f32>,
    /// The share of the canvas that the marks cover.
    share: f64,
}

impl Roughening {
    /// The highest amplitude: above it, noise alone determines the edges.
    pub const MOST: f32 = 0.6;

    /// The noise for `pattern`, 0..1 with its edges at ½, whose marks have the `radius` px (half of their width, for ellipses
    /// √(r₁·r₂)) around a place.
    #[must_use]
    pub fn new(pattern: &Field, radius: &(dyn Fn([f64; 2]) -> f64 + Sync), seed: u64) -> Self {
        let parts = Parts::new(pattern, radius);
        let mut noise = noise(&pattern.grid(), radius, seed);
        even(&mut noise, pattern, &parts, radius);
        Self { noise, share: share_above(pattern, 0.5) }
    }

    /// The `pattern`, whose marks have this `radius`, with edges roughened by `amount`, 0–[`Self::MOST`]; at 0 it is unchanged.
    #[must_use]
    pub fn by(&self, pattern: &Field, radius: &(dyn Fn([f64; 2]) -> f64 + Sync), amount: f32) -> Field {
        let mut out = pattern.clone();
        let amount = amount.clamp(0.0, Self::MOST);
        if amount == 0.0 {
            return out;
        }
        out.values.par_iter_mut().zip(&self.noise).for_each(|(value, noise)| {
            let p = value.clamp(0.0, 1.0);
            *value = (*value + amount * noise * 4.0 * p * (1.0 - p)).clamp(0.0, 1.0);
        });
        let parts = Parts::new(pattern, radius);
        for _ in 0..ROUNDS {
            relevel(&mut out, self.share);
            parts.tidy(&mut out);
            if (share_above(&out, 0.5) / self.share - 1.0).abs() < FOUND {
                break;
            }
        }
        parts::keep_off(&mut out);
        out
    }
}

/// n of each cell: noise whose discs follow `radius`.
fn noise(grid: &Grid, radius: &dyn Fn([f64; 2]) -> f64, seed: u64) -> Vec<f32> {
    let extent = Extent::from(grid.bounds_px());
    let mut sum = vec![0.0f32; grid.size[0] * grid.size[1]];
    for (octave, share) in OCTAVES.iter().enumerate() {
        let scale = SCALE * 0.5f64.powi(octave as i32);
        let disc = |at: [f64; 2]| Metric::circle(scale * radius(at));
        let [width, height] = extent.size;
        let largest = [0.0, 0.5, 1.0].iter().flat_map(|x| [0.0, 0.5, 1.0].map(|y| [x * width, y * height]));
        let frame = MARGIN * scale * largest.map(radius).fold(0.0, f64::max);
        let mut rng = Pcg64Mcg::seed_from_u64(seed.wrapping_add((octave as u64).wrapping_mul(OCTAVE_SEED)));
        let points = poisson_discs(&extent, frame, &disc, &[], &mut rng);
        let values: Vec<f32> = points.iter().map(|_| 2.0 * rng.random::<f32>() - 1.0).collect();
        let field = interpolate(&Delaunay::new(&points, extent), &values, grid, &Weights::default());
        sum.iter_mut().zip(&field.values).for_each(|(sum, value)| *sum += NORMALISED * share * value);
    }
    sum
}

/// Number of functions of the direction from a mark's centre that are removed from the noise.
const MODES: usize = 5;
/// A part of more than this number of discs of its radius is a stripe: only the mean is removed there.
const COMPACT: f64 = 6.0;

/// 1, cos θ, sin θ, cos 2θ and sin 2θ, where θ is the direction of a displacement.
#[must_use]
pub fn modes([x, y]: [f64; 2]) -> SVector<f64, MODES> {
    let length = libm::hypot(x, y);
    if length == 0.0 {
        return SVector::from([1.0, 0.0, 0.0, 0.0, 0.0]);
    }
    let (c, s) = (x / length, y / length);
    SVector::from([1.0, c, s, c * c - s * s, 2.0 * c * s])
}

/// The weighted sums of the least-squares fit of a mark.
#[derive(Clone, Copy, Default)]
pub struct Sums {
    /// Σ w·m·mᵀ over the modes m.
    pub square: SMatrix<f64, MODES, MODES>,
    /// Σ w·n·m over the noise n.
    pub product: SVector<f64, MODES>,
}

impl Sums {
    /// The coefficients of the modes; of marks that are not `compact` only the mean.
    #[must_use]
    pub fn solved(&self, compact: bool) -> SVector<f64, MODES> {
        let mean = || {
            let total = self.square[(0, 0)];
            let mean = if total > 0.0 { self.product[0] / total } else { 0.0 };
            SVector::from([mean, 0.0, 0.0, 0.0, 0.0])
        };
        if compact { self.square.cholesky().map_or_else(mean, |of| of.solve(&self.product)) } else { mean() }
    }
}

/// Removes from the noise, along the edge of the mark nearest to each cell, the components that would change the area of the mark,
/// move, stretch or rotate it, and the noise that would merge it with another one.
fn even(noise: &mut [f32], pattern: &Field, parts: &Parts, radius: &dyn Fn([f64; 2]) -> f64) {
    let grid = pattern.grid();
    let extent = Extent::from(grid.bounds_px());
    let inside: Vec<bool> = pattern.values.iter().map(|value| *value >= 0.5).collect();
    let Some(ways) = nearest(&inside, &grid) else { return };
    let owner = |cell: usize| grid.step(cell, ways[cell]).map_or(0, |(cell, _)| parts.mark_of(cell));
    let owners: Vec<u32> = (0..noise.len()).into_par_iter().map(owner).collect();
    // Centres as displacements from the first cell of each mark.
    let displacement = |mark: u32, cell: usize| {
        let (from, to) = (grid.center_px(mark as usize), grid.center_px(cell));
        extent.shortest([0, 1].map(|axis| to[axis] - from[axis]))
    };
    let mut centers = vec![([0.0f64; 2], 0.0f64); noise.len()];
    for (cell, owner) in owners.iter().enumerate().filter(|(cell, _)| inside[*cell]) {
        let ([x, y], count) = &mut centers[*owner as usize];
        let displacement = displacement(*owner, cell);
        (*x, *y, *count) = (*x + displacement[0], *y + displacement[1], *count + 1.0);
    }
    let from_center = |mark: u32, cell: usize| {
        let ([x, y], count) = centers[mark as usize];
        let displacement = displacement(mark, cell);
        [displacement[0] - x / count, displacement[1] - y / count]
    };
    let mut index = vec![0u32; noise.len()];
    let mut sums: Vec<(u32, Sums)> = Vec::new();
    for cell in 0..noise.len() {
        let owner = owners[cell];
        if inside[cell] && owner as usize == cell {
            index[cell] = sums.len() as u32;
            sums.push((owner, Sums::default()));
        }
    }
    for cell in 0..noise.len() {
        let p = f64::from(pattern.values[cell].clamp(0.0, 1.0));
        // Large at the edge and nearly 0 elsewhere.
        let weight = (4.0 * p * (1.0 - p)).powi(8);
        if weight < 1e-3 {
            continue;
        }
        let modes = modes(from_center(owners[cell], cell));
        let (_, of) = &mut sums[index[owners[cell] as usize] as usize];
        of.square += weight * modes * modes.transpose();
        of.product += weight * f64::from(noise[cell]) * modes;
    }
    let cell_area = grid.cell[0] * grid.cell[1];
    let found: Vec<SVector<f64, MODES>> = sums
        .iter()
        .map(|(mark, sums)| {
            let radius = radius(grid.center_px(*mark as usize));
            let area = centers[*mark as usize].1 * cell_area;
            sums.solved(area < COMPACT * std::f64::consts::PI * radius * radius)
        })
        .collect();
    let room = room(&owners, &ways, &grid);
    noise.par_iter_mut().enumerate().for_each(|(cell, noise)| {
        let owner = owners[cell];
        let taken = found[index[owner as usize] as usize].dot(&modes(from_center(owner, cell)));
        *noise -= taken as f32;
        if !inside[cell] && *noise > 0.0 {
            *noise *= room[cell];
        }
    });
}

/// 1 near the edges of marks; from halfway to the border between two marks it falls to 0, which it reaches at the border.
fn room(owners: &[u32], ways: &[[i32; 2]], grid: &Grid) -> Vec<f32> {
    let meets = |cell: usize| {
        let beside = |displacement| {
            grid.step(cell, displacement).is_some_and(|(beside, _)| owners[beside] != owners[cell])
        };
        [[1, 0], [0, 1], [-1, 0], [0, -1]].into_iter().any(beside)
    };
    let borders: Vec<bool> = (0..owners.len()).into_par_iter().map(meets).collect();
    let Some(to_border) = nearest(&borders, grid) else { return vec![1.0; owners.len()] };
    let share = |(displacement, border): (&[i32; 2], &[i32; 2])| {
        let [mark, border] = [displacement, border].map(|displacement| length(*displacement, grid));
        if mark + border > 0.0 { (2.0 * border / (mark + border)).min(1.0) as f32 } else { 0.0 }
    };
    ways.iter().zip(&to_border).map(share).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    /// 36 round spots of 20 px, 70 px apart.
    fn spots() -> Field {
        Field::from_fn([420, 420], [1.0, 1.0], Edges::Wrap, |at| {
            let [x, y] = at.map(|at| at.rem_euclid(70.0) - 35.0);
            (0.5 + (20.0 - libm::hypot(x, y)) / 24.0).clamp(0.0, 1.0) as f32
        })
    }

    /// Length of the level line ½, in steps between cells.
    fn contour(field: &Field) -> usize {
        let above = |x: usize, y: usize| field.get(x as isize, y as isize) > 0.5;
        let cells = (0..field.height).flat_map(|y| (0..field.width).map(move |x| (x, y)));
        cells
            .map(|(x, y)| {
                usize::from(above(x, y) != above(x + 1, y)) + usize::from(above(x, y) != above(x, y + 1))
            })
            .sum()
    }

    /// Number of marks in a field, and number of connected parts of the ground.
    fn counted(field: &Field) -> [usize; 2] {
        let turned =
            Field { values: field.values.iter().map(|value| 1.0 - value).collect(), ..field.clone() };
        [field, &turned].map(|field| Parts::new(field, &|_| 20.0).marks())
    }

    #[test]
    fn edges_get_longer_with_the_amount_while_the_area_stays() {
        let plain = spots();
        let roughening = Roughening::new(&plain, &|_| 20.0, 3);
        let lengths = [0.0, 0.08, 0.16].map(|amount| {
            let rough = roughening.by(&plain, &|_| 20.0, amount);
            assert!((share_above(&rough, 0.5) / share_above(&plain, 0.5) - 1.0).abs() < 5e-3);
            contour(&rough)
        });
        assert!(lengths[1] * 100 > lengths[0] * 101 && lengths[2] * 100 > lengths[0] * 106, "{lengths:?}");
    }

    #[test]
    fn no_fragments_and_no_holes_are_left() {
        let plain = spots();
        for seed in 1..5 {
            let rough = Roughening::new(&plain, &|_| 20.0, seed).by(&plain, &|_| 20.0, 0.4);
            assert!(contour(&rough) * 10 > contour(&plain) * 12);
            assert_eq!(counted(&rough), [36, 1], "seed {seed}");
        }
    }

    #[test]
    fn each_mark_keeps_its_own_area_nearly() {
        let plain = spots();
        let rough = Roughening::new(&plain, &|_| 20.0, 3).by(&plain, &|_| 20.0, 0.2);
        let area = |field: &Field, spot: [usize; 2]| {
            let cells = (0..70).flat_map(|y| (0..70).map(move |x| [x + 70 * spot[0], y + 70 * spot[1]]));
            cells.filter(|[x, y]| field.values[y * 420 + x] >= 0.5).count() as f64
        };
        for spot in (0..6).flat_map(|y| (0..6).map(move |x| [x, y])) {
            let change = area(&rough, spot) / area(&plain, spot) - 1.0;
            assert!(change.abs() < 0.2, "{spot:?}: {change}");
        }
    }

    #[test]
    fn places_far_from_edges_and_an_amount_of_0_change_nothing() {
        let plain = spots();
        let roughening = Roughening::new(&plain, &|_| 20.0, 3);
        assert_eq!(roughening.by(&plain, &|_| 20.0, 0.0), plain);
        assert_eq!(roughening.by(&plain, &|_| 20.0, 0.16).values[0], 0.0);
    }
}
