//! A JSON value with its path, and checked ways to read it.

use crate::document::error::Problem;
use crate::document::limits::Range;
use crate::document::shape::Object;
use serde_json::{Map, Value, json};

/// A value and the path that leads to it.
///
/// The path is a chain of borrowed nodes and becomes text only in a message.
pub(super) struct Node<'a> {
    value: &'a Value,
    parent: Option<&'a Node<'a>>,
    step: Step<'a>,
}

#[derive(Clone, Copy)]
enum Step<'a> {
    Root,
    Key(&'a str),
    Item(usize),
}

impl<'a> Node<'a> {
    /// The whole document.
    pub(super) fn root(value: &'a Value) -> Self {
        Self { value, parent: None, step: Step::Root }
    }

    /// Its JSON path.
    pub(super) fn place(&self) -> String {
        let before = self.parent.filter(|parent| parent.parent.is_some()).map(Node::place);
        match (self.step, before) {
            (Step::Root, _) => "the document".to_owned(),
            (Step::Key(key), Some(before)) => format!("{before}.{key}"),
            (Step::Key(key), None) => key.to_owned(),
            (Step::Item(i), before) => format!("{}[{i}]", before.unwrap_or_default()),
        }
    }

    /// The problem of a value that is not one of the `allowed` ones.
    pub(super) fn wrong(&self, allowed: impl Into<String>) -> Problem {
        Problem::new(self.place(), quoted(self.value), allowed)
    }

    /// The problem that there is `found` here, in words.
    pub(super) fn found(&self, found: impl Into<String>, allowed: impl Into<String>) -> Problem {
        Problem::new(self.place(), found, allowed)
    }

    /// Checks that it is an object with no other keys than those of the table.
    pub(super) fn is(&self, object: &Object) -> Result<(), Problem> {
        let known: Vec<&str> = object.keys.iter().map(|key| key.name).collect();
        self.keys(&known)
    }

    /// Checks that it is an object with no other keys than `known`.
    pub(super) fn keys(&self, known: &[&str]) -> Result<(), Problem> {
        for key in self.object()?.keys() {
            if !known.contains(&key.as_str()) {
                let shown = quoted(&Value::from(key.as_str()));
                let near =
                    nearest(key, known).map_or(String::new(), |near| format!(" (did you mean {near}?)"));
                let list = if known.is_empty() { "no keys here yet".to_owned() } else { known.join(", ") };
                return Err(self.found(format!("the unknown key {shown}"), list + &near));
            }
        }
        Ok(())
    }

    /// Whether it is an object.
    pub(super) fn is_object(&self) -> bool {
        self.value.is_object()
    }

    /// Whether it is a list of `count` values.
    pub(super) fn is_list_of(&self, count: usize) -> bool {
        self.value.as_array().is_some_and(|list| list.len() == count)
    }

    fn object(&self) -> Result<&'a Map<String, Value>, Problem> {
        self.value.as_object().ok_or_else(|| self.wrong("an object {…}"))
    }

    /// The value of `key`, if there is one.
    pub(super) fn get<'b>(&'b self, key: &'b str) -> Option<Node<'b>> {
        let value = self.value.as_object()?.get(key)?;
        Some(Node { value, parent: Some(self), step: Step::Key(key) })
    }

    /// The value of `key`, which must be there and be `allowed`.
    pub(super) fn need<'b>(&'b self, key: &'b str, allowed: &str) -> Result<Node<'b>, Problem> {
        self.object()?;
        self.get(key).ok_or_else(|| self.found(format!("no key \"{key}\""), format!("\"{key}\": {allowed}")))
    }

    /// Its items, if it is a list.
    pub(super) fn items<'b>(
        &'b self,
        allowed: &str,
    ) -> Result<impl Iterator<Item = Node<'b>> + use<'a, 'b>, Problem> {
        let list = self.value.as_array().ok_or_else(|| self.wrong(allowed))?;
        Ok(list.iter().enumerate().map(move |(i, value)| Node {
            value,
            parent: Some(self),
            step: Step::Item(i),
        }))
    }

    /// Its N numbers, number i in `ranges[i]`.
    pub(super) fn numbers<const N: usize>(&self, ranges: [Range; N]) -> Result<[f64; N], Problem> {
        let mut numbers = [0.0; N];
        let mut items = self.items_of(N, "numbers")?;
        for (number, range) in numbers.iter_mut().zip(&ranges) {
            if let Some(item) = items.next() {
                *number = item.number(range)?;
            }
        }
        Ok(numbers)
    }

    /// Its two whole numbers, each from 1 to its `most`.
    pub(super) fn counts(&self, most: [u32; 2]) -> Result<[u32; 2], Problem> {
        let mut counts = [0; 2];
        let mut items = self.items_of(2, "whole numbers")?;
        for (count, most) in counts.iter_mut().zip(most) {
            if let Some(item) = items.next() {
                // The cast is exact: the number is at most `most`.
                *count = item.whole(1, u64::from(most))? as u32;
            }
        }
        Ok(counts)
    }

    fn items_of(&self, n: usize, what: &str) -> Result<impl Iterator<Item = Node<'_>>, Problem> {
        let allowed = format!("a list of {n} {what}");
        match self.value.as_array() {
            Some(list) if list.len() == n => self.items(&allowed),
            _ => Err(self.wrong(allowed)),
        }
    }

    /// A number within `range`.
    pub(super) fn number(&self, range: &Range) -> Result<f64, Problem> {
        let number = self.value.as_f64().filter(|number| range.holds(*number));
        number.ok_or_else(|| self.wrong(range.to_string()))
    }

    /// A whole number from `low` to `high`; `512.0` is one too, as long as an f64 is exact.
    pub(super) fn whole(&self, low: u64, high: u64) -> Result<u64, Problem> {
        const EXACT: f64 = 9_007_199_254_740_992.0;
        let float = || self.value.as_f64().filter(|x| x.fract() == 0.0 && (0.0..=EXACT).contains(x));
        let number = self.value.as_u64().or_else(|| float().map(|x| x as u64));
        let number = number.filter(|number| (low..=high).contains(number));
        number.ok_or_else(|| self.wrong(format!("a whole number from {low} to {high}")))
    }

    /// True or false.
    pub(super) fn flag(&self) -> Result<bool, Problem> {
        self.value.as_bool().ok_or_else(|| self.wrong("true or false"))
    }

    /// A text.
    pub(super) fn text(&self, allowed: &str) -> Result<&'a str, Problem> {
        self.value.as_str().ok_or_else(|| self.wrong(allowed))
    }

    /// The one of `choices` that is named here.
    pub(super) fn choice<T: Copy>(&self, choices: &[(&str, T)]) -> Result<T, Problem> {
        let names: Vec<&str> = choices.iter().map(|(name, _)| *name).collect();
        let named = |text| choices.iter().find(|(name, _)| *name == text);
        if let Some((_, choice)) = self.value.as_str().and_then(named) {
            return Ok(*choice);
        }
        let near = self.value.as_str().and_then(|text| nearest(text, &names));
        let near = near.map_or(String::new(), |near| format!(" (did you mean {near}?)"));
        Err(self.wrong(format!("{}{near}", names.join(", "))))
    }
}

/// A number as JSON; whole numbers are written without a fraction.
pub(super) fn number(x: f64) -> Value {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if x.fract() == 0.0 && x.abs() <= EXACT { json!(x as i64) } else { json!(x) }
}

/// A value for a message: JSON on one line, shortened, with control characters escaped.
pub(super) fn quoted(value: &Value) -> String {
    const LONGEST: usize = 60;
    let json = match value {
        // A long list would be cut anyway.
        Value::Array(list) if list.len() > LONGEST => format!("a list of {} values", list.len()),
        Value::Null => "null".to_owned(),
        value => value.to_string(),
    };
    visible(&json, LONGEST)
}

/// The first characters of `text`, with control characters escaped, so that a terminal does not act on them.
pub(super) fn visible(text: &str, longest: usize) -> String {
    let mut shown = String::new();
    for (i, c) in text.chars().enumerate() {
        if i == longest {
            shown.push('…');
            break;
        }
        if c.is_control() || invisible(c) { shown.extend(c.escape_unicode()) } else { shown.push(c) }
    }
    shown
}

/// Characters that change the direction of text or have no width.
fn invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

/// The name that a mistyped `word` probably meant.
fn nearest<'n>(word: &str, names: &[&'n str]) -> Option<&'n str> {
    let word: String = word.chars().take(40).flat_map(char::to_lowercase).collect();
    let (edits, name) = names.iter().map(|name| (strsim::levenshtein(&word, name), *name)).min()?;
    // Up to a third of the letters may differ, as in a typing error or British spelling; beyond that it is another word.
    (edits <= (word.chars().count() / 3).max(1)).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_typing_error_is_recognised_and_another_word_is_not() {
        assert_eq!(nearest("Centre", &["kind", "center", "radii"]), Some("center"));
        assert_eq!(nearest("wobble", &["kind", "center", "radii"]), None);
        assert_eq!(nearest("x", &[]), None);
    }

    #[test]
    fn quoted_text_is_escaped() {
        let shown = quoted(&Value::from("a\u{1b}[31m\u{9b}\u{202e}b"));
        assert_eq!(shown, "\"a\\u001b[31m\\u{9b}\\u{202e}b\"");
        assert!(quoted(&Value::from("x".repeat(10_000))).chars().count() <= 61);
    }
}
