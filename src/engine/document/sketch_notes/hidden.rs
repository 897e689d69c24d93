//! All layers are hidden: the picture would be one plain colour.

use super::{Problem, SketchNote};
use crate::document::Document;

pub(super) const TEXT: &str =
    "all layers are hidden, so the picture would show no marks: show at least one layer";

pub(super) fn note(document: &Document) -> Option<SketchNote> {
    let is_hidden = !document.layers.is_empty() && document.layers.iter().all(|layer| !layer.visible);
    is_hidden.then(|| SketchNote::new(Vec::new(), Vec::new(), Problem::Hidden))
}
