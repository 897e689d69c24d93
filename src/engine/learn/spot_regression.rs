//! Spots: attributes ↔ parameters, by regression.

use super::answer::{Prediction, Z90};
use super::coordinates as to;
use super::coverage::{Judgement, Limit};
use super::local::{AS_IT_IS, Images, Local, Sample, varies};
use super::note::{Note, Quantity};
use super::{Found, InCells, Parameters, Row};
use crate::attributes::{Attribute, Attributes, Spots};
use crate::learn::small_vector::SmallVector;

/// The mirror images of a row: (cos, sin) of a double angle under θ, −θ, 90° − θ and 90° + θ.
///
/// The grid does not change under x ↔ y and under mirror images, so each row represents four.
const IMAGES: Images = &[[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]];

/// The map of a range of shapes of a spot set.
pub(super) struct SpotRegression {
    /// Attributes → parameters.
    asked: Local,
    /// Parameters → direction.
    outcomes: Local,
    /// Parameters → area, spacing and aspect.
    even: Local,
    /// Whether the ratio varies in the set.
    ratio: bool,
    /// Whether the level varies in the set.
    level: bool,
    /// ln A.
    pub area: Limit,
    /// ln(A/L²).
    pub density: Limit,
    /// −ln(aspect).
    pub elongation: Limit,
    /// The median ln(A/L²) of the set: used if the spacing is left free.
    median_density: f64,
}

/// ln(A/L²) of measured spots, which always have a spacing.
fn density(spots: &Spots) -> Option<f64> {
    spots.spacing.map(|spacing| to::log_density(spots.area, spacing))
}

/// The smallest aspect that is looked up. Large spots of the training sets are hardly narrower; small ones are, by the grid.
pub const NARROWEST: f64 = 0.15;

/// The range of −ln(aspect), at most that of [`NARROWEST`].
pub(super) fn elongations<'a>(spots: impl Iterator<Item = &'a Spots>) -> Limit {
    Limit::new(
        Attribute::Aspect,
        ["too round: the roundest possible is", "too narrow: the narrowest possible is"],
        |e| libm::exp(-e),
        spots.map(|s| -libm::log(s.aspect.max(NARROWEST))),
    )
}

/// The kind of excess of a spacing, too large or too small, with the limit.
const SPACINGS: [&str; 2] = [
    "too large for spots of this size: the largest distance of their centres is",
    "too small for spots of this size: the smallest distance of their centres is",
];

/// The ranges of ln A, ln(A/L²) and −ln(aspect).
fn limits<'a>(spots: impl Iterator<Item = &'a Spots> + Clone) -> [Limit; 3] {
    let area = Limit::new(
        Attribute::Area,
        ["too small: the smallest possible is", "too large: the largest possible is"],
        libm::exp,
        spots.clone().map(|s| libm::log(s.area)),
    );
    let density = Limit::new(Attribute::Density, SPACINGS, libm::exp, spots.clone().filter_map(density));
    [area, density, elongations(spots)]
}

/// Notes a difference from the spacing that was asked for, if the system determines the spacing.
fn judge_spacing(spots: &Spots, prediction: &Prediction, nearest: &mut Spots, judgement: &mut Judgement) {
    let Attributes::Spots(predicted) = prediction.attributes else { return };
    let Some(given) = predicted.spacing else { return };
    nearest.spacing = Some(given);
    let Some(asked) = spots.spacing else { return };
    let off = libm::log(asked) - libm::log(given);
    let sure = prediction.half_width(Attribute::Spacing);
    if judgement.beyond(off.abs() - sure) {
        let [asked, reached] = [asked, given].map(|spacing| Quantity::new(Attribute::Spacing, spacing));
        let called = "not possible with this system: spots of this size always stand at";
        judgement.notes.push(Note::Beyond { asked, reached, called });
    } else {
        nearest.spacing = Some(asked);
    }
}

impl SpotRegression {
    /// The map of these rows. `neighbours` are the numbers of neighbours of its regressions, where they are known.
    pub fn new(rows: &[Row], neighbours: Option<[usize; 3]>) -> Self {
        let runs: Vec<(Spots, Parameters)> = rows
            .iter()
            .filter_map(|row| match row.attributes.0 {
                Attributes::Spots(spots) => Some((spots, row.parameters)),
                Attributes::Stripes(_) => None,
            })
            .collect();
        let ratio = varies(runs.iter().map(|(_, p)| libm::log(p.ratio.unwrap_or(1.0))));
        let level = varies(runs.iter().map(|(_, p)| p.level.unwrap_or(0.5)));
        let local = |index: usize, images, of: &(dyn Fn(&Spots, &Parameters) -> [SmallVector; 2] + Sync)| {
            let samples = runs.iter().map(|(spots, parameters)| {
                let [at, gives] = of(spots, parameters);
                Sample { at, gives }
            });
            Local::new(samples.collect(), images, neighbours.map(|neighbours| neighbours[index]))
        };
        let asked = || {
            local(0, IMAGES, &|s, p| {
                let density = density(s).filter(|_| ratio || level);
                let at = to::spot_question(libm::log(s.area), density, to::elongation(s.aspect, s.angle));
                [at, to::spot_answer(s, p)]
            })
        };
        let outcomes = || {
            local(1, IMAGES, &|s, p| {
                [to::spot_features(p, ratio, level), SmallVector::new(to::elongation(s.aspect, s.angle))]
            })
        };
        let even = || {
            local(2, AS_IT_IS, &|s, p| {
                [to::spot_features_even(p, ratio, level), to::spot_outcomes_even(s, p)]
            })
        };
        let (asked, (outcomes, even)) = rayon::join(asked, || rayon::join(outcomes, even));
        let [area, density_limit, elongation] = limits(runs.iter().map(|(spots, _)| spots));
        let mut densities: Vec<f64> = runs.iter().filter_map(|(spots, _)| density(spots)).collect();
        densities.sort_by(f64::total_cmp);
        let median_density = densities.get(densities.len() / 2).copied().unwrap_or(0.0);
        Self { area, density: density_limit, elongation, median_density, asked, outcomes, even, ratio, level }
    }

    /// Whether area/spacing² is free in this set; otherwise the system determines it.
    pub fn dense(&self) -> bool {
        self.ratio || self.level
    }

    /// The parameters for `spots`, with the question moved into the range of the rows.
    pub fn ask(&self, spots: &Spots) -> Found {
        let (parameters, mut nearest, mut judgement) = self.reach(spots);
        if self.dense() {
            return Found::judged(parameters, Attributes::Spots(nearest), judgement);
        }
        // The spacing is the predicted one.
        let prediction = self.predict(&parameters);
        judge_spacing(spots, &prediction, &mut nearest, &mut judgement);
        let found = Found::judged(parameters, Attributes::Spots(nearest), judgement);
        Found { prediction: InCells(prediction).into(), ..found }
    }

    /// The parameters for `spots`, with the question moved into the range of the rows; and the question that was answered,
    /// without a spacing where the system determines it.
    fn reach(&self, spots: &Spots) -> (Parameters, Spots, Judgement) {
        let mut judgement = Judgement::new();
        let log_area = judgement.clamp(&self.area, libm::log(spots.area));
        let density = self.dense().then(|| self.clamp_density(spots, log_area, &mut judgement));
        let e = -libm::log(spots.aspect);
        let e_reached = judgement.clamp(&self.elongation, e);
        let [c, s] = to::harmonic(spots.angle, 2.0);
        let mut at = to::spot_question(log_area, density, [e_reached * c, e_reached * s]);
        let n = at.len();
        let mut nearest = Spots {
            area: if log_area == libm::log(spots.area) { spots.area } else { libm::exp(log_area) },
            aspect: if e_reached == e { spots.aspect } else { libm::exp(-e_reached) },
            ..*spots
        };
        let called = |at: &SmallVector| {
            let mut named = vec![Quantity::new(Attribute::Area, libm::exp(at[0]))];
            let spacing = || Quantity::new(Attribute::Spacing, libm::exp(0.5 * (at[0] - at[1])));
            named.extend(self.dense().then(spacing));
            let aspect = libm::exp(-to::length([at[n - 2], at[n - 1]]));
            named.push(Quantity::new(Attribute::Aspect, aspect));
            named
        };
        let before = at;
        let mut answered = judgement.within(&self.asked, &mut at, called);
        if at != before {
            let v = [at[n - 2], at[n - 1]];
            nearest.area = libm::exp(at[0]);
            nearest.aspect = libm::exp(-to::length(v));
            nearest.angle = to::axis(v);
        } else if e < e_reached {
            // Rounder than any row: the rows have all directions, so that this is no extrapolation.
            (at[n - 2], at[n - 1]) = (e * c, e * s);
            answered = self.asked.clamped(self.asked.line(&at, None).value());
        }
        nearest.spacing = self.dense().then(|| (nearest.area / libm::exp(at[1])).sqrt());
        let mut parameters = to::spot_parameters(at[0], &answered);
        if parameters.stretch > 1.0 - 1e-9 {
            // Spots without a direction get the one that was asked for.
            parameters.direction = spots.angle;
        }
        (parameters, nearest, judgement)
    }

    /// ln(A/L²) clamped to the range of the set; its median if the spacing is free.
    fn clamp_density(&self, spots: &Spots, log_area: f64, judgement: &mut Judgement) -> f64 {
        if let Some((density, spacing)) = density(spots).zip(spots.spacing) {
            let within = judgement.clamp(&self.density, density);
            if let Some(Note::Beyond { asked, reached, .. }) =
                judgement.notes.last_mut().filter(|_| within != density)
                && asked.attribute == self.density.what
            {
                // Given in the form in which it is drawn: the distance of the centres.
                *asked = Quantity::new(Attribute::Spacing, spacing);
                *reached = Quantity::new(Attribute::Spacing, libm::exp(0.5 * (log_area - within)));
            }
            return within;
        }
        judgement.notes.push(Note::FreeSpacing(libm::exp(self.median_density)));
        self.median_density
    }

    /// ln(A/L²) of the spots, the median of the set where their spacing is free; `None` where the system determines it.
    pub fn log_density(&self, spots: &Spots) -> Option<f64> {
        self.dense().then(|| density(spots).unwrap_or(self.median_density))
    }

    /// Row, mirror image and weight of each sample that the answer about `spots` uses.
    pub fn near(&self, spots: &Spots) -> Vec<(usize, [f64; 2], f64)> {
        self.asked.weights(&self.question(spots))
    }

    fn question(&self, spots: &Spots) -> SmallVector {
        let v = to::elongation(spots.aspect, spots.angle);
        to::spot_question(libm::log(spots.area), self.log_density(spots), v)
    }

    /// The parameters of the row nearest to `spots`.
    pub fn nearest(&self, spots: &Spots) -> Parameters {
        let found = self.asked.nearest(&self.question(spots), None).unwrap_or(self.asked.rows()[0]);
        to::spot_parameters(found.at[0], &found.gives)
    }

    /// The numbers of neighbours of its regressions.
    #[cfg(test)]
    pub fn neighbours(&self) -> [usize; 3] {
        [&self.asked, &self.outcomes, &self.even].map(Local::neighbours)
    }

    /// The attributes that grow with parameters.
    pub fn predict(&self, p: &Parameters) -> Prediction {
        let log_rate = libm::log(p.rate);
        let even = self.even.fit(&to::spot_features_even(p, self.ratio, self.level), None);
        let [log_area, log_spacing] = [even.value[0] - log_rate, 0.5 * (even.value[1] - log_rate)];
        let [by_area, by_spacing] = [Z90 * even.deviation[0], 0.5 * Z90 * even.deviation[1]];
        let (e, by_e) = (even.value[2], Z90 * even.deviation[2]);
        let aspect = |e: f64| libm::exp(-e.max(0.0));
        let fit = self.outcomes.fit(&to::spot_features(p, self.ratio, self.level), None);
        let v = [fit.value[0], fit.value[1]];
        let by_v = Z90 * to::length([fit.deviation[0], fit.deviation[1]]) / std::f64::consts::SQRT_2;
        let directed = to::length(v) > 1e-9;
        let angle = if directed { to::axis(v) } else { p.direction };
        let sine = if directed { by_v / to::length(v) } else { 1.0 };
        let by_angle = if sine < 1.0 { 0.5 * libm::asin(sine).to_degrees() } else { 90.0 };
        let spots = Spots {
            area: libm::exp(log_area),
            aspect: aspect(e),
            angle,
            spacing: Some(libm::exp(log_spacing)),
        };
        let interval = vec![
            (Attribute::Area, [log_area - by_area, log_area + by_area].map(libm::exp)),
            (Attribute::Aspect, [aspect(e + by_e), aspect(e - by_e)]),
            (Attribute::Angle, [angle - by_angle, angle + by_angle]),
            (Attribute::Spacing, [log_spacing - by_spacing, log_spacing + by_spacing].map(libm::exp)),
        ];
        Prediction { attributes: Attributes::Spots(spots), interval }
    }
}
