//! Materials.

use egui::{DragValue, RichText, Ui};

use super::About;
use super::{named, number, rows, size, yes};
use crate::app::exporting::Choices;
use crate::app::exporting::choices::RELIEF;

/// The choices.
pub fn page(ui: &mut Ui, choices: &mut Choices, about: &About) {
    rows(ui, "material size", |ui| size(ui, choices, about));
    let layers = &about.order.document.layers;
    let material = &mut choices.material;
    ui.add_space(8.0);
    ui.label(RichText::new("Surface").strong());
    rows(ui, "surface", |ui| {
        named(ui, "Ground", "How rough it is: 0 = a mirror, 1 = chalk");
        let field = DragValue::new(&mut material.roughness[0]).range(0.0..=1.0).speed(0.01).max_decimals(2);
        ui.horizontal(|ui| {
            number(ui, "Roughness of the ground", field);
            ui.weak("rough");
        });
        ui.end_row();
        for (index, layer) in layers.iter().enumerate() {
            named(
                ui,
                &shortened(&layer.name),
                "Its marks: how far they stand above the ground, below 0 into it; how rough they are",
            );
            ui.horizontal(|ui| {
                let mut relief = of(&material.relief, index);
                let field = DragValue::new(&mut relief).range(-RELIEF..=RELIEF).speed(0.1).max_decimals(1);
                if number(ui, &format!("Relief of {}", layer.name), field.suffix(" px")) {
                    put(&mut material.relief, index, relief);
                }
                ui.weak("high");
                let mut rough = of(&material.roughness, index + 1);
                let field = DragValue::new(&mut rough).range(0.0..=1.0).speed(0.01).max_decimals(2);
                if number(ui, &format!("Roughness of {}", layer.name), field) {
                    put(&mut material.roughness, index + 1, rough);
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
        named(ui, "Ground", "What lies between the marks");
        yes(
            ui,
            "transparent",
            &mut material.transparent,
            true,
            "One sees through the ground; adds a map of its opacity",
        );
        ui.end_row();
    });
    ui.add_space(6.0);
    ui.weak("Base colour, height, normals for OpenGL and Direct X, roughness, occlusion, packed maps, IDs and a glTF plane, named as engines expect.");
}

/// The value of one layer: the last for all further ones.
fn of(values: &[f64], index: usize) -> f64 {
    values.get(index).or(values.last()).copied().unwrap_or_default()
}

fn put(values: &mut Vec<f64>, index: usize, value: f64) {
    while values.len() <= index {
        values.push(values.last().copied().unwrap_or_default());
    }
    values[index] = value;
}

/// A name that fits beside its fields.
fn shortened(name: &str) -> String {
    if name.chars().count() <= 12 { name.to_owned() } else { name.chars().take(11).chain(['…']).collect() }
}
