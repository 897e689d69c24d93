//! Closed outlines that nearly touch, which suggests that the user wants cells.

use crate::document::layer_rules::{Beneath, Combination};
use crate::document::{AreaKind, Document, Kind, Layer, SystemChoice};
use crate::grid::Bounds;
use crate::marks::{Ellipse, Mark};

/// Least number of marks of a layer.
const LEAST: usize = 3;
/// Largest gap between two outlines that nearly touch, as a share of √area of the smaller one. Spots at their highest density, area
/// ÷ spacing² = 0.2, have gaps of 1.1.
const NEAR: f64 = 0.35;
/// Least share of the marks with such a neighbour.
const MOST: f64 = 0.75;

impl Document {
    /// Whether the marks of a layer lie side by side like cells: there are at least three closed outlines, and most of them nearly
    /// touch another one. False unless the system is chosen automatically and the layer may be cells. `marks` are the marks of its
    /// strokes, `None` for a stroke that is no mark.
    #[must_use]
    pub fn looks_like_cells(&self, layer: &Layer, marks: &[Option<Mark>]) -> bool {
        let ellipses: Option<Vec<Ellipse>> =
            marks.iter().map(|mark| mark.as_ref().and_then(Mark::ellipse)).collect();
        let Some(ellipses) = ellipses.filter(|all| all.len() >= LEAST) else { return false };
        if layer.system != SystemChoice::Auto || !may_be_cells(layer) {
            return false;
        }
        let canvas = Bounds { size: self.size.map(f64::from), edges: self.edges };
        let nearly_touch = |a: &Ellipse, b: &Ellipse| {
            (0.0..=NEAR * a.area().min(b.area()).sqrt()).contains(&a.gap_to(b, &canvas))
        };
        let has_neighbour = |index: &usize| {
            (0..ellipses.len())
                .any(|other| other != *index && nearly_touch(&ellipses[*index], &ellipses[other]))
        };
        let count = (0..ellipses.len()).filter(has_neighbour).count();
        count as f64 >= MOST * ellipses.len() as f64
    }
}

/// Whether the layer breaks no rule if it grows cells.
fn may_be_cells(layer: &Layer) -> bool {
    let system = SystemChoice::Of(AreaKind::Polygons.description());
    let combination = Combination::new(layer, Some(Kind::Ellipse), Beneath::Unknown);
    Combination { system, ..combination }.broken_rule().is_none()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{LayerOptions, Stroke};

    fn looks(strokes: &[Stroke], change: impl Fn(Layer) -> Layer) -> bool {
        let layer = change(Layer::new(strokes.to_vec()));
        let marks: Vec<Option<Mark>> = layer.strokes.iter().map(Stroke::mark).collect();
        Document::new([300, 200]).looks_like_cells(&layer, &marks)
    }

    /// Discs of 20 px in a row, `apart` px from centre to centre.
    fn row(apart: f64, count: usize) -> Vec<Stroke> {
        (0..count).map(|k| Stroke::ellipse([30.0 + apart * k as f64, 100.0], [20.0, 20.0], 0.0)).collect()
    }

    #[test]
    fn outlines_that_nearly_touch_look_like_cells_and_spots_do_not() {
        let same = |layer: Layer| layer;
        // √area is 35 px: gaps of 8 and of 20 px.
        assert!(looks(&row(48.0, 4), same));
        assert!(!looks(&row(60.0, 4), same));
        assert!(!looks(&row(48.0, 2), same), "two are too few");
        assert!(!looks(&row(35.0, 4), same), "they overlap");
        let far = [row(48.0, 2), vec![Stroke::ellipse([250.0, 40.0], [20.0, 20.0], 0.0)]].concat();
        assert!(!looks(&far, same), "only two of three nearly touch");
    }

    #[test]
    fn only_layers_that_may_be_cells_look_like_cells() {
        let strokes = row(48.0, 4);
        assert!(
            !looks(&strokes, |layer| layer.with_system(SystemChoice::Of(AreaKind::Patches.description())))
        );
        let irregular = LayerOptions { irregular: 0.5, ..LayerOptions::default() };
        assert!(!looks(&strokes, |layer| layer.with_options(irregular)));
        let line = [row(48.0, 3), vec![Stroke::line([20.0, 20.0], [90.0, 20.0], 5.0)]].concat();
        assert!(!looks(&line, |layer| layer));
    }
}
