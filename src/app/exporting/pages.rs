//! The choices of each kind of export.

mod film;
mod material;
mod outlines;
mod picture;

use std::sync::Arc;

use egui::{Checkbox, ComboBox, DragValue, Grid, Role, Ui, WidgetInfo, WidgetText, vec2};

use super::{Choices, Order, What};
use crate::app::fields::sides;
use crate::app::units::{Ruler, Units};
use crate::synth::Grown;

/// What the dialog is about.
pub struct About<'a> {
    /// What would be exported now.
    pub order: &'a Order,
    /// What has settled.
    pub grown: Option<&'a Arc<Grown>>,
    /// Does it still grow?
    pub growing: bool,
    /// Threads that it may take.
    pub threads: Option<usize>,
    /// In what lengths of the canvas are told.
    pub units: Units,
}

/// What was said to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Said {
    /// Choose where, and write.
    Export,
    /// Choose the document that this one shall become.
    Other,
    /// Never mind.
    Cancel,
}

/// The choices of what is chosen.
pub fn page(ui: &mut Ui, choices: &mut Choices, about: &About) -> Option<Said> {
    match choices.what {
        What::Picture => picture::page(ui, choices, about),
        What::Material => material::page(ui, choices, about),
        What::Outlines => outlines::page(ui, choices, about),
        What::Film => return film::page(ui, choices, about),
    }
    None
}

/// Names in a column, what is chosen beside them.
fn rows(ui: &mut Ui, name: &str, inside: impl FnOnce(&mut Ui)) {
    let grid = Grid::new(name).num_columns(2).min_col_width(92.0).spacing(vec2(14.0, 10.0));
    grid.show(ui, inside);
}

/// A row's name.
fn named(ui: &mut Ui, text: &str, explained: &str) {
    ui.label(text).on_hover_text(explained);
}

/// A row with yes or no.
fn yes(ui: &mut Ui, text: &str, on: &mut bool, enabled: bool, explained: &str) {
    ui.add_enabled(enabled, Checkbox::new(on, text))
        .on_hover_text(explained)
        .on_disabled_hover_text(explained);
}

/// A number to be typed or dragged.
fn number(ui: &mut Ui, name: &str, field: DragValue) -> bool {
    ui.add(field.update_while_editing(false)).accessible_name(name).changed()
}

/// One of several.
fn one_of<T: PartialEq + Copy>(
    ui: &mut Ui,
    name: &str,
    value: &mut T,
    texts: &[(T, String)],
    allowed: impl Fn(T) -> bool,
) -> bool {
    let before = *value;
    let shown = texts.iter().find(|(other, _)| other == value).map_or("", |(_, text)| text.as_str());
    let combo = ComboBox::from_id_salt(name).selected_text(WidgetText::from(shown)).width(190.0);
    let combo = combo.show_ui(ui, |ui| {
        for (other, text) in texts {
            ui.add_enabled_ui(allowed(*other), |ui| ui.selectable_value(value, *other, text));
        }
    });
    combo.response.widget_info(|| WidgetInfo::labeled(Role::ComboBox, true, format!("{name}: {shown}")));
    *value != before
}

/// How large the canvas and the picture are.
fn size(ui: &mut Ui, choices: &mut Choices, about: &About) {
    let size = &mut choices.size;
    let document = &about.order.document;
    named(ui, "Texture", "As you see it, or grown afresh on another canvas");
    ui.vertical(|ui| {
        let more = size.canvas.is_some();
        if ui.radio(!more, "This texture").on_hover_text("What you see").clicked() {
            size.canvas = None;
        }
        let explained =
            "A larger or smaller canvas with marks of the same size; the regions stretch. It is grown afresh.";
        if ui.radio(more, "More texture").on_hover_text(explained).clicked() {
            size.canvas = Some(document.size.map(|side| 2 * side));
        }
    });
    ui.end_row();
    if let Some(canvas) = &mut size.canvas {
        named(ui, "Canvas", "Its width and height");
        ui.horizontal(|ui| {
            let names = ["Width of the export", "Height of the export"];
            sides(ui, canvas, Ruler { units: about.units, dpi: document.dpi }, 16..=16_384, names)
        });
        ui.end_row();
    }
    named(ui, "Scale", "So many times the px along each side, sharp at any size");
    let field = DragValue::new(&mut size.scale).range(1..=64).speed(0.05).suffix("×");
    number(ui, "Scale", field);
    ui.end_row();
}

/// The layer that is written alone.
fn layer(ui: &mut Ui, choices: &mut Choices, about: &About, all: &str, explained: &str) {
    let layers = &about.order.document.layers;
    choices.layer = choices.layer.filter(|layer| *layer < layers.len());
    if layers.len() < 2 {
        choices.layer = None;
        return;
    }
    named(ui, "Layers", explained);
    let mut texts = vec![(None, all.to_owned())];
    texts.extend(layers.iter().enumerate().map(|(index, layer)| (Some(index), layer.name.clone())));
    one_of(ui, "Layers", &mut choices.layer, &texts, |_| true);
    ui.end_row();
}
