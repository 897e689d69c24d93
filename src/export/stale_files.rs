//! Files that somebody began to write and could not end, because he was killed.
//!
//! Whoever writes holds the lock of his file until it has its name; the system takes the lock from the dead. So a file
//! of ours whose lock is free is rubbish, on any file system that knows locks, and nobody else's work is touched.

use std::collections::BTreeSet;
use std::fs::{self, DirEntry, File, OpenOptions, Permissions, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use tempfile::{Builder, NamedTempFile, TempDir};

const PREFIX: &str = ".dapple-";
const SUFFIX: &str = ".part";

/// A new file in `folder`, under a name of its own, locked; rubbish that lies there is taken away before.
pub fn new_file(folder: &Path) -> io::Result<NamedTempFile> {
    sweep_once(folder);
    loop {
        let file = builder(0o666).tempfile_in(folder)?;
        // Whoever sweeps may have come between.
        if !matches!(file.as_file().try_lock(), Err(TryLockError::WouldBlock)) && file.path().exists() {
            return Ok(file);
        }
    }
}

/// The same for a folder, with its lock where the system has such.
pub fn new_folder(parent: &Path) -> io::Result<(TempDir, Option<File>)> {
    sweep_once(parent);
    loop {
        let folder = builder(0o777).tempdir_in(parent)?;
        let Ok(lock) = File::open(folder.path()) else { return Ok((folder, None)) };
        if !matches!(lock.try_lock(), Err(TryLockError::WouldBlock)) && folder.path().exists() {
            return Ok((folder, Some(lock)));
        }
    }
}

/// What any program's new file gets, before the umask; a temporary one would be the owner's alone.
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

/// Sweeps a folder when this process first writes into it: a batch need not list it for each picture.
fn sweep_once(folder: &Path) {
    static SWEPT: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());
    let Ok(folder) = folder.canonicalize() else { return };
    if SWEPT.lock().unwrap_or_else(PoisonError::into_inner).insert(folder.clone()) {
        sweep(&folder);
    }
}

/// Takes away what was left in a folder. What cannot be is no reason to fail.
fn sweep(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let is_ours = |name: &str| name.starts_with(PREFIX) && name.ends_with(SUFFIX);
        if entry.file_name().to_str().is_some_and(is_ours) {
            let _ = remove_left(&entry);
        }
    }
}

fn remove_left(entry: &DirEntry) -> io::Result<()> {
    let (kind, path) = (entry.file_type()?, entry.path());
    // A link leads to what is not ours.
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
        name.starts_with("frame-") && name.ends_with(".png") && !path.is_dir()
    };
    // What holds anything else, somebody wants.
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
    fn what_a_killed_process_left_is_swept_away_by_the_next_that_writes() {
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
    fn what_is_being_written_is_not_rubbish() {
        let folder = tempfile::tempdir().unwrap();
        let begun = new_file(folder.path()).unwrap();
        let film = new_folder(folder.path()).unwrap();
        sweep(folder.path());
        assert!(begun.path().exists() && film.0.path().exists());
        let (path, beside) = (begun.path().to_owned(), film.0.path().to_owned());
        // As a kill leaves them: there, and nobody holds their locks.
        let _ = (begun.keep().unwrap(), film.0.keep());
        drop(film.1);
        sweep(folder.path());
        assert!(!path.exists() && !beside.exists());
    }

    #[test]
    fn what_is_not_ours_stays() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        for name in ["dapple-aaaaaa.part", ".dapple-a.png", "a.part", ".dapple"] {
            fs::write(at(name), "mine").unwrap();
        }
        fs::create_dir(at(".dapple-cccccc.part")).unwrap();
        fs::write(at(".dapple-cccccc.part/frame-0001.png"), "a frame").unwrap();
        fs::write(at(".dapple-cccccc.part/notes.txt"), "mine").unwrap();
        let before = names_in(folder.path());
        sweep(folder.path());
        assert_eq!(names_in(folder.path()), before);
        assert_eq!(names_in(&at(".dapple-cccccc.part")), ["frame-0001.png", "notes.txt"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_that_has_such_a_name_and_what_it_leads_to_stay() {
        let folder = tempfile::tempdir().unwrap();
        let [mine, link] = ["mine", ".dapple-aaaaaa.part"].map(|name| folder.path().join(name));
        fs::write(&mine, "mine").unwrap();
        std::os::unix::fs::symlink(&mine, &link).unwrap();
        sweep(folder.path());
        assert!(mine.exists() && link.is_symlink());
    }
}
