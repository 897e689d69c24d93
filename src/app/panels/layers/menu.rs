//! The menu of a layer.

use egui::Response;

use crate::app::action::Action;
use crate::app::panels::entries::Entries;
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;

/// Shows it where it was asked for on the row of a layer, which becomes the active one.
pub(super) fn layer_menu(row: &Response, session: &Session, layer: usize, actions: &mut Vec<Action>) {
    if row.secondary_clicked() {
        actions.push(Action::Layer(LayerAction::Select(layer)));
    }
    row.context_menu(|ui| {
        ui.set_min_width(240.0);
        let mut entries = Entries::new(actions);
        // Until the layer is the active one, its entries would act on another.
        let is_active = session.active_layer == layer;
        for (text, action) in LayerAction::MENU {
            if matches!(action, LayerAction::Duplicate | LayerAction::Shift(1) | LayerAction::Delete) {
                ui.separator();
            }
            if !matches!(action, LayerAction::Step(_)) {
                let can = is_active && session.allows(action);
                entries.item(ui, text, &Action::Layer(action), can);
            }
        }
        entries.navigate(ui, false);
    });
}
