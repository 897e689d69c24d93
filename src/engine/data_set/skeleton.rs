//! The skeleton of a mask: lines of one px in the middle of its parts.
//!
//! T. Y. Zhang & C. Y. Suen, "A fast parallel algorithm for thinning digital patterns", CACM 27 (1984).

use crate::grid::distance::nearest;
use crate::grid::{Edges, Grid};

/// The eight neighbours, clockwise from the one above.
pub const AROUND: [[isize; 2]; 8] = [[0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1]];

/// A skeleton, and how thick the mask is about it.
pub struct Skeleton {
    /// Samples along each side.
    pub side: usize,
    /// Whether a sample is of the skeleton.
    pub on: Vec<bool>,
    /// Distance from each sample of the mask to the nearest one outside, samples.
    pub radius: Vec<f32>,
}

impl Skeleton {
    /// The skeleton of a square mask.
    pub fn new(mask: &[bool], side: usize) -> Self {
        let outside: Vec<bool> = mask.iter().map(|inside| !inside).collect();
        let grid = Grid::unit([side, side], Edges::Closed);
        let offsets = nearest(&outside, &grid).unwrap_or_else(|| vec![[side as i32, 0]; mask.len()]);
        let radius = offsets.iter().map(|[x, y]| ((x * x + y * y) as f32).sqrt()).collect();
        let mut skeleton = Self { side, on: mask.to_vec(), radius };
        skeleton.thin();
        skeleton
    }

    /// The samples around one that are on, clockwise; those beyond the border are off.
    pub fn around(&self, index: usize) -> [bool; 8] {
        let at = [index % self.side, index / self.side];
        AROUND.map(|step| {
            let to = [0, 1].map(|axis| at[axis].wrapping_add_signed(step[axis]));
            to[0] < self.side && to[1] < self.side && self.on[to[1] * self.side + to[0]]
        })
    }

    /// The samples of the skeleton around one of it.
    pub fn neighbours(&self, index: usize) -> impl Iterator<Item = usize> + '_ {
        let steps = self.around(index).into_iter().zip(AROUND).filter(|(on, _)| *on);
        steps.map(move |(_, [x, y])| index.wrapping_add_signed(y * self.side as isize + x))
    }

    /// How many lines begin at a sample: changes from off to on around it.
    pub fn branches(&self, index: usize) -> usize {
        let around = self.around(index);
        (0..8).filter(|k| !around[*k] && around[(k + 1) % 8]).count()
    }

    fn thin(&mut self) {
        let all: Vec<usize> = (0..self.on.len()).filter(|index| self.on[*index]).collect();
        // Around the samples that each of the last two passes has removed: any others stay, as they did two passes ago.
        let mut changed = [Vec::new(), all];
        let mut second = false;
        while changed.iter().any(|samples| !samples.is_empty()) {
            let near = changed.iter().flatten().copied();
            let removed: Vec<usize> =
                near.filter(|index| self.on[*index] && self.is_removed(*index, second)).collect();
            removed.iter().for_each(|index| self.on[*index] = false);
            let mut around: Vec<usize> = removed.iter().flat_map(|index| self.neighbours(*index)).collect();
            around.sort_unstable();
            around.dedup();
            let [_, before] = changed;
            changed = [before, around];
            second = !second;
        }
    }

    /// Whether the four samples beside a sample are on; no pass removes it then.
    fn is_inner(&self, index: usize) -> bool {
        let [x, y] = [index % self.side, index / self.side];
        let within = |along: usize| along > 0 && along + 1 < self.side;
        let beside = || [index - 1, index + 1, index - self.side, index + self.side];
        within(x) && within(y) && beside().iter().all(|other| self.on[*other])
    }

    /// Whether a pass removes a sample: P2 … P9 of the paper are its neighbours clockwise from above.
    fn is_removed(&self, index: usize, second: bool) -> bool {
        if self.is_inner(index) {
            return false;
        }
        let p = self.around(index);
        let count = p.iter().filter(|on| **on).count();
        let lines = (0..8).filter(|k| !p[*k] && p[(k + 1) % 8]).count();
        let [up, right, down, left] = [p[0], p[2], p[4], p[6]];
        let sides = if second { !(up && left && (right || down)) } else { !(right && down && (up || left)) };
        (2..=6).contains(&count) && lines == 1 && sides
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_skeleton_of_a_bar_is_its_middle_line() {
        let side = 60;
        let mask: Vec<bool> = (0..side * side)
            .map(|index| (10..50).contains(&(index % side)) && (26..35).contains(&(index / side)))
            .collect();
        let skeleton = Skeleton::new(&mask, side);
        let on: Vec<usize> = (0..side * side).filter(|index| skeleton.on[*index]).collect();
        let middle = on.iter().filter(|index| **index / side == 30).count();
        assert!((30..=42).contains(&middle) && on.len() < middle + 20, "{middle} of {}", on.len());
        assert_eq!(skeleton.radius[30 * side + 30], 5.0);
    }
}
