//! Files that several windows share: one at a time has the lock. It goes with whoever holds it, killed or not.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::ErrorKind;
use std::path::Path;
use std::thread;
use std::time::{Duration, Instant};

/// Nobody holds a shared lock for longer than it takes to write a small file; a process that was stopped in the middle
/// of that must not stop the others.
const PATIENCE: Duration = Duration::from_millis(500);

/// Who has a file.
#[derive(Debug)]
pub enum Held {
    /// We; until it is dropped.
    Ours(File),
    /// Another process, or another window of this one.
    Theirs,
    /// Nobody can: there is no such place, or its file system knows no locks.
    Unknown,
}

/// Takes the lock `file` if it is free; makes it where it is not there.
#[must_use]
pub fn take(file: &Path) -> Held {
    let Ok(lock) = OpenOptions::new().write(true).create(true).truncate(false).open(file) else {
        return Held::Unknown;
    };
    match lock.try_lock() {
        Ok(()) => Held::Ours(lock),
        Err(TryLockError::WouldBlock) => Held::Theirs,
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Interrupted => Held::Theirs,
        Err(TryLockError::Error(_)) => Held::Unknown,
    }
}

/// Waits for the lock `file`; gives up after half a second.
#[must_use]
pub fn wait_for(file: &Path) -> Option<File> {
    let began = Instant::now();
    loop {
        match take(file) {
            Held::Ours(lock) => return Some(lock),
            Held::Theirs if began.elapsed() < PATIENCE => thread::sleep(Duration::from_millis(3)),
            Held::Theirs | Held::Unknown => return None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_is_held_by_one_and_goes_with_him() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("lock");
        let mine = take(&file);
        assert!(matches!(mine, Held::Ours(_)));
        assert!(matches!(take(&file), Held::Theirs));
        drop(mine);
        assert!(matches!(take(&file), Held::Ours(_)));
        assert!(matches!(take(&folder.path().join("nowhere/lock")), Held::Unknown));
    }
}
