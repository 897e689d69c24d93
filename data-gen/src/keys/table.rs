//! The table of the pairs: small documents, and two values for each key.

use std::collections::BTreeMap;

use serde::Deserialize;
use serde_json::{Value, json};

use super::pictures;
use super::place::put;

/// The table.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Documents by name, without `format` and `version`.
    bases: BTreeMap<String, Value>,
    /// The pairs, by the objects whose keys they change.
    pub sections: Vec<Section>,
    /// The keys that no picture shows.
    pub unseen: Vec<Unseen>,
}

/// The keys of an object.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Section {
    /// The name of the object in the schema of documents.
    pub object: String,
    /// Its heading in `docs/format.md`, if that is another one.
    pub heading: Option<String>,
    /// Where it is in the documents.
    at: String,
    pub pairs: Vec<Pair>,
}

/// A key at two values.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Pair {
    pub key: String,
    /// The document that is changed.
    base: String,
    /// Other changes to it, by place.
    #[serde(default)]
    with: BTreeMap<String, Value>,
    /// Where the values go, if not to the key of the object of the section.
    at: Option<String>,
    /// The two values; without the key where one is null.
    pub values: [Value; 2],
    /// Words for the values, if these are too long to be shown.
    pub called: Option<[String; 2]>,
    /// The quantities whose change is written.
    pub shows: Vec<String>,
}

/// Keys that no picture shows.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Unseen {
    pub object: String,
    pub keys: Vec<String>,
    pub why: String,
}

/// A pair in its section.
pub struct Row<'a> {
    pub section: &'a Section,
    pub pair: &'a Pair,
    /// The number of pairs of this key before it.
    before: usize,
}

impl Table {
    /// The table of this program.
    pub fn built_in() -> Result<Self, String> {
        let mut reader = serde_json::Deserializer::from_str(include_str!("pairs.json"));
        serde_path_to_error::deserialize(&mut reader).map_err(|error| format!("pairs.json: {error}"))
    }

    /// All pairs, in the order of the page.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.sections.iter().flat_map(|section| {
            section.pairs.iter().enumerate().map(move |(index, pair)| {
                let before = section.pairs[..index].iter().filter(|other| other.key == pair.key).count();
                Row { section, pair, before }
            })
        })
    }

    /// The document of a pair with the first or the second value.
    pub fn document(&self, row: &Row, which: usize) -> Result<Value, String> {
        let Pair { base, with, values, .. } = row.pair;
        let base = self.bases.get(base).ok_or_else(|| format!("there is no base \"{base}\""))?;
        let mut document = json!({"format": "dapple", "version": 2});
        if let (Some(document), Some(base)) = (document.as_object_mut(), base.as_object()) {
            document.extend(base.clone());
        }
        for (at, value) in with.iter().map(|(at, value)| (at.as_str(), value)) {
            put(&mut document, at, value)?;
        }
        put(&mut document, &row.at(), &values[which])?;
        pictures::embed(&mut document);
        Ok(document)
    }
}

impl Row<'_> {
    /// The object and the key.
    pub fn name(&self) -> String {
        format!("{}, {}", self.section.object, self.pair.key)
    }

    /// The file of its pictures.
    pub fn file(&self) -> String {
        let name = format!("{} {}", self.section.object, self.pair.key).to_lowercase().replace(' ', "-");
        if self.before == 0 { format!("{name}.png") } else { format!("{name}-{}.png", self.before + 1) }
    }

    /// The values in words.
    pub fn values(&self) -> [String; 2] {
        let shown = |value: &Value| match value {
            Value::Null => "left out".to_owned(),
            value => format!("`{value}`"),
        };
        self.pair.called.clone().unwrap_or_else(|| self.pair.values.each_ref().map(shown))
    }

    /// The layer that is measured: that of the changed place, else the lowest.
    pub fn layer(&self) -> usize {
        let at = self.at();
        let index = at.strip_prefix("/layers/").and_then(|rest| rest.split('/').next()?.parse().ok());
        index.unwrap_or(0)
    }

    /// Where the values go.
    fn at(&self) -> String {
        let usual = || format!("{}/{}", self.section.at, self.pair.key);
        self.pair.at.clone().unwrap_or_else(usual)
    }
}
