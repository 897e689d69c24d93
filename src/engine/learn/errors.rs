//! Differences between answers and true values.

use super::Parameters;
use crate::attributes::{Attribute, Attributes};
use crate::marks::turn;

/// Directions are compared only below this aspect or stretch.
const DIRECTED: f64 = 0.8;

/// All quantities in the order in which they are shown.
const ORDER: [&str; 11] = [
    "rate",
    "ratio",
    "level",
    "stretch",
    "direction",
    Attribute::Area.name(),
    Attribute::Spacing.name(),
    Attribute::Width.name(),
    Attribute::Wavelength.name(),
    Attribute::Aspect.name(),
    Attribute::Angle.name(),
];

/// An absolute error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Error {
    /// The attribute or parameter.
    pub quantity: &'static str,
    /// `%` of what was wanted, `°`, or nothing for a plain difference.
    pub unit: &'static str,
    /// The error, not negative.
    pub value: f64,
}

/// The absolute errors of many answers in one quantity.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// The attribute or parameter.
    pub quantity: &'static str,
    /// `%` of what was wanted, `°`, or nothing for a plain difference.
    pub unit: &'static str,
    /// Number of answers.
    pub count: usize,
    /// Median.
    pub median: f64,
    /// 95th percentile.
    pub p95: f64,
}

fn percent(quantity: &'static str, got: f64, wanted: f64) -> Error {
    Error { quantity, unit: "%", value: 100.0 * (got / wanted - 1.0).abs() }
}

fn difference(quantity: &'static str, got: f64, wanted: f64) -> Error {
    Error { quantity, unit: "", value: (got - wanted).abs() }
}

fn turned(quantity: &'static str, got: f64, wanted: f64) -> Error {
    Error { quantity, unit: "°", value: turn(got, wanted).abs() }
}

impl Error {
    /// Errors of parameters against the `expected` ones: rate and ratio in %, stretch, direction where the stretch is below 0.8,
    /// level.
    #[must_use]
    pub fn of_parameters(got: &Parameters, expected: &Parameters) -> Vec<Self> {
        let mut errors = vec![percent("rate", got.rate, expected.rate)];
        errors.extend(got.ratio.zip(expected.ratio).map(|(got, expected)| percent("ratio", got, expected)));
        errors.push(difference("stretch", got.stretch, expected.stretch));
        errors.extend(
            (expected.stretch < DIRECTED).then(|| turned("direction", got.direction, expected.direction)),
        );
        errors
            .extend(got.level.zip(expected.level).map(|(got, expected)| difference("level", got, expected)));
        errors
    }

    /// Errors of attributes against those that were `wanted`: lengths and areas in %, aspect, angle where the aspect is
    /// below 0.8.
    ///
    /// ```
    /// use dapple_engine::attributes::{Attributes, Stripes};
    /// use dapple_engine::learn::Error;
    ///
    /// let stripes = |width| Attributes::Stripes(Stripes { width, angle: 0.0, wavelength: None });
    /// let errors = Error::of_attributes(&stripes(11.0), &stripes(10.0));
    /// assert!((errors[0].value - 10.0).abs() < 1e-9 && errors[0].unit == "%");
    /// ```
    #[must_use]
    pub fn of_attributes(got: &Attributes, wanted: &Attributes) -> Vec<Self> {
        let angle = turned(Attribute::Angle.name(), got.angle(), wanted.angle());
        match (got, wanted) {
            (Attributes::Spots(got), Attributes::Spots(wanted)) => {
                let mut errors = vec![percent(Attribute::Area.name(), got.area, wanted.area)];
                let spacing = got.spacing.zip(wanted.spacing);
                errors.extend(spacing.map(|(got, wanted)| percent(Attribute::Spacing.name(), got, wanted)));
                errors.push(difference(Attribute::Aspect.name(), got.aspect, wanted.aspect));
                errors.extend((wanted.aspect < DIRECTED).then_some(angle));
                errors
            }
            (Attributes::Stripes(got), Attributes::Stripes(wanted)) => {
                let mut errors = vec![percent(Attribute::Width.name(), got.width, wanted.width)];
                let wavelength = got.wavelength.zip(wanted.wavelength);
                errors.extend(
                    wavelength.map(|(got, wanted)| percent(Attribute::Wavelength.name(), got, wanted)),
                );
                errors.push(angle);
                errors
            }
            _ => Vec::new(),
        }
    }
}

/// The errors of many answers, by quantity: sizes first, directions last.
#[must_use]
pub fn summaries(errors: impl IntoIterator<Item = Error>) -> Vec<Errors> {
    let mut seen: Vec<(Error, Vec<f64>)> = Vec::new();
    for error in errors {
        match seen.iter_mut().find(|(first, _)| first.quantity == error.quantity) {
            Some((_, values)) => values.push(error.value),
            None => seen.push((error, vec![error.value])),
        }
    }
    seen.sort_by_key(|(first, _)| ORDER.iter().position(|quantity| *quantity == first.quantity));
    seen.into_iter().map(|(first, values)| summary(first, values)).collect()
}

fn summary(Error { quantity, unit, .. }: Error, mut values: Vec<f64>) -> Errors {
    values.sort_by(f64::total_cmp);
    let count = values.len();
    let share = |p: f64| values[((count - 1) as f64 * p).round() as usize];
    Errors { quantity, unit, count, median: share(0.5), p95: share(0.95) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::Spots;

    #[test]
    fn errors_have_the_unit_of_their_quantity() {
        let expected =
            Parameters { rate: 2.0, ratio: Some(10.0), stretch: 0.5, direction: 178.0, level: Some(0.5) };
        let got = Parameters { rate: 1.9, ratio: Some(11.0), stretch: 0.6, direction: 3.0, level: Some(0.4) };
        let errors = Error::of_parameters(&got, &expected);
        let named: Vec<_> = errors.iter().map(|error| (error.quantity, error.unit)).collect();
        let expected = [("rate", "%"), ("ratio", "%"), ("stretch", ""), ("direction", "°"), ("level", "")];
        assert_eq!(named, expected);
        for (error, expected) in errors.iter().zip([5.0, 10.0, 0.1, 5.0, 0.1]) {
            assert!((error.value - expected).abs() < 1e-9, "{error:?}");
        }
    }

    #[test]
    fn round_spots_have_no_error_of_direction() {
        let spots = |aspect| Attributes::Spots(Spots { area: 9.0, aspect, angle: 0.0, spacing: None });
        let quantities = |aspect| {
            Error::of_attributes(&spots(aspect), &spots(aspect)).into_iter().map(|error| error.quantity)
        };
        assert_eq!(quantities(0.79).collect::<Vec<_>>(), ["area", "aspect", "angle"]);
        assert_eq!(quantities(0.8).collect::<Vec<_>>(), ["area", "aspect"]);
    }

    #[test]
    fn quantities_keep_their_order_whichever_comes_first() {
        let errors =
            [turned("direction", 1.0, 2.0), difference("level", 1.0, 2.0), percent("rate", 1.0, 2.0)];
        let quantities: Vec<_> = summaries(errors).iter().map(|errors| errors.quantity).collect();
        assert_eq!(quantities, ["rate", "level", "direction"]);
    }

    #[test]
    fn errors_are_summarised_by_median_and_95th_percentile() {
        let errors = (0..=100).map(|i| difference("level", f64::from(100 - i), 0.0));
        let expected = Errors { quantity: "level", unit: "", count: 101, median: 50.0, p95: 95.0 };
        assert_eq!(summaries(errors), [expected]);
    }
}
