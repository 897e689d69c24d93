//! The ground of the active layer: how far its colours reach from the edges of marks, and its second colour.

use egui::{DragValue, Ui};

use crate::app::fields::reset;
use crate::app::panels::form::{heading, rows};
use crate::app::units::number_field;
use crate::document::{Colours, MapKey, limits};
use crate::editor::session::Session;

/// Shows them; the second colour where a map says where it is.
pub fn ground(ui: &mut Ui, session: &Session, colours: &mut Colours) {
    heading(ui, "Ground");
    let layer = session.document().layers.get(session.active_layer);
    let is_mapped = layer.is_some_and(|layer| layer.maps.get(MapKey::Ground).is_some());
    rows(ui, "ground", |ui| {
        let help = "How far the colours between ground and edge reach from a mark: 1 = as the stops say, 0.05 = the ground \
                    has its own colour up to the edge";
        ui.label("Halo").on_hover_text(help);
        ui.horizontal(|ui| {
            let field = DragValue::new(&mut colours.halo).range(limits::HALO.low..=limits::HALO.high);
            let field = number_field(field.speed(0.01).max_decimals(2), "");
            ui.add(field).accessible_name("Halo").on_hover_text(help);
            if reset(ui, "Halo", colours.halo >= limits::HALO.high) {
                colours.halo = limits::HALO.high;
            }
        });
        ui.end_row();
        if is_mapped {
            let help =
                "The second colour of the ground. Where it is, says Ground under Varies over the canvas";
            ui.label("Second colour").on_hover_text(help);
            let button = ui.color_edit_button_srgb(&mut colours.ground);
            button.accessible_name("Second colour of the ground").on_hover_text(help);
            ui.end_row();
        }
    });
}
