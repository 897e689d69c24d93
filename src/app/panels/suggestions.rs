//! Options that would help a drawing, each in one sentence with a button that takes it.

use egui::{Button, RichText, Ui};

use crate::app::action::Action;
use crate::app::canvas::Canvas;
use crate::editor::edit::Edit;
use crate::editor::session::Session;

/// Shows them.
pub fn suggestions(ui: &mut Ui, session: &Session, canvas: &Canvas) -> Vec<Action> {
    let mut actions = Vec::new();
    for (layer, one) in &canvas.analysis.suggestions {
        let Some(of) = session.document().layers.get(*layer) else { continue };
        ui.label(RichText::new(format!("{}: {}", session.layer_name(*layer), one.why())).weak());
        let can = *layer >= session.frozen();
        let help = "An option of How it grows. Can be undone.";
        if ui.add_enabled(can, Button::new(one.button())).on_hover_text(help).clicked() {
            actions.push(Action::Edit(Edit::LayerOptions(*layer, one.with(of.options))));
        }
    }
    actions
}
