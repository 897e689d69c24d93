//! Which of many boxes are near a place: the boxes that meet each tile of the canvas.

/// Tiles at most along a side: a million empty lists take 24 MB.
const MOST: f64 = 1024.0;
/// Tiles at most along a side of a mean box: many large boxes would otherwise fill the lists of all tiles.
const IN_A_BOX: f64 = 8.0;

/// Boxes, entered at the tiles that they meet. Places beyond a border that does not wrap count as the nearest ones on it.
#[derive(Clone, Debug)]
pub struct BoxTiles {
    size: [f64; 2],
    wrap: [bool; 2],
    /// Columns and rows of tiles.
    grid: [usize; 2],
    /// By tile, the boxes that meet it, ascending.
    boxes: Vec<Vec<u32>>,
}

impl BoxTiles {
    /// Tiles of about `side`, larger where the boxes are, on a canvas of this `size`, all in one unit, with the boxes between
    /// these low and high corners. Along an axis that wraps every image of a box counts.
    #[must_use]
    pub fn new(
        size: [f64; 2],
        wrap: [bool; 2],
        side: f64,
        boxes: impl Iterator<Item = [[f64; 2]; 2]>,
    ) -> Self {
        let boxes: Vec<[[f64; 2]; 2]> = boxes.collect();
        let longer = boxes.iter().map(|[low, high]| (high[0] - low[0]).max(high[1] - low[1]));
        let mean = longer.sum::<f64>() / boxes.len().max(1) as f64;
        let side = side.max(mean / IN_A_BOX);
        let grid = size.map(|length| (length / side).clamp(1.0, MOST) as usize);
        let mut tiles = Self { size, wrap, grid, boxes: vec![Vec::new(); grid[0] * grid[1]] };
        for (index, [low, high]) in boxes.into_iter().enumerate() {
            let columns: Vec<usize> = tiles.span(0, low, high).collect();
            for row in tiles.span(1, low, high) {
                for column in &columns {
                    tiles.boxes[row * grid[0] + column].push(index as u32);
                }
            }
        }
        tiles
    }

    /// The boxes that may hold a place, ascending.
    #[must_use]
    pub fn holding(&self, at: [f64; 2]) -> &[u32] {
        let [column, row] = [0, 1].map(|axis| {
            let at = if self.wrap[axis] { at[axis].rem_euclid(self.size[axis]) } else { at[axis] };
            self.clamped(axis, self.tile(axis, at))
        });
        &self.boxes[row * self.grid[0] + column]
    }

    /// Calls `each` with all boxes that come within `reach` of a place along both axes, and perhaps with others; with some of
    /// them several times.
    pub fn each_near(&self, at: [f64; 2], reach: f64, mut each: impl FnMut(u32)) {
        let [low, high] = [-reach, reach].map(|by| at.map(|at| at + by));
        for row in self.span(1, low, high) {
            for column in self.span(0, low, high) {
                self.boxes[row * self.grid[0] + column].iter().for_each(|index| each(*index));
            }
        }
    }

    /// The number of the tile of a coordinate, also beyond the canvas.
    fn tile(&self, axis: usize, at: f64) -> isize {
        // The cast takes what is too large to the bound.
        (at * self.grid[axis] as f64 / self.size[axis]).floor() as isize
    }

    fn clamped(&self, axis: usize, tile: isize) -> usize {
        tile.clamp(0, self.grid[axis] as isize - 1) as usize
    }

    /// The columns (`axis` 0) or rows (1) of tiles between two corners, each once.
    fn span(&self, axis: usize, low: [f64; 2], high: [f64; 2]) -> impl Iterator<Item = usize> + use<> {
        // A hair more, for the rounding of images.
        let hair = 1e-9 * self.size[axis];
        let (first, last) = (self.tile(axis, low[axis] - hair), self.tile(axis, high[axis] + hair));
        let count = self.grid[axis] as isize;
        let (first, last) = match self.wrap[axis] {
            true if last.saturating_sub(first) >= count => (0, count - 1),
            true => (first, last),
            false => (first.clamp(0, count - 1), last.clamp(0, count - 1)),
        };
        (first..=last).map(move |tile| tile.rem_euclid(count) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether an image of the box holds the place; beyond a border that does not wrap the nearest place on it counts.
    fn holds([low, high]: [[f64; 2]; 2], at: [f64; 2], size: [f64; 2], wrap: [bool; 2]) -> bool {
        (0..2).all(|axis| {
            let images = if wrap[axis] { -4..=4 } else { 0..=0 };
            images
                .map(|image| at[axis] + f64::from(image) * size[axis])
                .any(|at| (low[axis]..=high[axis]).contains(&at))
        })
    }

    #[test]
    fn no_box_that_holds_a_place_or_comes_near_it_is_missed() {
        let size = [70.0, 50.0];
        let number = |i: usize, step: f64| (0.5 + step * i as f64).fract();
        let boxes: Vec<[[f64; 2]; 2]> = (0..80)
            .map(|i| {
                let low = [110.0 * number(i, 0.754_877_7) - 30.0, 90.0 * number(i, 0.569_840_3) - 20.0];
                let long = if i % 20 == 0 { 90.0 } else { 8.0 };
                [low, [low[0] + long * number(i, 0.31), low[1] + long * number(i, 0.87)]]
            })
            .collect();
        for wrap in [[false; 2], [true; 2], [true, false]] {
            let tiles = BoxTiles::new(size, wrap, 9.0, boxes.iter().copied());
            let mut met = 0;
            for i in 0..300 {
                let at = [120.0 * number(i, 0.618_034) - 25.0, 100.0 * number(i, 0.414_214) - 25.0];
                let found = tiles.holding(at);
                assert!(found.is_sorted_by(|a, b| a < b));
                met += found.len();
                let mut near = Vec::new();
                tiles.each_near(at, 6.0, |index| near.push(index));
                for (index, of) in boxes.iter().enumerate() {
                    let is_held = holds(*of, at, size, wrap);
                    assert!(!is_held || found.contains(&(index as u32)), "{wrap:?} {at:?} {of:?}");
                    let wider = [of[0].map(|low| low - 6.0), of[1].map(|high| high + 6.0)];
                    assert!(!holds(wider, at, size, wrap) || near.contains(&(index as u32)), "{at:?}");
                }
            }
            assert!(met < 300 * 20, "{met}");
        }
    }
}
