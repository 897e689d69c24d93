//! The amount of free memory.

use std::sync::OnceLock;

static FREE: OnceLock<fn() -> f64> = OnceLock::new();

/// Bytes of memory that the program can still get; 0 before [`set_free`] was called.
#[must_use]
pub fn free_memory() -> f64 {
    FREE.get().map_or(0.0, |free| free())
}

/// Sets the function that returns the free memory. The page decides how much memory there is, and the allocator knows
/// how much is used.
pub fn set_free(free: fn() -> f64) {
    // Only the first call has an effect.
    let _ = FREE.set(free);
}

/// Does nothing: the memory of a page never shrinks.
pub fn give_back() {}
