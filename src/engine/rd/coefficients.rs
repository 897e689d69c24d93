//! Numbers of every cell that do not change during the growth, stored for [`LANES`] cells of a row together; equal neighbours share
//! them.

use rayon::prelude::*;

use super::plane::{LANES, Lanes, MARGIN, RowLayout};

/// `C` numbers of each cell.
#[derive(Clone, Debug)]
pub struct Coefficients<const C: usize> {
    groups: usize,
    /// By group, row by row: the set of stored numbers (bit k for number k), and the index of the first of them.
    at: Vec<(u32, u32)>,
    packs: Vec<Lanes>,
}

/// The numbers of the cells of one row.
#[derive(Clone, Copy)]
pub struct Numbers<'a> {
    at: &'a [(u32, u32)],
    packs: &'a [Lanes],
}

impl<'a> Numbers<'a> {
    /// Groups in the row.
    #[inline(always)]
    #[must_use]
    pub fn groups(&self) -> usize {
        self.at.len()
    }

    /// The stored numbers of group `group` as bits, and these in their order, followed by those of other groups.
    #[must_use]
    pub fn in_group(&self, group: usize) -> (u32, &'a [Lanes]) {
        let (used, first) = self.at[group];
        (used, &self.packs[first as usize..])
    }

    /// The stored numbers of group `group` as bits, and a pointer to the first of these, which the others follow.
    ///
    /// # Safety
    /// `group` must be below [`Self::groups`].
    #[inline(always)]
    #[must_use]
    pub unsafe fn first(&self, group: usize) -> (u32, *const Lanes) {
        // SAFETY: the caller guarantees that `group` is in range; the numbers of every group were stored before its index.
        unsafe {
            let (used, first) = *self.at.get_unchecked(group);
            (used, self.packs.as_ptr().add(first as usize))
        }
    }
}

/// Rows that are computed in parallel before they are joined.
const ROWS: usize = 64;

impl<const C: usize> Coefficients<C> {
    /// Computes the numbers of each cell by `of` from its `key` (of cell `y · nx + x`), once for neighbours with equal keys.
    pub fn new<K: Copy + PartialEq>(
        grid: RowLayout,
        key: impl Fn(usize) -> K + Sync,
        of: impl Fn(K) -> [f32; C] + Sync,
    ) -> Self {
        Self::by_row(grid, |y| Row::dense(grid, y, &key, &of))
    }

    /// The numbers that `row` writes for the groups of a row from left to right. It is given the cells of a group, and writes
    /// number k of each into `numbers[k]`, which still holds the numbers of the last group. It returns, as bits, which numbers it
    /// wrote; the others are 0.
    pub fn sparse<F: FnMut([usize; LANES], &mut [Lanes; C]) -> u32>(
        grid: RowLayout,
        row: impl Fn() -> F + Sync,
    ) -> Self {
        Self::by_row(grid, |y| Row::sparse(grid, y, row()))
    }

    fn by_row(grid: RowLayout, row: impl Fn(usize) -> Row + Sync) -> Self {
        let mut all = Self { groups: grid.groups(), at: Vec::new(), packs: Vec::new() };
        all.at.reserve_exact(grid.groups() * grid.ny);
        for first in (0..grid.ny).step_by(ROWS) {
            let rows: Vec<_> = (first..grid.ny.min(first + ROWS)).into_par_iter().map(&row).collect();
            if first == 0 {
                // An estimate that takes all rows to be like these; it saves most copies while the list grows.
                let numbers: usize = rows.iter().map(|row| row.packs.len()).sum();
                all.packs.reserve_exact(numbers * grid.ny / rows.len());
            }
            rows.into_iter().for_each(|row| all.push(&row));
        }
        all
    }

    /// These coefficients, after the numbers of each cell have been changed by `change`.
    #[must_use]
    pub fn with(&self, grid: RowLayout, change: impl Fn(usize, [f32; C]) -> [f32; C] + Sync) -> Self {
        let own = |cell: usize| self.cell(cell % grid.nx, cell / grid.nx);
        Self::new(grid, |cell| cell, |cell| change(cell, own(cell)))
    }

    fn push(&mut self, row: &Row) {
        let last = self.at.len().saturating_sub(self.groups);
        let (offset, above) = (self.packs.len() as u32, &self.at[last..]);
        let base = above.first().map_or(0, |(_, first)| *first);
        let same = above.len() == row.at.len()
            && self.packs[base as usize..] == row.packs[..]
            && above.iter().zip(&row.at).all(|(a, b)| *a == (b.0, b.1 + base));
        let from = if same { base } else { offset };
        self.at.extend(row.at.iter().map(|(used, first)| (*used, first + from)));
        if !same {
            self.packs.extend_from_slice(&row.packs);
        }
    }

    /// The stored numbers of group `group` of row `y` as bits, and these in their order.
    #[must_use]
    pub fn in_group(&self, group: usize, y: usize) -> (u32, &[Lanes]) {
        self.in_row(y).in_group(group)
    }

    /// The index of the numbers of a group; groups that share their numbers have equal indices.
    #[must_use]
    pub fn place(&self, group: usize, y: usize) -> u32 {
        self.at[y * self.groups + group].1
    }

    /// The numbers of row `y`.
    #[inline(always)]
    #[must_use]
    pub fn in_row(&self, y: usize) -> Numbers<'_> {
        Numbers { at: &self.at[y * self.groups..(y + 1) * self.groups], packs: &self.packs }
    }

    /// Writes the numbers of row `y`, margins included: number k of all cells from `rows[k · stride]` on. Numbers that no cell uses
    /// are left out. Returns the numbers that are used, as bits.
    pub fn row(&self, y: usize, rows: &mut [f32]) -> u32 {
        let stride = rows.len() / C;
        let row = self.in_row(y);
        let any = row.at.iter().fold(0, |any, (used, _)| any | used);
        for group in 0..self.groups {
            let (used, packs) = row.in_group(group);
            let mut kept = packs.iter();
            for k in (0..C).filter(|k| any & (1 << k) != 0) {
                let numbers = if used & (1 << k) == 0 { None } else { kept.next() };
                let place = k * stride + group * LANES;
                rows[place..place + LANES].copy_from_slice(&numbers.map_or([0.0; LANES], |lanes| lanes.0));
            }
        }
        any
    }

    /// Whether rows `y` and `other` have equal numbers.
    #[must_use]
    pub fn alike(&self, y: usize, other: usize) -> bool {
        self.in_row(y).at == self.in_row(other).at
    }

    /// The numbers of one cell.
    #[must_use]
    pub fn cell(&self, x: usize, y: usize) -> [f32; C] {
        let (used, packs) = self.in_group((MARGIN + x) / LANES, y);
        let mut kept = packs.iter();
        std::array::from_fn(|k| {
            if used & (1 << k) == 0 { 0.0 } else { kept.next().map_or(0.0, |lanes| lanes.0[x % LANES]) }
        })
    }

    /// The numbers in use, each set that neighbours share only once.
    pub fn groups_in_use(&self) -> impl Iterator<Item = (u32, &[Lanes])> {
        let mut before = None;
        self.at.iter().filter(move |at| before.replace(**at) != Some(**at)).map(|(used, first)| {
            let first = *first as usize;
            (*used, &self.packs[first..first + used.count_ones() as usize])
        })
    }
}

/// One row; indices count from its beginning.
struct Row {
    at: Vec<(u32, u32)>,
    packs: Vec<Lanes>,
}

impl Row {
    /// All numbers of every cell.
    fn dense<const C: usize, K: Copy + PartialEq>(
        grid: RowLayout,
        y: usize,
        key: &impl Fn(usize) -> K,
        of: &impl Fn(K) -> [f32; C],
    ) -> Self {
        let mut row = Self { at: Vec::with_capacity(grid.groups()), packs: Vec::new() };
        let used = u32::MAX >> (u32::BITS - C as u32);
        let mut known: Option<(K, [f32; C])> = None;
        for group in 0..grid.groups() {
            let mut packs = [Lanes([0.0; LANES]); C];
            for (j, cell) in grid.cells(group, y).into_iter().enumerate() {
                let key = key(cell);
                let numbers = known.filter(|(same, _)| *same == key).map_or_else(|| of(key), |known| known.1);
                known = Some((key, numbers));
                packs.iter_mut().zip(numbers).for_each(|(pack, number)| pack.0[j] = number);
            }
            match row.at.last() {
                // The numbers of the last group were the last to be stored, at the end of the list.
                Some(last) if row.packs[last.1 as usize..] == packs[..] => row.at.push(*last),
                _ => {
                    row.at.push((used, row.packs.len() as u32));
                    row.packs.extend_from_slice(&packs);
                }
            }
        }
        row
    }

    /// The numbers that `write` gives for each group.
    fn sparse<const C: usize>(
        grid: RowLayout,
        y: usize,
        mut write: impl FnMut([usize; LANES], &mut [Lanes; C]) -> u32,
    ) -> Self {
        let mut row = Self { at: Vec::with_capacity(grid.groups()), packs: Vec::new() };
        let mut numbers = [Lanes([0.0; LANES]); C];
        for group in 0..grid.groups() {
            let used = write(grid.cells(group, y), &mut numbers);
            let of_group = (0..C).filter(|k| used & (1 << k) != 0).map(|k| &numbers[k]);
            match row.at.last() {
                // The numbers of the last group were the last to be stored, at the end of the list.
                Some(last) if last.0 == used && row.packs[last.1 as usize..].iter().eq(of_group.clone()) => {
                    row.at.push(*last);
                }
                _ => {
                    row.at.push((used, row.packs.len() as u32));
                    row.packs.extend(of_group);
                }
            }
        }
        row
    }
}
