//! The layers, and how each meets those beneath.

use eframe::egui::Ui;

use crate::app::Window;
use crate::app::action::Action;

/// Shows them.
pub fn layers(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    let _ = (window, actions);
    ui.strong("Layers");
}
