//! What one can do with layers, by whatever button, menu or key.

use crate::app::desk::Desk;
use crate::app::window::Window;
use crate::document::limits;

/// Something to be done to the layer at hand, or to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LayerAction {
    /// Open an empty layer above.
    Add,
    /// Freeze it, and those beneath, and sketch the next.
    SketchNext,
    /// Take this one to hand.
    Take(usize),
    /// Take the one above (1) or beneath (−1) to hand.
    Step(isize),
    /// Move it up (1) or down (−1).
    Shift(isize),
    /// Move one layer to the place of another.
    Move(usize, usize),
    /// Put a copy above.
    Duplicate,
    /// Hide it, or show it again.
    Hide,
    /// Hide this one, or show it again.
    HideThis(usize),
    /// Give it a name.
    Rename,
    /// Take it away.
    Delete,
}

impl LayerAction {
    /// Those of the menu, as they stand there.
    pub const MENU: [(&'static str, Self); 10] = [
        ("New layer", Self::Add),
        ("Freeze it, sketch the next", Self::SketchNext),
        ("Duplicate layer", Self::Duplicate),
        ("Name layer", Self::Rename),
        ("Hide or show layer", Self::Hide),
        ("Raise layer", Self::Shift(1)),
        ("Lower layer", Self::Shift(-1)),
        ("Take the layer above", Self::Step(1)),
        ("Take the layer beneath", Self::Step(-1)),
        ("Delete layer", Self::Delete),
    ];
}

/// What the panel of layers remembers.
#[derive(Clone, Debug, Default)]
pub struct Layering {
    /// The layer that is being named, and its name so far.
    pub naming: Option<(usize, String)>,
    /// Are the details of the layer at hand unfolded?
    pub unfolded: bool,
    /// Did the row of the layer that is named have the keys, and shall have them again?
    pub from_row: bool,
}

impl Layering {
    /// Another document is on the desk.
    pub fn forget(&mut self) {
        self.naming = None;
    }
}

impl Desk {
    /// Can this be done as things are?
    #[must_use]
    pub fn allows(&self, action: LayerAction) -> bool {
        let layers = self.document().layers.len();
        let there = self.layer < layers;
        match action {
            LayerAction::Add => layers < limits::MAX_LAYERS,
            LayerAction::SketchNext => there && self.kind(self.layer).is_some(),
            LayerAction::Take(layer) | LayerAction::HideThis(layer) => layer < layers,
            LayerAction::Step(by) | LayerAction::Shift(by) => {
                there && self.layer.checked_add_signed(by).is_some_and(|to| to < layers)
            }
            LayerAction::Move(from, to) => from < layers && to < layers,
            LayerAction::Duplicate => there && layers < limits::MAX_LAYERS,
            LayerAction::Hide | LayerAction::Rename | LayerAction::Delete => there,
        }
    }
}

impl Window {
    /// Does it, where it can be done.
    pub(super) fn layer(&mut self, action: LayerAction) {
        let desk = &mut self.desk;
        if !desk.allows(action) {
            return;
        }
        let at_hand = desk.layer;
        match action {
            LayerAction::Add => desk.add_layer(),
            LayerAction::SketchNext => desk.sketch_next(),
            LayerAction::Take(layer) => desk.take_layer(layer),
            LayerAction::Step(by) => desk.take_layer(at_hand.saturating_add_signed(by)),
            LayerAction::Shift(by) => desk.move_layer(at_hand, at_hand.saturating_add_signed(by)),
            LayerAction::Move(from, to) => desk.move_layer(from, to),
            LayerAction::Duplicate => desk.duplicate_layer(),
            LayerAction::Hide => hide(desk, at_hand),
            LayerAction::HideThis(layer) => hide(desk, layer),
            LayerAction::Rename => {
                self.layering.naming = Some((at_hand, desk.document().layers[at_hand].name.clone()));
            }
            LayerAction::Delete => desk.delete_layer(at_hand),
        }
        if action != LayerAction::Rename {
            self.layering.naming = None;
        }
    }
}

fn hide(desk: &mut Desk, layer: usize) {
    let visible = desk.document().layers[layer].visible;
    desk.show_layer(layer, !visible);
}
