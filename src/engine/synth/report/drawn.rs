//! What became of each drawn mark.

use serde::Serialize;

use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Spots, Stripes};
use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::marks::{Ellipse, Path};
use crate::rd::Hindrance;
use crate::synth::grow::layer::GrownMarks;
use crate::synth::grow::pinned_correction::matched;
use crate::synth::plan::Plan;
use crate::synth::plan::pinned_marks::{LeftOut, displacement};
use crate::synth::report::covered::{COVERED, covered};
use crate::synth::report::stripe_along::{drawn_stripe, stripe_along};

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
    /// Why it is not there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reason: Option<&'static str>,
    /// Where it was drawn, px.
    #[serde(skip)]
    pub place: [f64; 2],
}

/// What became of each drawn mark of a layer, in the order in which they were drawn; `pattern` gives its pattern. Empty
/// where none was to be among those that grow.
#[must_use]
pub fn drawn_marks(layer: &GrownMarks, pattern: &dyn Fn() -> Field) -> Vec<DrawnMark> {
    let mut marks = if layer.plan.pinned_lines().is_empty() { spots(layer) } else { lines(layer, pattern) };
    marks.sort_by_key(|mark| mark.mark);
    marks
}

fn spots(layer: &GrownMarks) -> Vec<DrawnMark> {
    let (plan, layout) = (&layer.plan, layer.plan.lookup.map.layout());
    let own = matched(plan.pinned_spots(), layout, layer.measured.spots());
    let pinned = plan.pinned_spots().iter().zip(own).map(|(pinned, spot)| {
        let off = spot.map(|spot| {
            let [x, y] = displacement(spot.ellipse.center, pinned.visible.center, layout);
            (x * x + y * y).sqrt() / pinned.radius()
        });
        DrawnMark {
            mark: pinned.mark,
            there: spot.is_some(),
            off,
            asked: Some(attributes(&pinned.drawn)),
            got: spot.filter(|spot| spot.whole).map(|spot| attributes(&spot.ellipse)),
            reason: spot.is_none().then_some("its neighbours leave too little room for it"),
            place: pinned.drawn.center,
        }
    });
    pinned.chain(left_out(plan)).collect()
}

/// The drawn spots of a layer that find no room: known before it grows.
#[must_use]
pub fn left_out(plan: &Plan) -> Vec<DrawnMark> {
    let mark = |left_out: &LeftOut| DrawnMark {
        mark: left_out.mark,
        there: false,
        off: None,
        asked: Some(attributes(&left_out.drawn)),
        got: None,
        reason: Some(match left_out.reason {
            Hindrance::Neighbour => "closer to another drawn mark than such spots can be",
            Hindrance::Obstacle => "on a mark of a layer beneath, or too close to one",
        }),
        place: left_out.drawn.center,
    };
    plan.left_out().iter().map(mark).collect()
}

fn lines(layer: &GrownMarks, pattern: &dyn Fn() -> Field) -> Vec<DrawnMark> {
    let (plan, layout) = (&layer.plan, layer.plan.lookup.map.layout());
    let surface = Spline::new(&pattern());
    let mark = |(mark, line): (usize, &Path)| {
        let covered = covered(line, layout, &surface, |point| plan.is_hidden(point));
        let asked = match plan.lookup.map.free().map(|free| free.own(mark)) {
            Some(Attributes::Stripes(own)) => own,
            _ => drawn_stripe(line),
        };
        let got = stripe_along(line, &surface, layout.bounds());
        let got = got
            .map(|got| Stripes { wavelength: got.wavelength.filter(|_| asked.wavelength.is_some()), ..got });
        let oblique = "closer to others than the period of the stripes, or oblique to them";
        drawn_line((mark, line), covered, asked, got, oblique)
    };
    plan.pinned_lines().iter().enumerate().map(mark).collect()
}

/// What became of a drawn line, by its index, of which this share is `covered` by what grew; `None` = nothing of it can be seen.
/// `oblique` says why less than nine tenths are.
pub(super) fn drawn_line(
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

fn attributes(ellipse: &Ellipse) -> Attributes {
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
const NAMED: usize = 8;

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

/// A note that names the drawn spots of `plan` that will not grow, with their places, before they grow; `None` where all find
/// room beside each other.
#[must_use]
pub fn expected_note(plan: &Plan) -> Option<String> {
    let left_out = left_out(plan);
    let missing: Vec<&DrawnMark> = left_out.iter().collect();
    let all = plan.pinned_spots().len() + missing.len();
    (!missing.is_empty())
        .then(|| format!("{} of {all} drawn marks will not grow: {}", missing.len(), named(&missing)))
}

/// The places of the first marks, and why they are missing.
fn named(missing: &[&DrawnMark]) -> String {
    let named = missing.iter().take(NAMED).map(|mark| {
        let [x, y] = mark.place;
        format!("at ({x:.0}, {y:.0}): {}", mark.reason.unwrap_or_default())
    });
    let more = missing.len().saturating_sub(NAMED);
    let more = if more > 0 { format!("; and {more} more") } else { String::new() };
    format!("{}{more}", named.collect::<Vec<_>>().join("; "))
}
