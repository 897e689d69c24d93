//! Removal of incomplete files that killed processes left behind.
//!
//! A process keeps its temporary file locked until the file is renamed; the system releases the lock when the process
//! ends. So on every file system with locks, a temporary file of dapple without a lock is stale. Files in use are not
//! touched.

use std::collections::BTreeSet;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::abandon::created;
use crate::machine::fs::{self, DirEntry, File, OpenOptions, Permissions, TryLockError};
use crate::machine::temporary::{Builder, NamedTempFile, TempDir};

const PREFIX: &str = ".dapple-";
const SUFFIX: &str = ".part";

/// A new locked file with a unique name in `folder`; stale files there are removed first.
pub fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    remove_stale_once(folder);
    loop {
        let file = created(|| builder(0o666).tempfile_in(folder), |file| file.path().to_owned())?;
        // Another process may have removed it before it was locked.
        if !matches!(file.as_file().try_lock(), Err(TryLockError::WouldBlock)) && fs::exists(file.path()) {
            return Ok(file);
        }
    }
}

/// A new locked folder, made like [`new_file`] makes a file; without a lock where the system cannot lock folders.
pub fn new_folder(parent: &Path) -> io::Result<(TempDir, Option<File>)> {
    remove_stale_once(parent);
    loop {
        let folder = created(|| builder(0o777).tempdir_in(parent), |folder| folder.path().to_owned())?;
        let Ok(lock) = File::open(folder.path()) else { return Ok((folder, None)) };
        if !matches!(lock.try_lock(), Err(TryLockError::WouldBlock)) && fs::exists(folder.path()) {
            return Ok((folder, Some(lock)));
        }
    }
}

/// With the permissions of ordinary new files (before the umask); temporary files are readable by their owner only.
fn builder(mode: u32) -> Builder<'static, 'static> {
    let mut builder = Builder::new();
    builder.prefix(PREFIX).suffix(SUFFIX);
    if let Some(usual) = permissions(mode) {
        builder.permissions(usual);
    }
    builder
}

#[cfg(unix)]
fn permissions(mode: u32) -> Option<Permissions> {
    Some(std::os::unix::fs::PermissionsExt::from_mode(mode))
}

#[cfg(not(unix))]
fn permissions(_: u32) -> Option<Permissions> {
    None
}

/// Removes stale files when this process first writes into a folder, so a batch does not list it for each picture.
fn remove_stale_once(folder: &Path) {
    static CLEANED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    let Ok(folder) = fs::canonicalize(folder) else { return };
    if CLEANED.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.clone()) {
        remove_stale(&folder);
    }
}

/// Removes the stale files in a folder. Failures are ignored.
fn remove_stale(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let is_ours = |name: &str| name.starts_with(PREFIX) && name.ends_with(SUFFIX);
        if entry.file_name().to_str().is_some_and(is_ours) {
            let _ = remove_if_stale(&entry);
        }
    }
}

fn remove_if_stale(entry: &DirEntry) -> io::Result<()> {
    let (kind, path) = (entry.file_type()?, entry.path());
    // The target of a link does not belong to dapple.
    if kind.is_file() {
        let file = OpenOptions::new().write(true).open(&path)?;
        file.try_lock()?;
        return fs::remove_file(&path);
    }
    if !kind.is_dir() {
        return Ok(());
    }
    let lock = File::open(&path)?;
    lock.try_lock()?;
    let frames: Vec<PathBuf> = fs::read_dir(&path)?.flatten().map(|frame| frame.path()).collect();
    let is_frame = |path: &PathBuf| {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        name.starts_with("frame-") && name.ends_with(".png") && !fs::is_dir(path)
    };
    // A folder that holds any other file is kept: a user put that file there.
    if frames.iter().all(is_frame) {
        frames.iter().try_for_each(fs::remove_file)?;
        fs::remove_dir(&path)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    #[test]
    fn files_of_a_killed_process_are_removed_by_the_next_that_writes() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(".dapple-aaaaaa.part"), "half a picture").unwrap();
        let film = folder.path().join(".dapple-bbbbbb.part");
        fs::create_dir(&film).unwrap();
        fs::write(film.join("frame-0001.png"), "half a frame").unwrap();
        let begun = new_file(folder.path()).unwrap();
        let name = begun.path().file_name().unwrap().to_str().unwrap().to_owned();
        assert_eq!(names_in(folder.path()), [name]);
    }

    #[test]
    fn files_in_use_are_not_stale() {
        let folder = tempfile::tempdir().unwrap();
        let begun = new_file(folder.path()).unwrap();
        let film = new_folder(folder.path()).unwrap();
        remove_stale(folder.path());
        assert!(begun.path().exists() && film.0.path().exists());
        let (path, beside) = (begun.path().to_owned(), film.0.path().to_owned());
        // The state after a kill: the files exist, and their locks are free.
        let _ = (begun.keep().unwrap(), film.0.keep());
        drop(film.1);
        remove_stale(folder.path());
        assert!(!path.exists() && !beside.exists());
    }

    #[test]
    fn other_files_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        for name in ["dapple-aaaaaa.part", ".dapple-a.png", "a.part", ".dapple"] {
            fs::write(at(name), "mine").unwrap();
        }
        fs::create_dir(at(".dapple-cccccc.part")).unwrap();
        fs::write(at(".dapple-cccccc.part/frame-0001.png"), "a frame").unwrap();
        fs::write(at(".dapple-cccccc.part/notes.txt"), "mine").unwrap();
        let before = names_in(folder.path());
        remove_stale(folder.path());
        assert_eq!(names_in(folder.path()), before);
        assert_eq!(names_in(&at(".dapple-cccccc.part")), ["frame-0001.png", "notes.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_with_such_a_name_and_its_target_are_kept() {
        let folder = tempfile::tempdir().unwrap();
        let [mine, link] = ["mine", ".dapple-aaaaaa.part"].map(|name| folder.path().join(name));
        fs::write(&mine, "mine").unwrap();
        std::os::unix::fs::symlink(&mine, &link).unwrap();
        remove_stale(folder.path());
        assert!(mine.exists() && link.is_symlink());
    }
}
