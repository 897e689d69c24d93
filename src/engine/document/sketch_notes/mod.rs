//! Properties of a sketch that will not grow as drawn: shown by `check`, and by the window during drawing.
//!
//! Each rule has a file of its own. Problems that depend on the systems and on the other layers are noted by the plan of a layer.

mod crossings;
mod hidden;
mod narrow;
mod outlines;
mod sizes;

use std::fmt;

use serde::Serialize;

use crate::document::{Document, Stroke};
use crate::marks::Mark;

pub use crossings::crossing_strokes;
pub use outlines::outline_remark;
pub use sizes::size_groups;

/// Most places that a note names; the others are counted.
const NAMED: usize = 6;

/// Something that will not grow as it was drawn, and what to do about it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SketchNote {
    /// Index of the layer, 0 = the lowest; `None` for the whole document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub layer: Option<usize>,
    /// Indices of the strokes in that layer.
    pub strokes: Vec<usize>,
    /// Places on the canvas, px.
    pub places: Vec<[f64; 2]>,
    /// Description of the difference from the drawing, and the remedy.
    pub text: String,
    /// The difference from the drawing, as numbers.
    #[serde(skip)]
    pub problem: Problem,
    /// The remedies that dapple can carry out.
    #[serde(skip)]
    pub remedies: Vec<Remedy>,
}

/// A property of a sketch that will not grow as it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Problem {
    /// All layers are hidden.
    Hidden,
    /// An outline is far from the ellipse that it is read as: the share of its area that differs.
    Outline(f64),
    /// A path crosses itself.
    CrossesItself,
    /// Lines of one layer cross.
    CrossEachOther,
    /// Spots are narrower than any can be grown: how many, and the aspect of the narrowest.
    Narrow {
        /// Number of spots.
        spots: usize,
        /// Minor ÷ major radius of the narrowest.
        least: f64,
    },
    /// The spots of a layer have two sizes: how many, and their mean area, px²; the small ones, then the large ones.
    TwoSizes([(usize, f64); 2]),
}

impl Problem {
    /// The sentence without a full stop. `at`: such as ` at [30, 40]`, or nothing; `area` writes an area, px².
    #[must_use]
    pub fn in_words(&self, at: &str, area: &dyn Fn(f64) -> String) -> String {
        match self {
            Self::Hidden => hidden::TEXT.to_owned(),
            Self::Outline(share) => outlines::in_words(*share),
            Self::CrossesItself => format!(
                "this path crosses itself{at}: stripes have one direction at each place; cut it there and put the two parts \
                 on two layers"
            ),
            Self::CrossEachOther => format!(
                "these lines cross each other{at}: stripes have one direction at each place; use two layers, or a weave"
            ),
            Self::Narrow { spots, least } => narrow::in_words(*spots, *least),
            Self::TwoSizes([small, large]) => format!(
                "the spots of this layer have two sizes: {} of about {} and {} of about {}. One layer has one spacing for \
                 both; put the {} on a layer of their own",
                small.0,
                area(small.1),
                large.0,
                area(large.1),
                if large.0 <= small.0 { "large ones" } else { "small ones" },
            ),
        }
    }
}

/// A remedy that dapple can carry out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// Put the small spots on a layer of their own, see [`size_groups`].
    TwoLayers,
    /// Put lines that cross others on a layer of their own, see [`crossing_strokes`].
    CrossingLayer,
    /// Grow threads that cross, see [`PairKind::Weave`](crate::rd::pairs::PairKind::Weave).
    Weave,
}

impl fmt::Display for SketchNote {
    /// Writes the note with its layer and strokes, as in other messages: `layers[0].strokes[3]: …`.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        if let Some(layer) = self.layer {
            let named: Vec<String> = self.strokes.iter().take(NAMED).map(usize::to_string).collect();
            let more = if self.strokes.len() > NAMED { ", …" } else { "" };
            write!(f, "layers[{layer}].strokes[{}{more}]: ", named.join(", "))?;
        }
        write!(f, "{}", self.text)
    }
}

/// All notes on a sketch.
#[must_use]
pub fn notes_on(document: &Document) -> Vec<SketchNote> {
    let marks = document.layers.iter().map(|layer| layer.strokes.iter().map(Stroke::mark).collect());
    sketch_notes(document, &marks.collect::<Vec<_>>())
}

/// All notes on a sketch whose strokes have been fitted; `marks` are the marks of its strokes, by layer; `None` for a stroke that
/// is no mark.
#[must_use]
pub fn sketch_notes(document: &Document, marks: &[Vec<Option<Mark>>]) -> Vec<SketchNote> {
    let mut notes: Vec<SketchNote> = hidden::note(document).into_iter().collect();
    for (index, (layer, marks)) in document.layers.iter().zip(marks).enumerate() {
        // Patches and cells are as they were drawn.
        let outlines =
            if document.areas_of(index, marks).is_none() { outlines::notes(layer) } else { Vec::new() };
        let found = outlines.into_iter();
        let found = found.chain(crossings::notes(document, layer, marks)).chain(sizes::note(marks));
        let found = found.chain(narrow::note(marks));
        notes.extend(found.map(|note| SketchNote { layer: Some(index), ..note }));
    }
    notes
}

impl SketchNote {
    /// A note on some strokes of a layer, which is added by [`sketch_notes`].
    fn new(strokes: Vec<usize>, places: Vec<[f64; 2]>, problem: Problem) -> Self {
        let is_crossing = matches!(problem, Problem::CrossesItself | Problem::CrossEachOther);
        let at = if is_crossing { format!(" at {}", in_words(&places)) } else { String::new() };
        let text = problem.in_words(&at, &|area| format!("{area:.0} px²"));
        Self { layer: None, strokes, places, text, problem, remedies: Vec::new() }
    }
}

/// Places in words: `[102, 85], [30, 41] and 3 more`, in whole px.
fn in_words(places: &[[f64; 2]]) -> String {
    let named: Vec<String> = places.iter().take(NAMED).map(|[x, y]| format!("[{x:.0}, {y:.0}]")).collect();
    let more = places.len().saturating_sub(NAMED);
    if more > 0 { format!("{} and {more} more", named.join(", ")) } else { named.join(", ") }
}

#[cfg(test)]
mod tests;
