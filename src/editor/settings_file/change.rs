//! The changes that one window has made to the settings, and how they are merged into the file, to which other windows
//! write as well.

use std::path::PathBuf;

use super::{Entries, lock, read, write};
use crate::editor::path_encoding;
use crate::machine::fs;

/// The number of recent documents that are kept.
const RECENT: usize = 10;
/// The name of their list in the file.
const NAME: &str = "recent";

/// A change of the list of recent documents.
#[derive(Clone, Debug)]
pub enum RecentChange {
    /// A document was opened or saved: it becomes the latest.
    Used(PathBuf),
    /// The list was cleared.
    Cleared,
}

impl RecentChange {
    /// Carries out the change.
    pub fn apply(&self, recent: &mut Vec<PathBuf>) {
        match self {
            Self::Used(path) => {
                recent.retain(|other| other != path);
                recent.insert(0, path.clone());
                recent.truncate(RECENT);
            }
            Self::Cleared => recent.clear(),
        }
    }

    /// The change, with each path in the form that the file system gives it, so that one document is not listed under
    /// two paths.
    fn resolved(self) -> Self {
        match self {
            Self::Used(path) => Self::Used(fs::canonicalize(&path).unwrap_or(path)),
            Self::Cleared => Self::Cleared,
        }
    }
}

/// The changes of one window since it last read or wrote the file.
#[derive(Clone, Debug)]
pub struct SettingsChange {
    /// The settings file.
    pub file: PathBuf,
    /// The values at the time of that read or write.
    pub base: Entries,
    /// The present values. Those that differ from `base` were changed by this window.
    pub mine: Entries,
    /// The changes of the recent documents, in order.
    pub recent: Vec<RecentChange>,
}

/// The result of [`SettingsChange::write`].
#[derive(Debug, PartialEq, Eq)]
pub struct Merged {
    /// The recent documents of all windows, the latest first.
    pub recent: Vec<PathBuf>,
    /// Why the file could not be written.
    pub error: Option<String>,
}

impl SettingsChange {
    /// Merges the change into the file, and keeps the changes of other windows. Other windows wait until this is done.
    #[must_use]
    pub fn write(self) -> Merged {
        let _lock = lock(&self.file);
        let (theirs, _) = read(&self.file);
        let mut recent = recent(&theirs);
        self.recent.into_iter().for_each(|change| change.resolved().apply(&mut recent));
        let mut list = Entries::default();
        let paths: Vec<String> = recent.iter().map(|path| path_encoding::encode(path)).collect();
        list.set(NAME, &paths, &Vec::new());
        let merged = theirs.clone().with_changes(&self.base, &self.mine).with(NAME, &list);
        let unchanged = merged == theirs;
        let error = if unchanged { None } else { write(&self.file, &merged).err() };
        Merged { recent, error }
    }
}

/// The recent documents in the file, the latest first.
#[must_use]
pub fn recent(entries: &Entries) -> Vec<PathBuf> {
    let paths = entries.get::<Vec<String>>(NAME).unwrap_or_default();
    paths.iter().map(|path| path_encoding::decode(path)).take(RECENT).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::Path;

    fn used(path: &Path) -> SettingsChange {
        let file = path.with_file_name("settings");
        let recent = vec![RecentChange::Used(path.to_owned())];
        SettingsChange { file, base: Entries::default(), mine: Entries::default(), recent }
    }

    #[test]
    fn a_document_is_listed_once_whichever_path_leads_to_it() {
        let folder = tempfile::tempdir().unwrap();
        let folder = folder.path().canonicalize().unwrap();
        let document = folder.join("a.dapple");
        fs::write(&document, "").unwrap();
        fs::create_dir(folder.join("b")).unwrap();
        assert_eq!(used(&document).write().recent.len(), 1);
        let mut other = used(&folder.join("b/../a.dapple"));
        other.file = folder.join("settings");
        assert_eq!(other.write(), Merged { recent: vec![document], error: None });
    }

    #[test]
    fn the_latest_ten_are_remembered() {
        let folder = tempfile::tempdir().unwrap();
        let paths: Vec<PathBuf> = (0..12).map(|name| folder.path().join(name.to_string())).collect();
        let merged: Vec<Merged> = paths.iter().map(|path| used(path).write()).collect();
        let mut wanted = paths[2..].to_vec();
        wanted.reverse();
        assert_eq!(merged[11].recent, wanted);
    }

    #[test]
    fn a_file_that_cannot_be_written_is_reported() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("b"), "no folder").unwrap();
        let merged = used(&folder.path().join("b/a.dapple")).write();
        let error = merged.error.unwrap();
        assert!(error.contains("settings"), "{error}");
        assert_eq!(merged.recent, [folder.path().join("b/a.dapple")]);
    }
}
