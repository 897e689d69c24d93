//! What a new sketch can begin with: buttons below an empty canvas.

use egui::{Align, Layout, Rect, Ui, UiBuilder, pos2, vec2};

use crate::app::action::Action;

/// Shows the buttons at the bottom of `room`, which shows the canvas.
pub fn starters(ui: &mut Ui, room: Rect) -> Option<Action> {
    let mut action = None;
    let size = vec2(room.width().min(330.0), 28.0);
    let place = Rect::from_center_size(pos2(room.center().x, room.bottom() - 24.0), size);
    ui.scope_builder(UiBuilder::new().max_rect(place).layout(Layout::left_to_right(Align::Center)), |ui| {
        ui.weak("Begin with");
        for (text, begins) in [
            ("Spots", Action::Begin(true)),
            ("Stripes", Action::Begin(false)),
            ("A leopard", Action::Example("turk-2-lower-right-leopard")),
        ] {
            if ui.button(text).clicked() {
                action = Some(begins);
            }
        }
    });
    action
}
