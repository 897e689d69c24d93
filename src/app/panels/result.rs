//! What was asked and what has grown.

use eframe::egui::Ui;

use crate::app::Window;
use crate::app::action::Action;

/// Shows them.
pub fn result(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    let _ = (window, actions);
    ui.strong("Result");
}
