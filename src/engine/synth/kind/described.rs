//! The output of `check` for a plan.

use serde_json::{Map, Value};

use crate::attributes::Attributes;

/// A description of a layer that would grow.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Described {
    /// Text for people: lines, each with a line break.
    pub text: String,
    /// Notes for the user, as sentences.
    pub notes: Vec<String>,
    /// The particulars of this kind of layer, for programs: keys and values in their order.
    pub json: Map<String, Value>,
}

impl Described {
    /// A text, notes, and an object of JSON.
    #[must_use]
    pub fn new(text: String, notes: Vec<String>, json: Value) -> Self {
        let json = if let Value::Object(json) = json { json } else { Map::new() };
        Self { text, notes, json }
    }
}

/// Attributes in words; for lines along curves (`bent`) the width alone.
#[must_use]
pub fn in_words(wanted: &Attributes, bent: bool) -> String {
    match wanted {
        Attributes::Spots(spots) => {
            let spacing = spots.spacing.map(|spacing| format!(", {spacing:.1} px apart")).unwrap_or_default();
            format!(
                "spots of {:.0} px², aspect {:.2} at {:.0}°{spacing}",
                spots.area, spots.aspect, spots.angle
            )
        }
        Attributes::Stripes(stripes) if bent => format!("lines {:.1} px wide", stripes.width),
        Attributes::Stripes(stripes) => {
            let apart = stripes.wavelength.map(|apart| format!(", {apart:.1} px apart")).unwrap_or_default();
            format!("stripes {:.1} px wide at {:.0}°{apart}", stripes.width, stripes.angle)
        }
    }
}
