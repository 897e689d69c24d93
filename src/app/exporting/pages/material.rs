//! Materials.

use egui::{DragValue, RichText, Ui};

use super::ExportContext;
use super::{named, number, rows, size, yes};
use crate::app::exporting::Choices;
use crate::app::exporting::choices::RELIEF;

/// The choices.
pub fn page(ui: &mut Ui, choices: &mut Choices, context: &ExportContext) {
    rows(ui, "material size", |ui| size(ui, choices, context));
    let document = &context.request.document;
    let material = &mut choices.material;
    ui.add_space(8.0);
    ui.label(RichText::new("Surface").strong());
    rows(ui, "surface", |ui| {
        named(ui, "Ground", "Roughness of the ground: 0 = a mirror, 1 = chalk");
        let field = DragValue::new(&mut material.roughness[0]).range(0.0..=1.0).speed(0.01).max_decimals(2);
        ui.horizontal(|ui| {
            number(ui, "Roughness of the ground", field, "");
            ui.weak("rough");
        });
        ui.end_row();
        for (index, layer) in document.layers.iter().enumerate() {
            named(
                ui,
                &shortened(&layer.name),
                "Its marks: their height above the ground (below 0: depth), and their roughness",
            );
            ui.horizontal(|ui| {
                let mut relief = value(&material.relief_of(document), index);
                let field = DragValue::new(&mut relief).range(-RELIEF..=RELIEF).speed(0.1).max_decimals(1);
                if number(ui, &format!("Relief of {}", layer.name), field, " px") {
                    material.set_relief(document, index, relief);
                }
                ui.weak("high");
                let mut rough = value(&material.roughness, index + 1);
                let field = DragValue::new(&mut rough).range(0.0..=1.0).speed(0.01).max_decimals(2);
                if number(ui, &format!("Roughness of {}", layer.name), field, "") {
                    material.set_roughness(index + 1, rough);
                }
                ui.weak("rough");
            });
            ui.end_row();
        }
        named(ui, "Depth", "Colours and normals with 16 bit; heights always have it");
        yes(
            ui,
            "16 bit",
            &mut material.deep,
            true,
            "Colours and normals with 16 bit; heights always have it",
        );
        ui.end_row();
        named(ui, "Opacity", "The ground is the surface between the marks");
        yes(
            ui,
            "transparent",
            &mut material.transparent,
            true,
            "Makes the ground transparent; adds an opacity map",
        );
        ui.end_row();
    });
    ui.add_space(6.0);
    ui.weak("Base colour, height, normals for OpenGL and Direct X, roughness, occlusion, packed maps, IDs and a glTF plane, with the file names that game engines expect.");
}

/// The value of a layer: the last one for all further layers.
fn value(values: &[f64], index: usize) -> f64 {
    values.get(index).or(values.last()).copied().unwrap_or_default()
}

/// A name short enough for its column.
fn shortened(name: &str) -> String {
    if name.chars().count() <= 12 { name.to_owned() } else { name.chars().take(11).chain(['…']).collect() }
}
