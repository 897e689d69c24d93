//! Stripes: attributes ↔ parameters, learnt from rows.

use super::answer::{Prediction, Z90};
use super::coordinates as to;
use super::coverage::{Judgement, Limit};
use super::local::{Images, Local, Sample, varies};
use super::note::Quantity;
use super::{Found, Parameters, Row};
use crate::attributes::{Attribute, Attributes, Stripes};
use crate::learn::small_vector::SmallVector;
use crate::marks::axial;

/// The mirror images of a row. The grid does not change under x ↔ y and under mirror images, so each row represents four; in the
/// fourth harmonic they coincide in pairs.
const IMAGES: Images = &[[1.0, 1.0], [1.0, -1.0]];

/// The limits of the duty in words.
pub(super) const DUTY_LIMITS: [&str; 2] = [
    "a smaller share of the period than stripes can cover, which is at least",
    "a larger share of the period than stripes can cover, which is at most",
];

/// The map of a stripe set.
pub(super) struct StripeRegression {
    /// Attributes → parameters.
    asked: Local,
    /// Parameters → attributes.
    outcomes: Local,
    /// Whether the stretch varies in the set.
    stretch: bool,
    /// ln W.
    pub width: Limit,
    /// ln(W/λ) if it is free; otherwise each stripe is as wide as its gap.
    pub duty: Option<Limit>,
}

/// The angle for a place that determines only 4θ: of the four possible angles the one nearest to `asked`.
fn quarter(asked: f64, at: &SmallVector) -> f64 {
    let n = at.len();
    let quarter = 0.5 * to::axis([at[n - 2], at[n - 1]]);
    axial(asked + (quarter - asked + 45.0).rem_euclid(90.0) - 45.0)
}

impl StripeRegression {
    /// The map of these rows. `neighbours` are the numbers of neighbours of its two regressions, where they are known.
    pub fn new(rows: &[Row], neighbours: &[usize]) -> Self {
        let runs: Vec<(Stripes, Parameters)> = rows
            .iter()
            .filter_map(|row| match row.attributes.0 {
                Attributes::Stripes(stripes) => Some((stripes, row.parameters)),
                Attributes::Spots(_) => None,
            })
            .collect();
        let stretch = varies(runs.iter().map(|(_, p)| libm::log(p.stretch)));
        let local = |index: usize, of: &dyn Fn(&Stripes, &Parameters) -> [SmallVector; 2]| {
            let samples = runs.iter().map(|(stripes, parameters)| {
                let [at, gives] = of(stripes, parameters);
                Sample { at, gives }
            });
            Local::new(samples.collect(), IMAGES, neighbours.get(index).copied())
        };
        let log_duty = |s: &Stripes| s.wavelength.map(|wavelength| libm::log(s.width / wavelength));
        let asked = local(0, &|s, p| {
            [to::stripe_question(libm::log(s.width), log_duty(s), s.angle), to::stripe_answer(s, p)]
        });
        let outcomes = local(1, &|s, p| [to::stripe_features(p, stretch), to::stripe_outcomes(s, p)]);
        let duty = runs.iter().any(|(s, _)| s.wavelength.is_some()).then(|| {
            Limit::new(Attribute::Duty, DUTY_LIMITS, libm::exp, runs.iter().filter_map(|(s, _)| log_duty(s)))
        });
        let widths = runs.iter().map(|(stripes, _)| libm::log(stripes.width));
        Self {
            width: Limit::new(
                Attribute::Width,
                ["too thin: the thinnest possible is", "too wide: the widest possible is"],
                libm::exp,
                widths,
            ),
            duty,
            asked,
            outcomes,
            stretch,
        }
    }

    /// The numbers of neighbours of its regressions.
    #[cfg(test)]
    pub fn neighbours(&self) -> Vec<usize> {
        [&self.asked, &self.outcomes].map(Local::neighbours).to_vec()
    }

    /// The parameters for `stripes`, with the question moved into the range of the rows.
    pub fn ask(&self, stripes: &Stripes) -> Found {
        let mut judgement = Judgement::new();
        let log_width = judgement.clamp(&self.width, libm::log(stripes.width));
        let duty = self.duty.as_ref().map(|limit| judgement.clamp(limit, libm::log(stripes.duty())));
        let width = if log_width == libm::log(stripes.width) { stripes.width } else { libm::exp(log_width) };
        let wavelength = |width: f64, at: &SmallVector| self.duty.as_ref().map(|_| width / libm::exp(at[1]));
        let mut at = to::stripe_question(log_width, duty, stripes.angle);
        let mut nearest = Stripes { width, angle: stripes.angle, wavelength: wavelength(width, &at) };
        let angle = |at: &SmallVector| quarter(stripes.angle, at);
        let called = |at: &SmallVector| {
            let mut named = vec![Quantity::new(Attribute::Width, libm::exp(at[0]))];
            let duty = || Quantity::new(Attribute::Duty, libm::exp(at[1]));
            named.extend(self.duty.as_ref().map(|_| duty()));
            named.push(Quantity::new(Attribute::Angle, angle(at)));
            named
        };
        let before = at;
        let answered = judgement.within(&self.asked, &mut at, called);
        if at != before {
            let width = libm::exp(at[0]);
            nearest = Stripes { width, angle: angle(&at), wavelength: wavelength(width, &at) };
        }
        let parameters = to::stripe_parameters(at[0], nearest.angle, &answered);
        Found::judged(parameters, Attributes::Stripes(nearest), judgement)
    }

    /// Row, mirror image and weight of each sample that the answer to `stripes` uses.
    pub fn near(&self, stripes: &Stripes) -> Vec<(usize, [f64; 2], f64)> {
        let duty = self.duty.as_ref().map(|_| libm::log(stripes.duty()));
        self.asked.weights(&to::stripe_question(libm::log(stripes.width), duty, stripes.angle))
    }

    /// The parameters of the row nearest to `stripes`.
    pub fn nearest(&self, stripes: &Stripes) -> Parameters {
        let duty = self.duty.as_ref().map(|_| libm::log(stripes.duty()));
        let at = to::stripe_question(libm::log(stripes.width), duty, stripes.angle);
        let found = self.asked.nearest(&at, None).unwrap_or(self.asked.rows()[0]);
        to::stripe_parameters(found.at[0], quarter(stripes.angle, &found.at), &found.gives)
    }

    /// The attributes that grow with parameters.
    pub fn predict(&self, p: &Parameters) -> Prediction {
        let fit = self.outcomes.fit(&to::stripe_features(p, self.stretch), None);
        let log_width = 0.5 * (fit.value[0] - libm::log(p.rate));
        let by_width = 0.5 * Z90 * fit.deviation[0];
        let n = fit.value.len();
        let angle = axial(p.direction - to::axis([fit.value[n - 2], fit.value[n - 1]]));
        let sine = Z90 * fit.deviation[n - 1];
        let by_angle = if sine < 1.0 { 0.5 * libm::asin(sine).to_degrees() } else { 90.0 };
        let mut interval = vec![
            (Attribute::Width, [log_width - by_width, log_width + by_width].map(libm::exp)),
            (Attribute::Angle, [angle - by_angle, angle + by_angle]),
        ];
        let wavelength = self.duty.as_ref().map(|_| {
            let log_wavelength = 0.5 * (fit.value[1] - libm::log(p.rate));
            let by = 0.5 * Z90 * fit.deviation[1];
            interval.push((Attribute::Wavelength, [log_wavelength - by, log_wavelength + by].map(libm::exp)));
            libm::exp(log_wavelength)
        });
        let stripes = Stripes { width: libm::exp(log_width), angle, wavelength };
        Prediction { attributes: Attributes::Stripes(stripes), interval }
    }
}
