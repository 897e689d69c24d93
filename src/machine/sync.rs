//! Locks that the window's thread may take.

pub use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
