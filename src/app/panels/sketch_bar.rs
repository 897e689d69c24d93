//! The bar above the sketch: how many marks there are, and how sketch and texture are arranged.

use egui::{Align, Layout, Ui};

use crate::app::action::Action;
use crate::app::icons::Icon;

/// Shows the bar. `over`: the texture is shown over the sketch.
pub fn sketch_bar(ui: &mut Ui, marks: usize, over: bool) -> Option<Action> {
    let mut action = None;
    ui.horizontal_centered(|ui| {
        ui.strong("Sketch");
        ui.weak(match marks {
            0 => String::new(),
            1 => "1 mark".to_owned(),
            marks => format!("{marks} marks"),
        });
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let help = "The texture over the sketch, with a divider to drag";
            if Icon::Over.button(ui, "Texture over the sketch", over).on_hover_text(help).clicked() {
                action = Some(Action::Over(true));
            }
            let help = "The sketch beside the texture";
            if Icon::Beside.button(ui, "Side by side", !over).on_hover_text(help).clicked() {
                action = Some(Action::Over(false));
            }
            let fit = "Show the whole canvas";
            if Icon::Fit.button(ui, fit, false).on_hover_text(format!("{fit} (Ctrl+0)")).clicked() {
                action = Some(Action::Fit);
            }
        });
    });
    action
}
