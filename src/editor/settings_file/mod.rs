//! The settings file: named values in JSON. Several windows read and write it.

mod change;

pub use change::{Merged, RecentChange, SettingsChange, recent};

use std::io::{ErrorKind, Write};
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use crate::document::{io_in_words, with_causes};
use crate::editor::file_lock;
use crate::files;
use crate::machine::fs::{self, File};

/// The values in the file, by name. Names that a newer version wrote are kept.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Entries(Map<String, Value>);

impl Entries {
    /// Sets a value, unless it equals `default`: the file holds only what differs from the defaults.
    pub fn set<T: Serialize + PartialEq>(&mut self, name: &str, value: &T, default: &T) {
        if value != default
            && let Ok(value) = serde_json::to_value(value)
        {
            self.0.insert(name.to_owned(), value);
        }
    }

    /// A value; `None` where it is missing or of another type.
    #[must_use]
    pub fn get<T: DeserializeOwned>(&self, name: &str) -> Option<T> {
        T::deserialize(self.0.get(name)?).ok()
    }

    /// A value with named fields; a field that is missing or of another type is taken from `default`.
    #[must_use]
    pub fn fields<T: Serialize + DeserializeOwned + Clone>(&self, name: &str, default: &T) -> T {
        let (Some(Value::Object(stored)), Ok(mut value)) = (self.0.get(name), serde_json::to_value(default))
        else {
            return default.clone();
        };
        for (field, new) in stored {
            let Some(place) = value.get_mut(field) else { continue };
            let before = std::mem::replace(place, new.clone());
            if T::deserialize(&value).is_err() {
                value[field] = before;
            }
        }
        T::deserialize(&value).unwrap_or_else(|_| default.clone())
    }

    /// These values, with the value of `name` taken from `other`; where `other` has no such value, it is removed.
    #[must_use]
    pub fn with(mut self, name: &str, other: &Self) -> Self {
        match other.0.get(name) {
            Some(value) => self.0.insert(name.to_owned(), value.clone()),
            None => self.0.shift_remove(name),
        };
        self
    }

    /// These values, with each one that differs between `base` and `mine` taken from `mine`.
    #[must_use]
    pub fn with_changes(self, base: &Self, mine: &Self) -> Self {
        let names = base.0.keys().chain(mine.0.keys());
        let changed = names.filter(|name| base.0.get(*name) != mine.0.get(*name));
        changed.fold(self, |merged, name| merged.with(name, mine))
    }

    fn parse(text: &str) -> Result<Self, String> {
        serde_json::from_str(text).map(Self).map_err(|error| error.to_string())
    }

    fn text(&self) -> String {
        let text = serde_json::to_string_pretty(&self.0).unwrap_or_default();
        format!("{text}\n")
    }
}

/// Keeps other windows from writing until the returned file is dropped.
#[must_use]
fn lock(file: &Path) -> Option<File> {
    let _ = fs::create_dir_all(file.parent()?);
    file_lock::wait_for(&file.with_extension("lock"))
}

/// The values in the file, and a message for the user where it cannot be read; such a file is renamed.
#[must_use]
pub fn read(file: &Path) -> (Entries, Option<String>) {
    let text = match fs::read(file) {
        Ok(bytes) => String::from_utf8(bytes).map_err(|_| "it is not UTF-8 text".to_owned()),
        Err(error) if error.kind() == ErrorKind::NotFound => return (Entries::default(), None),
        Err(error) => Err(error.to_string()),
    };
    let why = match text.and_then(|text| Entries::parse(&text)) {
        Ok(entries) => return (entries, None),
        Err(why) => why,
    };
    let aside = file.with_extension("damaged");
    let kept = match fs::rename(file, &aside) {
        Ok(()) => format!("it was renamed to {}", aside.display()),
        Err(error) => format!("it could not be renamed: {}", io_in_words(&error)),
    };
    let file = file.display();
    let error = format!(
        "The settings file {file} cannot be read ({why}). dapple starts with default settings; {kept}"
    );
    (Entries::default(), Some(error))
}

/// Writes the file.
///
/// # Errors
/// Where it cannot be written: a message for the user.
fn write(file: &Path, entries: &Entries) -> Result<(), String> {
    let written = files::save(file, |out| Ok(out.write_all(entries.text().as_bytes())?));
    written.map_err(|error| format!("The settings cannot be saved: {}", with_causes(&error)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;
    use serde_json::json;

    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    struct Pair {
        size: [u32; 2],
        name: String,
    }

    fn entries(value: Value) -> Entries {
        let Value::Object(map) = value else { panic!("{value}") };
        Entries(map)
    }

    #[test]
    fn fields_that_are_missing_or_wrong_are_those_of_the_default() {
        let default = Pair { size: [1, 2], name: "a".to_owned() };
        for (stored, wanted) in [
            (json!({"pair": {"size": [3, 4]}}), Pair { size: [3, 4], ..default.clone() }),
            (json!({"pair": {"size": [3], "name": "b"}}), Pair { name: "b".to_owned(), ..default.clone() }),
            (json!({"pair": {"size": [3, -4], "name": 7, "new": 1}}), default.clone()),
            (json!({"pair": [1, 2]}), default.clone()),
            (json!({}), default.clone()),
        ] {
            assert_eq!(entries(stored).fields("pair", &default), wanted);
        }
    }

    #[test]
    fn only_what_differs_from_the_default_is_stored() {
        let mut stored = Entries::default();
        stored.set("threads", &3, &1);
        stored.set("over", &false, &false);
        assert_eq!(stored, entries(json!({"threads": 3})));
        assert_eq!((stored.get::<usize>("threads"), stored.get::<bool>("threads")), (Some(3), None));
    }

    #[test]
    fn changes_are_merged_name_by_name() {
        let base = entries(json!({"a": 1, "b": 2, "c": 3}));
        let mine = entries(json!({"a": 1, "b": 5}));
        let theirs = entries(json!({"a": 7, "b": 2, "c": 3, "d": 4}));
        assert_eq!(theirs.with_changes(&base, &mine), entries(json!({"a": 7, "b": 5, "d": 4})));
    }

    #[test]
    fn a_truncated_or_binary_file_is_renamed_and_reported_once() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("settings");
        for bytes in [&b"theme dark\n\xff\xfe"[..], b"theme dark\0\0\0", b"{\"theme\": \"da", b"{} {}"] {
            fs::write(&file, bytes).unwrap();
            let (read_entries, error) = read(&file);
            assert_eq!(read_entries, Entries::default());
            assert!(error.unwrap().contains("cannot be read"));
            assert_eq!(fs::read(file.with_extension("damaged")).unwrap(), bytes);
            assert!(read(&file).1.is_none());
        }
    }
}
