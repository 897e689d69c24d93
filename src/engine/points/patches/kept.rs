//! Kept outlines: patches that are reproduced as drawn.

use rayon::prelude::*;

use super::{Outline, Outlines, Patches};
use crate::grid::Field;
use crate::points::discs::POINTS_A_SQUARE;

/// Distance from a kept outline at which the field reaches 0 and 1, in radii of the discs for [`Patches::KEPT_DETAIL`] points.
const SLOPE: f64 = 2.0;

/// Radius, px, of discs of which the area of an outline would hold [`Patches::KEPT_DETAIL`]: the scale of its smallest details.
pub(super) fn fine(outline: &Outline) -> f64 {
    (POINTS_A_SQUARE * outline.area() / Patches::KEPT_DETAIL).sqrt()
}

/// Distance from an outline at which the field reaches 0 and 1, px.
pub fn slope(outline: &Outline) -> f64 {
    SLOPE * fine(outline)
}

/// Puts the outlines into a field whose patches are above ½: it is ½ along them. In a film in which the `share` of the patches has
/// appeared, they are smaller and grow from within.
pub(super) fn put(field: &mut Field, kept: &Outlines, share: f64) {
    let reach = kept.iter().map(slope).fold(0.0, f64::max);
    if reach == 0.0 {
        return;
    }
    let grid = field.grid();
    let extent = kept.extent();
    field.values.par_iter_mut().enumerate().for_each(|(cell, value)| {
        let at = grid.center_px(cell);
        for outline in kept.near(at, reach) {
            let slope = slope(outline);
            // Cells with the value 1 do not change, and farther away than its slope an outline adds nothing.
            if *value >= 1.0 || outline.away(at, extent) >= slope {
                continue;
            }
            let missing = (1.0 - share) * (outline.area() / std::f64::consts::PI).sqrt();
            let own = 0.5 + 0.5 * (outline.depth(at, extent) - missing) / slope;
            *value = value.max(own.clamp(0.0, 1.0) as f32);
        }
    });
}

/// Whether a place is in a kept outline or within `clearance` px of one.
pub(super) fn is_beside(at: [f64; 2], kept: &Outlines, clearance: f64) -> bool {
    kept.near(at, clearance).any(|outline| outline.depth(at, kept.extent()) > -clearance)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::points::extent::Extent;

    fn square(low: [f64; 2], side: f64) -> Outline {
        let [x, y] = low;
        Outline::new(vec![[x, y], [x + side, y], [x + side, y + side], [x, y + side]]).expect("an area")
    }

    #[test]
    fn the_field_is_a_half_along_kept_outlines_and_lower_between_two_that_are_two_px_apart() {
        let squares = [square([10.0, 10.0], 20.0), square([32.0, 10.0], 20.0)];
        let extent = Extent { size: [60.0, 40.0], wrap: [false; 2] };
        let kept = Outlines::new(squares.iter(), &extent);
        let mut field = Field::flat(120, 80, Edges::Closed, 0.0);
        field.cell = [0.5; 2];
        put(&mut field, &kept, 1.0);
        let at = |x: usize| field.values[40 * 120 + x];
        // Cells of half a px: their centres are 0.25 px inside and outside of the edges at 10, 30, 32 and 52.
        assert!(at(19) < 0.5 && at(20) > 0.5 && at(59) > 0.5 && at(60) < 0.5 && at(63) < 0.5 && at(64) > 0.5);
        assert_eq!((at(40), at(5)), (1.0, 0.0));
    }

    #[test]
    fn in_a_film_kept_outlines_grow_from_within() {
        let squares = [square([10.0, 10.0], 20.0)];
        let extent = Extent { size: [40.0, 40.0], wrap: [false; 2] };
        let kept = Outlines::new(squares.iter(), &extent);
        let inside = |share: f64| {
            let mut field = Field::flat(40, 40, Edges::Closed, 0.0);
            put(&mut field, &kept, share);
            field.values.iter().filter(|value| **value > 0.5).count()
        };
        let counts = [0.0, 0.3, 0.7, 1.0].map(inside);
        assert!(counts[0] == 0 && counts.is_sorted_by(|a, b| a < b) && counts[3] == 400, "{counts:?}");
    }

    #[test]
    fn places_nearer_than_the_clearance_are_beside_an_outline() {
        let squares = [square([10.0, 10.0], 20.0)];
        let extent = Extent { size: [60.0, 40.0], wrap: [false; 2] };
        let kept = Outlines::new(squares.iter(), &extent);
        let beside = |x: f64| is_beside([x, 20.0], &kept, 4.0);
        assert_eq!([20.0, 33.9, 34.1].map(beside), [true, true, false]);
    }
}
