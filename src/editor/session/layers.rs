//! Layers of the open document: which is active, which are frozen, and operations on whole layers.

use crate::document::layer_rules::{Beneath, Combination, tidy};
use crate::document::{Kind, Layer, limits};
use crate::editor::selection::{Place, Selection};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::Mark;

impl Session {
    /// How many of the lowest layers are frozen: their marks are shown and cannot be edited.
    #[must_use]
    pub fn frozen(&self) -> usize {
        self.frozen
    }

    /// The name of a layer; an unnamed one has the name that it gets in the file.
    #[must_use]
    pub fn layer_name(&self, layer: usize) -> String {
        let name = self.document.layers.get(layer).map_or("", |layer| layer.name.as_str());
        if name.is_empty() { format!("layer {}", layer + 1) } else { name.to_owned() }
    }

    /// The nearest layer beneath that is not empty.
    #[must_use]
    pub fn beneath(&self, layer: usize) -> Option<usize> {
        let layers = &self.document.layers;
        (0..layer.min(layers.len())).rev().find(|below| !layers[*below].is_blank())
    }

    /// Whether the active layer is frozen: nothing can be drawn there.
    #[must_use]
    pub fn is_active_frozen(&self) -> bool {
        self.active_layer < self.frozen
    }

    /// Makes a layer the active one; a frozen one stays frozen.
    pub fn select_layer(&mut self, layer: usize) {
        if layer < self.document.layers.len() {
            self.active_layer = layer;
            if self.is_active_frozen() {
                self.selection.clear();
            }
        }
    }

    /// Makes a layer the active one, and unfreezes it and the layers above it.
    pub fn unfreeze_layer(&mut self, layer: usize) {
        if layer < self.document.layers.len() {
            self.active_layer = layer;
            self.frozen = self.frozen.min(layer);
        }
    }

    /// Freezes the active layer and those beneath it. The lowest layer that is not frozen becomes active; if there is
    /// none, a new one is added. Does nothing when the active layer is empty.
    pub fn sketch_next(&mut self) {
        if self.document.layers.get(self.active_layer).is_none_or(Layer::is_blank) {
            return;
        }
        let next = self.frozen.max(self.active_layer + 1);
        if next >= self.document.layers.len() {
            self.active_layer = self.document.layers.len() - 1;
            self.add_layer();
        } else {
            self.active_layer = next;
        }
        self.frozen = self.active_layer;
        self.selection.clear();
    }

    /// The marks that can be edited: not those of frozen layers, nor of hidden layers other than the active one.
    pub fn editable_marks(&self) -> impl DoubleEndedIterator<Item = (Place, Mark)> + '_ {
        self.marks().filter(|(place, _)| {
            let shown = self.document.layers[place.layer].visible || place.layer == self.active_layer;
            place.layer >= self.frozen && shown
        })
    }

    /// The mark of a frozen layer nearest to a point, at most `reach` px away.
    #[must_use]
    pub fn hit_frozen(&self, point: [f64; 2], reach: f64) -> Option<Place> {
        let near = self.marks().rev().filter(|(place, _)| place.layer < self.frozen);
        let near = near.map(|(place, mark)| (place, shape::distance(&mark, point)));
        let near = near.filter(|(_, distance)| *distance <= reach);
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(place, _)| place)
    }

    /// Adds an empty layer above the active one and makes it active.
    pub fn add_layer(&mut self) {
        self.insert_layer(Layer::default());
    }

    /// Adds a copy of the active layer above it and makes it active.
    pub fn duplicate_layer(&mut self) {
        let Some(layer) = self.document.layers.get(self.active_layer) else { return };
        let mut copy = layer.clone();
        if !copy.name.is_empty() {
            copy.name = format!("{} copy", copy.name).chars().take(limits::MAX_NAME).collect();
        }
        self.insert_layer(copy);
    }

    /// Adds `layer` above the active one and makes it active.
    fn insert_layer(&mut self, layer: Layer) {
        let layers = self.document.layers.len();
        if layers >= limits::MAX_LAYERS {
            return;
        }
        // Frozen layers stay together.
        let at = (self.active_layer + 1).max(self.frozen).min(layers);
        self.selection.clear();
        self.edit(|document| document.layers.insert(at, layer));
        self.active_layer = at;
    }

    /// Deletes a layer with its marks.
    pub fn delete_layer(&mut self, layer: usize) {
        if layer >= self.document.layers.len() {
            return;
        }
        let selection = self.selection.with_layers_moved(|index| match index.cmp(&layer) {
            std::cmp::Ordering::Less => Some(index),
            std::cmp::Ordering::Equal => None,
            std::cmp::Ordering::Greater => Some(index - 1),
        });
        self.edit(|document| drop(document.layers.remove(layer)));
        self.selection = selection;
        self.active_layer -= usize::from(layer < self.active_layer);
        self.active_layer = self.active_layer.min(self.document.layers.len().saturating_sub(1));
        self.frozen -= usize::from(layer < self.frozen);
        // There is always a layer to draw on.
        self.frozen = self.frozen.min(self.document.layers.len().saturating_sub(1));
    }

    /// Moves a layer to another index; the active layer stays active.
    pub fn move_layer(&mut self, from: usize, to: usize) {
        let layers = self.document.layers.len();
        if from >= layers || to >= layers || from == to {
            return;
        }
        let new_index = |index: usize| match index {
            _ if index == from => to,
            _ if from < index && index <= to => index - 1,
            _ if to <= index && index < from => index + 1,
            _ => index,
        };
        let selection = self.selection.with_layers_moved(|index| Some(new_index(index)));
        self.edit(|document| {
            let layer = document.layers.remove(from);
            document.layers.insert(to, layer);
        });
        self.selection = selection;
        self.active_layer = new_index(self.active_layer);
        // A layer that now lies on another layer than before has to grow again.
        self.frozen = self.frozen.min(from).min(to);
    }

    /// Changes one layer, then resets its settings that are no longer allowed together.
    pub fn change_layer(&mut self, layer: usize, change: impl FnOnce(&mut Layer)) {
        let kind = self.kind(layer);
        self.edit(|document| {
            if let Some(layer) = document.layers.get_mut(layer) {
                change(layer);
                tidy(layer, kind);
            }
        });
    }

    /// Shows or hides a layer. The marks of a hidden layer that is not active are deselected.
    pub fn show_layer(&mut self, layer: usize, visible: bool) {
        self.change_layer(layer, |layer| layer.visible = visible);
        if !visible && layer != self.active_layer {
            let kept: Vec<Place> = self.selection.places().filter(|place| place.layer != layer).collect();
            self.selection = Selection::new(kept);
        }
    }

    /// Whether marks of `kind` do not belong on the active layer, because of its relation to the layers beneath.
    #[must_use]
    pub fn is_out_of_place(&self, kind: Kind) -> bool {
        let active = self.document.layers.get(self.active_layer);
        active.is_some_and(|layer| !layer.after.keeps_away()) && !self.accepts(self.active_layer, kind)
    }

    /// Whether a layer accepts marks of `kind`. This depends on its marks, its system and its `after`.
    pub(super) fn accepts(&self, layer: usize, kind: Kind) -> bool {
        let Some(settings) = self.document.layers.get(layer).filter(|_| layer >= self.frozen) else {
            return false;
        };
        Combination::new(settings, self.kind(layer), Beneath::Unknown).takes(kind)
    }
}

#[cfg(test)]
mod tests {
    use crate::document::{After, Document, SystemChoice};
    use crate::editor::session::layers::*;
    use crate::marks::{Ellipse, Line};
    use crate::rd::System;

    fn spot(x: f64) -> Mark {
        Mark::Ellipse(Ellipse { center: [x, 50.0], radii: [12.0, 8.0], angle: 0.0 })
    }

    fn line(y: f64) -> Mark {
        Mark::Line(Line { from: [10.0, y], to: [200.0, y], width: 6.0 })
    }

    /// One spot in each of three layers, at 10, 20, 30 px; the highest layer is active.
    fn three_layers() -> Session {
        let mut session = Session::open(Document::default(), None);
        for x in [10.0, 20.0, 30.0] {
            session.add_layer();
            session.add(&[spot(x)]);
        }
        session.commit();
        session
    }

    /// The x coordinates of the spots, layer by layer, px.
    fn positions(session: &Session) -> Vec<f64> {
        session.marks().map(|(_, mark)| mark.center()[0]).collect()
    }

    #[test]
    fn a_moved_layer_keeps_its_selection_and_stays_active() {
        let mut session = three_layers();
        session.move_layer(2, 0);
        assert_eq!(positions(&session), [30.0, 10.0, 20.0]);
        assert_eq!(session.active_layer, 0);
        assert_eq!(session.selected().map(|(_, mark)| mark.center()[0]).collect::<Vec<_>>(), [30.0]);
        session.move_layer(1, 2);
        assert_eq!(positions(&session), [30.0, 20.0, 10.0]);
        assert_eq!(session.active_layer, 0);
    }

    #[test]
    fn undo_restores_the_active_layer() {
        let mut session = three_layers();
        session.unfreeze_layer(0);
        session.commit();
        session.delete_layer(0);
        assert_eq!(positions(&session), [20.0, 30.0]);
        assert_eq!(session.active_layer, 0);
        session.unfreeze_layer(1);
        session.undo();
        assert_eq!((positions(&session), session.active_layer), (vec![10.0, 20.0, 30.0], 0));
    }

    #[test]
    fn a_copy_of_a_layer_is_added_above_it() {
        let mut session = three_layers();
        session.unfreeze_layer(0);
        session.change_layer(0, |layer| layer.name = "spots".to_owned());
        session.duplicate_layer();
        assert_eq!(positions(&session), [10.0, 10.0, 20.0, 30.0]);
        assert_eq!((session.active_layer, session.layer_name(1).as_str()), (1, "spots copy"));
    }

    #[test]
    fn a_frozen_layer_is_not_editable_until_it_is_unfrozen() {
        let mut session = Session::open(Document::default(), None);
        session.add(&[spot(40.0)]);
        session.sketch_next();
        assert_eq!((session.active_layer, session.frozen()), (1, 1));
        session.add(&[spot(80.0)]);
        assert_eq!(session.marks_of(0).len(), 1);
        assert_eq!(session.hit([40.0, 50.0], 5.0), None);
        assert_eq!(session.hit_frozen([40.0, 50.0], 5.0), Some(Place { layer: 0, stroke: 0 }));
        assert_eq!(session.editable_marks().count(), 1);
        session.select_layer(0);
        assert_eq!((session.active_layer, session.frozen()), (0, 1));
        session.unfreeze_layer(0);
        assert_eq!(session.frozen(), 0);
        assert!(session.hit([40.0, 50.0], 5.0).is_some());
    }

    #[test]
    fn freezing_goes_on_with_the_lowest_layer_that_is_not_frozen() {
        let mut session = three_layers();
        session.select_layer(1);
        session.sketch_next();
        session.select_layer(0);
        session.sketch_next();
        assert_eq!((session.active_layer, session.frozen()), (2, 2));
    }

    #[test]
    fn freezing_an_empty_layer_adds_no_layer() {
        let mut session = Session::open(Document::default(), None);
        session.sketch_next();
        assert!(session.document().layers.is_empty());
        session.add(&[spot(40.0)]);
        session.sketch_next();
        session.sketch_next();
        assert_eq!((session.document().layers.len(), session.active_layer), (2, 1));
    }

    #[test]
    fn a_layer_of_rings_accepts_lines_only() {
        let mut session = Session::open(Document::default(), None);
        session.add(&[spot(40.0)]);
        session.sketch_next();
        session.change_layer(1, |layer| layer.after = After::Around);
        session.add(&[spot(90.0)]);
        assert_eq!(session.marks_of(1), []);
        session.unfreeze_layer(1);
        session.add(&[line(20.0)]);
        assert_eq!(session.marks_of(1), [line(20.0)]);
    }

    #[test]
    fn the_lowest_layer_is_saved_without_a_relation_to_one_beneath() {
        let mut session = Session::open(Document::default(), None);
        session.add(&[spot(40.0)]);
        session.sketch_next();
        session.change_layer(1, |layer| layer.after = After::Around);
        session.change_layer(1, |layer| layer.options.broken = 0.3);
        session.add(&[line(20.0)]);
        session.finished().check("rings").unwrap();
        assert_eq!(session.finished().layers[1].options.broken, 0.3);
        session.unfreeze_layer(0);
        session.remove(&[Place { layer: 0, stroke: 0 }]);
        let finished = session.finished();
        assert_eq!((finished.layers[0].after, finished.layers[0].options.broken), (After::Between, 0.0));
        finished.check("what is left").unwrap();
        // The session itself has not changed.
        assert_eq!(session.document().layers[1].after, After::Around);
    }

    #[test]
    fn settings_that_a_new_system_does_not_allow_are_reset() {
        let mut session = Session::open(Document::default(), None);
        session.add(&[spot(40.0)]);
        session.change_layer(0, |layer| layer.options.irregular = 0.7);
        session
            .change_layer(0, |layer| layer.system = SystemChoice::Of(System::MEINHARDT_SPOTS.description()));
        assert_eq!(session.document().layers[0].options.irregular, 0.0);
        session.undo();
        assert!(session.document().layers.is_empty());
    }
}
