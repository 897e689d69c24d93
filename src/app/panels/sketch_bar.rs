//! Above the canvas: what is seen of it.

use eframe::egui::Ui;

use crate::app::Window;
use crate::app::action::Action;
use crate::app::icons::Icon;
use crate::field::Edges;

/// The bar. Gives what is chosen.
pub fn sketch_bar(ui: &mut Ui, window: &Window) -> Vec<Action> {
    let mut actions = Vec::new();
    ui.horizontal_centered(|ui| {
        ui.strong("Sketch");
        let marks = window.desk.marks().count();
        ui.weak(match marks {
            0 => String::new(),
            1 => "1 mark".to_owned(),
            marks => format!("{marks} marks"),
        });
        ui.with_layout(eframe::egui::Layout::right_to_left(eframe::egui::Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let mut button = |ui: &mut Ui, icon: Icon, name: &str, on: bool, help: &str, action: Action| {
                if icon.button(ui, name, on).on_hover_text(help).clicked() {
                    actions.push(action);
                }
            };
            let over = window.over;
            button(
                ui,
                Icon::Over,
                "One over the other",
                over,
                "Texture over the sketch, with a curtain to drag",
                Action::Over(true),
            );
            button(ui, Icon::Beside, "Side by side", !over, "Sketch beside the texture", Action::Over(false));
            if window.desk.document().edges == Edges::Wrap {
                let tiled = window.texture.tiled;
                button(
                    ui,
                    Icon::Tiles,
                    "Two by two",
                    tiled,
                    "Shows the tile two by two, so that a seam would be seen",
                    Action::Tiled(!tiled),
                );
            }
            button(
                ui,
                Icon::Fit,
                "Show the whole canvas",
                false,
                "Show the whole canvas (Ctrl+0)",
                Action::Fit,
            );
        });
    });
    actions
}
