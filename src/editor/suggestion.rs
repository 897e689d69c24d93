//! Options that would bring the texture nearer to what was drawn: as ragged, as irregular or as different in size as the drawn marks.

use std::f64::consts::PI;

use crate::attributes::Spread;
use crate::document::{Kind, LayerOptions, OptionKey, Outline, RaggedChoice, SpreadChoice, Stroke, limits};
use crate::editor::layer_choices::{has_option, option_refusal};
use crate::editor::session::Session;
use crate::marks::{Ellipse, Mark, ellipse_of_outline};
use crate::sketch::difference_from_ellipse;

/// The least mean raggedness of drawn outlines, (contour ÷ that of the ellipse)², that is meant: smooth ones drawn by hand have 1.1
/// and less.
const RAGGED: f64 = 1.25;
/// The raggedness that is proposed, that of the patches of a Holstein.
const EDGES: f64 = 0.2;
/// The least mean share of the area by which smooth outlines differ from ellipses that is meant.
const DIFFERS: f64 = 0.12;
/// The irregularity that is proposed.
const IRREGULAR: f64 = 0.6;
/// The least coefficient of variation of the area that is meant.
const VARIES: f64 = 0.2;
/// The number of marks from which on their variation is measured, so that grown ones vary as they do.
const MEASURED: usize = 6;

/// An option that would help.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Suggestion {
    /// Ragged edges.
    Ragged,
    /// Irregular shapes.
    Irregular,
    /// Sizes that vary by this coefficient of variation of the area.
    Varied(f64),
}

impl Suggestion {
    /// Why, in a sentence.
    #[must_use]
    pub const fn why(self) -> &'static str {
        match self {
            Self::Ragged => "these outlines are ragged; the grown spots have smooth edges.",
            Self::Irregular => "these outlines are no ellipses; the grown spots are.",
            Self::Varied(_) => {
                "these spots differ in size; with fewer than six drawn, the grown ones are alike."
            }
        }
    }

    /// The name of the button that takes it.
    #[must_use]
    pub const fn button(self) -> &'static str {
        match self {
            Self::Ragged => "Make the edges ragged",
            Self::Irregular => "Make the shapes irregular",
            Self::Varied(_) => "Let the sizes vary",
        }
    }

    /// The options of a layer with it.
    #[must_use]
    pub fn with(self, options: LayerOptions) -> LayerOptions {
        match self {
            Self::Ragged => LayerOptions { ragged: RaggedChoice::Given(EDGES), ..options },
            Self::Irregular => LayerOptions { irregular: IRREGULAR, ..options },
            Self::Varied(area) => {
                let spread = Spread { area, ..Spread::ZERO };
                LayerOptions { spread: SpreadChoice::Given(spread), ..options }
            }
        }
    }

    const fn option(self) -> OptionKey {
        match self {
            Self::Ragged => OptionKey::Ragged,
            Self::Irregular => OptionKey::Irregular,
            Self::Varied(_) => OptionKey::Spread,
        }
    }
}

/// What would help a layer of spots: at most one suggestion for its outlines, and one for its sizes.
#[must_use]
pub fn suggestions(session: &Session, layer: usize) -> Vec<Suggestion> {
    let Some(of) = session.document().layers.get(layer) else { return Vec::new() };
    let kind = session.kind(layer);
    if kind != Some(Kind::Ellipse) || session.areas(layer).is_some() || of.is_of_points() || of.is_driven() {
        return Vec::new();
    }
    let ellipses: Vec<Ellipse> = session.marks_of(layer).iter().filter_map(Mark::ellipse).collect();
    let found = [by_outlines(&of.strokes), by_sizes(&ellipses)];
    let is_possible = |one: &Suggestion| {
        let option = one.option();
        let is_default = option.is_default(&of.options);
        is_default && has_option(of, kind, option) && option_refusal(of, kind, option).is_none()
    };
    found.into_iter().flatten().filter(is_possible).collect()
}

fn by_outlines(strokes: &[Stroke]) -> Option<Suggestion> {
    let outline = |stroke: &Stroke| match stroke {
        Stroke::Freehand { points, .. } => Outline::closed(points).map(|outline| outline.points),
        Stroke::Fitted { outline, .. } | Stroke::Outline(outline) => Some(outline.points.clone()),
        Stroke::Ellipse(_) | Stroke::Line(_) | Stroke::Path(_) => None,
    };
    let outlines: Vec<Vec<[f64; 2]>> = strokes.iter().filter_map(outline).collect();
    let mean = |of: fn(&[[f64; 2]]) -> Option<f64>| {
        let values: Vec<f64> = outlines.iter().filter_map(|outline| of(outline)).collect();
        (!values.is_empty()).then(|| values.iter().sum::<f64>() / values.len() as f64)
    };
    if mean(raggedness)? >= RAGGED {
        Some(Suggestion::Ragged)
    } else {
        let differs = mean(|outline| {
            // A closed stroke ends where it begins.
            let around: Vec<[f64; 2]> = outline.iter().chain(outline.first()).copied().collect();
            Some(difference_from_ellipse(&around)?.1)
        });
        (differs? >= DIFFERS).then_some(Suggestion::Irregular)
    }
}

/// (contour ÷ contour of the ellipse with the same moments)².
fn raggedness(outline: &[[f64; 2]]) -> Option<f64> {
    let [a, b] = ellipse_of_outline(outline)?.radii;
    let next = outline.iter().cycle().skip(1);
    let contour: f64 =
        outline.iter().zip(next).map(|(from, to)| (to[0] - from[0]).hypot(to[1] - from[1])).sum();
    // Ramanujan's first approximation of the contour of an ellipse.
    let smooth = PI * (3.0 * (a + b) - ((3.0 * a + b) * (a + 3.0 * b)).sqrt());
    Some((contour / smooth) * (contour / smooth))
}

fn by_sizes(ellipses: &[Ellipse]) -> Option<Suggestion> {
    if !(2..MEASURED).contains(&ellipses.len()) {
        return None;
    }
    let n = ellipses.len() as f64;
    let mean = ellipses.iter().map(Ellipse::area).sum::<f64>() / n;
    let square = |ellipse: &Ellipse| (ellipse.area() / mean - 1.0) * (ellipse.area() / mean - 1.0);
    let varies = (ellipses.iter().map(square).sum::<f64>() / (n - 1.0)).sqrt();
    let share = (100.0 * varies.min(limits::SPREAD_AREA.high)).round() / 100.0;
    (varies >= VARIES).then_some(Suggestion::Varied(share))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Layer, SystemChoice};

    fn suggested(strokes: Vec<Stroke>) -> Vec<Suggestion> {
        let layer = Layer { strokes, ..Layer::default() };
        let document = Document { layers: vec![layer], ..Document::default() };
        suggestions(&Session::open(document, None), 0)
    }

    /// A closed pen stroke with this radius, px, by turn 0..1.
    fn drawn(x: f64, radius: impl Fn(f64) -> f64) -> Stroke {
        let point = |k: u32| {
            let turn = f64::from(k) / 72.0;
            let (sin, cos) = (2.0 * PI * turn).sin_cos();
            [x + radius(turn) * cos, 200.0 + radius(turn) * sin]
        };
        Stroke::Freehand { points: (0..=72).map(point).collect(), width: 6.0 }
    }

    #[test]
    fn ragged_outlines_ask_for_ragged_edges() {
        let jagged = |turn: f64| if (72.0 * turn).round() as u32 % 4 < 2 { 30.0 } else { 22.0 };
        assert_eq!(suggested(vec![drawn(100.0, jagged), drawn(300.0, jagged)]), [Suggestion::Ragged]);
    }

    #[test]
    fn smooth_ellipses_ask_for_nothing() {
        let wobbly = |turn: f64| 24.0 + 0.5 * (30.0 * turn).sin();
        assert_eq!(suggested(vec![drawn(100.0, wobbly), drawn(300.0, wobbly)]), []);
    }

    #[test]
    fn outlines_that_are_no_ellipses_ask_for_irregular_shapes() {
        let triangle = |turn: f64| 24.0 + 5.0 * (2.0 * PI * 3.0 * turn).cos();
        assert_eq!(suggested(vec![drawn(100.0, triangle), drawn(300.0, triangle)]), [Suggestion::Irregular]);
    }

    #[test]
    fn few_spots_of_different_sizes_ask_for_sizes_that_vary() {
        let spot =
            |k: u32| Stroke::ellipse([80.0 * f64::from(k + 1), 200.0], [10.0 + 3.0 * f64::from(k); 2], 0.0);
        let [Suggestion::Varied(area)] = suggested((0..4).map(spot).collect())[..] else { panic!() };
        assert!((0.4..=0.6).contains(&area), "{area}");
        assert_eq!(suggested((0..6).map(spot).collect()), [], "six are measured");
        assert_eq!(suggested((0..4).map(|_| spot(1)).collect()), [], "these are alike");
    }

    #[test]
    fn what_is_suggested_is_allowed_and_suggested_once() {
        let spot =
            |k: u32| Stroke::ellipse([80.0 * f64::from(k + 1), 200.0], [10.0 + 3.0 * f64::from(k); 2], 0.0);
        let layer = Layer { strokes: (0..4).map(spot).collect(), ..Layer::default() };
        let document = Document { layers: vec![layer], ..Document::default() };
        let mut session = Session::open(document, None);
        let [one] = suggestions(&session, 0)[..] else { panic!() };
        session.change_layer(0, |layer| layer.options = one.with(layer.options));
        session.finished().check("as suggested").unwrap();
        assert_eq!(suggestions(&session, 0), []);
        session.change_layer(0, |layer| {
            layer.options = LayerOptions::default();
            layer.system = SystemChoice::Of(&crate::document::systems::POINTS);
        });
        assert_eq!(suggestions(&session, 0), []);
    }
}
