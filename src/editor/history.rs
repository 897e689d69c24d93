//! Undo and redo: snapshots of the document and the selection.

use crate::document::Document;
use crate::editor::selection::Selection;

/// Steps that can be undone. A document of a hundred marks takes about 10 kB.
const MAX_STEPS: usize = 500;

/// A document and its selection at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The document.
    pub document: Document,
    /// What was selected.
    pub selection: Selection,
    /// The active layer.
    pub active_layer: usize,
    /// How many of the lowest layers were frozen.
    pub frozen: usize,
}

/// Snapshots before and after the current state.
#[derive(Clone, Debug, Default)]
pub struct History {
    undo: Vec<Snapshot>,
    redo: Vec<Snapshot>,
}

impl History {
    /// Adds the state before a change. Undone steps can then no longer be redone.
    pub fn push(&mut self, before: Snapshot) {
        self.redo.clear();
        self.undo.push(before);
        if self.undo.len() > MAX_STEPS {
            self.undo.remove(0);
        }
    }

    /// Exchanges the current state for the one before it; returns `current` when there is none.
    pub fn undo(&mut self, current: Snapshot) -> Snapshot {
        exchange(&mut self.undo, &mut self.redo, current)
    }

    /// Exchanges the current state for the one that was undone last; returns `current` when there is none.
    pub fn redo(&mut self, current: Snapshot) -> Snapshot {
        exchange(&mut self.redo, &mut self.undo, current)
    }

    /// Whether there is a step to undo, and one to redo.
    #[must_use]
    pub fn can_undo_redo(&self) -> [bool; 2] {
        [!self.undo.is_empty(), !self.redo.is_empty()]
    }
}

fn exchange(from: &mut Vec<Snapshot>, to: &mut Vec<Snapshot>, current: Snapshot) -> Snapshot {
    match from.pop() {
        None => current,
        Some(snapshot) => {
            to.push(current);
            snapshot
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> Snapshot {
        let document = Document { name: name.to_owned(), ..Document::default() };
        Snapshot { document, selection: Selection::default(), active_layer: 0, frozen: 0 }
    }

    #[test]
    fn undone_steps_are_redone_until_something_else_is_changed() {
        let mut history = History::default();
        assert_eq!(history.undo(named("a")).document.name, "a");
        history.push(named("a"));
        history.push(named("b"));
        assert_eq!(history.undo(named("c")).document.name, "b");
        assert_eq!(history.redo(named("b")).document.name, "c");
        assert_eq!(history.undo(named("c")).document.name, "b");
        assert_eq!(history.can_undo_redo(), [true, true]);
        history.push(named("b"));
        assert_eq!(history.can_undo_redo(), [true, false]);
    }

    #[test]
    fn the_oldest_step_is_dropped_when_there_are_too_many() {
        let mut history = History::default();
        for step in 0..=MAX_STEPS {
            history.push(named(&step.to_string()));
        }
        let undone = (0..MAX_STEPS).map(|_| history.undo(named("now"))).last().unwrap();
        assert_eq!((undone.document.name.as_str(), history.can_undo_redo()), ("1", [false, true]));
    }
}
