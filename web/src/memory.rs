//! The memory of the program: the page chooses how much there may be.

use std::alloc::System;

use cap::Cap;
use dapple::machine::browser::memory;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, usize::MAX);

/// Bytes that are left to the stacks of threads, and to what is lost between pieces of memory.
const SPARE: f64 = 96e6;

/// Says that there are `bytes` of memory: growing asks before it begins whether enough of them is free.
pub fn limit(bytes: f64) {
    // An error says that more is used already.
    let _ = ALLOCATOR.set_limit((bytes - SPARE).max(0.0) as usize);
    memory::set_free(|| ALLOCATOR.remaining() as f64);
}
