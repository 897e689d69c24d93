//! In what lengths are told and typed: px, or mm by the document's dots an inch. Documents hold px.

use egui::DragValue;

/// A unit of length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Units {
    /// Px of the canvas.
    #[default]
    Px,
    /// Millimetres.
    Mm,
}

/// Tells px as the user wants them told, and takes them so.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ruler {
    /// In what.
    pub units: Units,
    /// Dots an inch, > 0.
    pub dpi: f64,
}

/// mm an inch.
const INCH: f64 = 25.4;

impl Ruler {
    /// Units a px.
    #[must_use]
    pub fn per_px(self) -> f64 {
        match self.units {
            Units::Px => 1.0,
            Units::Mm => INCH / self.dpi,
        }
    }

    /// What stands behind a length.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self.units {
            Units::Px => " px",
            Units::Mm => " mm",
        }
    }

    /// What stands behind an area.
    #[must_use]
    pub fn unit_of_area(self) -> &'static str {
        match self.units {
            Units::Px => " px²",
            Units::Mm => " mm²",
        }
    }

    /// Decimals that tell a tenth of a px, about.
    fn decimals(self) -> usize {
        match self.units {
            Units::Px => 1,
            Units::Mm => digits(0.1 * self.per_px()),
        }
    }

    /// Decimals that tell a tenth of a px² (typed), about.
    fn decimals_of_area(self) -> usize {
        match self.units {
            Units::Px => 1,
            Units::Mm => digits(0.5 * self.per_px() * self.per_px()),
        }
    }

    /// A length of `px`, to a tenth of a px or so.
    #[must_use]
    pub fn length(self, px: f64) -> String {
        format!("{:.*}{}", self.decimals(), px * self.per_px(), self.unit())
    }

    /// A length of `px`, to a px or so.
    #[must_use]
    pub fn rough(self, px: f64) -> String {
        match self.units {
            Units::Px => format!("{px:.0} px"),
            Units::Mm => format!("{:.*} mm", digits(self.per_px()), px * self.per_px()),
        }
    }

    /// A place on the canvas, to a px or so.
    #[must_use]
    pub fn place(self, [x, y]: [f64; 2]) -> String {
        let x = self.rough(x);
        format!("{}, {}", x.trim_end_matches(self.unit()), self.rough(y))
    }

    /// An area of `px²`, to a px² or so.
    #[must_use]
    pub fn area(self, px: f64) -> String {
        match self.units {
            Units::Px => format!("{px:.0} px²"),
            Units::Mm => format!("{:.*} mm²", self.decimals_of_area(), px * self.per_px() * self.per_px()),
        }
    }

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
            // What is read again as it was written changes nothing, though less of it is written than there is.
            let written = |value: f64| format!("{value:.decimals$}");
            if let Some(typed) = typed.filter(|typed| written(*typed) != written(*value * factor)) {
                *value = typed / factor;
            }
            *value * factor
        });
        let field = field.speed(0.2 * factor).max_decimals(decimals).update_while_editing(false);
        field.custom_parser(move |text| self.typed(text, factor))
    }

    /// A field for a side of the canvas: whole px, however they are told.
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
        field.custom_parser(move |text| self.typed(text, factor))
    }

    /// What was typed, in these units; other units can be typed out: `3 mm`, `0.3cm`, `1 in`, `20 px`.
    fn typed(self, text: &str, factor: f64) -> Option<f64> {
        let text: String = text.chars().filter(|letter| !letter.is_whitespace()).collect();
        let text = text.replace('−', "-").replace(',', ".").to_lowercase();
        let split = text.find(|letter: char| letter.is_alphabetic() && letter != 'e').unwrap_or(text.len());
        let (number, unit) = text.split_at(split);
        let number: f64 = number.parse().ok().filter(|number: &f64| number.is_finite())?;
        let (unit, power) = match unit.strip_suffix(['²', '2']) {
            Some(unit) => (unit, 2),
            None => (unit, 1),
        };
        let px = match unit {
            "" => return Some(number),
            "px" => 1.0,
            "mm" => self.dpi / INCH,
            "cm" => 10.0 * self.dpi / INCH,
            "in" => self.dpi,
            _ => return None,
        };
        let px = if power == 2 { px * px } else { px };
        Some(number * px * factor)
    }
}

/// Three significant digits.
pub fn three_digits(value: f64) -> String {
    let before = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    let digits = (2.0 - before).clamp(0.0, 8.0) as usize;
    format!("{value:.digits$}")
}

/// Decimals that tell `step`.
fn digits(step: f64) -> usize {
    // A third of a digit less would hide a step, one more would show digits that mean nothing.
    libm::ceil(-libm::log10(step) - 0.3).clamp(0.0, 6.0) as usize
}

#[cfg(test)]
mod tests {
    use super::*;

    const MM: Ruler = Ruler { units: Units::Mm, dpi: 300.0 };
    const PX: Ruler = Ruler { units: Units::Px, dpi: 300.0 };

    #[test]
    fn an_inch_of_px_is_25_4_mm() {
        assert_eq!(MM.length(300.0), "25.40 mm");
        assert_eq!(MM.area(300.0 * 300.0), "645.160 mm²");
        assert_eq!(PX.length(300.0), "300.0 px");
        assert_eq!(PX.area(301.2), "301 px²");
        assert_eq!(MM.place([150.0, 300.0]), "12.7, 25.4 mm");
        assert_eq!(PX.place([150.2, 300.0]), "150, 300 px");
        assert_eq!(Ruler { dpi: 1200.0, ..MM }.length(1.0), "0.021 mm");
    }

    #[test]
    fn any_unit_can_be_typed() {
        let mm = |text| MM.typed(text, MM.per_px());
        assert_eq!(mm("2.5"), Some(2.5));
        assert_eq!(mm("2,5 mm"), Some(2.5));
        assert!((mm("0.25cm").unwrap() - 2.5).abs() < 1e-12);
        assert!((mm("300 px").unwrap() - 25.4).abs() < 1e-12);
        assert_eq!(mm("2 apples"), None);
        assert_eq!(mm(""), None);
        let px = |text| PX.typed(text, PX.per_px());
        assert_eq!(px("1 in"), Some(300.0));
        assert_eq!(px("1e2"), Some(100.0));
        assert_eq!(px("−3"), Some(-3.0));
        let area = MM.per_px() * MM.per_px();
        assert!((MM.typed("90000 px²", area).unwrap() - 645.16).abs() < 1e-9);
        assert!((PX.typed("645.16 mm2", 1.0).unwrap() - 90_000.0).abs() < 1e-6);
    }
}
