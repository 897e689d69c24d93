//! Above the canvas: what is seen of it.

use egui::{Align, Layout, Ui};

use crate::app::Window;
use crate::app::action::Action;
use crate::app::icons::Icon;

/// The bar. Gives what is chosen.
pub fn sketch_bar(ui: &mut Ui, window: &Window) -> Vec<Action> {
    let mut actions = Vec::new();
    ui.horizontal_centered(|ui| {
        ui.strong("Sketch");
        let marks = window.session.marks().count();
        ui.weak(match marks {
            0 => String::new(),
            1 => "1 mark".to_owned(),
            marks => format!("{marks} marks"),
        });
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let over = window.over;
            let help = "Texture over the sketch, with a curtain to drag";
            if Icon::Over.button(ui, "One over the other", over).on_hover_text(help).clicked() {
                actions.push(Action::Over(true));
            }
            if Icon::Beside
                .button(ui, "Side by side", !over)
                .on_hover_text("Sketch beside the texture")
                .clicked()
            {
                actions.push(Action::Over(false));
            }
            let fit = "Show the whole canvas";
            if Icon::Fit.button(ui, fit, false).on_hover_text(format!("{fit} (Ctrl+0)")).clicked() {
                actions.push(Action::Fit);
            }
        });
    });
    actions
}
