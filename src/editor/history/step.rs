//! A step of the history, stored small: it shares with the step beside it what both have.
//!
//! Most steps change one stroke of hundreds, and starred documents are as large as the document itself.

use std::sync::Arc;

use super::Snapshot;
use crate::document::{Document, Starred, Stroke};

/// A stroke is looked for among this many strokes of the other step after the last one that both have: more were hardly
/// deleted at once.
const AHEAD: usize = 32;

/// A stored snapshot.
#[derive(Clone, Debug)]
pub(super) struct Step {
    /// The snapshot without strokes and starred documents.
    rest: Snapshot,
    /// The strokes, by layer.
    strokes: Vec<Vec<Arc<Stroke>>>,
    starred: Vec<Arc<Starred>>,
}

impl Step {
    /// Stores a snapshot; what it has in common with the step `beside` it is shared.
    pub(super) fn new(mut snapshot: Snapshot, beside: Option<&Self>) -> Self {
        let document = &mut snapshot.document;
        let strokes = document.layers.iter_mut().enumerate().map(|(layer, of)| {
            let known = beside.and_then(|beside| beside.strokes.get(layer)).map_or(&[][..], Vec::as_slice);
            shared(std::mem::take(&mut of.strokes), known)
        });
        let strokes = strokes.collect();
        let known = beside.map_or(&[][..], |beside| &beside.starred);
        let starred = shared(std::mem::take(&mut document.starred), known);
        Self { rest: snapshot, strokes, starred }
    }

    /// The snapshot.
    pub(super) fn snapshot(self) -> Snapshot {
        let mut snapshot = self.rest;
        let Document { layers, starred, .. } = &mut snapshot.document;
        for (layer, strokes) in layers.iter_mut().zip(self.strokes) {
            layer.strokes = strokes.into_iter().map(Arc::unwrap_or_clone).collect();
        }
        *starred = self.starred.into_iter().map(Arc::unwrap_or_clone).collect();
        snapshot
    }

    /// The picture under the canvas.
    pub(super) fn backdrop(&mut self) -> &mut Option<crate::editor::backdrop::Backdrop> {
        &mut self.rest.backdrop
    }

    /// Whether a stroke is the one that the other step has.
    #[cfg(test)]
    pub(super) fn shares(&self, other: &Self, layer: usize, stroke: usize) -> bool {
        let own = &self.strokes[layer][stroke];
        other.strokes[layer].iter().any(|other| Arc::ptr_eq(own, other))
    }
}

/// The items, with those that are `known` shared. Both are in about the same order.
fn shared<T: PartialEq>(items: Vec<T>, known: &[Arc<T>]) -> Vec<Arc<T>> {
    let mut next = 0;
    let share = |item: T| {
        let ahead = known.iter().enumerate().skip(next).take(AHEAD);
        match ahead.into_iter().find(|(_, known)| ***known == item) {
            Some((at, known)) => {
                next = at + 1;
                Arc::clone(known)
            }
            None => Arc::new(item),
        }
    };
    items.into_iter().map(share).collect()
}
