//! The classification of each cell of a photograph.

use super::reading::Reading;
use super::watershed::component;
use crate::measure::Picture;

/// The class of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The ground, or a region too small for a mark.
    Ground,
    /// A spot that the border cuts: it is a neighbour of others, but not measured.
    Cut,
    /// A mark of this layer, 0 = the lowest.
    Mark(u8),
}

/// The classes of the cells of [`Reading::segmentation`]; spots with an area below `between` (px²) belong to layer 1.
///
/// Areas are those of whole cells: a region whose area is within a cell or two of the smallest may be shown on the wrong side.
#[must_use]
pub fn parts(reading: &Reading, between: Option<f64>) -> Vec<Part> {
    let field = &reading.segmentation.field;
    let size = [field.width, field.height];
    let mut seen: Vec<bool> = field.values.iter().map(|value| *value <= reading.segmentation.level).collect();
    let mut parts = vec![Part::Ground; seen.len()];
    let is_spotted = matches!(reading.picture, Picture::Spots { .. });
    for start in 0..seen.len() {
        if seen[start] {
            continue;
        }
        let cells = component(start, &mut seen, size);
        let area = cells.len() as f64 * field.cell[0] * field.cell[1];
        if area < reading.least {
            continue;
        }
        let at_border = |cell: &usize| {
            let (x, y) = (cell % size[0], cell / size[0]);
            x == 0 || y == 0 || x + 1 == size[0] || y + 1 == size[1]
        };
        let part = if is_spotted && cells.iter().any(at_border) {
            Part::Cut
        } else {
            Part::Mark(u8::from(between.is_some_and(|between| area < between)))
        };
        cells.iter().for_each(|cell| parts[*cell] = part);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::{Raster, read};

    #[test]
    fn discs_are_marks_and_those_at_the_border_are_cut() {
        // Dark discs of radius 6 every 20 px, of 10 in every second row; the first column is cut.
        let size = [190, 200];
        let dark = |x: usize, y: usize| {
            let near = |at: usize| (at as f64 + 0.5).rem_euclid(20.0) - 10.0;
            let radius = if (y / 20).is_multiple_of(2) { 8.0 } else { 4.0 };
            near(x + 10).hypot(near(y)) < radius
        };
        let px = |k: usize| if dark(k % size[0], k / size[0]) { [40; 3] } else { [220; 3] };
        let raster = Raster { size, rgb: (0..size[0] * size[1]).flat_map(px).collect(), dpi: None };
        let reading = read(&raster, false).unwrap();
        let field = &reading.segmentation.field;
        assert_eq!([field.width, field.height], size, "one cell a px");
        let parts = parts(&reading, Some(120.0));
        let at = |x: usize, y: usize| parts[y * size[0] + x];
        assert_eq!((at(2, 10), at(20, 10), at(20, 30)), (Part::Cut, Part::Mark(0), Part::Mark(1)));
        assert_eq!((at(10, 10), at(30, 20)), (Part::Ground, Part::Ground));
    }
}
