//! The attributes of several marks as numbers that can be typed.

use egui::{DragValue, Ui};

use crate::app::units::number_field;
use crate::editor::selection::Place;
use crate::editor::typed;
use crate::editor::units::Ruler;
use crate::marks::Mark;

/// Shows a row for each attribute of the marks in a grid of two columns. Where the layer has a given `duty`, the period of its
/// stripes follows from their width, and not from the distances of the lines. `of` is added to the names that screen readers
/// read, for example ` of all`. A number that is changed gives the marks that replace them.
pub fn typed_rows(
    ui: &mut Ui,
    ruler: Ruler,
    marks: &[(Place, Mark)],
    duty: Option<f64>,
    of: &str,
) -> Option<Vec<(Place, Mark)>> {
    let mut changed = None;
    if let Some(before) = typed::area(marks) {
        ui.label("Mean area").on_hover_text("Changing it scales the marks about their centres");
        if let Some(area) = area_field(ui, &format!("Mean area{of}"), before, ruler) {
            changed = Some(typed::with_area(marks, area));
        }
        ui.end_row();
        ui.label("Aspect").on_hover_text("Minor ÷ major radius; 1 is round. Changing it keeps the areas");
        let mut aspect = typed::aspect(marks).unwrap_or(1.0);
        let field = DragValue::new(&mut aspect)
            .range(0.05..=1.0)
            .clamp_existing_to_range(false)
            .speed(0.005)
            .max_decimals(2);
        if ui.add(number_field(field, "")).accessible_name(format!("Aspect{of}")).changed() {
            changed = Some(typed::with_aspect(marks, aspect));
        }
        ui.end_row();
    }
    if let Some(mut angle) = typed::direction(marks) {
        ui.label("Direction").on_hover_text(
            "Mean direction, degrees: 0 is to the right, 90 is down. Changing it turns all \
                            marks by the same angle",
        );
        let field = DragValue::new(&mut angle).speed(0.2).max_decimals(1);
        if ui.add(number_field(field, "°")).accessible_name(format!("Direction{of}")).changed() {
            changed = Some(typed::with_direction(marks, angle));
        }
        ui.end_row();
    }
    if let Some(before) = typed::spacing(marks) {
        ui.label("Spacing").on_hover_text(
            "Mean distance to the nearest neighbour, from centre to centre. Changing it moves the marks apart or together; \
             their sizes stay",
        );
        if let Some(spacing) = length_field(ui, &format!("Spacing{of}"), before, ruler) {
            changed = Some(typed::with_spacing(marks, spacing));
        }
        ui.end_row();
    }
    if let Some(before) = typed::width(marks) {
        ui.label("Width").on_hover_text("One width for all lines");
        if let Some(width) = length_field(ui, &format!("Width{of}"), before, ruler) {
            changed = Some(typed::with_width(marks, width));
        }
        ui.end_row();
    }
    if let Some(marks) = period_row(ui, ruler, marks, duty, of) {
        changed = Some(marks);
    }
    changed.filter(|marks| !marks.is_empty())
}

/// The row of the period of stripes: it follows from a given `duty`, else from the distances of the lines, which can be typed.
fn period_row(
    ui: &mut Ui,
    ruler: Ruler,
    marks: &[(Place, Mark)],
    duty: Option<f64>,
    of: &str,
) -> Option<Vec<(Place, Mark)>> {
    let mut changed = None;
    if let (Some(width), Some(duty)) = (typed::width(marks), duty) {
        ui.label("Period")
            .on_hover_text("Width ÷ the stripe width (share of the period) that is set for this layer");
        ui.label(ruler.rough(width / duty));
        ui.end_row();
    } else if let Some(before) = typed::period(marks) {
        ui.label("Line spacing").on_hover_text(
            "Mean distance of lines side by side, from the middle of one to the middle of the next. Changing it moves the lines \
             apart or together; their widths stay",
        );
        if let Some(period) = length_field(ui, &format!("Line spacing{of}"), before, ruler) {
            changed = Some(typed::with_period(marks, period));
        }
        ui.end_row();
    }
    changed
}

/// A length, px; the new one where it was changed.
fn length_field(ui: &mut Ui, name: &str, before: f64, ruler: Ruler) -> Option<f64> {
    let mut length = before;
    let field = ui.add(ruler.field(&mut length).suffix(ruler.unit())).accessible_name(name);
    (field.changed() && length > 0.0).then_some(length)
}

/// An area, px²; the new one where it was changed.
fn area_field(ui: &mut Ui, name: &str, before: f64, ruler: Ruler) -> Option<f64> {
    let mut area = before;
    let field = ui.add(ruler.field_of_area(&mut area).suffix(ruler.unit_of_area())).accessible_name(name);
    (field.changed() && area > 0.0).then_some(area)
}
