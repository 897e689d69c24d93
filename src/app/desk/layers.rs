//! Layers on the desk: which is at hand, which are frozen, and all that is done to a whole one.

use super::Desk;
use crate::app::shape;
use crate::document::layer_rules::{Beneath, Combination, tidy};
use crate::document::{Kind, Layer, limits};
use crate::editor::selection::{Place, Selection};
use crate::marks::Mark;

impl Desk {
    /// How many of the lowest layers are frozen: their marks are seen, and left alone.
    #[must_use]
    pub fn frozen(&self) -> usize {
        self.frozen
    }

    /// What people call a layer; one without a name is called as in a file.
    #[must_use]
    pub fn layer_name(&self, layer: usize) -> String {
        let name = self.document.layers.get(layer).map_or("", |layer| layer.name.as_str());
        if name.is_empty() { format!("layer {}", layer + 1) } else { name.to_owned() }
    }

    /// The nearest layer beneath that holds something.
    #[must_use]
    pub fn beneath(&self, layer: usize) -> Option<usize> {
        let layers = &self.document.layers;
        (0..layer.min(layers.len())).rev().find(|below| !layers[*below].strokes.is_empty())
    }

    /// Takes a layer to hand; were it frozen, it is so no more, nor are those above it.
    pub fn take_layer(&mut self, layer: usize) {
        if layer < self.document.layers.len() {
            self.layer = layer;
            self.frozen = self.frozen.min(layer);
        }
    }

    /// Freezes the layer at hand, and those beneath, and takes the next to hand: the one above, or a new one.
    pub fn sketch_next(&mut self) {
        let layers = self.document.layers.len();
        // An empty layer is not worth to be frozen.
        if self.document.layers.get(self.layer).is_none_or(|layer| layer.strokes.is_empty()) {
            return;
        }
        if self.layer + 1 == layers {
            self.add_layer();
        } else {
            self.layer += 1;
        }
        self.frozen = self.layer;
        self.selection.clear();
    }

    /// The marks that the hand can work on: not those of frozen layers, nor of hidden ones that are not at hand.
    pub fn reachable(&self) -> impl DoubleEndedIterator<Item = (Place, Mark)> + '_ {
        self.marks().filter(|(place, _)| {
            let shown = self.document.layers[place.layer].visible || place.layer == self.layer;
            place.layer >= self.frozen && shown
        })
    }

    /// The topmost mark of a frozen layer within `reach` px of a point.
    #[must_use]
    pub fn hit_frozen(&self, point: [f64; 2], reach: f64) -> Option<Place> {
        let near = self.marks().rev().filter(|(place, _)| place.layer < self.frozen);
        let near = near.map(|(place, mark)| (place, shape::distance(&mark, point)));
        let near = near.filter(|(_, distance)| *distance <= reach);
        near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(place, _)| place)
    }

    /// Opens an empty layer above the one at hand, and takes it to hand.
    pub fn add_layer(&mut self) {
        self.insert_layer(Layer::default());
    }

    /// Puts a copy of the layer at hand above it, and takes it to hand.
    pub fn duplicate_layer(&mut self) {
        let Some(layer) = self.document.layers.get(self.layer) else { return };
        let mut copy = layer.clone();
        if !copy.name.is_empty() {
            copy.name = format!("{} copy", copy.name).chars().take(limits::MAX_NAME).collect();
        }
        self.insert_layer(copy);
    }

    /// Puts `layer` above the one at hand, and takes it to hand.
    fn insert_layer(&mut self, layer: Layer) {
        let layers = self.document.layers.len();
        if layers >= limits::MAX_LAYERS {
            return;
        }
        let at = (self.layer + 1).min(layers);
        self.selection.clear();
        self.edit(|document| document.layers.insert(at, layer));
        self.layer = at;
    }

    /// Takes a layer away, marks and all.
    pub fn delete_layer(&mut self, layer: usize) {
        if layer >= self.document.layers.len() {
            return;
        }
        let selection = self.selection.moved(|of| match of.cmp(&layer) {
            std::cmp::Ordering::Less => Some(of),
            std::cmp::Ordering::Equal => None,
            std::cmp::Ordering::Greater => Some(of - 1),
        });
        self.edit(|document| drop(document.layers.remove(layer)));
        self.selection = selection;
        self.layer -= usize::from(layer < self.layer);
        self.layer = self.layer.min(self.document.layers.len().saturating_sub(1));
        self.frozen -= usize::from(layer < self.frozen);
        self.frozen = self.frozen.min(self.layer);
    }

    /// Moves a layer to another place among the others; the one at hand stays at hand.
    pub fn move_layer(&mut self, from: usize, to: usize) {
        let layers = self.document.layers.len();
        if from >= layers || to >= layers || from == to {
            return;
        }
        let place = |of: usize| match of {
            _ if of == from => to,
            _ if from < of && of <= to => of - 1,
            _ if to <= of && of < from => of + 1,
            _ => of,
        };
        let selection = self.selection.moved(|of| Some(place(of)));
        self.edit(|document| {
            let layer = document.layers.remove(from);
            document.layers.insert(to, layer);
        });
        self.selection = selection;
        self.layer = place(self.layer);
        // What lies above another than before grows anew.
        self.frozen = self.frozen.min(from).min(to).min(self.layer);
    }

    /// Changes one layer; what it says beyond that and what does not go with it any more goes back to its default.
    pub fn change_layer(&mut self, layer: usize, change: impl FnOnce(&mut Layer)) {
        let kind = self.kind(layer);
        self.edit(|document| {
            if let Some(layer) = document.layers.get_mut(layer) {
                change(layer);
                tidy(layer, kind);
            }
        });
    }

    /// Shows a layer, or hides it.
    pub fn show_layer(&mut self, layer: usize, visible: bool) {
        self.change_layer(layer, |layer| layer.visible = visible);
        if !visible && layer != self.layer {
            let held = self.selection.places().filter(|place| place.layer != layer).collect::<Vec<_>>();
            self.selection = Selection::of(held);
        }
    }

    /// Does a layer take marks of `kind`? What it holds, its system and how it meets those beneath say so.
    pub(super) fn takes(&self, layer: usize, kind: Kind) -> bool {
        let Some(of) = self.document.layers.get(layer).filter(|_| layer >= self.frozen) else { return false };
        Combination::new(of, self.kind(layer), Beneath::Unknown).takes(kind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{After, Document, SystemChoice};
    use crate::marks::{Ellipse, Line};

    fn spot(x: f64) -> Mark {
        Mark::Ellipse(Ellipse { center: [x, 50.0], radii: [12.0, 8.0], angle: 0.0 })
    }

    fn line(y: f64) -> Mark {
        Mark::Line(Line { from: [10.0, y], to: [200.0, y], width: 6.0 })
    }

    /// One spot in each of three layers, at 10, 20, 30 px; the highest is at hand.
    fn three() -> Desk {
        let mut desk = Desk::open(Document::default(), None);
        for x in [10.0, 20.0, 30.0] {
            desk.add_layer();
            desk.add(&[spot(x)]);
        }
        desk.commit();
        desk
    }

    /// Where the spots stand, layer by layer, px.
    fn places(desk: &Desk) -> Vec<f64> {
        desk.marks().map(|(_, mark)| mark.center()[0]).collect()
    }

    #[test]
    fn a_layer_that_moves_takes_its_selection_along_and_stays_at_hand() {
        let mut desk = three();
        desk.move_layer(2, 0);
        assert_eq!(places(&desk), [30.0, 10.0, 20.0]);
        assert_eq!(desk.layer, 0);
        assert_eq!(desk.selected().map(|(_, mark)| mark.center()[0]).collect::<Vec<_>>(), [30.0]);
        desk.move_layer(1, 2);
        assert_eq!(places(&desk), [30.0, 20.0, 10.0]);
        assert_eq!(desk.layer, 0);
    }

    #[test]
    fn undoing_brings_the_layer_back_to_hand_that_was() {
        let mut desk = three();
        desk.take_layer(0);
        desk.commit();
        desk.delete_layer(0);
        assert_eq!(places(&desk), [20.0, 30.0]);
        assert_eq!(desk.layer, 0);
        desk.take_layer(1);
        desk.undo();
        assert_eq!((places(&desk), desk.layer), (vec![10.0, 20.0, 30.0], 0));
    }

    #[test]
    fn a_copy_lies_above_what_was_copied() {
        let mut desk = three();
        desk.take_layer(0);
        desk.change_layer(0, |layer| layer.name = "spots".to_owned());
        desk.duplicate_layer();
        assert_eq!(places(&desk), [10.0, 10.0, 20.0, 30.0]);
        assert_eq!((desk.layer, desk.layer_name(1).as_str()), (1, "spots copy"));
    }

    #[test]
    fn a_frozen_layer_is_left_alone_until_it_is_taken_to_hand() {
        let mut desk = Desk::open(Document::default(), None);
        desk.add(&[spot(40.0)]);
        desk.sketch_next();
        assert_eq!((desk.layer, desk.frozen()), (1, 1));
        desk.add(&[spot(80.0)]);
        assert_eq!(desk.marks_of(0).len(), 1);
        assert_eq!(desk.hit([40.0, 50.0], 5.0), None);
        assert_eq!(desk.hit_frozen([40.0, 50.0], 5.0), Some(Place { layer: 0, stroke: 0 }));
        assert_eq!(desk.reachable().count(), 1);
        desk.take_layer(0);
        assert_eq!(desk.frozen(), 0);
        assert!(desk.hit([40.0, 50.0], 5.0).is_some());
    }

    #[test]
    fn freezing_an_empty_layer_opens_no_other() {
        let mut desk = Desk::open(Document::default(), None);
        desk.sketch_next();
        assert!(desk.document().layers.is_empty());
        desk.add(&[spot(40.0)]);
        desk.sketch_next();
        desk.sketch_next();
        assert_eq!((desk.document().layers.len(), desk.layer), (2, 1));
    }

    #[test]
    fn a_layer_that_rings_takes_lines_alone() {
        let mut desk = Desk::open(Document::default(), None);
        desk.add(&[spot(40.0)]);
        desk.sketch_next();
        desk.change_layer(1, |layer| layer.after = After::Around);
        desk.add(&[spot(90.0)]);
        assert_eq!(desk.marks_of(1), []);
        desk.take_layer(1);
        desk.add(&[line(20.0)]);
        assert_eq!(desk.marks_of(1), [line(20.0)]);
    }

    #[test]
    fn the_lowest_layer_that_holds_something_is_saved_as_one_that_meets_nothing() {
        let mut desk = Desk::open(Document::default(), None);
        desk.add(&[spot(40.0)]);
        desk.sketch_next();
        desk.change_layer(1, |layer| layer.after = After::Around);
        desk.change_layer(1, |layer| layer.options.broken = 0.3);
        desk.add(&[line(20.0)]);
        desk.finished().check("rings").unwrap();
        assert_eq!(desk.finished().layers[1].options.broken, 0.3);
        desk.take_layer(0);
        desk.remove(&[Place { layer: 0, stroke: 0 }]);
        let finished = desk.finished();
        assert_eq!((finished.layers[0].after, finished.layers[0].options.broken), (After::Between, 0.0));
        finished.check("what is left").unwrap();
        // On the desk it still is what it was.
        assert_eq!(desk.document().layers[1].after, After::Around);
    }

    #[test]
    fn what_does_not_go_with_a_choice_goes_back_to_its_default() {
        let mut desk = Desk::open(Document::default(), None);
        desk.add(&[spot(40.0)]);
        desk.change_layer(0, |layer| layer.options.irregular = 0.7);
        desk.change_layer(0, |layer| layer.system = SystemChoice::MeinhardtSpots);
        assert_eq!(desk.document().layers[0].options.irregular, 0.0);
        desk.undo();
        assert!(desk.document().layers.is_empty());
    }
}
