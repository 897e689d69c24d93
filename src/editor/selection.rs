//! Which marks are selected.

use std::collections::BTreeSet;

use crate::document::Document;

/// Position of a stroke in a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Its layer, 0 = the lowest.
    pub layer: usize,
    /// Its index in the layer.
    pub stroke: usize,
}

/// The selected strokes, in the order of the document.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection(BTreeSet<Place>);

impl Selection {
    /// Selects these strokes.
    pub fn new(places: impl IntoIterator<Item = Place>) -> Self {
        Self(places.into_iter().collect())
    }

    /// The selected strokes, in the order of the document.
    pub fn places(&self) -> impl DoubleEndedIterator<Item = Place> + '_ {
        self.0.iter().copied()
    }

    /// The number of selected strokes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether nothing is selected.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Whether this stroke is selected.
    #[must_use]
    pub fn contains(&self, place: Place) -> bool {
        self.0.contains(&place)
    }

    /// Selects a stroke, or deselects it.
    pub fn toggle(&mut self, place: Place) {
        if !self.0.remove(&place) {
            self.0.insert(place);
        }
    }

    /// Selects more strokes.
    pub fn add(&mut self, places: impl IntoIterator<Item = Place>) {
        self.0.extend(places);
    }

    /// Deselects all.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// The selected strokes after the indices of layers have changed; `None` = the layer no longer exists.
    #[must_use]
    pub fn with_layers_moved(&self, new_index: impl Fn(usize) -> Option<usize>) -> Self {
        Self::new(self.places().filter_map(|place| Some(Place { layer: new_index(place.layer)?, ..place })))
    }

    /// Removes the strokes that are not in the document.
    pub fn retain_existing(&mut self, document: &Document) {
        self.0.retain(|place| {
            document.layers.get(place.layer).is_some_and(|layer| place.stroke < layer.strokes.len())
        });
    }
}
