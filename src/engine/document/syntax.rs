//! Bytes → JSON values: UTF-8, no key twice, and errors that name line and column.

use crate::document::DocumentError;
use crate::document::node::{quoted, visible};
use serde::de::{Deserialize, Deserializer, Error as _, MapAccess, SeqAccess, Visitor};
use serde_json::{Map, Value};
use std::fmt;

/// The place where a text stops being JSON, and the reason.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct SyntaxProblem {
    /// Line, from 1.
    pub line: usize,
    /// Character in the line, from 1.
    pub column: usize,
    /// The text that was found, and what is allowed instead.
    pub problem: String,
}

impl SyntaxProblem {
    /// Turns it into an error of the document in `file`.
    pub(super) fn in_file(self, file: &str) -> DocumentError {
        let Self { line, column, problem } = self;
        DocumentError::Syntax { file: file.to_owned(), line, column, problem }
    }
}

/// The text in `bytes`, or where they stop being UTF-8.
pub(super) fn text(bytes: &[u8]) -> Result<&str, SyntaxProblem> {
    std::str::from_utf8(bytes).map_err(|error| {
        let good = bytes.get(..error.valid_up_to()).unwrap_or_default();
        let before = String::from_utf8_lossy(good);
        let wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
        SyntaxProblem {
            line: before.matches('\n').count() + 1,
            column: before.rsplit('\n').next().unwrap_or_default().chars().count() + 1,
            problem: format!(
                "found the byte 0x{:02x}{}; allowed: JSON text in UTF-8",
                bytes.get(error.valid_up_to()).copied().unwrap_or_default(),
                if wide { " (the text looks like UTF-16)" } else { "" }
            ),
        }
    })
}

/// The JSON value in `text`; a byte order mark before it is ignored.
pub(super) fn json(text: &str) -> Result<Value, SyntaxProblem> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        let problem = "found an empty file; allowed: a JSON object".to_owned();
        return Err(SyntaxProblem { line: 1, column: 1, problem });
    }
    serde_json::from_str::<Unique>(text).map(|unique| unique.0).map_err(|error| explain(text, &error))
}

/// Rewrites serde_json's error, and adds the piece of text that it is about.
fn explain(text: &str, error: &serde_json::Error) -> SyntaxProblem {
    let line_text = text.split('\n').nth(error.line().saturating_sub(1)).unwrap_or_default();
    let mut at = error.column().saturating_sub(1).min(line_text.len());
    while !line_text.is_char_boundary(at) {
        at -= 1;
    }
    let said = error.to_string();
    let said = said.rsplit_once(" at line ").map_or(said.as_str(), |(words, _)| words);
    let token = token(line_text, at);
    let bare = token.trim_start_matches(['-', '+']).to_ascii_lowercase();
    let problem = if error.is_eof() {
        format!("found the end of the file ({said}); allowed: one whole JSON object")
    } else if error.is_data() {
        said.to_owned()
    } else if ["nan", "inf", "infinity"].contains(&bare.as_str()) {
        format!("found {token}, which JSON does not have; allowed: a finite number")
    } else if said.contains("number out of range") {
        format!("found {token}, which is too large; allowed: a finite number below 1.8e308")
    } else if said.contains("recursion limit") {
        "found brackets nested more than 127 deep; allowed: the few levels of a document".to_owned()
    } else if token.is_empty() {
        format!("found the end of the line; allowed: JSON ({said})")
    } else {
        format!("found {token}; allowed: JSON ({said})")
    };
    let column = line_text.get(..at).unwrap_or_default().chars().count() + 1;
    SyntaxProblem { line: error.line().max(1), column, problem }
}

/// The word or number around byte `at` of a line, or the one character there, shortened for a message.
fn token(line: &str, at: usize) -> String {
    let wordy = |c: &char| c.is_alphanumeric() || "+-._".contains(*c);
    let (before, after) = (line.get(..at).unwrap_or_default(), line.get(at..).unwrap_or_default());
    let mut head: Vec<char> = before.chars().rev().take_while(wordy).take(30).collect();
    head.reverse();
    let tail: Vec<char> = after.chars().take_while(wordy).take(30).collect();
    if head.is_empty() && tail.is_empty() {
        let first = after.chars().next();
        return first.map_or(String::new(), |c| format!("`{}`", visible(&c.to_string(), 1)));
    }
    head.into_iter().chain(tail).collect()
}

/// A JSON value whose objects hold no key twice (serde_json would silently keep the last one).
struct Unique(Value);

impl<'de> Deserialize<'de> for Unique {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(UniqueVisitor).map(Self)
    }
}

struct UniqueVisitor;

impl<'de> Visitor<'de> for UniqueVisitor {
    type Value = Value;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Value, E> {
        Ok(Value::Null)
    }

    fn visit_bool<E>(self, flag: bool) -> Result<Value, E> {
        Ok(Value::Bool(flag))
    }

    fn visit_i64<E>(self, number: i64) -> Result<Value, E> {
        Ok(Value::from(number))
    }

    fn visit_u64<E>(self, number: u64) -> Result<Value, E> {
        Ok(Value::from(number))
    }

    fn visit_f64<E>(self, number: f64) -> Result<Value, E> {
        Ok(Value::from(number))
    }

    fn visit_str<E>(self, text: &str) -> Result<Value, E> {
        Ok(Value::from(text))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut items: A) -> Result<Value, A::Error> {
        let mut list = Vec::new();
        while let Some(Unique(item)) = items.next_element()? {
            list.push(item);
        }
        Ok(Value::Array(list))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut entries: A) -> Result<Value, A::Error> {
        let mut map = Map::new();
        while let Some(key) = entries.next_key::<String>()? {
            if map.contains_key(&key) {
                let key = quoted(&Value::from(key));
                return Err(A::Error::custom(format!("found the key {key} twice; allowed: each key once")));
            }
            let Unique(value) = entries.next_value()?;
            map.insert(key, value);
        }
        Ok(Value::Object(map))
    }
}
