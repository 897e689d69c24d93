//! All regions of a layer in a table, one row each.

use egui::{Align, Align2, Button, FontId, Layout, RichText, ScrollArea, TextStyle, Ui, pos2, vec2};

use super::{SIGN, error, named};
use crate::app::result::{LayerResult, RegionResult};
use crate::app::theme::Palette;
use crate::attributes::Attribute;

/// Height of a row, points.
const ROW: f32 = 22.0;
/// Largest height of the table, points; more is scrolled.
const HEIGHT: f32 = 9.0 * (ROW + 1.0);
/// Width of the first column, and of the others, points.
const FIRST: f32 = 54.0;
const COLUMN: f32 = 54.0;

/// Attributes that have a column, in order.
const COLUMNS: [Attribute; 6] = [
    Attribute::Area,
    Attribute::Aspect,
    Attribute::Angle,
    Attribute::Spacing,
    Attribute::Width,
    Attribute::Wavelength,
];

/// Shows the table, one row where the marks are free (`is_free`); the row that is clicked or gets the keyboard focus becomes `chosen`.
pub fn table(ui: &mut Ui, layer: &LayerResult, is_free: bool, chosen: &mut Option<[usize; 2]>) {
    let measured = |attribute: &Attribute| {
        layer.regions.iter().any(|region| region.report.error.iter().any(|(of, _)| of == attribute))
    };
    let columns: Vec<Attribute> = COLUMNS.into_iter().filter(measured).collect();
    let width = ((ui.available_width() - FIRST - 8.0) / columns.len().max(1) as f32).min(COLUMN);
    ui.spacing_mut().item_spacing.x = 0.0;
    ui.horizontal(|ui| {
        ui.add_space(FIRST);
        for attribute in &columns {
            let (name, help) = named(*attribute);
            // The longest name does not fit into a narrow column.
            let name = if *attribute == Attribute::Angle { "Angle" } else { name };
            ui.allocate_ui_with_layout(vec2(width, 16.0), Layout::right_to_left(Align::Center), |ui| {
                ui.label(RichText::new(name).small().weak()).on_hover_text(format!(
                    "{help}: difference between what has grown and what was asked for"
                ));
            });
        }
    });
    ui.spacing_mut().item_spacing.y = 1.0;
    let area = ScrollArea::vertical().id_salt("regions").max_height(HEIGHT).auto_shrink([false, true]);
    area.show_rows(ui, ROW, layer.regions.len(), |ui, rows| {
        for region in &layer.regions[rows] {
            row(ui, region, is_free, (&columns, width), chosen);
        }
    });
    ui.spacing_mut().item_spacing = vec2(8.0, 7.0);
}

fn row(
    ui: &mut Ui,
    region: &RegionResult,
    is_free: bool,
    (columns, width): (&[Attribute], f32),
    chosen: &mut Option<[usize; 2]>,
) {
    let place = region.report.place;
    let selected = *chosen == Some(place);
    let size = vec2(FIRST + width * columns.len() as f32 + 4.0, ROW);
    let button = ui.add_sized(size, Button::new("").selected(selected).frame_when_inactive(selected));
    let colour = if selected {
        ui.visuals().selection.stroke.color
    } else {
        ui.style().interact(&button).text_color()
    };
    let rect = button.rect;
    let sign =
        egui::Rect::from_center_size(pos2(rect.left() + 4.0 + 0.5 * SIGN, rect.center().y), vec2(SIGN, SIGN));
    region.verdict.paint(ui.painter(), sign, Palette::current(ui.visuals()));
    let font = FontId::new(TextStyle::Small.resolve(ui.style()).size, egui::FontFamily::Proportional);
    let name = if is_free { "all".to_owned() } else { format!("{}, {}", place[0] + 1, place[1] + 1) };
    let text = |x: f32, align: Align2, text: String| {
        ui.painter().text(pos2(rect.left() + x, rect.center().y), align, text, font.clone(), colour);
    };
    text(24.0, Align2::LEFT_CENTER, name.clone());
    let title = if is_free { "Whole canvas".to_owned() } else { format!("Region {name}") };
    let mut label = format!("{title}: {}", region.verdict.name());
    for (column, attribute) in columns.iter().enumerate() {
        let found = region.report.error.iter().find(|(of, _)| of == attribute);
        let value = found.map_or("–".to_owned(), |(_, off)| error(*attribute, *off));
        if found.is_some() {
            label.push_str(&format!(", {} {value}", named(*attribute).0));
        }
        text(FIRST + width * (column + 1) as f32, Align2::RIGHT_CENTER, value);
    }
    let button = button.accessible_name(label);
    if button.clicked() || button.gained_focus() {
        *chosen = Some(place);
    }
}
