//! One stage of a row, a [`Vector`] of cells at a time: bit for bit what [`crate::rd::explicit`] computes.
//!
//! Intermediate results stay in registers. Only the offsets in use are evaluated: an offset of weight 0 would add exactly 0.

use std::ops::Range;

use crate::rd::coefficients::Numbers;
use crate::rd::diffusion::Diffusion;
use crate::rd::kinetics::{Kinetics, Spreading, stepped};
use crate::rd::plane::{LANES, Lanes, MARGIN, RowLayout};
use crate::rd::problem::Problem;
use crate::rd::runs::Run;
use crate::rd::selling::{OFFSETS, REACH};
use crate::rd::stencil_sets::{BITS, MIXED, UNIT, taps};
use crate::rd::super_step::Stage;
use crate::rd::vector::Vector;

/// Rows y − REACH ..= y + REACH of each chemical, margins included. The values of
/// those beyond a closed edge are not used.
pub type Window<'a, const N: usize> = [[&'a [f32]; 2 * REACH + 1]; N];

/// The coefficients of one row.
#[derive(Clone, Copy)]
struct Row<'a> {
    y: usize,
    grid: RowLayout,
    /// Weights of the isotropic stencil along x, along y, and of the cell itself.
    isotropic: [f32; 3],
    /// Weights of the first tensor.
    weights: Numbers<'a>,
    mobility: Numbers<'a>,
    rate: Numbers<'a>,
    /// The tensors; read for all but the first.
    tensors: &'a [Diffusion],
}

/// The coefficients of one group.
#[derive(Clone, Copy)]
struct Group {
    /// Its number.
    number: usize,
    /// The offsets that the first tensor uses, as bits; a weight for each.
    used: u32,
    weights: *const Lanes,
    /// Mobilities, [`MOBILITIES`](crate::rd::kinetics::MOBILITIES) of them.
    mobility: *const Lanes,
    /// The rate, one number a lane.
    rate: *const Lanes,
}

impl Row<'_> {
    /// # Safety
    /// The row must have that group.
    #[inline(always)]
    unsafe fn group(&self, group: usize) -> Group {
        // SAFETY: the caller guarantees that the group exists.
        unsafe {
            let (used, weights) = self.weights.first(group);
            let (mobility, rate) = (self.mobility.first(group).1, self.rate.first(group).1);
            Group { number: group, used, weights, mobility, rate }
        }
    }

    /// The offsets in use and the weights of a tensor in the group of these coefficients.
    ///
    /// # Safety
    /// The row of that tensor must have that group.
    #[inline(always)]
    unsafe fn stencil(&self, tensor: usize, coefficients: &Group) -> (u32, *const Lanes) {
        if tensor == 0 {
            return (coefficients.used, coefficients.weights);
        }
        // SAFETY: the caller guarantees that the group exists.
        unsafe { self.tensors[tensor].weights.in_row(self.y).first(coefficients.number) }
    }
}

/// The rows from which a row is stepped.
pub struct Source<'a, const N: usize> {
    /// The rows y − REACH ..= y + REACH.
    pub window: Window<'a, N>,
    /// The row before the last stage; not read in the first.
    pub before: [&'a [f32]; N],
}

/// Steps the cells of row `y` into `to`.
#[inline(always)]
pub fn step_row<const N: usize, K: Kinetics<N>, V: Vector>(
    problem: &Problem,
    (kinetics, stage): (&K, Stage),
    y: usize,
    from: &Source<N>,
    to: &mut [&mut [f32]; N],
) {
    let (grid, groups) = (problem.grid, problem.grid.inner());
    let row = Row {
        y,
        grid,
        isotropic: problem.isotropic_weights(),
        weights: problem.tensors[0].weights.in_row(y),
        mobility: problem.mobility.in_row(y),
        rate: problem.rate.in_row(y),
        tensors: &problem.tensors,
    };
    // The unchecked loads and stores below rely on this.
    let least = groups.end * LANES + REACH;
    assert!(groups.start * LANES >= REACH);
    for rows in &from.window {
        for read in rows {
            assert!(read.len() >= least);
        }
    }
    for read in &from.before {
        assert!(read.len() >= least);
    }
    for written in to.iter() {
        assert!(written.len() >= least);
    }
    for numbers in [row.weights, row.mobility, row.rate] {
        assert!(numbers.groups() >= groups.end);
    }
    if K::TENSORS > 1 {
        assert!(row.tensors.len() >= K::TENSORS);
        for tensor in row.tensors {
            assert!(tensor.weights.in_row(y).groups() >= groups.end);
        }
    }
    let step = (kinetics, stage);
    let mut first = groups.start;
    for run in problem.runs.in_row(y) {
        let part = first..groups.end.min(run.end as usize);
        if part.is_empty() {
            continue;
        }
        first = part.end;
        if const { K::TENSORS > 1 } {
            // Groups with different offsets: special code for one set of them would never run, and takes long to compile.
            if run.edge {
                step_groups::<N, K, V, MIXED, true>(row, step, from, to, part, run.same);
            } else {
                step_groups::<N, K, V, MIXED, false>(row, step, from, to, part, run.same);
            }
        } else {
            step_alike::<N, K, V>(row, step, from, to, part, run);
        }
        if first == groups.end {
            break;
        }
    }
}

/// Steps the groups of a run, whose cells use the same offsets of the only tensor.
#[inline(always)]
fn step_alike<const N: usize, K: Kinetics<N>, V: Vector>(
    row: Row,
    step: (&K, Stage),
    from: &Source<N>,
    to: &mut [&mut [f32]; N],
    part: Range<usize>,
    run: &Run,
) {
    let known = BITS.iter().position(|bits| *bits == run.used).unwrap_or(MIXED);
    let set = if run.unit { UNIT } else { known };
    macro_rules! step {
        ($($known:literal)*) => {
            match set {
                UNIT if run.edge => step_groups::<N, K, V, UNIT, true>(row, step, from, to, part, run.same),
                UNIT => step_groups::<N, K, V, UNIT, false>(row, step, from, to, part, run.same),
                0 if run.edge => step_groups::<N, K, V, 0, true>(row, step, from, to, part, run.same),
                _ if run.edge => step_groups::<N, K, V, MIXED, true>(row, step, from, to, part, run.same),
                $($known => step_groups::<N, K, V, $known, false>(row, step, from, to, part, run.same),)*
                _ => step_groups::<N, K, V, MIXED, false>(row, step, from, to, part, run.same),
            }
        };
    }
    step!(0 1 2 3 4 5 6 7 8 9 10 11);
}

/// Steps groups that use one set of offsets. `SET` is the index of this set in [`SETS`](crate::rd::stencil_sets::SETS), or
/// [`MIXED`] or [`UNIT`]. If `EDGE` is false, nothing beyond a closed edge is within reach. `same`: all groups have the
/// coefficients of the first.
#[inline(always)]
fn step_groups<const N: usize, K: Kinetics<N>, V: Vector, const SET: usize, const EDGE: bool>(
    row: Row,
    (kinetics, stage): (&K, Stage),
    from: &Source<N>,
    to: &mut [&mut [f32]; N],
    groups: Range<usize>,
    same: bool,
) {
    // Pointers, because a write through one slice would make the compiler reload the addresses of the others.
    let mut rows = [[std::ptr::null(); 2 * REACH + 1]; N];
    let (mut before, mut out) = ([std::ptr::null(); N], [std::ptr::null_mut(); N]);
    for i in 0..N {
        rows[i] = from.window[i].map(<[f32]>::as_ptr);
        before[i] = from.before[i].as_ptr();
        out[i] = to[i].as_mut_ptr();
    }
    let (first, weight) = (stage.is_first(), V::splat(stage.weight));
    // SAFETY: `step_row` made sure that the row has these groups.
    let mut coefficients = unsafe { row.group(groups.start) };
    for group in groups {
        if !same {
            // SAFETY: as above.
            coefficients = unsafe { row.group(group) };
        }
        for lane in (0..LANES).step_by(V::WIDTH) {
            let place = group * LANES + lane;
            // SAFETY: `step_row` made sure that the rows reach beyond the groups by the stencil's reach on both
            // sides; `Lanes` hold LANES numbers.
            unsafe {
                let mut u = [V::splat(0.0); N];
                for i in 0..N {
                    u[i] = V::load(rows[i][REACH].add(place));
                }
                let mut base = u;
                if !first {
                    for i in 0..N {
                        base[i] = u[i] + V::splat(stage.repeated) * (u[i] - V::load(before[i].add(place)));
                    }
                }
                let spread = spread::<N, K, V, SET, EDGE>(&row, &rows, place, &coefficients, &u);
                let [first, second] =
                    [number::<V>(coefficients.mobility, 0, lane), number(coefficients.mobility, 1, lane)];
                let mobility = [weight * first, weight * second];
                let rate = weight * number(coefficients.rate, 0, lane);
                let next = stepped::<N, K, V>(kinetics, [u, base], spread, mobility, rate);
                for i in 0..N {
                    next[i].store(out[i].add(place));
                }
            }
        }
    }
}

/// Number `k` of a group for the cells from `lane` on.
///
/// # Safety
/// The group must keep that many numbers, and `lane` + `V::WIDTH` must not go beyond [`LANES`].
#[inline(always)]
unsafe fn number<V: Vector>(packs: *const Lanes, k: usize, lane: usize) -> V {
    // SAFETY: the caller guarantees that this is within the group.
    unsafe { V::load(packs.add(k).cast::<f32>().add(lane)) }
}

/// The diffusion term of the cells at `place` and after, without mobility.
#[inline(always)]
unsafe fn spread<const N: usize, K: Kinetics<N>, V: Vector, const SET: usize, const EDGE: bool>(
    row: &Row,
    rows: &[[*const f32; 2 * REACH + 1]; N],
    place: usize,
    coefficients: &Group,
    u: &[V; N],
) -> [V; N] {
    let mut spread = [V::splat(0.0); N];
    let lane = place % LANES;
    // Macros and not closures: a closure that is not inlined is compiled for any processor, and there every vector instruction
    // becomes a function call.
    macro_rules! weight {
        ($k:literal) => {
            // SAFETY: no more numbers are read than the group stores.
            unsafe { number::<V>(coefficients.weights, $k, lane) }
        };
    }
    // 2 Σ wₖ, in the order of the offsets.
    let center = if SET < MIXED {
        let mut sum = weight!(0) + weight!(1);
        if taps(SET).1 > 2 {
            sum = sum + weight!(2);
        }
        if taps(SET).1 > 3 {
            sum = sum + weight!(3);
        }
        V::splat(2.0) * sum
    } else {
        V::splat(4.0)
    };
    for i in 0..N {
        macro_rules! pair {
            ($offset:expr) => {
                // SAFETY: as for `step_groups`, of which this is a part.
                unsafe { neighbours::<V, EDGE>(row, place, &rows[i], $offset, u[i]) }
            };
        }
        let (around, center) = match K::SPREAD[i] {
            Spreading::Still => continue,
            Spreading::Tensor { .. } if SET == UNIT => (pair!([1, 0]) + pair!([0, 1]), V::splat(4.0)),
            Spreading::Tensor { tensor, .. } if SET == MIXED => {
                let stencil = if K::TENSORS > 1 {
                    // SAFETY: `step_row` made sure that every tensor has the group.
                    unsafe { row.stencil(tensor, coefficients) }
                } else {
                    (coefficients.used, coefficients.weights)
                };
                // SAFETY: as for `step_groups`, of which this is a part.
                unsafe { mixed::<V, EDGE>(row, place, &rows[i], stencil, u[i]) }
            }
            Spreading::Tensor { .. } => {
                // Unrolled by hand, so that the offsets are constants.
                let (offset, taps) = const { taps(if SET < MIXED { SET } else { 0 }) };
                let mut sum = weight!(0) * pair!(offset[0]) + weight!(1) * pair!(offset[1]);
                if taps > 2 {
                    sum = sum + weight!(2) * pair!(offset[2]);
                }
                if taps > 3 {
                    sum = sum + weight!(3) * pair!(offset[3]);
                }
                (sum, center)
            }
            _ if row.isotropic == [1.0, 1.0, 4.0] => (pair!([1, 0]) + pair!([0, 1]), V::splat(4.0)),
            _ => {
                let [wx, wy, center] = row.isotropic;
                let [wx, wy, center] = [V::splat(wx), V::splat(wy), V::splat(center)];
                (wx * pair!([1, 0]) + wy * pair!([0, 1]), center)
            }
        };
        spread[i] = around - center * u[i];
    }
    spread
}

/// Σ wₖ (u(x + eₖ) + u(x − eₖ)) and 2 Σ wₖ over the offsets in use, which are given as bits, and their weights.
#[inline(always)]
unsafe fn mixed<V: Vector, const EDGE: bool>(
    row: &Row,
    place: usize,
    rows: &[*const f32; 2 * REACH + 1],
    (mut used, packs): (u32, *const Lanes),
    own: V,
) -> (V, V) {
    let (mut sum, mut weights, mut kept) = (V::splat(0.0), V::splat(0.0), 0);
    while used != 0 {
        let offset = OFFSETS[used.trailing_zeros() as usize];
        // SAFETY: no more numbers are read than the group stores; for the rest as for `step_groups`, of which this is a part.
        let (weight, pair) = unsafe {
            (number::<V>(packs, kept, place % LANES), neighbours::<V, EDGE>(row, place, rows, offset, own))
        };
        sum = sum + weight * pair;
        weights = weights + weight;
        kept += 1;
        used &= used - 1;
    }
    (sum, V::splat(2.0) * weights)
}

/// u(x + e) + u(x − e). A cell beyond a closed edge has the value of the cell itself, `own`.
#[inline(always)]
unsafe fn neighbours<V: Vector, const EDGE: bool>(
    row: &Row,
    place: usize,
    rows: &[*const f32; 2 * REACH + 1],
    [dx, dy]: [isize; 2],
    own: V,
) -> V {
    // SAFETY: as for `step_groups`, of which this is a part.
    let [mut there, mut back] = unsafe {
        [
            V::load(rows[REACH.wrapping_add_signed(dy)].add(place).offset(dx)),
            V::load(rows[REACH.wrapping_sub_signed(dy)].add(place).offset(-dx)),
        ]
    };
    if EDGE {
        there = keep_inside(row, place, [dx, dy], own, there);
        back = keep_inside(row, place, [-dx, -dy], own, back);
    }
    there + back
}

/// Replaces the concentrations `there`, at an offset (dx, dy) from the cells `own`, by the cells' own if they lie beyond the
/// border, so that nothing flows across it.
#[inline(always)]
fn keep_inside<V: Vector>(row: &Row, place: usize, [dx, dy]: [isize; 2], own: V, there: V) -> V {
    if !(0..row.grid.ny as isize).contains(&(row.y as isize + dy)) {
        return own;
    }
    // Columns in this range are exact in f32.
    // SAFETY: there are LANES columns, and `place % LANES + V::WIDTH` of them at most are asked for.
    let lane = unsafe { V::load(COLUMNS[place % LANES..].as_ptr()) };
    let first = (place - place % LANES) as isize - MARGIN as isize;
    let x = lane + V::splat((first + dx) as f32);
    let there = own.where_less(x, V::splat(0.0), there);
    own.where_less(V::splat(row.grid.nx as f32 - 1.0), x, there)
}

/// Columns of a group, from its first.
const COLUMNS: [f32; LANES] = {
    let mut columns = [0.0; LANES];
    let mut j = 0;
    while j < LANES {
        columns[j] = j as f32;
        j += 1;
    }
    columns
};
