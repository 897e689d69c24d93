//! Undo and redo: snapshots of the document and the selection.

mod step;

use std::sync::Arc;

use crate::document::Document;
use crate::editor::backdrop::{Backdrop, Pixels};
use crate::editor::selection::Selection;
use step::Step;

/// Different pictures under the canvas that earlier steps keep; each takes up to 16 MB.
const MAX_PICTURES: usize = 4;
/// Steps that can be undone. Steps share what they have in common.
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
    /// The picture under the canvas.
    pub backdrop: Option<Backdrop>,
}

/// Snapshots before and after the current state.
#[derive(Clone, Debug, Default)]
pub struct History {
    undo: Vec<Step>,
    redo: Vec<Step>,
}

impl History {
    /// Adds the state before a change. Undone steps can then no longer be redone.
    pub fn push(&mut self, before: Snapshot) {
        self.redo.clear();
        self.undo.push(Step::new(before, self.undo.last()));
        if self.undo.len() > MAX_STEPS {
            self.undo.remove(0);
        }
        self.forget_pictures();
    }

    /// Removes the pictures under the canvas of old steps, where there are too many different ones.
    fn forget_pictures(&mut self) {
        let mut kept: Vec<Arc<Pixels>> = Vec::with_capacity(MAX_PICTURES);
        for step in self.undo.iter_mut().rev() {
            let Some(backdrop) = step.backdrop() else { continue };
            if kept.iter().all(|pixels| !Arc::ptr_eq(pixels, &backdrop.pixels)) {
                if kept.len() == MAX_PICTURES {
                    *step.backdrop() = None;
                    continue;
                }
                kept.push(Arc::clone(&backdrop.pixels));
            }
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

fn exchange(from: &mut Vec<Step>, to: &mut Vec<Step>, current: Snapshot) -> Snapshot {
    match from.pop() {
        None => current,
        Some(step) => {
            to.push(Step::new(current, Some(&step)));
            step.snapshot()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Layer, Starred, Stroke};
    use crate::marks::Line;

    fn named(name: &str) -> Snapshot {
        let document = Document { name: name.to_owned(), ..Document::default() };
        Snapshot { document, selection: Selection::default(), active_layer: 0, frozen: 0, backdrop: None }
    }

    #[test]
    fn only_the_latest_pictures_are_kept_with_the_steps() {
        let mut history = History::default();
        let picture =
            |name: usize| Backdrop::new(Pixels { name: name.to_string(), size: [1; 2], rgba: vec![0; 4] });
        for name in 0..6 {
            let backdrop = Some(picture(name));
            // The steps in between have the picture as well, and do not count.
            for _ in 0..3 {
                history.push(Snapshot { backdrop: backdrop.clone(), ..named("a") });
            }
        }
        let kept: Vec<Option<String>> =
            (0..18).map(|_| history.undo(named("b")).backdrop.map(|of| of.pixels.name.clone())).collect();
        let of = |step: usize| (step < 12).then(|| (5 - step / 3).to_string());
        assert_eq!(kept, (0..18).map(of).collect::<Vec<_>>());
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
    fn steps_share_the_strokes_that_they_have_in_common_and_are_restored_as_they_were() {
        let line = |x: f64| Stroke::Line(Line { from: [x, 0.0], to: [x, 9.0], width: 2.0 });
        let drawn = |xs: &[f64]| {
            let layer = Layer { strokes: xs.iter().copied().map(line).collect(), ..Layer::default() };
            let star = Starred { name: "a".to_owned(), document: named("star").document };
            let document = Document { layers: vec![layer], starred: vec![star], ..Document::default() };
            Snapshot { document, ..named("") }
        };
        let sketches = [&[1.0, 2.0][..], &[1.0, 2.0, 3.0], &[1.0, 3.0], &[5.0, 1.0, 4.0]].map(drawn);
        let mut history = History::default();
        sketches.iter().for_each(|sketch| history.push(sketch.clone()));
        let shares = |step: usize, stroke| history.undo[step].shares(&history.undo[step - 1], 0, stroke);
        assert_eq!([(1, 0), (1, 1), (1, 2)].map(|(step, stroke)| shares(step, stroke)), [true, true, false]);
        assert_eq!([(2, 0), (2, 1)].map(|(step, stroke)| shares(step, stroke)), [true, true]);
        assert_eq!([(3, 0), (3, 1), (3, 2)].map(|(step, stroke)| shares(step, stroke)), [false, true, false]);
        for sketch in sketches.iter().rev() {
            assert_eq!(history.undo(named("now")), *sketch);
        }
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
