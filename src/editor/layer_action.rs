//! Operations on layers, for menus and keys.

use crate::document::limits;
use crate::editor::session::Session;

/// An operation on the active layer, or on another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LayerAction {
    /// Add an empty layer above the active one.
    Add,
    /// Freeze the active layer and those beneath it, and make the next one active.
    SketchNext,
    /// Make this layer active; a frozen one stays frozen.
    Select(usize),
    /// Unfreeze the active layer and those above it.
    Unfreeze,
    /// Make this layer active, and unfreeze it and those above it.
    UnfreezeThis(usize),
    /// Make the layer above (1) or beneath (−1) active.
    Step(isize),
    /// Move the active layer up (1) or down (−1).
    Shift(isize),
    /// Move a layer to another index.
    Move(usize, usize),
    /// Add a copy of the active layer above it.
    Duplicate,
    /// Hide or show the active layer.
    Hide,
    /// Hide or show this layer.
    HideThis(usize),
    /// Ask for the name of the active layer.
    Rename,
    /// Delete the active layer.
    Delete,
    /// Move the small spots of this layer to a new layer above it.
    SplitBySize(usize),
    /// Move the lines of this layer that cross others to a new layer above it.
    SplitCrossings(usize),
}

impl LayerAction {
    /// The entries of the menu, in order.
    pub const MENU: [(&'static str, Self); 11] = [
        ("New layer", Self::Add),
        ("Freeze layer and start the next", Self::SketchNext),
        ("Unfreeze layer", Self::Unfreeze),
        ("Duplicate layer", Self::Duplicate),
        ("Rename layer", Self::Rename),
        ("Hide or show layer", Self::Hide),
        ("Raise layer", Self::Shift(1)),
        ("Lower layer", Self::Shift(-1)),
        ("Select layer above", Self::Step(1)),
        ("Select layer below", Self::Step(-1)),
        ("Delete layer", Self::Delete),
    ];
}

impl Session {
    /// Whether an operation is possible now.
    #[must_use]
    pub fn allows(&self, action: LayerAction) -> bool {
        let layers = self.document().layers.len();
        let is_any = self.active_layer < layers;
        match action {
            LayerAction::Add => layers < limits::MAX_LAYERS,
            LayerAction::SketchNext => is_any && !self.document().layers[self.active_layer].is_blank(),
            LayerAction::Select(layer) | LayerAction::HideThis(layer) => layer < layers,
            LayerAction::Unfreeze => self.is_active_frozen(),
            LayerAction::UnfreezeThis(layer) => layer < self.frozen(),
            LayerAction::Step(by) => {
                is_any && self.active_layer.checked_add_signed(by).is_some_and(|to| to < layers)
            }
            LayerAction::Shift(by) => {
                let to = self.active_layer.checked_add_signed(by);
                to.is_some_and(|to| self.allows(LayerAction::Move(self.active_layer, to)))
            }
            // Frozen layers keep their order.
            LayerAction::Move(from, to) => {
                let movable = self.frozen()..layers;
                movable.contains(&from) && movable.contains(&to)
            }
            LayerAction::Duplicate => is_any && layers < limits::MAX_LAYERS,
            LayerAction::Hide | LayerAction::Rename => is_any,
            LayerAction::Delete => is_any && !self.is_active_frozen(),
            LayerAction::SplitBySize(layer) => {
                layer >= self.frozen() && layers < limits::MAX_LAYERS && self.has_two_sizes(layer)
            }
            LayerAction::SplitCrossings(layer) => {
                let can_split = layer >= self.frozen() && layers < limits::MAX_LAYERS;
                can_split && !self.crossing_strokes(layer).is_empty()
            }
        }
    }

    /// Carries out an operation; does nothing where it is not possible. Renaming, which asks for the name first, is
    /// left to the caller.
    pub fn apply(&mut self, action: LayerAction) {
        if !self.allows(action) {
            return;
        }
        let active = self.active_layer;
        match action {
            LayerAction::Add => self.add_layer(),
            LayerAction::SketchNext => self.sketch_next(),
            LayerAction::Select(layer) => self.select_layer(layer),
            LayerAction::Unfreeze => self.unfreeze_layer(active),
            LayerAction::UnfreezeThis(layer) => self.unfreeze_layer(layer),
            LayerAction::Step(by) => self.select_layer(active.saturating_add_signed(by)),
            LayerAction::Shift(by) => self.move_layer(active, active.saturating_add_signed(by)),
            LayerAction::Move(from, to) => self.move_layer(from, to),
            LayerAction::Duplicate => self.duplicate_layer(),
            LayerAction::Hide => self.hide_or_show(active),
            LayerAction::HideThis(layer) => self.hide_or_show(layer),
            LayerAction::Rename => {}
            LayerAction::Delete => self.delete_layer(active),
            LayerAction::SplitBySize(layer) => self.split_by_size(layer),
            LayerAction::SplitCrossings(layer) => self.split_crossings(layer),
        }
    }

    fn hide_or_show(&mut self, layer: usize) {
        let visible = self.document().layers[layer].visible;
        self.show_layer(layer, !visible);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;

    #[test]
    fn impossible_actions_change_nothing() {
        let mut session = Session::open(Document::default(), None);
        for (_, action) in LayerAction::MENU.into_iter().filter(|(_, action)| *action != LayerAction::Add) {
            assert!(!session.allows(action), "{action:?}");
            session.apply(action);
            assert!(session.document().layers.is_empty(), "{action:?}");
        }
        for _ in 0..=limits::MAX_LAYERS {
            session.apply(LayerAction::Add);
        }
        assert_eq!(session.document().layers.len(), limits::MAX_LAYERS);
        session.apply(LayerAction::Step(1));
        assert_eq!(session.active_layer, limits::MAX_LAYERS - 1);
        session.apply(LayerAction::Hide);
        assert!(!session.document().layers[limits::MAX_LAYERS - 1].visible);
    }
}
