//! Freehand outlines that are far from the ellipse that they are read as: hearts, stars, spirals, letters.

use super::{Problem, SketchNote};
use crate::document::{Layer, Stroke};
use crate::marks::Ellipse;
use crate::sketch::difference_from_ellipse;

/// The largest share of its area by which an outline may differ. Round outlines drawn by hand differ by 0.02–0.08, a hexagon by
/// 0.08,
/// a square by 0.18.
const MOST: f64 = 0.12;

pub(super) fn notes(layer: &Layer) -> Vec<SketchNote> {
    let note = |(index, stroke): (usize, &Stroke)| {
        let Stroke::Freehand { points, .. } = stroke else { return None };
        let (ellipse, share) = far_outline(points)?;
        Some(SketchNote::new(vec![index], vec![ellipse.center], Problem::Outline(share)))
    };
    layer.strokes.iter().enumerate().filter_map(note).collect()
}

/// The remark on a freehand stroke whose outline is far from the ellipse that it is read as.
#[must_use]
pub fn outline_remark(points: &[[f64; 2]]) -> Option<String> {
    far_outline(points).map(|(_, share)| in_words(share))
}

fn far_outline(points: &[[f64; 2]]) -> Option<(Ellipse, f64)> {
    difference_from_ellipse(points).filter(|(_, share)| *share > MOST)
}

pub(super) fn in_words(share: f64) -> String {
    format!(
        "this outline is read as an ellipse, from which {:.0} % of its area differ: spots are ellipses; draw it as several \
         ellipses, or leave its end open to draw a stripe",
        100.0 * share
    )
}
