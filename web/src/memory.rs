//! The memory of the program: the page decides how much there may be.

use std::alloc::System;

use cap::Cap;
use dapple::machine::browser::memory;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes that are reserved for the stacks of threads, and for the gaps between allocations.
const SPARE: f64 = 96e6;

/// Sets the amount of memory to `bytes`. Before a document grows, it is checked whether enough memory is free.
pub fn limit(bytes: f64) {
    // An error means that more than this is already in use.
    let _ = ALLOCATOR.set_limit((bytes - SPARE).max(0.0) as usize);
    memory::set_free(|| ALLOCATOR.remaining() as f64);
}
