//! One answer, as text and as JSON.

use crate::attributes::{Attribute, Attributes};
use crate::cli::Error;
use crate::document::SystemChoice;
use crate::learn::{Answer, Coverage, Note, Parameters};
use crate::rd::System;
use crate::synth::{LookedUp, Training};
use serde_json::{Map, Value, json};
use std::fmt::Write;

/// A question and its answer. Lengths are px, parameters are for a grid of `cell` px a cell.
pub(super) struct LookupReport {
    pub system: System,
    /// Whether the parameters grow the gaps between the stripes, as lines.
    pub inverted: bool,
    pub asked: Attributes,
    pub cell: f64,
    pub answer: Answer,
    /// Notes about the answer.
    pub notes: Vec<String>,
}

impl LookupReport {
    /// Looks up the parameters for `wanted` (px).
    ///
    /// A free spacing is chosen as by `grow`.
    pub fn new(training: &Training, choice: SystemChoice, wanted: &Attributes) -> Result<Self, Error> {
        let looked = LookedUp::new(training, system_of(choice), wanted).map_err(Error::step)?;
        let answer = looked.predict();
        let notes = worded(&answer.notes, looked.free_spacing);
        let LookedUp { system, inverted, cell, .. } = looked;
        Ok(Self { system, inverted, asked: *wanted, cell, answer, notes })
    }

    /// Names and values of the parameters: [`named_parameters`].
    fn parameters(&self) -> Vec<(&'static str, f64)> {
        named_parameters(&self.answer.parameters, self.answer.pitch, self.cell)
    }

    /// The JSON of `lookup --json`; `docs/format.md` lists its keys.
    pub fn json(&self) -> Value {
        let object = |named: Vec<(&'static str, f64)>| -> Map<String, Value> {
            named.into_iter().map(|(name, value)| (name.to_owned(), json!(value))).collect()
        };
        let interval: Map<String, Value> = self
            .answer
            .interval
            .iter()
            .map(|(attribute, range)| (attribute.name().to_owned(), json!(range)))
            .collect();
        json!({
            "system": self.system.name(),
            "asked": object(named(&self.asked)),
            "parameters": object(self.parameters()),
            "inverted": self.inverted,
            "predicted": object(named(&self.answer.predicted)),
            "interval": interval,
            "coverage": self.answer.coverage.to_string(),
            "nearest": object(named(&self.answer.nearest)),
            "notes": self.notes,
        })
    }

    /// The answer as text.
    pub fn text(&self) -> String {
        let list = |named: Vec<(&'static str, f64)>| {
            let words: Vec<String> =
                named.into_iter().map(|(name, value)| format!("{name} {}", brief(value))).collect();
            words.join("  ")
        };
        let range = |attribute: Attribute| self.answer.interval.iter().find(|(of, _)| *of == attribute);
        let predicted = self.answer.predicted.listed().into_iter().map(|(attribute, value)| {
            let range = range(attribute).map_or_else(String::new, |(_, [low, high])| {
                format!(" ({} to {})", brief(*low), brief(*high))
            });
            format!("{attribute} {}{range}", brief(value))
        });
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "system:     {}", self.system.name());
        let _ = writeln!(text, "asked:      {}", list(named(&self.asked)));
        let _ = writeln!(text, "parameters: {}", list(self.parameters()));
        if self.inverted {
            let _ = writeln!(text, "inverted:   the parameters grow the gaps between the stripes");
        }
        let _ = writeln!(text, "predicted:  {}", predicted.collect::<Vec<_>>().join("  "));
        let _ = writeln!(text, "coverage:   {}", self.answer.coverage);
        if self.answer.coverage != Coverage::Inside {
            let _ = writeln!(text, "nearest:    {}", list(named(&self.answer.nearest)));
        }
        for note in &self.notes {
            let _ = writeln!(text, "note:       {note}");
        }
        text
    }
}

/// The system that is asked for; where none is chosen, the first one that grows spots of any spacing.
pub(super) fn system_of(choice: SystemChoice) -> System {
    let system = choice.system().or_else(|| System::first(|system| system.free_spacing));
    system.expect("a system grows spots of any spacing")
}

/// The notes as text, with the spacing, px, that was chosen where it was free.
pub(super) fn worded(notes: &[Note], free_spacing: Option<f64>) -> Vec<String> {
    let free = free_spacing.map(|spacing| format!("no spacing given: {} px chosen", brief(spacing)));
    notes.iter().map(ToString::to_string).chain(free).collect()
}

/// The parameters by name, and at the end the size of a cell, px.
pub(super) fn named_parameters(parameters: &Parameters, pitch: f64, cell: f64) -> Vec<(&'static str, f64)> {
    let mut named = parameters.named();
    if pitch > 1.0 {
        named.push(("pitch", pitch));
    }
    named.push(("cell", cell));
    named
}

/// The attributes by name, without those that do not apply.
pub(super) fn named(attributes: &Attributes) -> Vec<(&'static str, f64)> {
    attributes.listed().into_iter().map(|(attribute, value)| (attribute.name(), value)).collect()
}

/// Four significant digits.
pub(super) fn brief(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if (1e-6..1e9).contains(&rounded.abs()) || rounded == 0.0 {
        rounded.to_string()
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::attributes::{Spots, Stripes};

    fn spots(spacing: Option<f64>) -> Attributes {
        Attributes::Spots(Spots { area: 300.0, aspect: 0.5, angle: 150.0, spacing })
    }

    fn keys(value: &Value) -> Vec<&str> {
        value.as_object().unwrap().keys().map(String::as_str).collect()
    }

    #[test]
    fn json_has_the_keys_of_the_format() {
        let training = Training::default();
        let json = LookupReport::new(
            &training,
            SystemChoice::Of(System::MEINHARDT_SPOTS.description()),
            &spots(Some(60.0)),
        )
        .unwrap()
        .json();
        assert_eq!(
            keys(&json),
            [
                "system",
                "asked",
                "parameters",
                "inverted",
                "predicted",
                "interval",
                "coverage",
                "nearest",
                "notes"
            ]
        );
        assert_eq!(json["system"], "meinhardt-spots");
        assert_eq!(keys(&json["asked"]), ["area", "aspect", "angle", "spacing"]);
        assert_eq!(keys(&json["parameters"]), ["rate", "ratio", "stretch", "direction", "level", "cell"]);
        assert_eq!(keys(&json["predicted"]), ["area", "aspect", "angle", "spacing"]);
        assert_eq!(json["interval"]["area"].as_array().unwrap().len(), 2);
        assert!(json["notes"].is_array());

        let stripes = Attributes::Stripes(Stripes { width: 10.0, angle: 30.0, wavelength: None });
        let json =
            LookupReport::new(&training, SystemChoice::Of(System::MEINHARDT_STRIPES.description()), &stripes)
                .unwrap()
                .json();
        assert_eq!(keys(&json["parameters"]), ["rate", "stretch", "direction", "cell"]);
        assert_eq!(keys(&json["nearest"]), ["width", "angle"]);
    }

    #[test]
    fn the_same_pattern_twice_as_large_has_the_same_parameters_in_cells_twice_as_large() {
        let training = Training::default();
        let up = |wanted: Attributes| {
            LookupReport::new(&training, SystemChoice::Of(System::MEINHARDT_SPOTS.description()), &wanted)
                .unwrap()
        };
        let (small, large) = (up(spots(Some(60.0))), up(spots(Some(60.0)).scaled(2.0)));
        assert!((large.cell / small.cell - 2.0).abs() < 1e-9);
        for ((name, a), (_, b)) in
            small.answer.parameters.named().into_iter().zip(large.answer.parameters.named())
        {
            assert!((a - b).abs() <= 1e-9 * a.abs(), "{name}: {a} {b}");
        }
    }

    #[test]
    fn a_spacing_that_was_not_given_is_not_among_the_asked_values_but_noted() {
        let looked = LookupReport::new(
            &Training::default(),
            SystemChoice::Of(System::MEINHARDT_SPOTS.description()),
            &spots(None),
        )
        .unwrap();
        assert_eq!(keys(&looked.json()["asked"]), ["area", "aspect", "angle"]);
        assert!(looked.text().contains("note:       no spacing given: "), "{}", looked.text());
        assert!(
            looked
                .text()
                .starts_with("system:     meinhardt-spots\nasked:      area 300  aspect 0.5  angle 150\n")
        );
    }

    #[test]
    fn numbers_in_texts_are_short() {
        assert_eq!([1.0 / 3.0, 150.0, 1e-300, 0.0].map(brief), ["0.3333", "150", "1e-300", "0"]);
    }
}
