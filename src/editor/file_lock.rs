//! Locks on files that several windows share: one holder at a time. The system releases a lock when its process ends,
//! in whatever way it ends.

use std::io::ErrorKind;
use std::path::Path;
use std::time::Duration;

use crate::machine::clock::Instant;
use crate::machine::fs::{File, OpenOptions, TryLockError};
use crate::machine::threads;

/// Longest wait for a shared lock. It is much longer than writing a small file takes, and so short that a process which
/// was stopped while it held the lock does not block the others.
const TIMEOUT: Duration = Duration::from_millis(500);

/// The outcome of taking a lock.
#[derive(Debug)]
pub enum Lock {
    /// This process holds it until the file is dropped.
    Held(File),
    /// Another process holds it, or another window of this one.
    Busy,
    /// The file cannot be made, or its file system has no locks.
    Unsupported,
}

/// Takes the lock `file` if it is free; creates the file if it is missing.
#[must_use]
pub fn try_lock(file: &Path) -> Lock {
    let Ok(lock) = OpenOptions::new().write(true).create(true).truncate(false).open(file) else {
        return Lock::Unsupported;
    };
    match lock.try_lock() {
        Ok(()) => Lock::Held(lock),
        Err(TryLockError::WouldBlock) => Lock::Busy,
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Interrupted => Lock::Busy,
        Err(TryLockError::Error(_)) => Lock::Unsupported,
    }
}

/// Waits for the lock `file`; `None` after half a second, or where there are no locks.
#[must_use]
pub fn wait_for(file: &Path) -> Option<File> {
    let began = Instant::now();
    loop {
        match try_lock(file) {
            Lock::Held(lock) => return Some(lock),
            Lock::Busy if began.elapsed() < TIMEOUT => threads::sleep(Duration::from_millis(3)),
            Lock::Busy | Lock::Unsupported => return None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_has_one_holder_and_is_free_when_it_is_dropped() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("lock");
        let mine = try_lock(&file);
        assert!(matches!(mine, Lock::Held(_)));
        assert!(matches!(try_lock(&file), Lock::Busy));
        drop(mine);
        assert!(matches!(try_lock(&file), Lock::Held(_)));
        assert!(matches!(try_lock(&folder.path().join("nowhere/lock")), Lock::Unsupported));
    }
}
