//! The fast solver: slice by slice with vector instructions, multithreaded; bit for bit what [`super::plain`] computes.
//!
//! The sums of a row are added up in the order of its entries, and padding adds exactly 0.

use std::ops::Range;

use rayon::prelude::*;

use super::layout::layout;
use super::problem::SparseProblem;
use super::slices::ROWS;
use crate::rd::kinetics::{Kinetics, stepped};
use crate::rd::super_step::Stage;
#[cfg(target_arch = "x86_64")]
use crate::rd::vector::{Eight, Sixteen};
use crate::rd::vector::{Four, Pairs};
use crate::rd::wavefront::Instructions;

/// Fewest slices that are given to a thread: some 5 µs for each step.
const SLICES_A_PART: usize = 64;
/// Parts per thread: if one thread is interrupted, the others take over the remaining parts.
const PARTS_A_THREAD: usize = 3;

/// Takes one stage, with the bits of [`super::plain::step`]. Instructions that the machine lacks are replaced by the baseline.
pub fn step<const N: usize, K: Kinetics<N>>(
    problem: &SparseProblem,
    kinetics: &K,
    stage: Stage,
    old: &[Vec<[f32; 2]>],
    new: &mut [Vec<[f32; 2]>],
    instructions: Instructions,
) {
    let instructions = if instructions.there() { instructions } else { Instructions::Baseline };
    let slices = problem.rate.len() / ROWS;
    // The unchecked loads and stores below rely on this, and on columns that name rows alone: `SparseRows` looked each of them up.
    let layout = layout::<N, K>();
    let is_whole = |pairs: &Vec<[f32; 2]>| pairs.len() == slices * ROWS;
    assert!(old.len() == layout.count && new.len() == layout.count);
    assert!(old.iter().all(is_whole) && new.iter().all(is_whole));
    assert!(problem.mobility.iter().all(|mobility| mobility.len() == slices * ROWS));
    assert!(layout.operators.iter().flatten().all(|operator| *operator < problem.operators.slices.len()));
    assert!(problem.operators.slices.iter().all(|of| of.starts.len() == slices + 1));
    let part = slices.div_ceil(PARTS_A_THREAD * rayon::current_num_threads()).max(SLICES_A_PART);
    let mut parts: Vec<_> = new.iter_mut().map(|pairs| pairs.chunks_mut(part * ROWS)).collect();
    let mut tasks: Vec<Part<N, K>> = (0..slices.div_ceil(part))
        .map(|index| Part {
            problem,
            kinetics,
            stage,
            old,
            slices: index * part..slices.min((index + 1) * part),
            new: std::array::from_fn(|i| parts.get_mut(i).and_then(Iterator::next).unwrap_or_default()),
        })
        .collect();
    match &mut tasks[..] {
        [part] => part.run(instructions),
        parts => parts.par_iter_mut().for_each(|part| part.run(instructions)),
    }
}

/// Slices that one task steps.
struct Part<'a, const N: usize, K> {
    problem: &'a SparseProblem,
    kinetics: &'a K,
    stage: Stage,
    old: &'a [Vec<[f32; 2]>],
    slices: Range<usize>,
    /// The new concentrations, from the first of these slices on.
    new: [&'a mut [[f32; 2]]; N],
}

impl<const N: usize, K: Kinetics<N>> Part<'_, N, K> {
    fn run(&mut self, instructions: Instructions) {
        match instructions {
            Instructions::Baseline => self.step::<Four>(),
            #[cfg(target_arch = "x86_64")]
            // SAFETY: `step` made sure that the processor has them.
            Instructions::Avx2 => unsafe { self.step_avx2() },
            #[cfg(target_arch = "x86_64")]
            // SAFETY: `step` made sure that the processor has them.
            Instructions::Avx512 => unsafe { self.step_avx512() },
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn step_avx2(&mut self) {
        self.step::<Eight>();
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512vl")]
    fn step_avx512(&mut self) {
        self.step::<Sixteen>();
    }

    #[inline(always)]
    fn step<V: Pairs>(&mut self) {
        let mut old = [std::ptr::null(); N];
        let mut new = [std::ptr::null_mut(); N];
        for (i, (from, to)) in self.old.iter().zip(&mut self.new).enumerate() {
            (old[i], new[i]) = (from.as_ptr(), to.as_mut_ptr());
        }
        let first = self.slices.start * ROWS;
        for slice in self.slices.clone() {
            for lane in (0..ROWS).step_by(V::WIDTH) {
                let row = slice * ROWS + lane;
                // SAFETY: the function `step` made sure that all of `old` have these rows, and all of `new` those of these slices.
                unsafe {
                    let new = new.map(|new: *mut [f32; 2]| new.wrapping_add(row - first));
                    step_rows::<N, K, V>(
                        self.problem,
                        (self.kinetics, self.stage),
                        &old,
                        &new,
                        [slice, lane],
                    );
                }
            }
        }
    }
}

/// Steps the rows of a slice from `lane` on.
///
/// # Safety
/// `old` must have the rows of all slices, and `new` those that are stepped.
#[inline(always)]
unsafe fn step_rows<const N: usize, K: Kinetics<N>, V: Pairs>(
    problem: &SparseProblem,
    (kinetics, stage): (&K, Stage),
    old: &[*const [f32; 2]; N],
    new: &[*mut [f32; 2]; N],
    [slice, lane]: [usize; 2],
) {
    let layout = const { layout::<N, K>() };
    let row = slice * ROWS + lane;
    let zero = V::splat(0.0);
    let (mut u, mut from, mut spread) = ([zero; N], [zero; N], [zero; N]);
    for pair in 0..layout.count {
        // SAFETY: the caller guarantees that these rows are there.
        let own = unsafe { V::load_pairs(old[pair].add(row)) };
        let mut sums = [zero; 2];
        if let Some(operator) = layout.operators[pair] {
            for column in problem.operators.slices[operator].of(slice) {
                // SAFETY: a column has the numbers of all rows of a slice, and names rows that are there.
                unsafe {
                    let weight = V::load(column.weights.as_ptr().add(lane));
                    let there = V::gather_pairs(old[pair], column.at.as_ptr().add(lane));
                    sums[0] = sums[0] + weight * (there[0] - own[0]);
                    sums[1] = sums[1] + weight * (there[1] - own[1]);
                }
            }
        }
        let mut base = own;
        if !stage.is_first() {
            // SAFETY: the caller guarantees that these rows are there.
            let before = unsafe { V::load_pairs(new[pair]) };
            for i in 0..2 {
                base[i] = own[i] + V::splat(stage.repeated) * (own[i] - before[i]);
            }
        }
        for i in 0..2 {
            let chemical = layout.pairs[pair][i];
            if chemical < N {
                (u[chemical], from[chemical], spread[chemical]) = (own[i], base[i], sums[i]);
            }
        }
    }
    let weight = V::splat(stage.weight);
    // SAFETY: `step` made sure that there is a number for each row.
    let [first, second, rate] = unsafe {
        [&problem.mobility[0], &problem.mobility[1], &problem.rate]
            .map(|numbers| V::load(numbers.as_ptr().add(row)))
    };
    let next =
        stepped::<N, K, V>(kinetics, [u, from], spread, [weight * first, weight * second], weight * rate);
    for (to, [a, b]) in new.iter().zip(layout.pairs).take(layout.count) {
        // SAFETY: the caller guarantees that these rows are there.
        unsafe { V::store_pairs([next[a], if b < N { next[b] } else { zero }], *to) };
    }
}
