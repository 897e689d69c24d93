//! The menu of the selected marks, or of the canvas where none is selected.

use egui::{Popup, PopupKind, Pos2, SetOpenCommand, Ui};

use super::entries::Entries;
use super::menu::clipboard;
use crate::app::action::{Action, WIDER};
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;

/// Shows the menu at a place of the screen while it is open; `opens`: it opens in this frame. Returns the actions, and
/// whether its first entry could get the keyboard focus (`None` once the menu is closed).
pub fn context_menu(ui: &mut Ui, at: Pos2, opens: bool, session: &Session) -> (Vec<Action>, Option<bool>) {
    let mut actions = Vec::new();
    let id = egui::Id::unique("context menu");
    let popup = Popup::new(id, ui.ctx().clone(), at, ui.layer_id()).kind(PopupKind::Menu);
    let popup = popup.style(egui::containers::menu::menu_style).gap(0.0);
    let popup = popup.layout(egui::Layout::top_down_justified(egui::Align::Min));
    let shown = popup.open_memory(opens.then_some(SetOpenCommand::Bool(true))).show(|ui| {
        ui.set_min_width(210.0);
        let mut entries = Entries::new(&mut actions);
        content(ui, session, &mut entries);
        entries.navigate(ui, opens)
    });
    (actions, shown.map(|shown| shown.inner))
}

fn content(ui: &mut Ui, session: &Session, entries: &mut Entries) {
    let some = !session.selection.is_empty();
    clipboard(ui, some, entries);
    ui.separator();
    if some {
        entries.item(ui, "Wider or larger", &Action::Widen(WIDER), true);
        entries.item(ui, "Narrower or smaller", &Action::Widen(1.0 / WIDER), true);
        entries.item(ui, "Turn by 5°", &Action::Turn(5.0), true);
        entries.item(ui, "Turn back by 5°", &Action::Turn(-5.0), true);
        ui.separator();
        let several = session.selection.len() > 1;
        entries.item(ui, "Align in a row", &Action::Align(1), several);
        entries.item(ui, "Align in a column", &Action::Align(0), several);
        let many = session.selection.len() > 2;
        entries.item(ui, "Space evenly across", &Action::Distribute(0), many);
        entries.item(ui, "Space evenly down", &Action::Distribute(1), many);
    } else {
        entries.item(ui, "Select all", &Action::SelectAll, true);
        let next = LayerAction::SketchNext;
        entries.item(ui, "Freeze layer and start the next", &Action::Layer(next), session.allows(next));
        ui.separator();
        entries.item(ui, "Show the whole canvas", &Action::Fit, true);
        entries.item(ui, "Actual size", &Action::ActualSize, true);
    }
}
