//! Units of length for the user: px, or mm by the document's dots per inch. Documents hold px.

use serde::{Deserialize, Serialize};

use super::arithmetic::evaluate;

/// A unit of length.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Units {
    /// Px of the canvas.
    #[default]
    Px,
    /// Millimetres.
    Mm,
}

/// Converts between px and the user's unit, as text and as numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ruler {
    /// The unit.
    pub units: Units,
    /// Dots per inch, > 0.
    pub dpi: f64,
}

/// Millimetres per inch.
const INCH: f64 = 25.4;

impl Ruler {
    /// Units per px.
    #[must_use]
    pub fn per_px(self) -> f64 {
        match self.units {
            Units::Px => 1.0,
            Units::Mm => INCH / self.dpi,
        }
    }

    /// The suffix of a length.
    #[must_use]
    pub fn unit(self) -> &'static str {
        match self.units {
            Units::Px => " px",
            Units::Mm => " mm",
        }
    }

    /// The suffix of an area.
    #[must_use]
    pub fn unit_of_area(self) -> &'static str {
        match self.units {
            Units::Px => " px²",
            Units::Mm => " mm²",
        }
    }

    /// Decimals that show about a tenth of a px.
    #[must_use]
    pub fn decimals(self) -> usize {
        match self.units {
            Units::Px => 1,
            Units::Mm => digits(0.1 * self.per_px()),
        }
    }

    /// Decimals that show about half a px².
    #[must_use]
    pub fn decimals_of_area(self) -> usize {
        match self.units {
            Units::Px => 1,
            Units::Mm => digits(0.5 * self.per_px() * self.per_px()),
        }
    }

    /// A length of `px` as text, to about a tenth of a px.
    #[must_use]
    pub fn length(self, px: f64) -> String {
        format!("{:.*}{}", self.decimals(), px * self.per_px(), self.unit())
    }

    /// A length of `px` as text, to about a px.
    #[must_use]
    pub fn rough(self, px: f64) -> String {
        match self.units {
            Units::Px => format!("{px:.0} px"),
            Units::Mm => format!("{:.*} mm", digits(self.per_px()), px * self.per_px()),
        }
    }

    /// A point of the canvas as text, to about a px.
    #[must_use]
    pub fn place(self, [x, y]: [f64; 2]) -> String {
        let x = self.rough(x);
        format!("{}, {}", x.trim_end_matches(self.unit()), self.rough(y))
    }

    /// An area of `px²` as text, to about a px².
    #[must_use]
    pub fn area(self, px: f64) -> String {
        match self.units {
            Units::Px => format!("{px:.0} px²"),
            Units::Mm => format!("{:.*} mm²", self.decimals_of_area(), px * self.per_px() * self.per_px()),
        }
    }

    /// Computes a length or an area that was typed, such as `3 mm`, `0.3cm + 2` or `20*1.5`. A number without a unit is
    /// in the user's unit. `factor` is the number of the user's units per px or px². `None` where the text is not such
    /// a length or area.
    #[must_use]
    pub fn parse(self, text: &str, factor: f64) -> Option<f64> {
        evaluate(text, &|number, unit| {
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
        })
    }
}

/// Decimals that show steps of `step`.
pub(crate) fn digits(step: f64) -> usize {
    // A third of a digit less would hide a step; one digit more would be meaningless.
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
        let mm = |text| MM.parse(text, MM.per_px());
        assert_eq!(mm("2.5"), Some(2.5));
        assert_eq!(mm("2,5 mm"), Some(2.5));
        assert!((mm("0.25cm").unwrap() - 2.5).abs() < 1e-12);
        assert!((mm("300 px").unwrap() - 25.4).abs() < 1e-12);
        assert_eq!(mm("2 apples"), None);
        assert_eq!(mm(""), None);
        assert!((mm("1 mm + 0.1 cm * 2").unwrap() - 3.0).abs() < 1e-12);
        let px = |text| PX.parse(text, PX.per_px());
        assert_eq!(px("20*1.5"), Some(30.0));
        assert_eq!(px("1 in"), Some(300.0));
        assert_eq!(px("1e2"), Some(100.0));
        assert_eq!(px("−3"), Some(-3.0));
        let area = MM.per_px() * MM.per_px();
        assert!((MM.parse("90000 px²", area).unwrap() - 645.16).abs() < 1e-9);
        assert!((PX.parse("645.16 mm2", 1.0).unwrap() - 90_000.0).abs() < 1e-6);
    }
}
