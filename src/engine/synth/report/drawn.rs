//! The report on each drawn mark.

use serde::Serialize;

use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Spots, Stripes};
use crate::marks::{Ellipse, Path};
use crate::synth::report::covered::COVERED;

/// A drawn mark that was to be kept, and how it has grown.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnMark {
    /// Its index among the strokes of the layer.
    pub mark: usize,
    /// Whether it grew: for a spot, a grown spot of its own within half its radius √(r₁r₂); for a line, nine tenths of it in
    /// stripes. The parts on marks of the layers beneath are ignored.
    pub there: bool,
    /// Distance from its place, in radii; for a line the share that lies in no stripe. `None` for a spot that did not grow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub off: Option<f64>,
    /// The drawn attributes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asked: Option<Attributes>,
    /// The grown attributes, of a whole spot, or of the stripe along a line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Attributes>,
    /// The reason why it did not grow, or that it is half grown.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<&'static str>,
    /// Place where the mark was drawn, px.
    #[serde(skip)]
    pub place: [f64; 2],
}

/// The report on a drawn line, by its index, of which grown stripes cover the share `covered`; `None` = no part of it is visible.
/// `oblique` is the reason if less than nine tenths are covered.
#[must_use]
pub fn drawn_line(
    (mark, line): (usize, &Path),
    covered: Option<f64>,
    asked: Stripes,
    got: Option<Stripes>,
    oblique: &'static str,
) -> DrawnMark {
    DrawnMark {
        mark,
        there: covered.is_some_and(|covered| covered >= COVERED),
        off: Some(1.0 - covered.unwrap_or(0.0)),
        asked: Some(Attributes::Stripes(asked)),
        got: got.map(Attributes::Stripes),
        reason: match covered {
            None => Some("on marks of a layer beneath, or outside of the canvas"),
            Some(covered) if covered < COVERED => Some(oblique),
            Some(_) => None,
        },
        place: line.center(),
    }
}

/// The attributes of one drawn or grown spot.
#[must_use]
pub fn attributes_of(ellipse: &Ellipse) -> Attributes {
    Attributes::Spots(Spots {
        area: ellipse.area(),
        aspect: ellipse.aspect(),
        angle: ellipse.major_angle(),
        spacing: None,
    })
}

/// The `drawn` marks in each region of `layout`.
#[must_use]
pub fn by_region(drawn: &[DrawnMark], layout: &RegionGrid) -> Vec<Vec<DrawnMark>> {
    let mut regions = vec![Vec::new(); layout.len()];
    drawn.iter().for_each(|mark| regions[layout.index(layout.region_of(mark.place))].push(mark.clone()));
    regions
}

/// Most marks that a note names.
pub(in crate::synth) const NAMED: usize = 8;

/// A note that names the missing marks, with their places; `None` if none is missing. `lines_in` names the stripes in which lines
/// should lie: `"stripes"` or `"threads"`.
#[must_use]
pub fn note(marks: &[DrawnMark], lines_in: Option<&str>) -> Option<String> {
    let missing: Vec<&DrawnMark> = marks.iter().filter(|mark| !mark.there).collect();
    if missing.is_empty() {
        return None;
    }
    let what = match lines_in {
        Some(stripes) => format!("lines lie partly outside of {stripes}"),
        None => "marks did not grow".to_owned(),
    };
    Some(format!("{} of {} drawn {what}: {}", missing.len(), marks.len(), named(&missing)))
}

/// The places of the first marks, and why they are missing.
pub(in crate::synth) fn named(missing: &[&DrawnMark]) -> String {
    let named = missing.iter().take(NAMED).map(|mark| {
        let [x, y] = mark.place;
        format!("at ({x:.0}, {y:.0}): {}", mark.reason.unwrap_or_default())
    });
    let more = missing.len().saturating_sub(NAMED);
    let more = if more > 0 { format!("; and {more} more") } else { String::new() };
    format!("{}{more}", named.collect::<Vec<_>>().join("; "))
}
