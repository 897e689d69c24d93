//! The colours of the layer at hand.

use eframe::egui::Ui;

use crate::app::Window;
use crate::app::action::Action;

/// Shows them.
pub fn colour(ui: &mut Ui, window: &mut Window, actions: &mut Vec<Action>) {
    let _ = (window, actions);
    ui.strong("Colour");
}
