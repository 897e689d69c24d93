//! The report on each drawn mark of a layer of spots or stripes.

use crate::attributes::{Attributes, Stripes};
use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::marks::Path;
use crate::rd::Hindrance;
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::matched;
use crate::synth::marks::plan::Plan;
use crate::synth::marks::plan::pinned_marks::{LeftOut, displacement};
use crate::synth::report::covered::covered;
use crate::synth::report::drawn::{DrawnMark, attributes_of, drawn_line, named};
use crate::synth::report::stripe_along::{drawn_stripe, stripe_along};

/// For each drawn mark of a layer, in the order of drawing, how it has grown; `pattern` gives the pattern of the layer. Empty if no
/// drawn mark was to be kept.
#[must_use]
pub fn drawn_marks(layer: &GrownMarks, pattern: &dyn Fn() -> Field) -> Vec<DrawnMark> {
    let mut marks = if layer.plan.pinned_lines().is_empty() { spots(layer) } else { lines(layer, pattern) };
    marks.sort_by_key(|mark| mark.mark);
    marks
}

fn spots(layer: &GrownMarks) -> Vec<DrawnMark> {
    let layout = layer.plan.lookup.map.layout();
    let own = matched(layer.corrections.pinned_spots(), layout, layer.measured.spots());
    let pinned = layer.corrections.pinned_spots().iter().zip(own).map(|(pinned, spot)| {
        let off = spot.map(|spot| {
            let [x, y] = displacement(spot.ellipse.center, pinned.visible.center, layout);
            (x * x + y * y).sqrt() / pinned.radius()
        });
        let half = spot.is_some_and(|spot| layer.half_grown.contains(&spot.ellipse.center));
        DrawnMark {
            mark: pinned.mark,
            there: spot.is_some(),
            off,
            asked: Some(attributes_of(&pinned.drawn)),
            got: spot.filter(|spot| spot.whole).map(|spot| attributes_of(&spot.ellipse)),
            reason: match spot {
                None => Some("its neighbours leave too little room for it"),
                Some(_) => half.then_some("it has grown by half"),
            },
            place: pinned.drawn.center,
        }
    });
    pinned.chain(left_out(layer.corrections.left_out())).collect()
}

/// The report on drawn spots that find no room. Most are known before the layer grows.
#[must_use]
pub fn left_out(marks: &[LeftOut]) -> Vec<DrawnMark> {
    let mark = |left_out: &LeftOut| DrawnMark {
        mark: left_out.mark,
        there: false,
        off: None,
        asked: Some(attributes_of(&left_out.drawn)),
        got: None,
        reason: Some(match left_out.reason {
            Hindrance::Neighbour => "closer to another drawn mark than such spots can be",
            Hindrance::Obstacle => "on a mark of a layer beneath, or too close to one",
        }),
        place: left_out.drawn.center,
    };
    marks.iter().map(mark).collect()
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

/// A note, before they grow, that names the drawn spots of `plan` that will not grow, with their places; `None` if all find room.
#[must_use]
pub fn expected_note(plan: &Plan) -> Option<String> {
    let left_out = left_out(plan.left_out());
    let missing: Vec<&DrawnMark> = left_out.iter().collect();
    let all = plan.pinned_spots().len() + missing.len();
    (!missing.is_empty())
        .then(|| format!("{} of {all} drawn marks will not grow: {}", missing.len(), named(&missing)))
}
