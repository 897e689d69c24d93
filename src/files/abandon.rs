//! Keeps a list of the unfinished files of this process, so that the process can end at any moment without leaving any.

use std::collections::BTreeSet;
use std::io;
use std::mem::forget;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::machine::fs;

/// Temporary files and folders that were created, also those that have been renamed or deleted since.
static CREATED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
/// Folders that were created for files, each before its parent folder.
static FOLDERS: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
/// Locked while files that belong together get their final names.
static NAMING: Mutex<()> = Mutex::new(());

/// The number of attempts to remove a folder.
const TRIES: usize = 100;

fn locked<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Creates a temporary file or folder, and records its path.
pub(super) fn created<T>(
    create: impl FnOnce() -> io::Result<T>,
    path: impl FnOnce(&T) -> PathBuf,
) -> io::Result<T> {
    let mut paths = locked(&CREATED);
    let made = create()?;
    paths.insert(path(&made));
    Ok(made)
}

/// Gives files their final names. [`abandon`] waits until all of them have theirs.
pub(super) fn naming<T>(name: impl FnOnce() -> T) -> T {
    let _all = locked(&NAMING);
    name()
}

/// Creates `folder` and its missing parents.
pub(super) fn create_folders(folder: &Path) -> io::Result<()> {
    let mut folders = locked(&FOLDERS);
    let missing = folder.ancestors().take_while(|folder| *folder != Path::new("") && !fs::exists(folder));
    let missing: Vec<PathBuf> = missing.map(Path::to_owned).collect();
    let made = fs::create_dir_all(folder);
    folders.splice(..0, missing);
    made
}

/// Removes the folders that this process has created for files and that are empty.
pub fn remove_empty_folders() {
    remove_if_empty(&mut locked(&FOLDERS));
}

fn remove_if_empty(folders: &mut Vec<PathBuf>) {
    for folder in folders.drain(..) {
        // A folder that is not empty is not removed.
        let _ = fs::remove_dir(folder);
    }
}

/// Deletes the unfinished files and folders of this process, and the folders that would be left empty. After that the
/// process cannot create or rename a temporary file: threads that try to do so wait for ever. Call this just before the
/// process ends.
pub fn abandon() {
    forget(locked(&NAMING));
    let paths = locked(&CREATED);
    for path in paths.iter() {
        // Most of them have been renamed or deleted. Another thread may still write into a folder.
        (0..TRIES).take_while(|_| fs::exists(path)).for_each(|_| {
            let _ = fs::remove_file(path).or_else(|_| fs::remove_dir_all(path));
        });
    }
    forget(paths);
    let mut folders = locked(&FOLDERS);
    remove_if_empty(&mut folders);
    forget(folders);
}
