//! Undo and redo: what the document and the selection were, step by step.

use crate::document::Document;
use crate::editor::selection::Selection;

/// Steps that can be undone; a document of a hundred marks takes some 10 kB.
const MOST: usize = 500;

/// A document and what was selected in it.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// The document.
    pub document: Document,
    /// What was selected.
    pub selection: Selection,
    /// The layer at hand.
    pub layer: usize,
    /// How many of the lowest layers were frozen.
    pub frozen: usize,
}

/// What came before, and what was undone.
#[derive(Clone, Debug, Default)]
pub struct History {
    before: Vec<Moment>,
    undone: Vec<Moment>,
}

impl History {
    /// Remembers what was there before a change; what was undone is gone.
    pub fn remember(&mut self, before: Moment) {
        self.undone.clear();
        self.before.push(before);
        if self.before.len() > MOST {
            self.before.remove(0);
        }
    }

    /// Goes back: takes `now`, gives what was there before.
    pub fn undo(&mut self, now: Moment) -> Moment {
        step(&mut self.before, &mut self.undone, now)
    }

    /// Goes forth again.
    pub fn redo(&mut self, now: Moment) -> Moment {
        step(&mut self.undone, &mut self.before, now)
    }

    /// Is there something to undo, and to redo?
    #[must_use]
    pub fn can(&self) -> [bool; 2] {
        [!self.before.is_empty(), !self.undone.is_empty()]
    }
}

fn step(from: &mut Vec<Moment>, to: &mut Vec<Moment>, now: Moment) -> Moment {
    match from.pop() {
        None => now,
        Some(moment) => {
            to.push(now);
            moment
        }
    }
}
