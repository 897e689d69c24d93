//! Operations on layers, and asking for a layer's name.

use super::Window;
use crate::editor::layer_action::LayerAction;

impl Window {
    /// Carries out an operation on layers, where it is possible.
    pub(super) fn layer(&mut self, action: LayerAction) {
        let session = &mut self.session;
        if !session.allows(action) {
            return;
        }
        let active = session.active_layer;
        session.apply(action);
        let name = || session.document().layers[active].name.clone();
        self.layers.naming = (action == LayerAction::Rename).then(|| (active, name()));
    }
}
