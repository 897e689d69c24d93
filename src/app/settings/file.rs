//! The settings on the disk: a line a thing, a word and what it is. Several windows write them.

use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::editor::file_lock;
use crate::export;

/// What stands in the file, by its first word; words that a newer version knows are kept.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Entries(BTreeMap<String, Vec<String>>);

impl Entries {
    fn parse(text: &str) -> Self {
        let mut entries = Self::default();
        for (key, value) in text.lines().filter_map(|line| line.split_once(' ')) {
            entries.add(key, value);
        }
        entries
    }

    /// One more line.
    pub fn add(&mut self, key: &str, value: impl Into<String>) {
        self.0.entry(key.to_owned()).or_default().push(value.into());
    }

    /// All that is said of a thing.
    pub fn all(&self, key: &str) -> impl Iterator<Item = &str> {
        self.0.get(key).into_iter().flatten().map(String::as_str)
    }

    /// What is said of it first.
    #[must_use]
    pub fn one(&self, key: &str) -> Option<&str> {
        self.all(key).next()
    }

    /// The same as `N` numbers, all of them finite.
    #[must_use]
    pub fn numbers<const N: usize>(&self, key: &str) -> Option<[f64; N]> {
        let numbers =
            self.one(key)?.split(' ').map(|number| number.parse().ok().filter(|n: &f64| n.is_finite()));
        numbers.collect::<Option<Vec<f64>>>()?.try_into().ok()
    }

    /// The same, but for what `others` say of a thing.
    #[must_use]
    pub fn with(mut self, key: &str, others: &Self) -> Self {
        self.0.remove(key);
        if let Some(lines) = others.0.get(key) {
            self.0.insert(key.to_owned(), lines.clone());
        }
        self
    }

    /// The same, but for what differs between `base` and `mine`, which is as in `mine`.
    #[must_use]
    pub fn changed(self, base: &Self, mine: &Self) -> Self {
        let keys = base.0.keys().chain(mine.0.keys());
        let changed = keys.filter(|key| base.0.get(*key) != mine.0.get(*key));
        changed.fold(self, |merged, key| merged.with(key, mine))
    }

    fn text(&self) -> String {
        let lines = self.0.iter().flat_map(|(key, values)| values.iter().map(move |value| (key, value)));
        lines.map(|(key, value)| format!("{key} {value}\n")).collect()
    }
}

/// Keeps other windows from writing until it is dropped.
#[must_use]
pub fn lock(file: &Path) -> Option<File> {
    let _ = fs::create_dir_all(file.parent()?);
    file_lock::wait_for(&file.with_extension("lock"))
}

/// What stands in the file, and what is wrong with it. A damaged one is put aside.
#[must_use]
pub fn read(file: &Path) -> (Entries, Option<String>) {
    let what = match fs::read(file) {
        Ok(bytes) => match String::from_utf8(bytes) {
            Ok(text)
                if !text.contains(|letter: char| letter.is_control() && letter != '\n' && letter != '\r') =>
            {
                return (Entries::parse(&text), None);
            }
            _ => "is damaged".to_owned(),
        },
        Err(error) if error.kind() == ErrorKind::NotFound => return (Entries::default(), None),
        Err(error) => format!("cannot be read ({error})"),
    };
    let aside = file.with_extension("damaged");
    let kept = match fs::rename(file, &aside) {
        Ok(()) => format!("it is kept aside as {}", aside.display()),
        Err(error) => format!("it could not be put aside: {error}"),
    };
    let trouble = format!("The settings file {} {what}: dapple begins with its own. {kept}", file.display());
    (Entries::default(), Some(trouble))
}

/// Writes them; that this fails is no reason to disturb anybody.
pub fn write(file: &Path, entries: &Entries) {
    let _ = export::save(file, |out| Ok(out.write_all(entries.text().as_bytes())?));
}

/// Where such things are kept on this system.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    let variable = |name: &str| std::env::var_os(name).filter(|value| !value.is_empty()).map(PathBuf::from);
    let base = if cfg!(windows) {
        variable("APPDATA")?
    } else if cfg!(target_os = "macos") {
        variable("HOME")?.join("Library/Application Support")
    } else {
        variable("XDG_DATA_HOME").or_else(|| Some(variable("HOME")?.join(".local/share")))?
    };
    Some(base.join("dapple"))
}
