//! The memory that is free.

use std::sync::OnceLock;

static FREE: OnceLock<fn() -> f64> = OnceLock::new();

/// Bytes of memory that the program can still have; none before [`set_free`] has said how they are found.
#[must_use]
pub fn free_memory() -> f64 {
    FREE.get().map_or(0.0, |free| free())
}

/// Says how the free memory is found: the page chooses how much there is, and the allocator knows what is used.
pub fn set_free(free: fn() -> f64) {
    // It is said once.
    let _ = FREE.set(free);
}
