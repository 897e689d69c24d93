//! The choices of each kind of export.

mod film;
mod material;
mod outlines;
mod picture;

use std::sync::Arc;

use egui::{Checkbox, ComboBox, DragValue, Grid, Role, Ui, WidgetInfo, WidgetText, vec2};

use super::{Choices, ExportKind, ExportRequest};
use crate::app::fields::sides;
use crate::app::units::number_field;
use crate::editor::task::Tasks;
use crate::editor::units::{Ruler, Units};
use crate::synth::Grown;

/// What the dialog works with.
pub struct ExportContext<'a> {
    /// What would be exported with the current choices.
    pub request: &'a ExportRequest,
    /// The finished texture.
    pub grown: Option<&'a Arc<Grown>>,
    /// Whether the texture is still growing.
    pub growing: bool,
    /// Starts the threads.
    pub tasks: &'a Tasks,
    /// The number of threads to use; `None` = all cores.
    pub threads: Option<usize>,
    /// The unit of lengths on the canvas.
    pub units: Units,
}

/// What the user asks the dialog for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DialogAction {
    /// Choose a file, and write it.
    Export,
    /// Choose the document that a film ends with.
    ChooseOther,
    /// Close the dialog.
    Cancel,
}

/// The choices for the chosen kind.
pub fn page(ui: &mut Ui, choices: &mut Choices, context: &ExportContext) -> Option<DialogAction> {
    match choices.what {
        ExportKind::Picture => picture::page(ui, choices, context),
        ExportKind::Material => material::page(ui, choices, context),
        ExportKind::Outlines => outlines::page(ui, choices, context),
        ExportKind::Film => return film::page(ui, choices, context),
    }
    None
}

/// A grid with a column for names and one for values.
fn rows(ui: &mut Ui, name: &str, inside: impl FnOnce(&mut Ui)) {
    let grid = Grid::new(name).num_columns(2).min_col_width(92.0).spacing(vec2(14.0, 10.0));
    grid.show(ui, inside);
}

/// A row's name.
fn named(ui: &mut Ui, text: &str, explained: &str) {
    ui.label(text).on_hover_text(explained);
}

/// A checkbox.
fn yes(ui: &mut Ui, text: &str, on: &mut bool, enabled: bool, explained: &str) {
    ui.add_enabled(enabled, Checkbox::new(on, text))
        .on_hover_text(explained)
        .on_disabled_hover_text(explained);
}

/// A field for a number with a unit. Returns whether the number was changed.
fn number(ui: &mut Ui, name: &str, field: DragValue, unit: &str) -> bool {
    ui.add(number_field(field, unit)).accessible_name(name).changed()
}

/// A list of options. Returns whether another one was chosen.
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

/// The size of the canvas and of the picture.
fn size(ui: &mut Ui, choices: &mut Choices, context: &ExportContext) {
    let size = &mut choices.size;
    let document = &context.request.document;
    named(ui, "Texture", "As it is shown, or grown again on another canvas");
    ui.vertical(|ui| {
        let more = size.canvas.is_some();
        if ui.radio(!more, "Canvas size").on_hover_text("The texture as shown").clicked() {
            size.canvas = None;
        }
        let explained =
            "A larger or smaller canvas with marks of the same size; regions are stretched. The texture is grown again.";
        if ui.radio(more, "Larger canvas").on_hover_text(explained).clicked() {
            size.canvas = Some(document.size.map(|side| 2 * side));
        }
    });
    ui.end_row();
    if let Some(canvas) = &mut size.canvas {
        named(ui, "Canvas", "Its width and height");
        ui.horizontal(|ui| {
            let names = ["Width of the export", "Height of the export"];
            sides(ui, canvas, Ruler { units: context.units, dpi: document.dpi }, 16..=16_384, names)
        });
        ui.end_row();
    }
    named(ui, "Scale", "Factor for the number of px along each side; sharp at any size");
    let field = DragValue::new(&mut size.scale).range(1..=64).speed(0.05);
    number(ui, "Scale", field, "×");
    ui.end_row();
}

/// The choice of a single layer.
fn layer(ui: &mut Ui, choices: &mut Choices, context: &ExportContext, all: &str, explained: &str) {
    let layers = &context.request.document.layers;
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
