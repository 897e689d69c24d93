//! Many drawn outlines: those near a place are found without looking at all of them.

use super::outline::Outline;
use crate::grid::BoxTiles;
use crate::points::extent::Extent;

/// Outlines with the tiles of the canvas that their boxes meet.
#[derive(Clone, Debug)]
pub struct Outlines<'a> {
    outlines: Vec<&'a Outline>,
    tiles: BoxTiles,
    extent: Extent,
}

impl<'a> Outlines<'a> {
    /// The same outlines on a canvas.
    pub fn new(outlines: impl Iterator<Item = &'a Outline>, extent: &Extent) -> Self {
        let outlines: Vec<&Outline> = outlines.collect();
        // About a tile for each outline.
        let side = (extent.size[0] * extent.size[1] / outlines.len().max(1) as f64).sqrt();
        let boxes = outlines.iter().map(|outline| outline.corners());
        Self { tiles: BoxTiles::new(extent.size, extent.wrap, side, boxes), extent: *extent, outlines }
    }

    /// The canvas.
    #[must_use]
    pub fn extent(&self) -> &Extent {
        &self.extent
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &'a Outline> + '_ {
        self.outlines.iter().copied()
    }

    /// Calls `each` with the depth of a place, px, in each outline from whose box it is at most `reach` px away along both
    /// axes, and perhaps in others; in some of them several times. See [`Outline::depth`].
    pub fn each_near(&self, at: [f64; 2], reach: f64, mut each: impl FnMut(&Outline, f64)) {
        self.each_index_near(at, reach, |_, outline, depth| each(outline, depth));
    }

    fn each_index_near(&self, at: [f64; 2], reach: f64, mut each: impl FnMut(u32, &Outline, f64)) {
        self.tiles.each_near(at, reach, |index| {
            let outline = self.outlines[index as usize];
            each(index, outline, outline.depth(at, &self.extent));
        });
    }

    /// The depth of a place in the outline in which it is deepest, px, and the index of this outline, the lower of equal ones;
    /// `None` where it is more than `reach` px outside of all, or little less.
    #[must_use]
    pub fn deepest(&self, at: [f64; 2], reach: f64) -> Option<(f64, u32)> {
        let mut deepest: Option<(f64, u32)> = None;
        self.each_index_near(at, reach, |index, _, depth| {
            let is_deeper = |(other, of): (f64, u32)| depth > other || depth == other && index < of;
            if deepest.is_none_or(is_deeper) {
                deepest = Some((depth, index));
            }
        });
        deepest.filter(|(depth, _)| *depth >= -reach)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_deepest_outline_is_that_of_a_full_search() {
        let number = |i: usize, step: f64| (0.5 + step * i as f64).fract();
        let outlines: Vec<Outline> = (0..60)
            .filter_map(|i| {
                let [x, y] = [130.0 * number(i, 0.754_877_7) - 15.0, 90.0 * number(i, 0.569_840_3) - 10.0];
                let (long, high) = (3.0 + 15.0 * number(i, 0.31), 3.0 + 9.0 * number(i, 0.87));
                Outline::new(vec![[x, y], [x + long, y + 1.0], [x + 0.7 * long, y + high]])
            })
            .collect();
        for wrap in [[false; 2], [true; 2]] {
            let extent = Extent { size: [100.0, 70.0], wrap };
            let all = Outlines::new(outlines.iter(), &extent);
            let mut found_some = 0;
            for i in 0..400 {
                let at = [120.0 * number(i, 0.618_034) - 10.0, 90.0 * number(i, 0.414_214) - 10.0];
                let depths = outlines.iter().map(|outline| outline.depth(at, &extent));
                let expected = depths.zip(0..).fold(None, |deepest: Option<(f64, u32)>, one| {
                    Some(deepest.filter(|deepest| deepest.0 >= one.0).unwrap_or(one))
                });
                let found = all.deepest(at, 4.0);
                found_some += usize::from(found.is_some());
                assert_eq!(found, expected.filter(|(depth, _)| *depth >= -4.0), "{wrap:?} {at:?}");
            }
            assert!((100..400).contains(&found_some), "{found_some}");
        }
    }
}
