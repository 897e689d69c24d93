//! Freehand outlines that are far from the ellipse that they are read as: hearts, stars, spirals, letters.

use super::SketchNote;
use crate::document::{Layer, Stroke};
use crate::sketch::difference_from_ellipse;

/// The share of its area by which an outline may differ. Round outlines drawn by hand differ by 0.02–0.08, a hexagon by 0.08,
/// a square by 0.18.
const MOST: f64 = 0.12;

pub(super) fn notes(layer: &Layer) -> Vec<SketchNote> {
    let note = |(index, stroke): (usize, &Stroke)| {
        let Stroke::Freehand { points, .. } = stroke else { return None };
        let (ellipse, share) = difference_from_ellipse(points).filter(|(_, share)| *share > MOST)?;
        Some(SketchNote::new(vec![index], vec![ellipse.center], in_words(share)))
    };
    layer.strokes.iter().enumerate().filter_map(note).collect()
}

/// What is told of an outline that differs by this share of its area.
#[must_use]
pub(super) fn in_words(share: f64) -> String {
    format!(
        "this outline is read as an ellipse, and {:.0} % of its area differ from it: spots are ellipses; draw it of several \
         ellipses, or leave its end open for a stripe",
        100.0 * share
    )
}
