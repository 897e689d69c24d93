//! How well the grown texture reaches what was asked for: signs that differ in shape, word and colour.

use egui::{Color32, Painter, Rect, Shape, Stroke, pos2, vec2};

use crate::app::theme::Palette;
use crate::attributes::Attribute;
use crate::synth::report::RegionReport;

/// How well a value is reached, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Within the tolerance that cannot be seen.
    Met,
    /// Nothing was measured.
    Unknown,
    /// Slightly off.
    Near,
    /// Clearly off, or beyond what the system can grow.
    Missed,
}

/// The largest errors of an attribute that count as reached, and as close. They are relative, except for the aspect (a
/// difference) and the angle (degrees). 5 % is the limit of the error tables; three times that is clearly visible
/// beside the drawn mark.
fn allowed(attribute: Attribute) -> Option<[f64; 2]> {
    match attribute {
        Attribute::Area | Attribute::Spacing | Attribute::Width | Attribute::Wavelength => Some([0.05, 0.15]),
        Attribute::Aspect => Some([0.05, 0.12]),
        Attribute::Angle => Some([5.0, 15.0]),
        _ => None,
    }
}

impl Verdict {
    /// The verdict on the error of an attribute; `None` for attributes that are not judged.
    #[must_use]
    pub fn for_error(attribute: Attribute, error: f64) -> Option<Self> {
        let [met, near] = allowed(attribute)?;
        Some(match error.abs() {
            error if error <= met => Self::Met,
            error if error <= near => Self::Near,
            _ => Self::Missed,
        })
    }

    /// The verdict on the numbers of a region: that on its worst attribute.
    #[must_use]
    pub fn for_region(report: &RegionReport) -> Self {
        if !report.beyond.is_empty() {
            return Self::Missed;
        }
        let all = report.error.iter().filter_map(|(attribute, error)| Self::for_error(*attribute, *error));
        all.max().unwrap_or(Self::Unknown)
    }

    /// Its label.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Met => "reached",
            Self::Unknown => "not measured",
            Self::Near => "close",
            Self::Missed => "missed",
        }
    }

    /// Its tooltip.
    #[must_use]
    pub fn help(self) -> &'static str {
        match self {
            Self::Met => {
                "Reached: area, spacing and width within 5 %, aspect within 0.05, direction within 5°, and every mark grew \
                 as it was drawn"
            }
            Self::Unknown => "Not measured: no whole mark grew here",
            Self::Near => "Close: area, spacing or width off by up to 15 %, aspect by 0.12, direction by 15°",
            Self::Missed => {
                "Missed: off by more (over 15 %, 0.12 or 15°), not possible with this system, or a mark did not grow as it \
                 was drawn"
            }
        }
    }

    fn colour(self, palette: &Palette) -> Color32 {
        match self {
            Self::Met => palette.accent,
            Self::Unknown => palette.border,
            Self::Near => palette.edge,
            Self::Missed => palette.wrong,
        }
    }

    /// Paints the sign into a square: a disc with a tick, a diamond with a wave, a triangle with an exclamation mark, a
    /// ring.
    pub fn paint(self, painter: &Painter, rect: Rect, palette: &Palette) {
        let unit = rect.width() / 16.0;
        let at = |[x, y]: [f32; 2]| rect.min + vec2(x, y) * unit;
        let all = |points: &[[f32; 2]]| points.iter().map(|point| at(*point)).collect::<Vec<_>>();
        let colour = self.colour(palette);
        let sign = Stroke::new(1.9 * unit, palette.paper);
        let halo = Stroke::new(1.5 * unit, palette.paper);
        match self {
            Self::Met => {
                painter.circle(at([8.0, 8.0]), 7.0 * unit, colour, halo);
                painter.add(Shape::line(all(&[[4.8, 8.3], [7.1, 10.6], [11.3, 5.6]]), sign));
            }
            Self::Unknown => {
                painter.circle(at([8.0, 8.0]), 6.0 * unit, palette.paper, Stroke::new(1.6 * unit, colour));
                painter.line_segment([at([5.3, 8.0]), at([10.7, 8.0])], Stroke::new(1.6 * unit, colour));
            }
            Self::Near => {
                let diamond = all(&[[8.0, 0.4], [15.6, 8.0], [8.0, 15.6], [0.4, 8.0]]);
                painter.add(Shape::convex_polygon(diamond, colour, halo));
                let wave = all(&[[4.2, 9.1], [5.4, 7.4], [6.8, 7.3], [9.2, 8.7], [10.6, 8.6], [11.8, 6.9]]);
                painter.add(Shape::line(wave, sign));
            }
            Self::Missed => {
                let triangle = all(&[[8.0, 0.8], [15.6, 14.6], [0.4, 14.6]]);
                painter.add(Shape::convex_polygon(triangle, colour, halo));
                painter.line_segment([at([8.0, 5.2]), at([8.0, 9.8])], sign);
                painter.circle_filled(at([8.0, 12.2]), 1.1 * unit, palette.paper);
            }
        }
    }

    /// The square of side `side` whose upper right corner is `inset` from that of `region`.
    #[must_use]
    pub fn corner(region: Rect, side: f32, inset: f32) -> Rect {
        Rect::from_min_size(pos2(region.right() - inset - side, region.top() + inset), vec2(side, side))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_of_both_signs_are_judged() {
        for (attribute, error, verdict) in [
            (Attribute::Area, 0.04, Verdict::Met),
            (Attribute::Area, -0.06, Verdict::Near),
            (Attribute::Spacing, 0.2, Verdict::Missed),
            (Attribute::Aspect, -0.1, Verdict::Near),
            (Attribute::Angle, -4.0, Verdict::Met),
            (Attribute::Angle, 30.0, Verdict::Missed),
        ] {
            assert_eq!(Verdict::for_error(attribute, error), Some(verdict), "{attribute} {error}");
        }
        assert_eq!(Verdict::for_error(Attribute::AngleScatter, 30.0), None);
    }
}
