//! Laws in closed form for patches, streaks and cracks: attributes → parameters, without a canvas and without training rows.

use crate::attributes::{Spots, Spread, Stripes};
use crate::document::LineKind;
use crate::points::lines::{Course, WantedLines, mesh, radius};
use crate::points::patches::Wanted;
use crate::synth::areas::plan::patches::{MOST_COVERAGE, USUAL_COVERAGE, distance_of_points};
use crate::synth::lines::plan::{alone, share_of, shares};

/// A number with its name.
pub type Named = (&'static str, f64);

/// The answer of a law.
#[derive(Clone, Debug, PartialEq)]
pub struct ClosedForm {
    /// Parameters; lengths in px.
    pub parameters: Vec<Named>,
    /// The attributes of the marks that are expected to grow.
    pub predicted: Vec<Named>,
    /// Whether these are the attributes that were asked for.
    pub reached: bool,
    /// Notes for the user.
    pub notes: Vec<String>,
}

/// Raggedness this close to the one asked for counts as equal: the median error of grown patches.
const CLOSE: f64 = 0.02;

/// Patches of these attributes and this `raggedness`, at least 1, of `detail` points each. `None` = the least raggedness.
///
/// Parameters: `distance` of the points, `points` a patch, `sigma` of their costs, `metric`: the aspect of the metric in which
/// patches claim points, `coverage` of the canvas.
///
/// ```
/// use dapple_engine::attributes::Spots;
/// use dapple_engine::synth::closed_form::patches;
///
/// let spots = Spots { area: 900.0, aspect: 0.8, angle: 0.0, spacing: Some(45.0) };
/// let law = patches(&spots, Some(1.5), 24.0);
/// assert!(law.parameters.iter().any(|(name, value)| *name == "points" && *value > 1.0));
/// ```
#[must_use]
pub fn patches(spots: &Spots, raggedness: Option<f64>, detail: f64) -> ClosedForm {
    let Spots { area, aspect, angle, spacing } = *spots;
    let mut notes = Vec::new();
    let least = Wanted::spacing_of_coverage(area, MOST_COVERAGE);
    let usual = Wanted::spacing_of_coverage(area, USUAL_COVERAGE);
    if spacing.is_none() {
        notes.push(format!("spacing is free: {usual:.1} px taken"));
    }
    let asked = spacing.unwrap_or(usual);
    let mut wanted =
        Wanted { area, spacing: asked.max(least), aspect, angle, raggedness: 1.0, spread: Spread::ZERO };
    wanted.raggedness = raggedness.unwrap_or(wanted.raggedness_of(0.0, detail));
    if asked < least {
        notes.push(format!(
            "patches cover {:.0} % of the canvas at most: {least:.1} px apart",
            100.0 * MOST_COVERAGE
        ));
    }
    let shape = wanted.shape(detail);
    let got = wanted.nearest_raggedness(detail);
    let off = raggedness.map_or(0.0, |raggedness| got / raggedness - 1.0);
    let is_ragged_as_asked = off.abs() < CLOSE;
    if !is_ragged_as_asked {
        let which = if off > 0.0 { "smoothest" } else { "most ragged" };
        notes.push(format!("the {which} of such patches have a raggedness of {got:.2}"));
    }
    ClosedForm {
        parameters: vec![
            ("distance", distance_of_points(&wanted, detail)),
            ("points", wanted.points(detail)),
            ("sigma", shape.sigma),
            ("metric", shape.aspect),
            ("coverage", wanted.coverage()),
        ],
        predicted: vec![
            ("area", area),
            ("aspect", aspect),
            ("angle", angle),
            ("spacing", wanted.spacing),
            ("raggedness", got),
        ],
        reached: asked >= least && is_ragged_as_asked,
        notes,
    }
}

/// Streaks of `detail` points, or cracks, of these attributes.
///
/// Parameters: `distance` of the points, `share` of the canvas that is covered; for cracks also `mesh`, the distance of the knots.
#[must_use]
pub fn lines(kind: LineKind, stripes: &Stripes, detail: f64) -> ClosedForm {
    let course = match kind {
        LineKind::Streaks => Course::Streaks(detail),
        LineKind::Cracks => Course::Cracks,
    };
    let period = stripes.wavelength.unwrap_or(stripes.width / alone(kind));
    let asked = share_of(kind, stripes.width / period);
    let [least, most] = shares(kind);
    let share = asked.clamp(least, most);
    let wanted = WantedLines { width: stripes.width, share, angle: stripes.angle };
    let mut notes = Vec::new();
    if stripes.wavelength.is_none() {
        notes.push(format!("the share is free: {:.0} % of the canvas taken", 100.0 * asked));
    }
    let reached = (share - asked).abs() < 1e-9;
    if !reached {
        let [least, most] = [least, most].map(|share| 100.0 * share);
        let asked = 100.0 * asked;
        notes.push(format!(
            "{} cover {least:.0} % to {most:.0} % of the canvas, not {asked:.0} %",
            kind.description().name
        ));
    }
    let (mut parameters, mut predicted) =
        (vec![("distance", radius(course, &wanted)), ("share", share)], vec![("width", stripes.width)]);
    match kind {
        LineKind::Streaks => {
            parameters.push(("points", detail));
            predicted.extend([("angle", stripes.angle), ("wavelength", stripes.width / share)]);
        }
        LineKind::Cracks => parameters.push(("mesh", mesh(&wanted))),
    }
    predicted.push(("share", share));
    ClosedForm { parameters, predicted, reached, notes }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::points::patches::Patches;

    fn value(named: &[Named], name: &str) -> f64 {
        named.iter().find(|(other, _)| *other == name).expect("the name").1
    }

    const SPOTS: Spots = Spots { area: 900.0, aspect: 0.7, angle: 20.0, spacing: Some(60.0) };

    #[test]
    fn patches_twice_as_large_and_apart_have_points_twice_as_far_apart_and_the_same_shape() {
        let small = patches(&SPOTS, Some(1.4), Patches::DETAIL);
        let large = patches(
            &Spots { area: 4.0 * SPOTS.area, spacing: Some(120.0), ..SPOTS },
            Some(1.4),
            Patches::DETAIL,
        );
        assert!(small.reached && small.notes.is_empty());
        let times = |name| value(&large.parameters, name) / value(&small.parameters, name);
        assert!((times("distance") - 2.0).abs() < 1e-9);
        for name in ["points", "sigma", "metric", "coverage"] {
            assert!((times(name) - 1.0).abs() < 1e-9, "{name}");
        }
        assert!((value(&small.predicted, "raggedness") - 1.4).abs() < 1e-6);
    }

    #[test]
    fn impossible_patches_are_noted() {
        let dense = patches(&Spots { spacing: Some(30.0), ..SPOTS }, Some(1.4), Patches::DETAIL);
        assert!(!dense.reached && dense.notes[0].contains("72 %"), "{dense:?}");
        assert!(value(&dense.predicted, "spacing") > 30.0);
        let smooth = patches(&SPOTS, Some(1.0), Patches::DETAIL);
        assert!(!smooth.reached && smooth.notes[0].contains("smoothest"), "{smooth:?}");
        assert!(patches(&SPOTS, None, Patches::DETAIL).reached);
        let free = patches(&Spots { spacing: None, ..SPOTS }, Some(1.4), Patches::DETAIL);
        assert!(free.reached && (value(&free.parameters, "coverage") - 0.35).abs() < 1e-9);
    }

    #[test]
    fn lines_cover_the_share_of_their_duty_within_what_grows() {
        let of = |kind, period| {
            lines(kind, &Stripes { width: 8.0, angle: 30.0, wavelength: Some(period) }, Patches::DETAIL)
        };
        let streaks = of(LineKind::Streaks, 20.0);
        assert!(streaks.reached && (value(&streaks.predicted, "wavelength") - 20.0).abs() < 1e-9);
        // Cracks run in both directions.
        assert!((value(&of(LineKind::Cracks, 80.0).parameters, "share") - 0.19).abs() < 1e-9);
        let thin = of(LineKind::Streaks, 80.0);
        assert!(!thin.reached && thin.notes[0].contains("20 % to 60 %"), "{thin:?}");
    }
}
