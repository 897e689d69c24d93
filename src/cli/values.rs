//! Arguments → checked values; clap adds the argument's name and text to each message.

use std::fmt::Display;
use std::ops::RangeInclusive;

use crate::attributes::Stripes;
use crate::attributes::system::{Description, Family, LookupBy};
use crate::document::layer_rules::{Beneath, Combination};
use crate::document::systems::{self, SYSTEMS};
use crate::document::{DutyChoice, Layer, LayerOptions, OptionKey, SystemChoice, limits};
use crate::export::outline::Ends;
use crate::finish::Kind as FinishKind;
use crate::marks::axial;
use crate::photo::{Corners, Crop, LEVELS};

/// `WxH`, such as `4096x4096`, px, or one number for both sides.
pub(super) fn size(text: &str) -> Result<[u32; 2], String> {
    let allowed = || {
        format!(
            "allowed: WIDTHxHEIGHT, 1 to {} px each, such as 4096x4096, or one number for both",
            limits::MAX_SIDE
        )
    };
    let is_one = !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit());
    let both = is_one.then_some((text, text));
    let (width, height) = both.or_else(|| text.split_once(['x', 'X', '×'])).ok_or_else(allowed)?;
    let side = |text: &str| {
        // Rust's parser would accept `+5`.
        let side = text.bytes().all(|c| c.is_ascii_digit()).then(|| text.parse::<u64>().ok()).flatten();
        let side = side.ok_or_else(|| format!("found {text:?} for a side; {}", allowed()))?;
        let whole = u32::try_from(side).ok().filter(|side| (1..=limits::MAX_SIDE).contains(side));
        whole.ok_or_else(|| format!("found a side of {side} px; allowed: 1 to {}", limits::MAX_SIDE))
    };
    Ok([side(width)?, side(height)?])
}

/// The name of a finish, such as `fur`.
pub(super) fn finish(text: &str) -> Result<FinishKind, String> {
    let named = FinishKind::NAMES.iter().find(|(name, _)| *name == text).map(|(_, kind)| *kind);
    let names = || FinishKind::NAMES.map(|(name, _)| name).join(", ");
    named.ok_or_else(|| format!("allowed: {}", names()))
}

/// Columns and rows of regions, `CxR`, for example `3x2`.
pub(super) fn regions(text: &str) -> Result<[usize; 2], String> {
    let allowed = || format!("allowed: COLUMNSxROWS, 1 to {} each, such as 3x2", limits::MAX_REGIONS);
    let (columns, rows) = text.split_once(['x', 'X', '×']).ok_or_else(allowed)?;
    let count = |text: &str| {
        let count = text.bytes().all(|c| c.is_ascii_digit()).then(|| text.parse::<usize>().ok()).flatten();
        count.filter(|count| (1..=limits::MAX_REGIONS as usize).contains(count)).ok_or_else(allowed)
    };
    Ok([count(columns)?, count(rows)?])
}

/// A part of a picture, `X,Y,W,H`, whole px.
pub(super) fn crop(text: &str) -> Result<Crop, String> {
    const ALLOWED: &str = "allowed: X,Y,WIDTH,HEIGHT in whole px, such as 200,100,800,600";
    let numbers: Option<Vec<usize>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, width, height]) if width > 0 && height > 0 => {
            Ok(Crop { from: [x, y], size: [width, height] })
        }
        _ => Err(ALLOWED.to_owned()),
    }
}

/// Four corners, eight numbers, px.
pub(super) fn corners(text: &str) -> Result<Corners, String> {
    const ALLOWED: &str = "allowed: X,Y of four corners in px, from the upper left one clockwise, such as 10,20,790,0,800,600,0,580";
    let number = |number: &str| number.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    let numbers: Option<Vec<f64>> = text.split(',').map(number).collect();
    match numbers.as_deref() {
        Some(&[a, b, c, d, e, f, g, h]) => Ok(Corners([[a, b], [c, d], [e, f], [g, h]])),
        _ => Err(ALLOWED.to_owned()),
    }
}

/// Largest relief, px: more than the widest canvas.
const MAX_RELIEF: f64 = 1e5;

/// The height of marks above the ground, px.
pub(super) fn relief(text: &str) -> Result<f64, String> {
    let number = text.trim().parse::<f64>().ok().filter(|number| number.abs() <= MAX_RELIEF);
    number.ok_or_else(|| format!("allowed: numbers from -{MAX_RELIEF} to {MAX_RELIEF}, such as 6 or 6,-2"))
}

/// A level between ground (0) and marks (1).
pub(super) fn edge_level(text: &str) -> Result<f32, String> {
    let [low, high] = LEVELS;
    let number = text.trim().parse::<f32>().ok().filter(|number| (low..=high).contains(number));
    number.ok_or_else(|| format!("allowed: a number from {low} to {high}"))
}

/// A system with training rows, by name, or `stripes`; not `auto`, which chooses by the marks of a document.
pub(super) fn system(text: &str) -> Result<SystemChoice, String> {
    stripes_or(text, |system| matches!(system.lookup, LookupBy::Rows))
}

/// A system with training rows, those of pairs too, by name.
pub(super) fn learnt(text: &str) -> Result<SystemChoice, String> {
    system_where(text, has_rows)
}

/// The argument of a command that asks for one of [`learnt`].
pub(super) fn learnt_help() -> String {
    format!("Only this system: {}", names_where(has_rows))
}

/// A system with training rows, or with laws in closed form, by name, or `stripes`.
pub(super) fn looked_up(text: &str) -> Result<SystemChoice, String> {
    stripes_or(text, |system| has_rows(system) || is_by_law(system))
}

/// The argument of a command that asks for one of [`looked_up`].
pub(super) fn looked_up_help() -> String {
    let [rows, laws] = [names_where(has_rows), names_where(is_by_law)];
    format!("The system: {rows}, stripes (whichever grows them), or, by laws in closed form, {laws}")
}

/// Whether it has training rows, of its parameters or of how far its laws are off.
fn has_rows(system: &Description) -> bool {
    matches!(system.lookup, LookupBy::Rows | LookupBy::Pairs(_))
}

fn is_by_law(system: &Description) -> bool {
    matches!(system.lookup, LookupBy::Law)
}

fn system_where(text: &str, allowed: impl Fn(&Description) -> bool) -> Result<SystemChoice, String> {
    let system = systems::named(text).filter(|system| allowed(system));
    system.map(SystemChoice::Of).ok_or_else(|| format!("allowed: {}", names_where(allowed)))
}

/// The allowed system of this name, or `stripes`, which leaves the system open: see [`SystemChoice::with_stripes_chosen`].
fn stripes_or(text: &str, allowed: impl Fn(&Description) -> bool) -> Result<SystemChoice, String> {
    let stripes = SystemChoice::Stripes;
    if text == stripes.name() {
        return Ok(stripes);
    }
    system_where(text, allowed).map_err(|allowed| format!("{allowed}, {}", stripes.name()))
}

/// The names of all such systems.
fn names_where(allowed: impl Fn(&Description) -> bool) -> String {
    let named = SYSTEMS.iter().filter(|system| allowed(system)).map(|system| system.name);
    named.collect::<Vec<_>>().join(", ")
}

/// A length (px) or an area (px²).
pub(super) fn positive(text: &str) -> Result<f64, String> {
    // More than the area of the largest canvas, less than that of the smallest mark, and far from where squares and
    // quotients overflow.
    let number = text.parse::<f64>().ok().filter(|number| (1e-6..=1e12).contains(number));
    number.ok_or_else(|| "allowed: a number above 0, from 1e-6 to 1e12".to_owned())
}

/// An aspect.
pub(super) fn aspect(text: &str) -> Result<f64, String> {
    // Far below the narrowest mark that grows; for smaller values the longer radius overflows.
    const LEAST: f64 = 1e-6;
    let number = text.parse::<f64>().ok().filter(|number| (LEAST..=1.0).contains(number));
    number.ok_or_else(|| format!("allowed: minor / major radius, {LEAST} to 1 (round)"))
}

/// A raggedness.
pub(super) fn raggedness(text: &str) -> Result<f64, String> {
    // Beyond this value patches are only threads, and so are spirals.
    const MOST: f64 = 100.0;
    let number = text.parse::<f64>().ok().filter(|number| (1.0..=MOST).contains(number));
    number.ok_or_else(|| format!("allowed: (contour ÷ contour of an ellipse)², 1 to {MOST}"))
}

/// Stripe width ÷ period.
pub(super) fn duty(text: &str) -> Result<f64, String> {
    let limits::Range { low, high, .. } = limits::DUTY;
    let number = text.parse::<f64>().ok().filter(|number| (low..=high).contains(number));
    number.ok_or_else(|| format!("allowed: {}", limits::DUTY))
}

/// Why stripes of `system` cannot have this duty, and which duties they can have; `None` where they can.
pub(super) fn duty_mismatch(duty: f64, system: SystemChoice) -> Option<String> {
    let layer = Layer {
        system,
        options: LayerOptions { duty: DutyChoice::Given(duty), ..LayerOptions::default() },
        ..Layer::default()
    };
    let rule = Combination::new(&layer, None, Beneath::Unknown).against_option(OptionKey::Duty);
    rule.filter(|_| duty != LayerOptions::DUTY).map(|rule| format!("{}. {}", LayerOptions::DUTY, rule.reason))
}

/// The attributes of stripes that `system` grows.
pub(super) fn stripes(system: SystemChoice, width: f64, angle: f64, duty: Option<f64>) -> Stripes {
    // Streaks and cracks have their own usual share.
    let usual = if system.kind() == Some(Family::Lines) { None } else { Some(LayerOptions::DUTY) };
    let period = duty.or(usual).map(|duty| width / duty);
    let wavelength = period.filter(|_| system.is_known(|system| system.free_spacing));
    Stripes { width, angle: axial(angle), wavelength }
}

/// An angle.
pub(super) fn angle(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| "allowed: any finite number of degrees".to_owned())
}

/// Another direction of lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Across {
    /// Direction, degrees.
    pub angle: f64,
    /// Width, px; `None` = that of the first direction.
    pub width: Option<f64>,
    /// Width ÷ period; `None` = that of the first direction.
    pub duty: Option<f64>,
}

/// Another direction of lines: its angle, and perhaps its width and duty.
pub(super) fn across(text: &str) -> Result<Across, String> {
    let allowed = "allowed: D, D,W or D,W,Q: an angle in degrees, a width in px, width ÷ period";
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let part = |index: usize, parse: fn(&str) -> Result<f64, String>| {
        parts.get(index).map(|part| parse(part).map_err(|why| format!("'{part}': {why}"))).transpose()
    };
    let angle = part(0, angle)?.filter(|_| parts.len() <= 3).ok_or(allowed)?;
    Ok(Across { angle, width: part(1, positive)?, duty: part(2, duty)? })
}

/// The decay of stucco.
pub(super) fn decay(text: &str) -> Result<f64, String> {
    let limits::Range { low, high, .. } = limits::DECAY;
    let number = text.parse::<f64>().ok().filter(|number| (low..=high).contains(number));
    number.ok_or_else(|| format!("allowed: {}", limits::DECAY))
}

/// A whole number in this range.
pub(super) fn whole<T>(range: RangeInclusive<T>) -> impl Fn(&str) -> Result<T, String> + Clone
where
    T: TryFrom<i128> + PartialOrd + Display + Clone,
{
    move |text| {
        let number = text.parse::<i128>().ok().and_then(|number| T::try_from(number).ok());
        let number = number.filter(|number| range.contains(number));
        number.ok_or_else(|| format!("allowed: a whole number from {} to {}", range.start(), range.end()))
    }
}

/// The seed of all random numbers.
pub(super) fn seed(text: &str) -> Result<u64, String> {
    whole(0..=u64::MAX)(text)
}

/// A number of threads.
pub(super) fn threads(text: &str) -> Result<usize, String> {
    whole(1..=1024)(text)
}

/// Bits of a colour.
pub(super) fn bits(text: &str) -> Result<u8, String> {
    match text {
        "8" => Ok(8),
        "16" => Ok(16),
        _ => Err("allowed: 8, 16".to_owned()),
    }
}

/// A duration, seconds.
pub(super) fn seconds(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| (0.0..=600.0).contains(number));
    number.ok_or_else(|| "allowed: 0 to 600 seconds".to_owned())
}

/// A number of rows, columns or pictures.
pub(super) fn count(text: &str) -> Result<usize, String> {
    whole(1..=1000)(text)
}

/// Cells along each side of a grid to benchmark. The largest takes about 3 GB.
pub(super) fn grid_side(text: &str) -> Result<usize, String> {
    whole(16..=4096)(text).map_err(|allowed| format!("{allowed} cells"))
}

/// Dots per inch.
pub(super) fn dpi(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| limits::DPI.holds(*number));
    number.ok_or_else(|| format!("allowed: {}", limits::DPI))
}

/// The pattern value that outlines follow.
pub(super) fn level(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| *number > 0.0 && *number < 1.0);
    number.ok_or_else(|| {
        "allowed: a pattern value above 0 and below 1; 0.5 is the edge of the marks".to_owned()
    })
}

/// The unit of lengths of outlines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Units {
    /// Millimetres.
    Mm,
    /// Canvas px.
    Px,
}

/// `mm` or `px`.
pub(super) fn unit(text: &str) -> Result<Units, String> {
    match text {
        "mm" => Ok(Units::Mm),
        "px" => Ok(Units::Px),
        _ => Err("allowed: mm, px".to_owned()),
    }
}

/// A way to draw outlines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StylePart {
    /// Filled areas.
    Fill,
    /// Strokes along them.
    Stroke,
    /// Parallel strokes.
    Hatch {
        /// Distance of the strokes, in the unit of the outlines.
        spacing: f64,
        /// Direction of the strokes, degrees.
        angle: f64,
    },
}

/// `fill`, `stroke`, `hatch:SPACING` or `hatch:SPACING:ANGLE`.
pub(super) fn style(text: &str) -> Result<StylePart, String> {
    let mut parts = text.split(':');
    let words = [parts.next(), parts.next(), parts.next(), parts.next()];
    match words {
        [Some("fill"), None, ..] => Ok(StylePart::Fill),
        [Some("stroke"), None, ..] => Ok(StylePart::Stroke),
        [Some("hatch"), Some(spacing), degrees, None] => Ok(StylePart::Hatch {
            spacing: positive(spacing).map_err(|allowed| format!("spacing {spacing:?}: {allowed}"))?,
            angle: degrees
                .map_or(Ok(45.0), angle)
                .map_err(|allowed| format!("angle {:?}: {allowed}", degrees.unwrap_or_default()))?,
        }),
        _ => {
            Err("allowed: fill, stroke, hatch:SPACING, hatch:SPACING:ANGLE, such as hatch:1.5:45".to_owned())
        }
    }
}

/// `closed` or `cut`.
pub(super) fn ends(text: &str) -> Result<Ends, String> {
    match text {
        "closed" => Ok(Ends::Closed),
        "cut" => Ok(Ends::Cut),
        _ => Err("allowed: closed, cut".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rd::System;

    #[test]
    fn a_size_is_two_sides_or_one_for_both() {
        assert_eq!(size("4096x2048"), Ok([4096, 2048]));
        assert_eq!(size("1×65536"), Ok([1, 65536]));
        assert_eq!(size("512"), Ok([512, 512]));
        for wrong in
            ["", "x", "0", "0x10", "10x0", "-5x5", "+5x5", "5x5x5", "1e3x5", "65537x1", "5 x5", "nanx1"]
        {
            assert!(size(wrong).is_err(), "{wrong}");
        }
        let huge = size("99999999999999999999999x5").unwrap_err();
        assert!(huge.contains("allowed"), "{huge}");
    }

    #[test]
    fn invalid_numbers_are_refused() {
        for wrong in ["nan", "inf", "-inf", "0", "-1", "1e999", ""] {
            assert!(positive(wrong).is_err(), "{wrong}");
            assert!(aspect(wrong).is_err(), "{wrong}");
        }
        assert!(aspect("1.01").is_err());
        assert!(angle("nan").is_err() && angle("inf").is_err());
        assert_eq!(angle("-30"), Ok(-30.0));
    }

    #[test]
    fn a_whole_number_lies_in_its_range_and_is_refused_in_words() {
        let fps = whole(1..=120u16);
        assert_eq!([fps("1"), fps("120")], [Ok(1), Ok(120)]);
        assert_eq!(seed("18446744073709551615"), Ok(u64::MAX));
        for wrong in
            ["", "0", "121", "-1", "1.5", "1e30", "nan", "99999999999999999999999999999999999999999999"]
        {
            assert_eq!(fps(wrong), Err("allowed: a whole number from 1 to 120".to_owned()), "{wrong}");
        }
    }

    #[test]
    fn a_style_is_a_word_or_a_hatch_with_numbers() {
        assert_eq!(style("fill"), Ok(StylePart::Fill));
        assert_eq!(style("hatch:1.5"), Ok(StylePart::Hatch { spacing: 1.5, angle: 45.0 }));
        assert_eq!(style("hatch:2:-30"), Ok(StylePart::Hatch { spacing: 2.0, angle: -30.0 }));
        for wrong in
            ["", "hatch", "hatch:", "hatch:0", "hatch:-1", "hatch:nan", "hatch:1:x", "hatch:1:2:3", "fill:1"]
        {
            assert!(style(wrong).unwrap_err().contains("allowed"), "{wrong}");
        }
        for wrong in ["0", "1", "-1", "nan", "x"] {
            assert!(level(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_system_to_look_up_has_a_name() {
        assert_eq!(system("turing-spots"), Ok(SystemChoice::Of(System::TURING_SPOTS.description())));
        assert!(system("auto").unwrap_err().contains("meinhardt-stripes"));
    }
}
