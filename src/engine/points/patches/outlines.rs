//! A set of drawn outlines, searched by place without testing all of them.

use smallvec::SmallVec;

use super::outline::Outline;
use crate::grid::BoxTiles;
use crate::points::extent::Extent;

/// Number of outlines near a place that are held without allocation.
const IN_PLACE: usize = 16;

/// Outlines, with the tiles of the canvas that their bounding boxes meet.
#[derive(Clone, Debug)]
pub struct Outlines<'a> {
    outlines: Vec<&'a Outline>,
    tiles: BoxTiles,
    extent: Extent,
}

impl<'a> Outlines<'a> {
    /// Prepares the search of `outlines` on a canvas.
    pub fn new(outlines: impl Iterator<Item = &'a Outline>, extent: &Extent) -> Self {
        let outlines: Vec<&Outline> = outlines.collect();
        // About one tile for each outline.
        let side = (extent.size[0] * extent.size[1] / outlines.len().max(1) as f64).sqrt();
        let boxes = outlines.iter().map(|outline| outline.corners());
        Self { tiles: BoxTiles::new(extent.size, extent.wrap, side, boxes), extent: *extent, outlines }
    }

    /// The canvas.
    #[must_use]
    pub fn extent(&self) -> &Extent {
        &self.extent
    }

    /// All outlines.
    pub fn iter(&self) -> impl Iterator<Item = &'a Outline> + '_ {
        self.outlines.iter().copied()
    }

    /// The outlines whose bounding box is at most `reach` px away from a place, px, along both axes, and possibly further ones,
    /// each once. Computing the depth of the place in an outline ([`Outline::depth`]) takes longer than this search.
    pub fn near(&self, at: [f64; 2], reach: f64) -> impl Iterator<Item = &'a Outline> + '_ {
        self.indices_near(at, reach).into_iter().map(|index| self.outlines[index as usize])
    }

    /// The indices of these outlines, ascending.
    fn indices_near(&self, at: [f64; 2], reach: f64) -> SmallVec<[u32; IN_PLACE]> {
        let mut near = SmallVec::new();
        self.tiles.each_near(at, reach, |index| near.push(index));
        near.sort_unstable();
        near.dedup();
        near
    }

    /// The depth of a place in the outline in which it is deepest, px, and the index of this outline, the lowest if several are
    /// equal. `None` if the place is more than about `reach` px outside of all.
    #[must_use]
    pub fn deepest(&self, at: [f64; 2], reach: f64) -> Option<(f64, u32)> {
        let mut deepest: Option<(f64, u32)> = None;
        for index in self.indices_near(at, reach) {
            let depth = self.outlines[index as usize].depth(at, &self.extent);
            if deepest.is_none_or(|(other, _)| depth > other) {
                deepest = Some((depth, index));
            }
        }
        deepest.filter(|(depth, _)| *depth >= -reach)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_deepest_outline_agrees_with_a_full_search() {
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
