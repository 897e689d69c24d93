//! Reads the settings of a layer in the document that all kinds of layers share.

pub mod maps;
pub mod parametric;
pub mod sketch_targets;

use crate::document::{After, Document};

/// Whether layer `index` is not shown because the marks of the next one replace it (`after` is `"inside"`).
#[must_use]
pub fn is_replaced(document: &Document, index: usize) -> bool {
    document.layers.get(index + 1).is_some_and(|above| above.after == After::Inside)
}
