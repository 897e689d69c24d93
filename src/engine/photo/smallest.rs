//! Removal of marks that are too small.

use super::watershed::areas;
use crate::grid::Field;

/// Difference between the threshold and the value of removed cells: the interpolated surface may not rise above the threshold
/// between them.
const BELOW: f32 = 0.2;

/// Lowers the connected regions above `level` that are smaller than `least` px² to below it.
pub fn remove_below(field: &mut Field, level: f32, least: f64) {
    let areas = areas(field, level);
    for (value, area) in field.values.iter_mut().zip(areas) {
        if area > 0.0 && area < least {
            *value = level - BELOW;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn smaller_regions_are_removed_and_larger_ones_unchanged() {
        // Squares of 2 and 5 cells of 3 px: 36 and 225 px².
        let inside = |x: usize, y: usize| (2..4).contains(&x) && y < 2 || (8..13).contains(&x) && y > 2;
        let values = (0..16 * 8).map(|k| if inside(k % 16, k / 16) { 1.0 } else { 0.1 }).collect();
        let mut field = Field { width: 16, height: 8, cell: [3.0; 2], edges: Edges::Closed, values };
        let before = field.clone();
        remove_below(&mut field, 0.5, 36.0);
        assert_eq!(field, before);
        remove_below(&mut field, 0.5, 36.1);
        let above = |field: &Field| field.values.iter().filter(|value| **value > 0.5).count();
        assert_eq!((above(&before), above(&field)), (29, 25));
    }
}
