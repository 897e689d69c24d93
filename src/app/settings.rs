//! Settings that are kept from one run of dapple to the next: recent files, preferences, window placement.

mod export_choices;
mod layout;

pub use layout::{COLUMN_WIDTHS, Layout};

use std::path::{Path, PathBuf};

use egui::ThemePreference;

use super::exporting::Choices;
use super::pages::New;
use super::platform;
use crate::document::link::SITE;
use crate::editor::pens::Pens;
use crate::editor::settings_file::{self, Entries, RecentChange, SettingsChange};
use crate::editor::units::Units;
use crate::editor::wheel::Wheel;

/// Scales of the interface that can be chosen.
pub const SCALES: [f32; 8] = [0.75, 0.9, 1.0, 1.1, 1.25, 1.5, 1.75, 2.0];

/// The settings.
#[derive(Clone, Debug)]
pub struct Settings {
    /// Documents opened or saved, the latest first.
    pub recent: Vec<PathBuf>,
    /// Light, dark, or as the system.
    pub theme: ThemePreference,
    /// The unit in which lengths are shown and typed.
    pub units: Units,
    /// Number of threads that grow; `None` = as many as there are cores.
    pub threads: Option<usize>,
    /// How pens are used.
    pub pens: Pens,
    /// What the wheel does.
    pub wheel: Wheel,
    /// Scale of the interface; 1 = as large as the system asks for.
    pub scale: f32,
    /// The initial values for a new document.
    pub new: New,
    /// The initial choices of the export dialog.
    pub export: Choices,
    /// The folder that was exported into last.
    pub export_folder: Option<PathBuf>,
    /// The address of the window on the web. In a link, the document follows this address.
    pub site: String,
    /// Placement of the window, and what is shown in it.
    pub layout: Layout,
    /// Why the file could not be read: a message to be shown once.
    pub error: Option<String>,
    file: Option<PathBuf>,
    /// The values as they were last read or written. Values that differ now were changed by this window.
    base: Entries,
    /// Changes of the recent documents that are not written yet.
    recent_changes: Vec<RecentChange>,
    is_due: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            recent: Vec::new(),
            theme: ThemePreference::System,
            units: Units::default(),
            threads: None,
            pens: Pens::default(),
            wheel: Wheel::default(),
            scale: 1.0,
            new: New::default(),
            export: Choices::default(),
            export_folder: None,
            site: SITE.to_owned(),
            layout: Layout::default(),
            error: None,
            file: None,
            base: Entries::default(),
            recent_changes: Vec::new(),
            is_due: false,
        }
    }
}

impl Settings {
    /// Reads the user's settings; without a folder for them, nothing is remembered. This blocks, because the window
    /// opens at the place and in the theme that the settings name.
    #[must_use]
    pub fn for_user() -> Self {
        platform::settings_folder().map_or_else(Self::default, |folder| Self::read(&folder.join("settings")))
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
        self.recent = settings_file::recent(entries);
        self.theme = match entries.get::<String>("theme").as_deref() {
            Some("light") => ThemePreference::Light,
            Some("dark") => ThemePreference::Dark,
            _ => ThemePreference::System,
        };
        self.units = entries.get("units").unwrap_or_default();
        self.threads = entries.get("threads").filter(|threads| *threads > 0);
        self.pens = entries.get("pens").unwrap_or_default();
        self.wheel = entries.get("wheel").unwrap_or_default();
        self.scale = entries.get("scale").filter(|scale| SCALES.contains(scale)).unwrap_or(1.0);
        let new = entries.fields("new", &New::default());
        self.new = if new.is_allowed() { new } else { New::default() };
        self.export = export_choices::read(entries);
        self.export_folder = entries.get::<String>("export_folder").map(PathBuf::from);
        self.site = entries.get("site").unwrap_or_else(|| SITE.to_owned());
        self.layout.take_in(entries);
    }

    /// The values that differ from the defaults, without the recent documents.
    fn entries(&self) -> Entries {
        let mut entries = Entries::default();
        let theme = match self.theme {
            ThemePreference::Light => "light",
            ThemePreference::Dark => "dark",
            ThemePreference::System => "system",
        };
        entries.set("theme", &theme, &"system");
        entries.set("units", &self.units, &Units::default());
        entries.set("threads", &self.threads, &None);
        entries.set("pens", &self.pens, &Pens::default());
        entries.set("wheel", &self.wheel, &Wheel::default());
        entries.set("scale", &self.scale, &1.0);
        entries.set("new", &self.new, &New::default());
        export_choices::write(&self.export, &mut entries);
        // A folder whose name is not valid Unicode is not kept.
        let folder = self.export_folder.as_deref().and_then(Path::to_str);
        entries.set("export_folder", &folder, &None);
        entries.set("site", &self.site.as_str(), &SITE);
        self.layout.write(&mut entries);
        entries
    }

    /// Adds a document to the recent ones, unless its file is temporary.
    pub fn remember(&mut self, path: &Path) {
        if platform::HAS_FOLDERS {
            self.change_recent(RecentChange::Used(path.to_owned()));
        }
    }

    /// Forgets the recent documents.
    pub fn forget(&mut self) {
        self.change_recent(RecentChange::Cleared);
    }

    fn change_recent(&mut self, change: RecentChange) {
        change.apply(&mut self.recent);
        self.recent_changes.push(change);
        self.write_soon();
    }

    /// Requests that the changed settings are written.
    pub fn write_soon(&mut self) {
        self.is_due = true;
    }

    /// Whether there is something to write.
    #[must_use]
    pub fn is_due(&self) -> bool {
        self.is_due && self.file.is_some()
    }

    /// The change that is to be written, once; `None` where there is nothing to write.
    pub fn take_change(&mut self) -> Option<SettingsChange> {
        let is_due = std::mem::take(&mut self.is_due);
        let file = self.file.clone().filter(|_| is_due)?;
        let mine = self.entries();
        let base = std::mem::replace(&mut self.base, mine.clone());
        Some(SettingsChange { file, base, mine, recent: std::mem::take(&mut self.recent_changes) })
    }

    /// Replaces the recent documents by those in the file, to which all windows write.
    pub fn take_recent(&mut self, recent: Vec<PathBuf>) {
        self.recent = recent;
        self.recent_changes.iter().for_each(|change| change.apply(&mut self.recent));
    }

    /// Writes the changes of this window at once; changes by other windows are kept. Returns why that failed.
    pub fn write(&mut self) -> Option<String> {
        self.write_soon();
        let merged = self.take_change()?.write();
        self.take_recent(merged.recent);
        merged.error
    }
}

#[cfg(test)]
mod tests;
