//! Locks that the page's thread may take. A browser does not let that thread block, so it tries again until it
//! succeeds. Such locks may only be held for a short time.

use std::hint::spin_loop;
pub use std::sync::{Condvar, MutexGuard, PoisonError};
use std::sync::{LockResult, TryLockError};

use super::threads::{fail_if_panicked, is_page};

/// A lock.
#[derive(Debug, Default)]
pub struct Mutex<T>(std::sync::Mutex<T>);

impl<T> Mutex<T> {
    /// A lock around `value`.
    pub const fn new(value: T) -> Self {
        Self(std::sync::Mutex::new(value))
    }

    /// Takes the lock.
    ///
    /// # Errors
    /// Never: a thread that panics ends the program.
    pub fn lock(&self) -> LockResult<MutexGuard<'_, T>> {
        if !is_page() {
            return self.0.lock();
        }
        loop {
            match self.0.try_lock() {
                Ok(guard) => return Ok(guard),
                Err(TryLockError::Poisoned(error)) => return Err(error),
                Err(TryLockError::WouldBlock) => {
                    fail_if_panicked();
                    spin_loop();
                }
            }
        }
    }
}
