//! Which marks are selected.

use std::collections::BTreeSet;

use crate::document::Document;

/// Where a stroke stands in a document.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Place {
    /// Its layer, 0 = the lowest.
    pub layer: usize,
    /// Its number in the layer.
    pub stroke: usize,
}

/// The selected strokes, in the order of the document.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Selection(BTreeSet<Place>);

impl Selection {
    /// These.
    pub fn of(places: impl IntoIterator<Item = Place>) -> Self {
        Self(places.into_iter().collect())
    }

    /// The selected strokes, in the order of the document.
    pub fn places(&self) -> impl DoubleEndedIterator<Item = Place> + '_ {
        self.0.iter().copied()
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Is nothing selected?
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Is this one selected?
    #[must_use]
    pub fn holds(&self, place: Place) -> bool {
        self.0.contains(&place)
    }

    /// The only one.
    #[must_use]
    pub fn single(&self) -> Option<Place> {
        if self.0.len() == 1 { self.0.first().copied() } else { None }
    }

    /// Selects, or no longer.
    pub fn toggle(&mut self, place: Place) {
        if !self.0.remove(&place) {
            self.0.insert(place);
        }
    }

    /// Selects more.
    pub fn add(&mut self, places: impl IntoIterator<Item = Place>) {
        self.0.extend(places);
    }

    /// Nothing is selected any more.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// The same strokes where layers went to other places; `None` = they are gone.
    #[must_use]
    pub fn moved(&self, layer: impl Fn(usize) -> Option<usize>) -> Self {
        Self::of(self.places().filter_map(|place| Some(Place { layer: layer(place.layer)?, ..place })))
    }

    /// Forgets what is not in the document.
    pub fn keep_within(&mut self, document: &Document) {
        self.0.retain(|place| {
            document.layers.get(place.layer).is_some_and(|layer| place.stroke < layer.strokes.len())
        });
    }
}
