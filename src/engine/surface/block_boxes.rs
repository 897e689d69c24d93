//! Bounding boxes of consecutive vertices, to test quickly whether all of a range are far away.

use std::ops::Range;

use super::vector::Vector;

/// Vertices of a box. Not tuned.
const BLOCK: usize = 256;

/// The box of each block of vertices.
#[derive(Clone, Debug)]
pub struct BlockBoxes {
    boxes: Vec<[Vector; 2]>,
}

impl BlockBoxes {
    pub fn new(positions: &[Vector]) -> Self {
        let bounds = |block: &[Vector]| {
            let first = [block[0]; 2];
            block.iter().fold(first, |[low, high], at| {
                [
                    [0, 1, 2].map(|axis| low[axis].min(at[axis])),
                    [0, 1, 2].map(|axis| high[axis].max(at[axis])),
                ]
            })
        };
        Self { boxes: positions.chunks(BLOCK).map(bounds).collect() }
    }

    /// Whether some vertices of a range may lie within `reach` of a point: a path along a surface is at least as long as the
    /// straight line.
    pub fn may_reach(&self, point: Vector, reach: f64, among: &Range<usize>) -> bool {
        let blocks = among.start / BLOCK..among.end.div_ceil(BLOCK).min(self.boxes.len());
        let square = |[low, high]: &[Vector; 2]| {
            let off = |axis: usize| (low[axis] - point[axis]).max(point[axis] - high[axis]).max(0.0);
            (0..3).map(|axis| off(axis) * off(axis)).sum::<f64>()
        };
        // A margin for the rounding of lengths.
        self.boxes[blocks].iter().any(|bounds| square(bounds) <= reach * reach * (1.0 + 1e-9))
    }
}
