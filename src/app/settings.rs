//! What is remembered between two sessions: recent files, theme, whether the hint was seen. One line a thing.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

use eframe::egui::ThemePreference;

use crate::export;

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
    file: Option<PathBuf>,
}

impl Default for Settings {
    fn default() -> Self {
        Self { recent: Vec::new(), theme: ThemePreference::System, hint_seen: false, file: None }
    }
}

impl Settings {
    /// Reads the user's; without a place for them, nothing is remembered.
    #[must_use]
    pub fn of_user() -> Self {
        Self::at(&match folder() {
            Some(folder) => folder.join("settings"),
            None => return Self::default(),
        })
    }

    /// Reads a file.
    #[must_use]
    pub fn at(file: &Path) -> Self {
        let mut settings = Self { file: Some(file.to_owned()), ..Self::default() };
        settings.take_in(&fs::read_to_string(file).unwrap_or_default());
        settings
    }

    fn take_in(&mut self, text: &str) {
        for (key, value) in text.lines().filter_map(|line| line.split_once(' ')) {
            match (key, value) {
                ("recent", path) => self.recent.push(PathBuf::from(path)),
                ("theme", "light") => self.theme = ThemePreference::Light,
                ("theme", "dark") => self.theme = ThemePreference::Dark,
                ("hint", "seen") => self.hint_seen = true,
                // What a newer version remembers.
                _ => {}
            }
        }
        self.recent.truncate(RECENT);
    }

    /// Remembers a document.
    pub fn remember(&mut self, path: &Path) {
        let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        // Another window may have remembered others in the meantime.
        if let Some(file) = &self.file {
            self.recent = Self::at(file).recent;
        }
        self.recent.retain(|other| *other != path);
        self.recent.insert(0, path);
        self.recent.truncate(RECENT);
        self.write();
    }

    /// Forgets the documents.
    pub fn forget(&mut self) {
        self.recent.clear();
        self.write();
    }

    /// Writes them down. That this fails is no reason to disturb anybody.
    pub fn write(&self) {
        let Some(file) = &self.file else { return };
        let mut text = String::new();
        for path in &self.recent {
            text.push_str(&format!("recent {}\n", path.display()));
        }
        match self.theme {
            ThemePreference::Light => text.push_str("theme light\n"),
            ThemePreference::Dark => text.push_str("theme dark\n"),
            ThemePreference::System => {}
        }
        if self.hint_seen {
            text.push_str("hint seen\n");
        }
        if let Some(folder) = file.parent() {
            let _ = fs::create_dir_all(folder);
        }
        let _ = export::save(file, |out| Ok(out.write_all(text.as_bytes())?));
    }
}

/// Where such things are kept on this system.
fn folder() -> Option<PathBuf> {
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
