//! Reads a plan, and checks it.

use std::path::Path;

use serde_json::Value;

use crate::check::check;
use crate::plan::{BUILT_IN, Plan, shown};

/// The value of `format` in a plan.
const FORMAT: &str = "dapple sweep plan";
/// The version that is read and written.
const VERSION: u64 = 1;

impl Plan {
    /// The plan of `training/`.
    pub fn built_in() -> Result<Self, String> {
        Self::parse(BUILT_IN, "plan.json (built in)")
    }

    /// The plan in a file.
    pub fn load(path: &Path) -> Result<Self, String> {
        let file = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|error| {
            format!("{file}: cannot be read: {error} (`data-gen plan` prints a plan to begin from)")
        })?;
        Self::parse(&text, &file)
    }

    /// Parses the plan in `text`; `file` is its name in messages.
    pub fn parse(text: &str, file: &str) -> Result<Self, String> {
        let value: Value = serde_json::from_str(text).map_err(|error| format!("{file}: {error}"))?;
        Self::from_json(&value).map_err(|problem| format!("{file}: {}", shown(&problem)))
    }

    /// The plan in a JSON value.
    pub fn from_json(value: &Value) -> Result<Self, String> {
        let format = value.get("format").and_then(Value::as_str);
        if format != Some(FORMAT) {
            return Err(format!("this is no plan of a sweep: it has no \"format\": \"{FORMAT}\""));
        }
        let version = value.get("version").and_then(Value::as_u64);
        if version.is_some_and(|version| version > VERSION) {
            return Err(format!(
                "version {} is newer than {VERSION}, which this program reads",
                version.unwrap_or(0)
            ));
        }
        let plan: Self = serde_path_to_error::deserialize(value).map_err(|error| {
            let place = place(value, &error.path().to_string());
            format!("{place}: {}", error.into_inner())
        })?;
        check(&plan)?;
        Ok(plan)
    }

    /// The sets with these names (all where no name is given), each with this number of runs (as planned where `None`).
    pub fn chosen(mut self, names: &[String], runs: Option<u64>) -> Result<Self, String> {
        if let Some(unknown) = names.iter().find(|name| !self.sets.iter().any(|set| set.name == **name)) {
            let sets: Vec<&str> = self.sets.iter().map(|set| set.name.as_str()).collect();
            return Err(format!("no set is called '{unknown}'; the plan has {}", sets.join(", ")));
        }
        self.sets.retain(|set| names.is_empty() || names.contains(&set.name));
        for set in &mut self.sets {
            set.runs = runs.unwrap_or(set.runs);
        }
        check(&self)?;
        Ok(self)
    }
}

/// A place in messages: `sets[2].sweep.area` → `set 'turing-spots-size', sweep.area`.
fn place(value: &Value, path: &str) -> String {
    let Some((number, rest)) = path.strip_prefix("sets[").and_then(|rest| rest.split_once(']')) else {
        return path.to_owned();
    };
    let name = number.parse::<usize>().ok().and_then(|set| value["sets"][set]["name"].as_str());
    let set = name.map_or_else(|| format!("set {number}"), |name| format!("set '{name}'"));
    match rest.trim_start_matches('.') {
        "" => set,
        key => format!("{set}, {key}"),
    }
}
