//! Values that are set in a document by their places, such as `layers[0].options.ragged=.2`.

use std::str::FromStr;

use serde_json::{Map, Value, json};

use crate::document::node::Node;
use crate::document::{Document, DocumentError, Problem, reader, writer};

/// A value and its place in a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    steps: Vec<Step>,
    value: Value,
}

/// One step of the path to a place: a key or an index.
#[derive(Clone, Debug, PartialEq)]
enum Step {
    Key(String),
    Index(usize),
}

impl FromStr for Setting {
    type Err = String;

    /// `PLACE=VALUE`: keys with points between them and indices in brackets; JSON, or a text that needs no quotes.
    fn from_str(text: &str) -> Result<Self, String> {
        let wrong = || {
            format!(
                "found {text:?}; allowed: PLACE=VALUE, such as layers[0].options.ragged=.2 or layers[0].system=stripes"
            )
        };
        let (place, value) = text.split_once('=').ok_or_else(wrong)?;
        let steps = steps(place.trim()).ok_or_else(wrong)?;
        let is_colours = matches!(steps.last(), Some(Step::Key(key)) if key == "colours");
        let value = colours(value.trim()).filter(|_| is_colours).unwrap_or_else(|| json_of(value.trim()));
        Ok(Self { steps, value })
    }
}

/// The steps of a place; `None` if the text is not a place.
fn steps(place: &str) -> Option<Vec<Step>> {
    let mut steps = Vec::new();
    for part in place.split('.') {
        let (key, mut indices) = part.split_at(part.find('[').unwrap_or(part.len()));
        if key.is_empty() {
            return None;
        }
        steps.push(Step::Key(key.to_owned()));
        while !indices.is_empty() {
            let (index, rest) = indices.strip_prefix('[')?.split_once(']')?;
            steps.push(Step::Index(index.parse().ok()?));
            indices = rest;
        }
    }
    Some(steps)
}

/// JSON, a number as people write it (`.2`, `+3`), or else a text.
fn json_of(text: &str) -> Value {
    let number = || text.parse::<f64>().ok().filter(|number| number.is_finite()).map(|number| json!(number));
    serde_json::from_str(text).ok().or_else(number).unwrap_or_else(|| Value::from(text))
}

/// Colours with commas between them, `#f4e3c1,#3b2314`, as stops at even distances.
fn colours(text: &str) -> Option<Value> {
    let all: Vec<&str> = text.split(',').map(str::trim).collect();
    let last = (all.len() - 1).max(1) as f64;
    let stop = |(k, colour): (usize, &&str)| json!({"at": k as f64 / last, "colour": colour});
    all.iter()
        .all(|colour| colour.starts_with('#'))
        .then(|| json!({"stops": all.iter().enumerate().map(stop).collect::<Vec<_>>()}))
}

impl Setting {
    /// Puts the value into a document.
    fn put(&self, root: &mut Value) -> Result<(), Problem> {
        let (mut at, mut place) = (root, String::new());
        for step in &self.steps {
            at = match step {
                Step::Key(key) => {
                    // Objects that are left out stand for their defaults.
                    if at.is_null() {
                        *at = Value::Object(Map::new());
                    }
                    let Value::Object(entries) = at else {
                        return Err(Problem::new(
                            place,
                            "a value without keys",
                            format!("no key \"{key}\" in it"),
                        ));
                    };
                    place += if place.is_empty() { "" } else { "." };
                    place += key;
                    entries.entry(key.clone()).or_insert(Value::Null)
                }
                Step::Index(index) => {
                    let Value::Array(items) = at else {
                        return Err(Problem::new(place, "no list", format!("no index [{index}] in it")));
                    };
                    let allowed = match items.len() {
                        0 => "none: the list is empty".to_owned(),
                        n => format!("0 to {}", n - 1),
                    };
                    let Some(item) = items.get_mut(*index) else {
                        return Err(Problem::new(place, format!("the index {index}"), allowed));
                    };
                    place += &format!("[{index}]");
                    item
                }
            };
        }
        *at = self.value.clone();
        Ok(())
    }
}

impl Document {
    /// The document with these values set, checked as a file is checked. Messages call it `source_name`.
    ///
    /// # Errors
    /// A place that does not exist, or the first value that a document may not hold.
    pub fn with_settings(self, settings: &[Setting], source_name: &str) -> Result<Self, DocumentError> {
        if settings.is_empty() {
            return Ok(self);
        }
        let mut value = writer::value(&self);
        let put = settings.iter().try_for_each(|setting| setting.put(&mut value));
        let read = put.and_then(|()| reader::document(&Node::root(&value)));
        read.map_err(|problem| problem.in_file(source_name))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Layer, RaggedChoice, Stroke};

    fn document() -> Document {
        Document::new([96, 96]).with_layer(Layer::new([Stroke::ellipse([40.0, 40.0], [9.0, 6.0], 30.0)]))
    }

    fn set(texts: &[&str]) -> Result<Document, DocumentError> {
        let settings: Vec<Setting> = texts.iter().map(|text| text.parse().expect("a setting")).collect();
        document().with_settings(&settings, "a.dapple")
    }

    #[test]
    fn options_system_and_colours_are_put_in_their_places() {
        let changed = set(&[
            "layers[0].options.ragged=.2",
            "layers[0].system=turing-spots",
            "layers[0].colours=#fff,#102030",
            "layers[0].name=a = b",
            "edges=wrap",
            "size=[128, 64]",
        ])
        .expect("a document");
        let layer = &changed.layers[0];
        assert_eq!((layer.options.ragged, layer.system.name()), (RaggedChoice::Given(0.2), "turing-spots"));
        let colours = layer.colours.as_ref().expect("colours");
        assert_eq!((colours.stops[0].colour, colours.stops[1].colour), ([255; 3], [16, 32, 48]));
        assert_eq!((layer.name.as_str(), changed.size), ("a = b", [128, 64]));
    }

    #[test]
    fn what_a_document_may_not_hold_is_named_by_its_place() {
        let refused = |text: &str| set(&[text]).expect_err(text).to_string();
        assert!(
            refused("layers[0].options.ragged=9")
                .starts_with("a.dapple: layers[0].options.ragged: found 9; allowed:")
        );
        assert!(refused("layers[0].options.raged=.2").contains("raged"));
        assert!(refused("layers[0].system=spotted").contains("layers[0].system: found"));
        assert_eq!(refused("layers[2].name=a"), "a.dapple: layers: found the index 2; allowed: 0 to 0");
        assert!(refused("size.width=3").contains("size: found a value without keys"));
        for text in ["layers", "=3", "a..b=3", "layers[x]=1", "layers[0=1"] {
            assert!(
                text.parse::<Setting>().is_err_and(|error| error.contains("layers[0].options.ragged=.2")),
                "{text}"
            );
        }
    }
}
