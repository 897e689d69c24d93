//! What is remembered between two sessions: recent files, preferences, how the window lies. One line a thing.

mod export_choices;
mod file;
mod layout;

pub use file::{Entries, folder};
pub use layout::Layout;

use std::fs;
use std::path::{Path, PathBuf};

use egui::ThemePreference;

use super::exporting::Choices;
use super::pages::New;
use super::units::Units;
use crate::editor::path_encoding;

/// Recent files that are remembered.
const RECENT: usize = 10;

/// What is remembered.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Documents opened or saved, the latest first.
    pub recent: Vec<PathBuf>,
    /// Light, dark, or as the system.
    pub theme: ThemePreference,
    /// Was the first hint read?
    pub hint_seen: bool,
    /// In what lengths are told and typed.
    pub units: Units,
    /// Threads that grow; `None` = as many as there are cores, but for one that is left to the window.
    pub threads: Option<usize>,
    /// What a new document is, unless it is said.
    pub new: New,
    /// With what the next export dialog begins.
    pub export: Choices,
    /// How the window lies.
    pub layout: Layout,
    /// What was wrong with the file, to be told once.
    pub trouble: Option<String>,
    file: Option<PathBuf>,
    /// As last read or written: what differs was changed here, not by another window.
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
            trouble: None,
            file: None,
            base: Entries::default(),
        }
    }
}

impl Settings {
    /// Reads the user's; without a place for them, nothing is remembered.
    #[must_use]
    pub fn of_user() -> Self {
        folder().map_or_else(Self::default, |folder| Self::at(&folder.join("settings")))
    }

    /// Reads a file. One that is damaged is put aside.
    #[must_use]
    pub fn at(file: &Path) -> Self {
        let (entries, trouble) = file::read(file);
        let mut settings = Self { file: Some(file.to_owned()), trouble, ..Self::default() };
        settings.take_in(&entries);
        settings.base = settings.entries();
        settings
    }

    fn take_in(&mut self, entries: &Entries) {
        self.recent = entries.all("recent").map(path_encoding::decode).take(RECENT).collect();
        let one = |key| entries.one(key);
        self.theme = match one("theme") {
            Some("light") => ThemePreference::Light,
            Some("dark") => ThemePreference::Dark,
            _ => ThemePreference::System,
        };
        self.hint_seen = one("hint") == Some("seen");
        self.units = if one("units") == Some("mm") { Units::Mm } else { Units::Px };
        self.threads = one("threads").and_then(|number| number.parse().ok()).filter(|threads| *threads > 0);
        self.new = New::default();
        if let Some([width, height, columns, rows, seamless, dpi]) = entries.numbers("new") {
            let new = New {
                size: [width, height].map(|side| side as u32),
                regions: [columns, rows].map(|regions| regions as u32),
                seamless: seamless != 0.0,
                dpi,
            };
            self.new = if new.is_allowed() { new } else { New::default() };
        }
        self.export = export_choices::read(entries);
        self.layout.take_in(entries);
    }

    /// What differs from what a first start finds.
    fn entries(&self) -> Entries {
        let mut entries = Entries::default();
        for path in &self.recent {
            entries.add("recent", path_encoding::encode(path));
        }
        match self.theme {
            ThemePreference::Light => entries.add("theme", "light"),
            ThemePreference::Dark => entries.add("theme", "dark"),
            ThemePreference::System => {}
        }
        if self.hint_seen {
            entries.add("hint", "seen");
        }
        if self.units == Units::Mm {
            entries.add("units", "mm");
        }
        if let Some(threads) = self.threads {
            entries.add("threads", threads.to_string());
        }
        if self.new != New::default() {
            let New { size, regions, seamless, dpi } = &self.new;
            let ([width, height], [columns, rows]) = (size, regions);
            let seamless = u8::from(*seamless);
            entries.add("new", format!("{width} {height} {columns} {rows} {seamless} {dpi}"));
        }
        export_choices::tell(&self.export, &mut entries);
        self.layout.tell(&mut entries);
        entries
    }

    /// Remembers a document.
    pub fn remember(&mut self, path: &Path) {
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        self.update(|settings| {
            settings.recent.retain(|other| *other != path);
            settings.recent.insert(0, path);
            settings.recent.truncate(RECENT);
        });
    }

    /// Forgets the documents.
    pub fn forget(&mut self) {
        self.update(|settings| settings.recent.clear());
    }

    /// Writes down what was changed here; what other windows changed stays. That this fails is no reason to disturb
    /// anybody.
    pub fn write(&mut self) {
        self.update(|_| {});
    }

    fn update(&mut self, change: impl FnOnce(&mut Self)) {
        let Some(file) = self.file.clone() else {
            change(self);
            return;
        };
        let _one_at_a_time = file::lock(&file);
        let (theirs, _) = file::read(&file);
        // Another window may have remembered others in the meantime.
        self.recent = theirs.all("recent").map(path_encoding::decode).take(RECENT).collect();
        let known = self.base.clone().with("recent", &theirs);
        change(self);
        let mine = self.entries();
        let merged = theirs.clone().changed(&known, &mine);
        if merged != theirs {
            file::write(&file, &merged);
        }
        self.base = mine;
    }
}

#[cfg(test)]
mod tests;
