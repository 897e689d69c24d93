//! The answer of a law in closed form, as text and as JSON, with the keys of other answers.

use serde_json::{Map, Value, json};
use std::fmt::Write;

use super::answer::{brief, named};
use crate::attributes::Attributes;
use crate::cli::Error;
use crate::document::{AreaKind, LayerOptions, SystemChoice};
use crate::learn::Coverage;
use crate::synth::closed_form::{ClosedForm, Named, lines, patches};

/// The note on every answer by a law.
const BY_LAW: &str = "by laws in closed form, without training rows";

/// A question and its answer by a law. Lengths are px.
pub(super) struct LawReport {
    system: SystemChoice,
    asked: Vec<Named>,
    answer: ClosedForm,
}

impl LawReport {
    /// The answer of a law for `wanted`; `None` where `system` has training rows, or neither rows nor a law.
    ///
    /// # Errors
    ///
    /// [`Error::Usage`] where a `raggedness` is given for a system that has none.
    pub fn new(
        system: SystemChoice,
        wanted: &Attributes,
        raggedness: Option<f64>,
    ) -> Result<Option<Self>, Error> {
        let mut asked = named(wanted);
        let detail = LayerOptions::default().detail;
        let answer = match (system.lines(), wanted) {
            (None, Attributes::Spots(spots)) if system.areas() == Some(AreaKind::Patches) => {
                asked.extend(raggedness.map(|raggedness| ("raggedness", raggedness)));
                patches(spots, raggedness, detail)
            }
            _ if raggedness.is_some() => {
                let system = system.name();
                return Err(Error::Usage(format!("--raggedness: {system} has none; allowed: with patches")));
            }
            (Some(kind), Attributes::Stripes(stripes)) => {
                asked.retain(|(name, _)| kind.description().directed || *name != "angle");
                lines(kind, stripes, detail)
            }
            _ => return Ok(None),
        };
        Ok(Some(Self { system, asked, answer }))
    }

    fn coverage(&self) -> Coverage {
        if self.answer.reached { Coverage::Inside } else { Coverage::Outside }
    }

    fn notes(&self) -> impl Iterator<Item = &str> {
        self.answer.notes.iter().map(String::as_str).chain([BY_LAW])
    }

    /// The JSON of `lookup --json`. The predicted values are the nearest that can be reached.
    pub fn json(&self) -> Value {
        let object = |named: &[Named]| -> Map<String, Value> {
            named.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect()
        };
        json!({
            "system": self.system.name(),
            "asked": object(&self.asked),
            "parameters": object(&self.answer.parameters),
            "inverted": false,
            "predicted": object(&self.answer.predicted),
            "interval": {},
            "coverage": self.coverage().to_string(),
            "nearest": object(&self.answer.predicted),
            "notes": self.notes().collect::<Vec<_>>(),
        })
    }

    /// The answer as text.
    pub fn text(&self) -> String {
        let list = |named: &[Named]| {
            let words = named.iter().map(|(name, value)| format!("{name} {}", brief(*value)));
            words.collect::<Vec<_>>().join("  ")
        };
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = writeln!(text, "system:     {}", self.system.name());
        let _ = writeln!(text, "asked:      {}", list(&self.asked));
        let _ = writeln!(text, "parameters: {}", list(&self.answer.parameters));
        let _ = writeln!(text, "predicted:  {}", list(&self.answer.predicted));
        let _ = writeln!(text, "coverage:   {}", self.coverage());
        for note in self.notes() {
            let _ = writeln!(text, "note:       {note}");
        }
        text
    }
}
