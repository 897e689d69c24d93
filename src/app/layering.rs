//! Layer operations in the window: the state of the layer panel, and asking for a layer's name.

use crate::app::window::Window;
use crate::editor::layer_action::LayerAction;

/// What the layer panel remembers from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct Layering {
    /// The layer whose name is being typed, and the name so far.
    pub naming: Option<(usize, String)>,
    /// Whether the settings of the active layer are unfolded.
    pub unfolded: bool,
    /// Whether the row of that layer had the keyboard focus and shall get it back.
    pub from_row: bool,
}

impl Layering {
    /// Another document was opened.
    pub fn forget(&mut self) {
        self.naming = None;
    }
}

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
        self.layering.naming = (action == LayerAction::Rename).then(|| (active, name()));
    }
}
