//! Heights over a canvas.

use crate::grid::Edges;

/// A picture of heights: 0 at black, 1 at white.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightField {
    size: [usize; 2],
    values: Vec<f32>,
}

impl HeightField {
    /// Heights of `size` px, row by row from the top; `None` where their number does not fit, or one is not finite.
    #[must_use]
    pub fn new(size: [usize; 2], values: Vec<f32>) -> Option<Self> {
        let fits = size[0] * size[1] == values.len() && !values.is_empty();
        (fits && values.iter().all(|value| value.is_finite())).then_some(Self { size, values })
    }

    /// Columns and rows, px.
    #[must_use]
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// The mean heights of the parts of a grid of [columns, rows], row by row. There are as many parts as px along a side, at most.
    #[must_use]
    pub fn averaged(&self, grid: [usize; 2]) -> Self {
        let grid = [0, 1].map(|axis| grid[axis].clamp(1, self.size[axis]));
        // The px of each part with the share of them that lies in it: parts are alike although px do not divide evenly.
        let part = |axis: usize, index: usize| {
            let [from, to] = [index, index + 1].map(|end| (end * self.size[axis]) as f64 / grid[axis] as f64);
            let share = move |px: usize| (px, (to.min(px as f64 + 1.0) - from.max(px as f64)).max(0.0));
            (from as usize..self.size[axis].min(to.ceil() as usize)).map(share)
        };
        let mean = |index: usize| {
            let (mut sum, mut weights) = (0.0, 0.0);
            for (row, high) in part(1, index / grid[0]) {
                for (column, wide) in part(0, index % grid[0]) {
                    sum += high * wide * f64::from(self.values[row * self.size[0] + column]);
                    weights += high * wide;
                }
            }
            (sum / weights) as f32
        };
        Self { size: grid, values: (0..grid[0] * grid[1]).map(mean).collect() }
    }

    /// By how much it rises from one px to the next along x and y, at the px [column, row]: half the difference of both neighbours. Beyond a
    /// closed border it goes on as before; beyond one that wraps it begins again.
    #[must_use]
    pub fn rise(&self, place: [usize; 2], edges: Edges) -> [f64; 2] {
        [0, 1].map(|axis| {
            let (at, count) = (place[axis], self.size[axis]);
            let (before, after) = match edges {
                Edges::Wrap => ((at + count - 1) % count, (at + 1) % count),
                Edges::Closed => (at.saturating_sub(1), (at + 1).min(count - 1)),
            };
            let apart = if edges == Edges::Wrap { 2 } else { after - before };
            let value = |along: usize| {
                let [column, row] = if axis == 0 { [along, place[1]] } else { [place[0], along] };
                f64::from(self.values[row * self.size[0] + column])
            };
            if apart == 0 { 0.0 } else { (value(after) - value(before)) / apart as f64 }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_rises_alike_everywhere_up_to_its_borders() {
        let values = (0..12).map(|i| (0.5 * f64::from(i % 4) - 0.25 * f64::from(i / 4)) as f32).collect();
        let plane = HeightField::new([4, 3], values).expect("twelve px");
        for place in [[0, 0], [1, 1], [3, 2]] {
            assert_eq!(plane.rise(place, Edges::Closed), [0.5, -0.25], "{place:?}");
        }
        assert_eq!(plane.rise([3, 0], Edges::Wrap), [-0.5, 0.125]);
    }

    #[test]
    fn parts_have_the_means_of_their_px() {
        let field = HeightField::new([4, 2], vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]).expect("eight px");
        assert_eq!(field.averaged([2, 1]).values, [2.5, 4.5]);
        assert_eq!(field.averaged([9, 9]), field);
    }

    #[test]
    fn heights_that_are_no_numbers_or_do_not_fit_are_none() {
        assert!(HeightField::new([2, 1], vec![0.0, f32::NAN]).is_none());
        assert!(HeightField::new([2, 2], vec![0.0; 3]).is_none());
        assert!(HeightField::new([0, 2], Vec::new()).is_none());
    }
}
