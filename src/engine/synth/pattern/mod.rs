//! The pattern of a layer of any kind: 0 = ground, ½ = an edge, 1 = the middle of a mark.

mod area_pattern;

pub use area_pattern::AreaPattern;

use std::ops::Range;

use crate::grid::Field;

/// The pattern value at the edge of a mark. A px is covered by a mark if its value is not below it.
pub const EDGE: f32 = 0.5;

/// A pattern that can be shown at any size.
pub trait PatternRows: Send + Sync {
    /// Cells along x and y of the grid that it grew on.
    fn grid(&self) -> [usize; 2];

    /// Whether it has corners within a cell of that grid, as where threads cross.
    fn has_corners(&self) -> bool {
        true
    }

    /// Rows `rows` at `width` × `height` px over the whole canvas.
    fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32>;

    /// The whole pattern at `width` × `height` px.
    fn field(&self, width: usize, height: usize) -> Field;
}

/// The pattern with `by` times the cells of its `coarse` field along each side, at most one a px; `coarse` has the cells that it grew on.
#[must_use]
pub fn finer(pattern: &dyn PatternRows, coarse: &Field, by: f64) -> Field {
    let extent = coarse.extent();
    let [width, height] = [0, 1].map(|axis| {
        let cells = [coarse.width, coarse.height][axis];
        let px = extent[axis].round() as usize;
        ((cells as f64 * by).ceil() as usize).clamp(cells, cells.max(px))
    });
    pattern.field(width, height)
}

/// The pattern of a layer of any kind.
pub type LayerPattern<'a> = Box<dyn PatternRows + 'a>;

/// u → the pattern: the smooth monotone map of 0..1 onto itself that takes `level` to ½,
/// p = u(1 − l)/(u(1 − l) + l(1 − u)).
#[must_use]
pub fn share(u: f32, level: f32) -> f32 {
    let u = u.clamp(0.0, 1.0);
    let up = u * (1.0 - level);
    up / (up + level * (1.0 - u))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_level_becomes_one_half_and_the_ends_stay() {
        for level in [0.2, 0.5, 0.75] {
            assert!((share(level, level) - 0.5).abs() < 1e-6);
            assert_eq!([share(0.0, level), share(1.0, level)], [0.0, 1.0]);
            assert_eq!([share(-0.1, level), share(1.3, level)], [0.0, 1.0]);
        }
    }

    #[test]
    fn the_pattern_rises_with_the_concentration() {
        for level in [0.2, 0.5, 0.75] {
            let p: Vec<f32> = (0..=100).map(|i| share(i as f32 / 100.0, level)).collect();
            assert!(p.windows(2).all(|w| w[0] < w[1]));
        }
    }
}
