//! Rosettes of patches: none, or by numbers.

use egui::{DragValue, RichText, Ui};

use super::share;
use crate::app::units::number_field;
use crate::document::{Rosettes, limits};

pub(super) fn choice(ui: &mut Ui, rosette: &mut Option<Rosettes>) -> egui::Response {
    let mut grown = rosette.is_some();
    let field = ui.checkbox(&mut grown, "grow").accessible_name("Rosettes");
    if field.changed() {
        *rosette = grown.then(Rosettes::default);
    }
    field
}

/// The fields of rosettes that grow.
pub(super) fn numbers(ui: &mut Ui, rosette: &mut Option<Rosettes>) {
    let Some(of) = rosette else { return };
    let label = |ui: &mut Ui, name: &str, help: &str| {
        ui.label(RichText::new(format!("  {name}")).weak()).on_hover_text(help);
    };
    let count = |ui: &mut Ui, name: &str, value: &mut u32, low: u32, high: u32| {
        let field = DragValue::new(value).range(low..=high).speed(0.1);
        ui.add(field).accessible_name(name);
    };
    label(ui, "blotches", "The least and the greatest number of blotches around a rosette");
    let [low, high] = limits::ROSETTE_PARTS.map(|count| count as u32);
    ui.horizontal(|ui| {
        let [least, most] = &mut of.parts;
        count(ui, "Fewest blotches", least, low, *most);
        count(ui, "Most blotches", most, *least, high);
    });
    ui.end_row();
    label(ui, "solid", "The share of the patches that stay solid, small ones rather than large ones");
    share(ui, "Solid patches", &mut of.solid, &limits::ROSETTE_SOLID);
    ui.end_row();
    label(
        ui,
        "depth",
        "How deep blotches are. Automatic: 22 % of the side of a square as large as a mean patch",
    );
    ui.horizontal(|ui| {
        let mut automatic = of.width.is_none();
        if ui.checkbox(&mut automatic, "automatic").accessible_name("Depth automatic").changed() {
            of.width = (!automatic).then_some(8.0);
        }
        if let Some(width) = &mut of.width {
            let limits::Range { low, high, unit } = limits::ROSETTE_WIDTH;
            let field = DragValue::new(width).range(low..=high).speed(0.1).max_decimals(1);
            ui.add(number_field(field, unit)).accessible_name("Depth of blotches");
        }
    });
    ui.end_row();
    label(ui, "dots", "The greatest number of dots inside a rosette; 0: none");
    let [low, high] = limits::ROSETTE_DOTS.map(|count| count as u32);
    count(ui, "Dots", &mut of.dots, low, high);
    ui.end_row();
    label(ui, "tint", "The colour inside: 0 % is that of the ground, 45 % nearly that of an edge");
    share(ui, "Tint", &mut of.tint, &limits::ROSETTE_TINT);
    ui.end_row();
}
