//! Outlines.

use egui::{DragValue, RichText, Ui};

use super::ExportContext;
use super::{layer, named, number, rows, size, yes};
use crate::app::exporting::{Choices, Outlines};
use crate::editor::units::Units;
use crate::export::outline::Hatch;

/// The choices.
pub fn page(ui: &mut Ui, choices: &mut Choices, context: &ExportContext) {
    let dpi = context.request.document.dpi * f64::from(choices.size.scale);
    if let Some(finishing) = &context.request.document.finish {
        let kind = finishing.finish.kind.name();
        ui.label(RichText::new(format!("Outlines are those without the finish, {kind}.")).weak());
    }
    rows(ui, "outlines", |ui| {
        named(ui, "Format", "SVG for drawing programs; DXF (release 12) for cutters and CAD");
        ui.horizontal(|ui| {
            ui.radio_value(&mut choices.outlines.dxf, false, "SVG");
            ui.radio_value(&mut choices.outlines.dxf, true, "DXF");
        });
        ui.end_row();
        layer(
            ui,
            choices,
            context,
            "All visible layers",
            "One group for each visible layer, or one layer alone",
        );
        let outlines = &mut choices.outlines;
        named(
            ui,
            "Level",
            "Where the outlines lie: 0.5 = at the edges of the marks, less = outside them, more = inside",
        );
        let field = DragValue::new(&mut outlines.level).range(0.01..=0.99).speed(0.005).max_decimals(3);
        number(ui, "Level", field, "");
        ui.end_row();
        named(ui, "Units", "The unit of lengths, in the file and here");
        ui.horizontal(|ui| {
            let before = outlines.units;
            ui.radio_value(&mut outlines.units, Units::Mm, "mm")
                .on_hover_text("By the document's resolution");
            ui.radio_value(&mut outlines.units, Units::Px, "px");
            convert(outlines, before, dpi);
        });
        ui.end_row();
        style(ui, outlines, dpi);
        smallest(ui, outlines);
        size(ui, choices, context);
    });
}

/// Converts lengths to the new unit.
fn convert(outlines: &mut Outlines, before: Units, dpi: f64) {
    if outlines.units == before {
        return;
    }
    let by = if outlines.units == Units::Px { dpi / 25.4 } else { 25.4 / dpi };
    let rounded = |value: f64| (value * 1000.0).round() / 1000.0;
    for length in [&mut outlines.spacing, &mut outlines.pen, &mut outlines.width] {
        *length = rounded(*length * by);
    }
    outlines.area = rounded(outlines.area * by * by);
}

fn unit(outlines: &Outlines) -> &'static str {
    if outlines.units == Units::Mm { " mm" } else { " px" }
}

fn style(ui: &mut Ui, outlines: &mut Outlines, dpi: f64) {
    let unit = unit(outlines);
    named(ui, "Style", "What is drawn of each mark");
    ui.horizontal(|ui| {
        yes(ui, "fill", &mut outlines.fill, true, "Areas");
        yes(ui, "stroke", &mut outlines.stroke, true, "Strokes along the outlines");
        yes(ui, "hatch", &mut outlines.hatch, true, "Parallel strokes, for pens");
    });
    ui.end_row();
    if outlines.hatch {
        named(ui, "Hatch", "Spacing of its strokes, and their direction: 0° runs to the right, 90° down");
        let finest = Hatch::FINEST * outlines.unit(dpi).per_px();
        ui.horizontal(|ui| {
            let field = DragValue::new(&mut outlines.spacing).range(finest..=1e4).speed(0.02).max_decimals(3);
            number(ui, "Spacing of the hatch", field, unit);
            let field = DragValue::new(&mut outlines.angle).range(-360.0..=360.0).speed(0.5).max_decimals(1);
            number(ui, "Direction of the hatch", field, "°");
        });
        ui.end_row();
    }
    if (outlines.stroke || outlines.hatch) && !outlines.dxf {
        named(ui, "Pen", "Width of the strokes");
        let field = DragValue::new(&mut outlines.pen).range(0.001..=1e4).speed(0.01).max_decimals(3);
        number(ui, "Pen", field, unit);
        ui.end_row();
    }
    named(ui, "At the edge", "Strokes of marks that reach over the edge of the canvas");
    ui.horizontal(|ui| {
        ui.radio_value(&mut outlines.cut, false, "closed").on_hover_text("They run along the edge");
        ui.add_enabled_ui(!outlines.fill, |ui| {
            let radio = ui.radio_value(&mut outlines.cut, true, "cut").on_hover_text("They end at the edge");
            radio.on_disabled_hover_text("Areas must be closed: switch off the fill first");
        });
    });
    ui.end_row();
    named(ui, "Order", "The order in which the pen draws the outlines");
    yes(
        ui,
        "optimise pen travel",
        &mut outlines.ordered,
        true,
        "Otherwise in the order in which the outlines are found",
    );
    ui.end_row();
    if !outlines.dxf {
        named(ui, "Ground", "The surface between the marks");
        let help = "A rectangle in the colour of the ground beneath the outlines";
        yes(ui, "rectangle", &mut outlines.ground, true, help);
        ui.end_row();
    }
}

fn smallest(ui: &mut Ui, outlines: &mut Outlines) {
    let unit = unit(outlines);
    named(ui, "Leave out", "Leaves out islands and holes that are narrower, or smaller in area; 0 = none");
    ui.horizontal(|ui| {
        ui.weak("under");
        let field = DragValue::new(&mut outlines.width).range(0.0..=1e4).speed(0.02).max_decimals(3);
        number(ui, "Narrowest", field, unit);
        let field = DragValue::new(&mut outlines.area).range(0.0..=1e8).speed(0.05).max_decimals(3);
        number(ui, "Smallest area", field, &format!("{unit}²"));
    });
    ui.end_row();
}
