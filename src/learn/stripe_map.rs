//! Stripes: attributes ↔ parameters, learnt from rows.

use super::answer::{Prediction, Reached, Z90};
use super::coordinates as to;
use super::coverage::{Judgement, Limit};
use super::local::{Images, Local, Sample, varies};
use super::note::{Quantity, Unit};
use super::point::Point;
use super::{Parameters, Row};
use crate::attributes::{Attributes, Stripes};
use crate::marks::axial;

/// The mirror images of a row. The grid looks the same under x ↔ y and under mirrors, so each row stands
/// for four; the features hold the fourth harmonic, in which two of them are the same.
const IMAGES: Images = &[[1.0, 1.0], [1.0, -1.0]];

/// The map of a stripe set.
pub(super) struct StripeMap {
    /// Attributes → parameters.
    asked: Local,
    /// Parameters → attributes.
    told: Local,
    /// Does the stretch vary in the set?
    stretch: bool,
    /// ln W.
    pub width: Limit,
}

/// The angle at a place, where 4θ is known: of the four it stands for the one nearest to `asked`.
fn quarter(asked: f64, at: &Point) -> f64 {
    let quarter = 0.5 * to::axis([at[1], at[2]]);
    axial(asked + (quarter - asked + 45.0).rem_euclid(90.0) - 45.0)
}

impl StripeMap {
    pub fn new(rows: &[Row]) -> Self {
        let runs: Vec<(Stripes, Parameters)> = rows
            .iter()
            .filter_map(|row| match row.attributes {
                Attributes::Stripes(stripes) => Some((stripes, row.parameters)),
                Attributes::Spots(_) => None,
            })
            .collect();
        let stretch = varies(runs.iter().map(|(_, p)| libm::log(p.stretch)));
        let local = |of: &dyn Fn(&Stripes, &Parameters) -> [Point; 2]| {
            let samples = runs.iter().map(|(stripes, parameters)| {
                let [at, gives] = of(stripes, parameters);
                Sample { at, gives }
            });
            Local::new(samples.collect(), IMAGES)
        };
        let asked =
            local(&|s, p| [to::stripes_asked(libm::log(s.width), s.angle), to::stripes_answered(s, p)]);
        let told = local(&|s, p| [to::stripes_told(p, stretch), to::stripes_seen(s, p)]);
        let widths = runs.iter().map(|(stripes, _)| libm::log(stripes.width));
        Self {
            width: Limit::of(
                "width",
                Unit::Length,
                ["the thinnest this system grows", "the widest this system grows"],
                libm::exp,
                widths,
            ),
            asked,
            told,
            stretch,
        }
    }

    /// The parameters for `stripes`, the question moved to where the rows are.
    pub fn ask(&self, stripes: &Stripes) -> Reached {
        let mut judgement = Judgement::new();
        let log_width = judgement.clamp(&self.width, libm::log(stripes.width));
        let mut nearest = Stripes {
            width: if log_width == libm::log(stripes.width) { stripes.width } else { libm::exp(log_width) },
            ..*stripes
        };
        let mut at = to::stripes_asked(log_width, stripes.angle);
        let angle = |at: &Point| quarter(stripes.angle, at);
        let called = |at: &Point| {
            let width = Quantity::new("width", libm::exp(at[0]), Unit::Length);
            vec![width, Quantity::new("angle", angle(at), Unit::Angle)]
        };
        let before = at;
        let answered = judgement.within(&self.asked, &mut at, called);
        if at != before {
            nearest = Stripes { width: libm::exp(at[0]), angle: angle(&at) };
        }
        let parameters = to::stripe_parameters(at[0], nearest.angle, &answered);
        let prediction = self.predict(&parameters);
        Reached { parameters, prediction, nearest: Attributes::Stripes(nearest), judgement }
    }

    /// The parameters for `stripes` that `find` finds among the known points.
    pub fn known(&self, stripes: &Stripes, find: impl Fn(&Local, &Point) -> Option<Sample>) -> Parameters {
        let at = to::stripes_asked(libm::log(stripes.width), stripes.angle);
        let found = find(&self.asked, &at).unwrap_or(self.asked.rows()[0]);
        to::stripe_parameters(found.at[0], quarter(stripes.angle, &found.at), &found.gives)
    }

    /// What grows from parameters.
    pub fn predict(&self, p: &Parameters) -> Prediction {
        let fit = self.told.fit(&to::stripes_told(p, self.stretch), None);
        let log_width = 0.5 * (fit.value[0] - libm::log(p.rate));
        let by_width = 0.5 * Z90 * fit.deviation[0];
        let angle = axial(p.direction - to::axis([fit.value[1], fit.value[2]]));
        let sine = Z90 * fit.deviation[2];
        let by_angle = if sine < 1.0 { 0.5 * libm::asin(sine).to_degrees() } else { 90.0 };
        let interval = vec![
            ("width", [log_width - by_width, log_width + by_width].map(libm::exp)),
            ("angle", [angle - by_angle, angle + by_angle]),
        ];
        let stripes = Stripes { width: libm::exp(log_width), angle };
        Prediction { attributes: Attributes::Stripes(stripes), interval }
    }
}
