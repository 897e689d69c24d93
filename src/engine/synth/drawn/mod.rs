//! What the document says of a layer, as every kind of layer reads it.

pub mod maps;
pub mod parametric;
pub mod sketch_targets;

use crate::document::{After, Document};

/// Whether layer `index` is not shown because the next one stands inside it.
#[must_use]
pub fn is_replaced(document: &Document, index: usize) -> bool {
    document.layers.get(index + 1).is_some_and(|above| above.after == After::Inside)
}
