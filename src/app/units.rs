//! Fields for lengths and areas.

use egui::DragValue;

use crate::editor::arithmetic::evaluate;
use crate::editor::units::{Ruler, Units, digits};

impl Ruler {
    /// A field for a length, px.
    pub fn field(self, value: &mut f64) -> DragValue<'_> {
        self.number(value, self.per_px(), self.decimals())
    }

    /// A field for an area, px².
    pub fn field_of_area(self, value: &mut f64) -> DragValue<'_> {
        self.number(value, self.per_px() * self.per_px(), self.decimals_of_area())
    }

    fn number(self, value: &mut f64, factor: f64, decimals: usize) -> DragValue<'_> {
        let field = DragValue::from_get_set(move |typed| {
            // The text shows fewer digits than the value has. If the text is not changed, the value is not changed
            // either.
            let written = |value: f64| format!("{value:.decimals$}");
            if let Some(typed) = typed.filter(|typed| written(*typed) != written(*value * factor)) {
                *value = typed / factor;
            }
            *value * factor
        });
        let field = field.speed(0.2 * factor).max_decimals(decimals).update_while_editing(false);
        field.custom_parser(move |text| self.parse(text, factor))
    }

    /// A field for a side of the canvas, in whole px.
    pub fn side(self, value: &mut u32, range: std::ops::RangeInclusive<u32>) -> DragValue<'_> {
        let factor = self.per_px();
        let decimals = if self.units == Units::Px { 0 } else { digits(0.5 * factor) };
        let ends = [*range.start(), *range.end()].map(f64::from);
        let field = DragValue::from_get_set(move |typed| {
            if let Some(typed) = typed {
                *value = (typed / factor).round().clamp(ends[0], ends[1]) as u32;
            }
            f64::from(*value) * factor
        });
        let field = field.speed(factor).max_decimals(decimals).update_while_editing(false);
        field.custom_parser(move |text| self.parse(text, factor))
    }
}

/// The field for a number without a unit, with arithmetic; `unit` may be typed after the number.
pub fn number_field<'a>(field: DragValue<'a>, unit: &'a str) -> DragValue<'a> {
    let is_unit = move |typed: &str| typed.is_empty() || typed == unit.trim();
    let field = field.suffix(unit).update_while_editing(false);
    field.custom_parser(move |text| evaluate(text, &|number, typed| is_unit(typed).then_some(number)))
}

/// Three significant digits.
pub fn three_digits(value: f64) -> String {
    let before = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    let digits = (2.0 - before).clamp(0.0, 8.0) as usize;
    format!("{value:.digits$}")
}
