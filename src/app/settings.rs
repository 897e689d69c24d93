//! What is remembered from one session to the next: recent files, preferences, window placement.

mod export_choices;
mod layout;

pub use layout::Layout;

use std::fs;
use std::path::{Path, PathBuf};

use directories::BaseDirs;
use egui::ThemePreference;

use super::exporting::Choices;
use super::pages::New;
use crate::editor::path_encoding;
use crate::editor::settings_file::{self, Entries};
use crate::editor::units::Units;

/// Recent files that are remembered.
const RECENT: usize = 10;

/// What is remembered.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Documents opened or saved, the latest first.
    pub recent: Vec<PathBuf>,
    /// Light, dark, or as the system.
    pub theme: ThemePreference,
    /// Whether the first hint was read.
    pub hint_seen: bool,
    /// The unit in which lengths are shown and typed.
    pub units: Units,
    /// Number of threads that grow; `None` = one less than there are cores, which is left to the window.
    pub threads: Option<usize>,
    /// The initial values for a new document.
    pub new: New,
    /// The initial choices of the export dialog.
    pub export: Choices,
    /// Placement of the window and what it shows.
    pub layout: Layout,
    /// Why the file could not be read: a message to be shown once.
    pub error: Option<String>,
    file: Option<PathBuf>,
    /// The values as last read or written: those that differ now were changed by this window.
    base: Entries,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            recent: Vec::new(),
            theme: ThemePreference::System,
            hint_seen: false,
            units: Units::default(),
            threads: None,
            new: New::default(),
            export: Choices::default(),
            layout: Layout::default(),
            error: None,
            file: None,
            base: Entries::default(),
        }
    }
}

impl Settings {
    /// Reads the user's settings; without a folder for them, nothing is remembered.
    #[must_use]
    pub fn for_user() -> Self {
        folder().map_or_else(Self::default, |folder| Self::read(&folder.join("settings")))
    }

    /// Reads a file. One that is damaged is renamed.
    #[must_use]
    pub fn read(file: &Path) -> Self {
        let (entries, error) = settings_file::read(file);
        let mut settings = Self { file: Some(file.to_owned()), error, ..Self::default() };
        settings.take_in(&entries);
        settings.base = settings.entries();
        settings
    }

    fn take_in(&mut self, entries: &Entries) {
        self.recent = recent(entries);
        self.theme = match entries.get::<String>("theme").as_deref() {
            Some("light") => ThemePreference::Light,
            Some("dark") => ThemePreference::Dark,
            _ => ThemePreference::System,
        };
        self.hint_seen = entries.get("hint_seen").unwrap_or_default();
        self.units = entries.get("units").unwrap_or_default();
        self.threads = entries.get("threads").filter(|threads| *threads > 0);
        let new = entries.fields("new", &New::default());
        self.new = if new.is_allowed() { new } else { New::default() };
        self.export = export_choices::read(entries);
        self.layout.take_in(entries);
    }

    /// The values that differ from the defaults.
    fn entries(&self) -> Entries {
        let mut entries = Entries::default();
        let recent: Vec<String> = self.recent.iter().map(|path| path_encoding::encode(path)).collect();
        entries.set("recent", &recent, &Vec::new());
        let theme = match self.theme {
            ThemePreference::Light => "light",
            ThemePreference::Dark => "dark",
            ThemePreference::System => "system",
        };
        entries.set("theme", &theme, &"system");
        entries.set("hint_seen", &self.hint_seen, &false);
        entries.set("units", &self.units, &Units::default());
        entries.set("threads", &self.threads, &None);
        entries.set("new", &self.new, &New::default());
        export_choices::write(&self.export, &mut entries);
        self.layout.write(&mut entries);
        entries
    }

    /// Adds a document to the recent ones.
    pub fn remember(&mut self, path: &Path) {
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        self.update(|settings| {
            settings.recent.retain(|other| *other != path);
            settings.recent.insert(0, path);
            settings.recent.truncate(RECENT);
        });
    }

    /// Forgets the recent documents.
    pub fn forget(&mut self) {
        self.update(|settings| settings.recent.clear());
    }

    /// Writes what this window changed; what other windows changed stays. Failing to write is not reported.
    pub fn write(&mut self) {
        self.update(|_| {});
    }

    fn update(&mut self, change: impl FnOnce(&mut Self)) {
        let Some(file) = self.file.clone() else {
            change(self);
            return;
        };
        let _lock = settings_file::lock(&file);
        let (theirs, _) = settings_file::read(&file);
        // Another window may have added recent documents in the meantime.
        self.recent = recent(&theirs);
        let base = self.base.clone().with("recent", &theirs);
        change(self);
        let mine = self.entries();
        let merged = theirs.clone().with_changes(&base, &mine);
        if merged != theirs {
            settings_file::write(&file, &merged);
        }
        self.base = mine;
    }
}

fn recent(entries: &Entries) -> Vec<PathBuf> {
    let paths = entries.get::<Vec<String>>("recent").unwrap_or_default();
    paths.iter().map(|path| path_encoding::decode(path)).take(RECENT).collect()
}

/// The folder of the user's settings and recovery files; `None` where the system has none.
#[must_use]
pub fn folder() -> Option<PathBuf> {
    let base = BaseDirs::new()?;
    // On Windows the roaming folder: settings follow the user.
    Some(base.data_dir().join("dapple"))
}

#[cfg(test)]
mod tests;
