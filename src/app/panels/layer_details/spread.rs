//! The variation of spots: as drawn, none, or by numbers.

use egui::{ComboBox, DragValue, RichText, Ui};

use super::{CONTROL, share};
use crate::app::units::number_field;
use crate::attributes::Spread;
use crate::document::limits::Range;
use crate::document::{LayerOptions, SpreadChoice, limits};

pub(super) fn choice(ui: &mut Ui, spread: &mut SpreadChoice) -> egui::Response {
    let (drawn, even) = (SpreadChoice::Drawn, SpreadChoice::Given(Spread::ZERO));
    let now = match *spread {
        SpreadChoice::Drawn => "As drawn",
        given if given == even => "None",
        SpreadChoice::Given(_) => "By numbers",
    };
    let combo = ComboBox::from_id_salt("spread").selected_text(now).width(CONTROL).truncate();
    let combo = combo.show_ui(ui, |ui| {
        ui.selectable_value(spread, drawn, "As drawn");
        ui.selectable_value(spread, even, "None");
        let numbers = !matches!(now, "As drawn" | "None");
        if ui.selectable_label(numbers, "By numbers").clicked() && !numbers {
            // A variation that is clearly visible.
            *spread = SpreadChoice::Given(Spread { area: 0.2, ..Spread::ZERO });
        }
    });
    combo.response.accessible_name("Variation")
}

/// The fields of a given spread.
pub(super) fn numbers(ui: &mut Ui, options: &mut LayerOptions) {
    let SpreadChoice::Given(mut spread) = options.spread else { return };
    let before = spread;
    let rows: [(&str, &str, &mut f64, &Range); 4] = [
        (
            "of area",
            "Standard deviation ÷ mean of the areas, 0 to 60 %",
            &mut spread.area,
            &limits::SPREAD_AREA,
        ),
        (
            "of spacing",
            "Standard deviation ÷ mean of the distances, 0 to 20 %",
            &mut spread.spacing,
            &limits::SPREAD_SPACING,
        ),
        (
            "of aspect",
            "Standard deviation of minor ÷ major radius, 0 to 20 %",
            &mut spread.aspect,
            &limits::SPREAD_ASPECT,
        ),
        ("of direction", "Scatter of the directions, 0 to 45°", &mut spread.angle, &limits::SPREAD_ANGLE),
    ];
    for (name, help, value, range) in rows {
        ui.label(RichText::new(format!("  {}", name.trim_start_matches("of "))).weak()).on_hover_text(help);
        let named = format!("Variation {name}");
        if range.unit.is_empty() {
            share(ui, &named, value, range).on_hover_text(help);
        } else {
            let field = DragValue::new(value).range(range.low..=range.high).speed(0.2).max_decimals(0);
            let field = ui.add(number_field(field, "°"));
            field.accessible_name(named).on_hover_text(help);
        }
        ui.end_row();
    }
    if spread != before {
        options.spread = SpreadChoice::Given(spread);
    }
}
