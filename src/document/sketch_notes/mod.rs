//! What will not grow as it was drawn, found in the sketch itself: told by `check`, and by the window while one draws.
//!
//! Each rule has a file of its own. What depends on the systems and on the other layers is told by the plan of a layer.

mod crossings;
mod hidden;
mod outlines;
mod sizes;

use std::fmt;

use serde::Serialize;

use crate::document::{Document, Stroke};
use crate::marks::Mark;

pub use outlines::outline_remark;
pub use sizes::size_groups;

/// Places that a note names in words; the others are counted.
const NAMED: usize = 6;

/// Something that will not grow as it was drawn, and what to do about it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SketchNote {
    /// Index of the layer, 0 = the lowest; `None` of the whole document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub layer: Option<usize>,
    /// Indices of the strokes in that layer.
    pub strokes: Vec<usize>,
    /// Where on the canvas, px.
    pub places: Vec<[f64; 2]>,
    /// What will not be as drawn, and the remedy.
    pub text: String,
    /// The remedy, where dapple can carry it out.
    #[serde(skip)]
    pub remedy: Option<Remedy>,
}

/// A remedy that dapple can carry out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// Put the small spots on a layer of their own, see [`size_groups`].
    TwoLayers,
}

impl fmt::Display for SketchNote {
    /// With layer and strokes as in other messages: `layers[0].strokes[3]: …`.
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

/// All notes on a sketch whose strokes have been fitted; `marks` are those of its strokes, by layer, `None` of a stroke that is no mark.
#[must_use]
pub fn sketch_notes(document: &Document, marks: &[Vec<Option<Mark>>]) -> Vec<SketchNote> {
    let mut notes: Vec<SketchNote> = hidden::note(document).into_iter().collect();
    for (index, (layer, marks)) in document.layers.iter().zip(marks).enumerate() {
        let found = outlines::notes(layer).into_iter();
        let found = found.chain(crossings::notes(layer, marks)).chain(sizes::note(marks));
        notes.extend(found.map(|note| SketchNote { layer: Some(index), ..note }));
    }
    notes
}

impl SketchNote {
    /// A note on some strokes of a layer, which is added by [`sketch_notes`].
    fn new(strokes: Vec<usize>, places: Vec<[f64; 2]>, text: String) -> Self {
        Self { layer: None, strokes, places, text, remedy: None }
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
