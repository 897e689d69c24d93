//! The machine that the program runs on: its memory, clocks and threads.
//!
//! The engine asks for none of these; it is told.

pub mod aside;
pub mod clock;
pub mod memory;
pub mod threads;

pub use memory::free_memory;

use crate::synth::Machine;

/// What the engine is told of this machine: the memory that is free now, and a clock.
#[must_use]
pub fn this_machine() -> Machine {
    Machine { memory: Some(free_memory()), clock: clock::elapsed }
}
