//! One step of [`LANES`] cells at once, so that the compiler uses vectors: bit for bit what [`super::explicit`]
//! computes.
//!
//! All that is computed stays in registers. Cells whose stencils use the same offsets pay for no others: an offset
//! of weight 0 would add exactly 0.

use std::ops::Range;

use super::coefficients::Numbers;
use super::kinetics::{Kinetics, Spread, euler};
use super::plane::{Grid, LANES, Lanes, MARGIN};
use super::problem::Problem;
use super::selling::{OFFSETS, REACH};
use super::vector::Vector;

/// Rows y − REACH ..= y + REACH of each chemical, margins included. Those beyond a closed edge are never read for
/// what they hold.
pub type Window<'a, const N: usize> = [[&'a [f32]; 2 * REACH + 1]; N];

/// The sets of [`OFFSETS`] that Selling's reduction ends with: the axes (isotropic diffusion and tensors along the
/// axes), with a diagonal, or with a knight's move between; then what groups use where one becomes the other. The
/// last offset of a shorter set is repeated.
const SETS: [[usize; 4]; 12] = [
    [0, 1, 1, 1],
    [0, 1, 2, 2],
    [0, 1, 3, 3],
    [0, 2, 4, 4],
    [1, 2, 5, 5],
    [0, 3, 6, 6],
    [1, 3, 7, 7],
    [0, 1, 2, 3],
    [0, 1, 2, 4],
    [0, 1, 2, 5],
    [0, 1, 3, 6],
    [0, 1, 3, 7],
];
/// Any other set: looked up while stepping.
const MIXED: usize = SETS.len();
/// The sets as bits.
const BITS: [u8; SETS.len()] = {
    let mut bits = [0; SETS.len()];
    let mut set = 0;
    while set < SETS.len() {
        let [a, b, c, d] = SETS[set];
        bits[set] = 1 << a | 1 << b | 1 << c | 1 << d;
        set += 1;
    }
    bits
};
/// The offsets of a set, and how many.
const fn taps(set: usize) -> ([[isize; 2]; 4], u32) {
    let [a, b, c, d] = SETS[set];
    ([OFFSETS[a], OFFSETS[b], OFFSETS[c], OFFSETS[d]], BITS[set].count_ones())
}

/// The weights that a group keeps, and which they are.
#[derive(Clone, Copy)]
struct Kept<'a> {
    used: u8,
    numbers: &'a [Lanes],
}

/// The coefficients of one row.
#[derive(Clone, Copy)]
struct Row<'a> {
    y: usize,
    grid: Grid,
    isotropic: [f32; 2],
    weights: Numbers<'a>,
    mobility: Numbers<'a>,
    rate: Numbers<'a>,
}

/// Steps the cells of row `y`, from the rows about it into `to`.
#[inline(always)]
pub fn step_row<const N: usize, K: Kinetics<N>, V: Vector>(
    problem: &Problem,
    y: usize,
    from: &Window<N>,
    to: &mut [&mut [f32]; N],
) {
    let (grid, groups) = (problem.grid, problem.grid.inner());
    let row = Row {
        y,
        grid,
        isotropic: problem.isotropic,
        weights: problem.diffusion.weights.in_row(y),
        mobility: problem.mobility.in_row(y),
        rate: problem.rate.in_row(y),
    };
    // What the unchecked loads and stores below rely on.
    let rows = from.iter().flatten().map(|row| row.len()).chain(to.iter().map(|row| row.len()));
    assert!(groups.start * LANES >= REACH && rows.min() >= Some(groups.end * LANES + REACH));
    let mut first = groups.start;
    for run in problem.diffusion.runs(y) {
        let part = first..groups.end.min(run.end as usize);
        if part.is_empty() {
            continue;
        }
        first = part.end;
        let set = BITS.iter().position(|bits| *bits == run.used).unwrap_or(MIXED);
        macro_rules! step {
            ($($known:literal)*) => {
                match set {
                    0 if run.edge => step_groups::<N, K, V, 0, true>(row, from, to, part),
                    _ if run.edge => step_groups::<N, K, V, MIXED, true>(row, from, to, part),
                    $($known => step_groups::<N, K, V, $known, false>(row, from, to, part),)*
                    _ => step_groups::<N, K, V, MIXED, false>(row, from, to, part),
                }
            };
        }
        step!(0 1 2 3 4 5 6 7 8 9 10 11);
        if first == groups.end {
            break;
        }
    }
}

/// Steps groups that use the same offsets. `SET`: these, by place in [`SETS`], or [`MIXED`]. Where `EDGE` is false,
/// nothing beyond a closed edge is within reach.
#[inline(always)]
fn step_groups<const N: usize, K: Kinetics<N>, V: Vector, const SET: usize, const EDGE: bool>(
    row: Row,
    from: &Window<N>,
    to: &mut [&mut [f32]; N],
    groups: Range<usize>,
) {
    for group in groups {
        let (used, weights) = row.weights.of(group);
        let weights = Kept { used, numbers: weights };
        let (mobility, rate) = (row.mobility.of(group).1, row.rate.of(group).1);
        for lane in (0..LANES).step_by(V::WIDTH) {
            let place = group * LANES + lane;
            // SAFETY: `step_row` made sure that the rows reach beyond the groups by the stencil's reach on both
            // sides; `Lanes` hold LANES numbers.
            unsafe {
                let mut u = [V::of(0.0); N];
                for i in 0..N {
                    u[i] = V::load(from[i][REACH], place);
                }
                let spread = spread::<N, K, V, SET, EDGE>(&row, from, place, weights, &u);
                let mobility = [V::load(&mobility[0].0, lane), V::load(&mobility[1].0, lane)];
                let next = euler::<N, K, V>(u, spread, mobility, V::load(&rate[0].0, lane));
                for i in 0..N {
                    next[i].store(to[i], place);
                }
            }
        }
    }
}

/// What diffusion alone would do to the cells at `place` and after, mobility left out.
#[inline(always)]
unsafe fn spread<const N: usize, K: Kinetics<N>, V: Vector, const SET: usize, const EDGE: bool>(
    row: &Row,
    from: &Window<N>,
    place: usize,
    weights: Kept,
    u: &[V; N],
) -> [V; N] {
    // SAFETY: as for `step_groups`, whose this is a part.
    unsafe {
        let mut spread = [V::of(0.0); N];
        let lane = place % LANES;
        let numbers = weights.numbers;
        if SET == MIXED {
            let offsets = OFFSETS.into_iter().enumerate().filter(|(k, _)| weights.used & (1 << k) != 0);
            for ((_, offset), weight) in offsets.zip(numbers) {
                add_pair::<N, K, V, EDGE>(row, place, from, offset, V::load(&weight.0, lane), u, &mut spread);
            }
        } else {
            // By hand: a loop is not always unrolled, and then its offsets are no constants.
            let (offset, taps) = const { taps(if SET == MIXED { 0 } else { SET }) };
            let weight = |k: usize| V::load(&numbers[k].0, lane);
            add_pair::<N, K, V, EDGE>(row, place, from, offset[0], weight(0), u, &mut spread);
            add_pair::<N, K, V, EDGE>(row, place, from, offset[1], weight(1), u, &mut spread);
            if taps > 2 {
                add_pair::<N, K, V, EDGE>(row, place, from, offset[2], weight(2), u, &mut spread);
            }
            if taps > 3 {
                add_pair::<N, K, V, EDGE>(row, place, from, offset[3], weight(3), u, &mut spread);
            }
        }
        for i in 0..N {
            if let Spread::Isotropic(_) = K::SPREAD[i] {
                let [wx, wy] = row.isotropic.map(V::of);
                let along = second_difference::<V, EDGE>(row, place, &from[i], [1, 0], u[i]);
                let down = second_difference::<V, EDGE>(row, place, &from[i], [0, 1], u[i]);
                spread[i] = wx * along + wy * down;
            }
        }
        spread
    }
}

/// Adds w (u(x + e) + u(x − e) − 2u(x)) to the spread of the chemicals that feel the tensor.
#[inline(always)]
unsafe fn add_pair<const N: usize, K: Kinetics<N>, V: Vector, const EDGE: bool>(
    row: &Row,
    place: usize,
    from: &Window<N>,
    offset: [isize; 2],
    weight: V,
    u: &[V; N],
    spread: &mut [V; N],
) {
    for i in 0..N {
        if let Spread::Tensor(_) = K::SPREAD[i] {
            // SAFETY: as for `step_groups`, whose this is a part.
            let difference = unsafe { second_difference::<V, EDGE>(row, place, &from[i], offset, u[i]) };
            spread[i] = spread[i] + weight * difference;
        }
    }
}

/// u(x + e) + u(x − e) − 2u(x). What lies beyond a closed edge counts as the cell's `own`.
#[inline(always)]
unsafe fn second_difference<V: Vector, const EDGE: bool>(
    row: &Row,
    place: usize,
    rows: &[&[f32]; 2 * REACH + 1],
    [dx, dy]: [isize; 2],
    own: V,
) -> V {
    // SAFETY: as for `step_groups`, whose this is a part.
    let [mut there, mut back] = unsafe {
        [
            V::load(rows[REACH.wrapping_add_signed(dy)], place.wrapping_add_signed(dx)),
            V::load(rows[REACH.wrapping_sub_signed(dy)], place.wrapping_sub_signed(dx)),
        ]
    };
    if EDGE {
        there = keep_inside(row, place, [dx, dy], own, there);
        back = keep_inside(row, place, [-dx, -dy], own, back);
    }
    there + back - V::of(2.0) * own
}

/// Of the concentrations `there`, at an offset (dx, dy) from the cells `own`, puts the cells' own in the place of
/// those beyond the border, so that nothing flows across it.
#[inline(always)]
fn keep_inside<V: Vector>(row: &Row, place: usize, [dx, dy]: [isize; 2], own: V, there: V) -> V {
    if !(0..row.grid.ny as isize).contains(&(row.y as isize + dy)) {
        return own;
    }
    // Columns that far from 0 are exact in f32.
    // SAFETY: there are LANES columns, and `place % LANES + V::WIDTH` of them at most are asked for.
    let lane = unsafe { V::load(&COLUMNS, place % LANES) };
    let first = (place - place % LANES) as isize - MARGIN as isize;
    let x = lane + V::of((first + dx) as f32);
    let there = own.where_less(x, V::of(0.0), there);
    own.where_less(V::of(row.grid.nx as f32 - 1.0), x, there)
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
