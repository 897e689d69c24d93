//! The fast solver: the same step, 16 cells of a row at a time, so that the compiler uses vectors, over all
//! threads; bit for bit what [`super::explicit`] computes, on any number of threads and any instruction set.
//!
//! A segment of 64 cells pays only for the stencil offsets that some cell of it uses: an offset of
//! weight 0 would add exactly 0.

use rayon::prelude::*;

use super::diffusion::SEGMENT;
use super::kinetics::{Kinetics, Spread, euler};
use super::plane::{Plane, fill_row_margin};
use super::problem::Problem;
use super::selling::{OFFSETS, REACH};
use crate::field::Edges;

/// Cells stepped at once: one vector of AVX-512, two of AVX2.
const LANES: usize = 16;

/// Rows that one task steps: enough work (some 10 µs) to outweigh handing it out.
const CELLS_A_TASK: usize = 16_384;

/// Steps the chemicals once, from `old` into `new` (whose contents do not matter).
pub fn step<const N: usize, K: Kinetics<N>>(problem: &Problem, old: &[Plane; N], new: &mut [Plane; N]) {
    let stride = old[0].stride();
    let rows_a_task = (CELLS_A_TASK / problem.nx).max(1);
    let inside = REACH * stride..(REACH + problem.ny) * stride;
    let mut tasks: Vec<[&mut [f32]; N]> = Vec::new();
    let mut bands = new.each_mut().map(|plane| plane.values[inside.clone()].chunks_mut(rows_a_task * stride));
    for _ in 0..problem.ny.div_ceil(rows_a_task) {
        tasks.push(bands.each_mut().map(|band| band.next().unwrap_or_default()));
    }
    let run = |(task, band): (usize, &mut [&mut [f32]; N])| {
        step_band::<N, K>(problem, old, task * rows_a_task, band);
    };
    if tasks.len() == 1 {
        tasks.iter_mut().enumerate().for_each(run);
    } else {
        tasks.par_iter_mut().enumerate().for_each(run);
    }
    for plane in new {
        plane.fill_margin_rows(problem.edges);
    }
}

/// Steps the rows from `y0` on that `band` holds, with the widest vectors this machine has.
fn step_band<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    old: &[Plane; N],
    y0: usize,
    band: &mut [&mut [f32]; N],
) {
    #[cfg(target_arch = "x86_64")]
    {
        if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl") {
            // SAFETY: the processor has what the function was compiled for.
            return unsafe { step_band_avx512::<N, K>(problem, old, y0, band) };
        }
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has what the function was compiled for.
            return unsafe { step_band_avx2::<N, K>(problem, old, y0, band) };
        }
    }
    step_band_here::<N, K>(problem, old, y0, band);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl")]
fn step_band_avx512<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    old: &[Plane; N],
    y0: usize,
    band: &mut [&mut [f32]; N],
) {
    step_band_here::<N, K>(problem, old, y0, band);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn step_band_avx2<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    old: &[Plane; N],
    y0: usize,
    band: &mut [&mut [f32]; N],
) {
    step_band_here::<N, K>(problem, old, y0, band);
}

#[inline(always)]
fn step_band_here<const N: usize, K: Kinetics<N>>(
    problem: &Problem,
    old: &[Plane; N],
    y0: usize,
    band: &mut [&mut [f32]; N],
) {
    let stride = old[0].stride();
    let nx = problem.nx;
    for y in y0..y0 + band[0].len() / stride {
        let row = (y - y0) * stride;
        let closed = problem.edges == Edges::Closed;
        let at_edge = closed && (y < REACH || y + REACH >= problem.ny);
        if nx < LANES {
            for x in 0..nx {
                step_lanes::<N, K, 1, true>(problem, old, [x, y], band, row);
            }
        } else {
            // The last lanes step some cells for a second time: the same numbers come out.
            for x in (0..nx - LANES).step_by(LANES).chain([nx - LANES]) {
                if at_edge || closed && (x < REACH || x + LANES + REACH > nx) {
                    step_lanes::<N, K, LANES, true>(problem, old, [x, y], band, row);
                } else {
                    step_lanes::<N, K, LANES, false>(problem, old, [x, y], band, row);
                }
            }
        }
        for b in band.iter_mut() {
            fill_row_margin(&mut b[row..row + stride], problem.edges);
        }
    }
}

/// Steps `L` cells from (x, y) on. All that is computed stays in registers. Where `EDGE` is false, nothing beyond a
/// closed edge is within reach.
#[inline(always)]
fn step_lanes<const N: usize, K: Kinetics<N>, const L: usize, const EDGE: bool>(
    problem: &Problem,
    old: &[Plane; N],
    [x, y]: [usize; 2],
    band: &mut [&mut [f32]; N],
    row: usize,
) {
    let here = old[0].at(x, y);
    let cell = y * problem.nx + x;
    let mut u = [[0.0; L]; N];
    for i in 0..N {
        u[i] = load(&old[i].values, here);
    }
    let mut spread = [[0.0; L]; N];
    let used = problem.diffusion.used(x / SEGMENT, y) | problem.diffusion.used((x + L - 1) / SEGMENT, y);
    let stride = old[0].stride() as isize;
    for (k, [dx, dy]) in OFFSETS.into_iter().enumerate() {
        if used & (1 << k) == 0 {
            continue;
        }
        let weight: [f32; L] = load(&problem.diffusion.weights[k], cell);
        let e = dy * stride + dx;
        for i in 0..N {
            if let Spread::Tensor(_) = K::SPREAD[i] {
                let mut there: [f32; L] = load(&old[i].values, here.wrapping_add_signed(e));
                let mut back: [f32; L] = load(&old[i].values, here.wrapping_add_signed(-e));
                if EDGE && problem.edges == Edges::Closed {
                    keep_inside(problem, [x, y], [dx, dy], &u[i], &mut there);
                    keep_inside(problem, [x, y], [-dx, -dy], &u[i], &mut back);
                }
                for j in 0..L {
                    spread[i][j] += weight[j] * (there[j] + back[j] - 2.0 * u[i][j]);
                }
            }
        }
    }
    for i in 0..N {
        if let Spread::Isotropic(_) = K::SPREAD[i] {
            spread[i] = isotropic(problem, &old[i].values, here, stride as usize, &u[i]);
        }
    }
    let mobility: [[f32; L]; 2] = [load(&problem.mobility[0], cell), load(&problem.mobility[1], cell)];
    let rate: [f32; L] = load(&problem.rate, cell);
    let mut next = [[0.0; L]; N];
    for j in 0..L {
        let (mut at, mut laplacian) = ([0.0; N], [0.0; N]);
        for i in 0..N {
            at[i] = u[i][j];
            laplacian[i] = spread[i][j];
        }
        let stepped = euler::<N, K>(at, laplacian, [mobility[0][j], mobility[1][j]], rate[j]);
        for i in 0..N {
            next[i][j] = stepped[i];
        }
    }
    for i in 0..N {
        band[i][row + REACH + x..][..L].copy_from_slice(&next[i]);
    }
}

/// Of the concentrations `there`, at an offset (dx, dy) from the cells `own` that begin at (x, y), puts the cells'
/// own in the place of those beyond the border, so that nothing flows across it.
fn keep_inside<const L: usize>(
    problem: &Problem,
    [x, y]: [usize; 2],
    [dx, dy]: [isize; 2],
    own: &[f32; L],
    there: &mut [f32; L],
) {
    let beyond = y.checked_add_signed(dy).is_none_or(|y| y >= problem.ny);
    for j in 0..L {
        if beyond || (x + j).checked_add_signed(dx).is_none_or(|x| x >= problem.nx) {
            there[j] = own[j];
        }
    }
}

#[inline(always)]
fn isotropic<const L: usize>(
    problem: &Problem,
    u: &[f32],
    here: usize,
    stride: usize,
    center: &[f32; L],
) -> [f32; L] {
    let (east, west): ([f32; L], [f32; L]) = (load(u, here + 1), load(u, here - 1));
    let (south, north): ([f32; L], [f32; L]) = (load(u, here + stride), load(u, here - stride));
    let [wx, wy] = problem.isotropic;
    let mut sum = [0.0; L];
    for j in 0..L {
        let twice = 2.0 * center[j];
        sum[j] = wx * (east[j] + west[j] - twice) + wy * (south[j] + north[j] - twice);
    }
    sum
}

/// `L` values from index `from` on.
#[inline(always)]
fn load<const L: usize>(values: &[f32], from: usize) -> [f32; L] {
    let mut lanes = [0.0; L];
    lanes.copy_from_slice(&values[from..from + L]);
    lanes
}

#[cfg(test)]
mod tests {
    use super::super::diffusion::Diffusion;
    use super::super::explicit;
    use super::super::meinhardt_spots::MeinhardtSpots;
    use super::super::meinhardt_stripes::MeinhardtStripes;
    use super::super::selling::Tensor;
    use super::super::turing_spots::TuringSpots;
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// Coefficients that differ from cell to cell.
    fn uneven(nx: usize, ny: usize, edges: Edges) -> Problem {
        let wave = |i: usize, f: f64| 0.5 + 0.5 * libm::sin(f * i as f64);
        let tensor = |i: usize| {
            let stretch = 0.3 + 0.7 * wave(i, 0.013);
            Tensor::oriented(1.0 / stretch, stretch, 180.0 * wave(i, 0.007))
        };
        let plane = |low: f64, high: f64, f: f64| {
            (0..nx * ny).map(|i| (low + (high - low) * wave(i, f)) as f32).collect::<Vec<_>>()
        };
        Problem {
            nx,
            ny,
            edges,
            diffusion: Diffusion::new(nx, ny, tensor),
            isotropic: [1.02, 0.98],
            mobility: [plane(0.001, 0.004, 0.1), plane(0.05, 0.09, 0.2)],
            rate: plane(0.01, 0.05, 0.03),
        }
    }

    fn agree<const N: usize, K: Kinetics<N>>(nx: usize, ny: usize, edges: Edges) {
        let problem = uneven(nx, ny, edges);
        let mut rng = Pcg64Mcg::seed_from_u64((nx * 1000 + ny) as u64);
        let mut plain: [Plane; N] = std::array::from_fn(|_| {
            let cells: Vec<f32> = (0..nx * ny).map(|_| 0.2 + rng.random::<f32>()).collect();
            Plane::from_cells(nx, ny, &cells, edges).expect("as many cells as the grid has")
        });
        let mut fast = [plain.clone(), plain.clone()];
        for _ in 0..5 {
            explicit::step::<N, K>(&problem, &mut plain);
            let [old, new] = &mut fast;
            step::<N, K>(&problem, old, new);
            fast.swap(0, 1);
        }
        let bits = |planes: &[Plane; N]| -> Vec<u32> {
            planes.iter().flat_map(|p| p.values.iter().map(|v| v.to_bits())).collect()
        };
        assert!(bits(&plain) == bits(&fast[0]), "{nx}×{ny} {edges:?}");
    }

    #[test]
    fn fast_and_plain_steps_agree_bit_for_bit() {
        for edges in [Edges::Closed, Edges::Wrap] {
            for (nx, ny) in [(1, 1), (3, 2), (64, 9), (65, 33), (127, 300), (200, 130)] {
                agree::<2, TuringSpots>(nx, ny, edges);
                agree::<2, MeinhardtSpots>(nx, ny, edges);
                agree::<5, MeinhardtStripes>(nx, ny, edges);
            }
        }
    }
}
