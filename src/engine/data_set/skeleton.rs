//! The skeleton of a mask: lines of one px in the middle of its parts.
//!
//! T. Y. Zhang & C. Y. Suen, "A fast parallel algorithm for thinning digital patterns", CACM 27 (1984).

use crate::grid::distance::nearest;
use crate::grid::{Edges, Grid};

/// A skeleton, and how thick the mask is about it. A border of samples that are off surrounds the canvas.
pub struct Skeleton {
    /// Samples of a row, with those of the border.
    pub width: usize,
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
        let width = side + 2;
        let mut skeleton = Self { width, on: vec![false; width * width], radius: vec![0.0; width * width] };
        for row in 0..side {
            let (from, to) = (row * side, (row + 1) * width + 1);
            skeleton.on[to..to + side].copy_from_slice(&mask[from..from + side]);
            let radius = skeleton.radius[to..to + side].iter_mut().zip(&offsets[from..from + side]);
            radius.for_each(|(radius, [x, y])| *radius = ((x * x + y * y) as f32).sqrt());
        }
        skeleton.thin();
        skeleton
    }

    /// The place of the middle of a sample on the canvas, samples.
    pub fn place(&self, index: usize) -> [f64; 2] {
        [index % self.width, index / self.width].map(|along| along as f64 - 0.5)
    }

    /// The sample at a place, or the nearest one of the canvas.
    pub fn at(&self, place: [f64; 2]) -> usize {
        let [x, y] = place.map(|along| (along.max(0.0) as usize).min(self.width - 3) + 1);
        y * self.width + x
    }

    /// The indices of the eight samples around one of the canvas, clockwise from the one above.
    fn beside(&self, index: usize) -> [usize; 8] {
        let (above, below) = (index - self.width, index + self.width);
        [above, above + 1, index + 1, below + 1, below, below - 1, index - 1, above - 1]
    }

    /// A bit for each of the eight samples around one, clockwise from the one above: whether it is on.
    fn around(&self, index: usize) -> u8 {
        let beside = self.beside(index).into_iter().enumerate();
        beside.fold(0, |bits, (bit, index)| bits | u8::from(self.on[index]) << bit)
    }

    /// The samples of the skeleton around one of it.
    pub fn neighbours(&self, index: usize) -> impl Iterator<Item = usize> + '_ {
        self.beside(index).into_iter().filter(|index| self.on[*index])
    }

    /// How many lines begin at a sample: changes from off to on around it.
    pub fn branches(&self, index: usize) -> u32 {
        lines(self.around(index))
    }

    fn thin(&mut self) {
        let removable = [false, true].map(|second| {
            let mut bits = 0..=u8::MAX;
            [(); 256].map(|()| bits.next().is_some_and(|bits| is_removed(bits, second)))
        });
        let edge = (0..self.on.len()).filter(|index| self.on[*index] && !self.is_inner(*index)).collect();
        // Around the samples that each of the last two passes has removed: any others stay, as they did two passes ago.
        let mut changed = [Vec::new(), edge];
        let mut seen = vec![0; self.on.len()];
        let mut pass = 0;
        while changed.iter().any(|samples| !samples.is_empty()) {
            let is_removed =
                |index: &usize| self.on[*index] && removable[pass % 2][usize::from(self.around(*index))];
            let removed: Vec<usize> = changed.iter().flatten().copied().filter(is_removed).collect();
            removed.iter().for_each(|index| self.on[*index] = false);
            pass += 1;
            let mut around = Vec::new();
            for index in removed.iter().flat_map(|index| self.neighbours(*index)) {
                if std::mem::replace(&mut seen[index], pass) != pass {
                    around.push(index);
                }
            }
            let [_, before] = changed;
            changed = [before, around];
        }
    }

    /// Whether the four samples beside a sample are on; no pass removes it then.
    fn is_inner(&self, index: usize) -> bool {
        self.around(index) & BESIDE == BESIDE
    }
}

/// The bits of the samples above, to the right, below and to the left.
const BESIDE: u8 = 0b0101_0101;

/// How many lines begin at a sample with these around it.
fn lines(around: u8) -> u32 {
    (!around & around.rotate_right(1)).count_ones()
}

/// Whether a pass removes a sample with these around it: bits 0 … 7 are P2 … P9 of the paper.
fn is_removed(around: u8, second: bool) -> bool {
    let [up, right, down, left] = [0, 2, 4, 6].map(|bit| around >> bit & 1 == 1);
    let sides = if second { !(up && left && (right || down)) } else { !(right && down && (up || left)) };
    (2..=6).contains(&around.count_ones()) && lines(around) == 1 && sides
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
        let on: Vec<usize> = (0..skeleton.on.len()).filter(|index| skeleton.on[*index]).collect();
        let middle = on.iter().filter(|index| skeleton.place(**index)[1] == 30.5).count();
        assert!((30..=42).contains(&middle) && on.len() < middle + 20, "{middle} of {}", on.len());
        assert_eq!(skeleton.radius[skeleton.at([30.5, 30.5])], 5.0);
    }
}
