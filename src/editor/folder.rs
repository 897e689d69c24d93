//! Lists folders and checks chosen files for a file dialog. This runs on other threads, because a folder may be on a
//! network drive.

use std::path::{Path, PathBuf};

use super::task::{StartError, Task, Tasks, Worker};
use crate::machine::fs;

/// What is in a folder.
#[derive(Debug, PartialEq, Eq)]
pub struct Listing {
    /// The folder.
    pub folder: PathBuf,
    /// Names of folders, then of files; `true` = a folder.
    pub entries: Vec<(String, bool)>,
}

/// What is at a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing.
    Missing,
    /// A file.
    File,
    /// A folder with nothing in it.
    EmptyFolder,
    /// A folder.
    Folder,
}

/// Endings of file names.
type Endings = &'static [&'static str];

/// Lists the folders in `folder` and the files with one of these endings, without hidden ones.
///
/// # Errors
/// Where no thread can be started.
pub fn list(folder: &Path, endings: Endings, tasks: &Tasks) -> Result<Task<Listing>, StartError> {
    let folder = folder.to_owned();
    tasks.start("reading a folder", move |worker: &Worker<_>| worker.send(listing(folder, endings)))
}

/// Lists the folder that [`resolved`] gives for `folder`, without hidden files.
///
/// # Errors
/// Where no thread can be started.
pub fn list_resolved(folder: &Path, endings: Endings, tasks: &Tasks) -> Result<Task<Listing>, StartError> {
    let folder = folder.to_owned();
    tasks.start("reading a folder", move |worker: &Worker<_>| {
        worker.send(listing(resolved(&folder), endings));
    })
}

/// Finds out whether a file or a folder is at `path`.
///
/// # Errors
/// Where no thread can be started.
pub fn look_at(path: &Path, tasks: &Tasks) -> Result<Task<Kind>, StartError> {
    let path = path.to_owned();
    tasks.start("looking at a file", move |worker: &Worker<_>| worker.send(kind(&path)))
}

/// The folder, resolved; the current one where there is no such folder.
#[must_use]
pub fn resolved(folder: &Path) -> PathBuf {
    let current = || std::env::current_dir().unwrap_or_else(|_| PathBuf::from("."));
    let folder = if fs::is_dir(folder) { folder.to_owned() } else { current() };
    fs::canonicalize(&folder).unwrap_or(folder)
}

/// What is at `path`.
#[must_use]
pub fn kind(path: &Path) -> Kind {
    if !fs::is_dir(path) {
        return if fs::exists(path) { Kind::File } else { Kind::Missing };
    }
    let is_empty = fs::read_dir(path).is_ok_and(|mut inside| inside.next().is_none());
    if is_empty { Kind::EmptyFolder } else { Kind::Folder }
}

fn listing(folder: PathBuf, endings: &[&str]) -> Listing {
    let fits = |name: &str| {
        let ending = Path::new(name).extension().map(|ending| ending.to_string_lossy().to_lowercase());
        ending.is_some_and(|ending| endings.contains(&ending.as_str()))
    };
    let files = fs::read_dir(&folder).into_iter().flatten().flatten();
    let mut entries: Vec<(String, bool)> = files
        .map(|entry| (entry.file_name().to_string_lossy().into_owned(), fs::is_dir(entry.path())))
        .filter(|(name, folder)| !name.starts_with('.') && (*folder || fits(name)))
        .collect();
    entries.sort_by_key(|(name, folder)| (!folder, name.to_lowercase()));
    Listing { folder, entries }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_come_first_and_hidden_and_other_files_are_left_out() {
        let folder = tempfile::tempdir().unwrap();
        fs::create_dir(folder.path().join("z")).unwrap();
        for name in ["b.PNG", "A.png", "c.txt", ".hidden.png"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let task = list_resolved(&folder.path().join("z/.."), &["png"], &Tasks::default()).unwrap();
        let entries = [("z", true), ("A.png", false), ("b.PNG", false)];
        let entries = entries.map(|(name, is_folder)| (name.to_owned(), is_folder)).to_vec();
        assert_eq!(task.join(), [Listing { folder: folder.path().canonicalize().unwrap(), entries }]);
    }

    #[test]
    fn the_current_folder_is_listed_where_there_is_no_such_folder() {
        let here = std::env::current_dir().unwrap().canonicalize().unwrap();
        let nowhere = Path::new("/nowhere/at/all");
        assert_eq!(list_resolved(nowhere, &[], &Tasks::default()).unwrap().join()[0].folder, here);
        let listing = Listing { folder: nowhere.to_owned(), entries: Vec::new() };
        assert_eq!(list(nowhere, &[], &Tasks::default()).unwrap().join(), [listing]);
    }

    #[test]
    fn files_and_empty_and_other_folders_are_told_apart() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(kind(folder.path()), Kind::EmptyFolder);
        let file = folder.path().join("a");
        assert_eq!(kind(&file), Kind::Missing);
        fs::write(&file, "").unwrap();
        assert_eq!((kind(&file), kind(folder.path())), (Kind::File, Kind::Folder));
    }
}
