//! Heights over a canvas.

use crate::grid::Edges;

/// A picture of heights: 0 at black, 1 at white.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightField {
    size: [usize; 2],
    values: Vec<f32>,
}

impl HeightField {
    /// Heights of `size` px, row by row from the top; `None` if their number is wrong, or one is not finite.
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

    /// The heights at the centres of the parts of a grid of [columns, rows], each the mean over a part around it. There are at most
    /// as many parts as px along a side. A plane is not changed.
    #[must_use]
    pub fn averaged(&self, grid: [usize; 2]) -> Self {
        let grid = [0, 1].map(|axis| grid[axis].clamp(1, self.size[axis]));
        let [width, _] = self.size;
        let across = |row: usize| averaged_line(&|px| self.values[row * width + px], width, grid[0]);
        let rows: Vec<Vec<f32>> = (0..self.size[1]).map(across).collect();
        let mut values = vec![0.0; grid[0] * grid[1]];
        for column in 0..grid[0] {
            let down = averaged_line(&|px| rows[px][column], self.size[1], grid[1]);
            down.into_iter().enumerate().for_each(|(row, value)| values[row * grid[0] + column] = value);
        }
        Self { size: grid, values }
    }

    /// The slope along x and y at the px [column, row], per px: half the difference of both neighbours. Beyond a closed border the
    /// heights are extrapolated; beyond one that wraps they repeat.
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

/// The values of a line of `count` px at the centres of `parts` parts. Between px they are linear; each px is the mean of the px
/// within half a part on either side, fewer at the ends.
fn averaged_line(value: &dyn Fn(usize) -> f32, count: usize, parts: usize) -> Vec<f32> {
    let part = count as f64 / parts as f64;
    let mean = |px: usize| {
        let reach = (0.5 * part) as usize;
        let reach = reach.min(px).min(count - 1 - px);
        let sum: f64 = (px - reach..=px + reach).map(|px| f64::from(value(px))).sum();
        sum / (2 * reach + 1) as f64
    };
    let at = |index: usize| {
        let centre = ((index as f64 + 0.5) * part - 0.5).clamp(0.0, (count - 1) as f64);
        let (low, share) = (centre as usize, centre.fract());
        let high = (low + 1).min(count - 1);
        ((1.0 - share) * mean(low) + share * mean(high)) as f32
    };
    (0..parts).map(at).collect()
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
    fn parts_have_the_means_about_their_centres_and_a_plane_stays_a_plane() {
        let field = HeightField::new([4, 2], vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]).expect("eight px");
        assert_eq!(field.averaged([2, 1]).values, [2.5, 4.5]);
        let ramp = HeightField::new([240, 1], (0..240).map(|px| px as f32).collect()).expect("240 px");
        for parts in [7, 64, 128, 200] {
            let found = ramp.averaged([parts, 1]);
            let wanted = 240.0 / parts as f64;
            for place in 0..parts {
                let [rise, _] = found.rise([place, 0], Edges::Closed);
                assert!((rise / wanted - 1.0).abs() < 1e-4, "{parts} {place}: {rise}");
            }
        }
        assert_eq!(field.averaged([9, 9]), field);
    }

    #[test]
    fn heights_that_are_not_finite_or_of_a_wrong_number_are_refused() {
        assert!(HeightField::new([2, 1], vec![0.0, f32::NAN]).is_none());
        assert!(HeightField::new([2, 2], vec![0.0; 3]).is_none());
        assert!(HeightField::new([0, 2], Vec::new()).is_none());
    }
}
