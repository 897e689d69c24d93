//! The rows and fields that are used for fields of points, for maps and for tones.

use egui::{DragValue, Label, Response, Ui};

use crate::app::fields::reset;
use crate::app::panels::layer_details::share;
use crate::app::units::number_field;
use crate::document::limits::{self, Range};

/// Two fields side by side, named `name` and `name, at the end`.
pub(super) fn two<T>(
    ui: &mut Ui,
    name: &str,
    values: &mut [T; 2],
    one: impl Fn(&mut Ui, &str, &mut T) -> Response,
) -> Response {
    ui.horizontal(|ui| {
        // Narrow, so that the scroll bar does not cover the reset button.
        ui.spacing_mut().item_spacing.x = 3.0;
        ui.spacing_mut().button_padding.x = 4.0;
        let [first, last] = values;
        let first = one(ui, name, first);
        ui.weak("–");
        first.union(one(ui, &format!("{name}, at the end"), last))
    })
    .inner
}

/// Two probabilities.
pub(super) fn probability(ui: &mut Ui, name: &str, dark: &mut [f64; 2]) -> Response {
    two(ui, name, dark, |ui, name, dark| share(ui, name, dark, &limits::INK))
}

/// Two counts of rays; the second one is kept from falling below the first.
pub(super) fn rays(ui: &mut Ui, name: &str, rays: &mut [u32; 2]) -> Response {
    let before = *rays;
    let shown = two(ui, name, rays, |ui, name, rays| whole(ui, name, rays, limits::RAYS));
    if rays[0] != before[0] {
        rays[1] = rays[1].max(rays[0]);
    } else {
        rays[0] = rays[0].min(rays[1]);
    }
    shown
}

/// The probability of nodes, in per cent with one decimal.
pub(super) fn nodes(ui: &mut Ui, start: &mut f64) -> Response {
    let Range { low, high, .. } = limits::START;
    let mut percent = 100.0 * *start;
    let field = DragValue::new(&mut percent).range(100.0 * low..=100.0 * high).speed(0.05).max_decimals(1);
    let field = ui.add(number_field(field, " %")).accessible_name("Nodes");
    if field.changed() {
        *start = ((10.0 * percent).round() / 1000.0).clamp(low, high);
    }
    field
}

/// A whole number.
pub(super) fn whole(ui: &mut Ui, name: &str, value: &mut u32, [low, high]: [u32; 2]) -> Response {
    let field = DragValue::new(value).range(low..=high).speed(0.1);
    ui.add(number_field(field, "")).accessible_name(name)
}

/// A number with two decimals.
pub(super) fn number(ui: &mut Ui, name: &str, value: &mut f64, range: &Range) -> Response {
    let field = DragValue::new(value).range(range.low..=range.high).speed(0.01).max_decimals(2);
    ui.add(number_field(field, "")).accessible_name(name)
}

/// A distance, px.
pub(super) fn px(ui: &mut Ui, name: &str, value: &mut f64) -> Response {
    let Range { low, high, .. } = limits::POINT_DISTANCE;
    let field = DragValue::new(value).range(low..=high).speed(1.0).max_decimals(1);
    ui.add(number_field(field, " px")).accessible_name(name)
}

/// Degrees.
pub(super) fn degrees(ui: &mut Ui, name: &str, value: &mut f64) -> Response {
    let field = DragValue::new(value).range(Range::ANGLE.low..=Range::ANGLE.high).speed(0.5).max_decimals(0);
    ui.add(number_field(field, "°")).accessible_name(name)
}

/// A row: the name, a control, and the button that restores the default. Returns whether that button was pressed.
pub(super) fn row(
    ui: &mut Ui,
    name: &str,
    help: &str,
    default: bool,
    control: impl FnOnce(&mut Ui) -> Response,
) -> bool {
    ui.add(Label::new(name)).on_hover_text(help);
    control(ui).on_hover_text(help);
    let pressed = reset(ui, name, default);
    ui.end_row();
    pressed
}
