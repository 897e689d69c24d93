//! What became of each drawn mark.

use serde::Serialize;

use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Spots, Stripes};
use crate::marks::{Ellipse, Path};
use crate::synth::report::covered::COVERED;

/// What became of a drawn mark that was to be among those that grow.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DrawnMark {
    /// Its index among the strokes of the layer.
    pub mark: usize,
    /// Whether it grew: a spot of its own within half its radius √(r₁r₂), a line of which nine tenths lie in stripes,
    /// as far as it is not on marks of the layers beneath.
    pub there: bool,
    /// How far it is from its place, ÷ its radius; of a line the share that lies in no stripe. `None` of a spot that did not
    /// grow.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub off: Option<f64>,
    /// What was drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asked: Option<Attributes>,
    /// What grew, of a spot that is whole, or of the stripe along a line.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Attributes>,
    /// Why it is not there, or that it has grown by half.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<&'static str>,
    /// Where it was drawn, px.
    #[serde(skip)]
    pub place: [f64; 2],
}

/// What became of a drawn line, by its index, of which this share is `covered` by what grew; `None` = nothing of it can be seen.
/// `oblique` says why less than nine tenths are.
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

/// Marks that a note names at most.
pub(in crate::synth) const NAMED: usize = 8;

/// A note that names the marks that are not there, with their places; `None` where all are. Of lines, what they should
/// lie in: `"stripes"` or `"threads"`.
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
