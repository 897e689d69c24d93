//! The machine that the program runs on: its memory, clocks and threads.
//!
//! The engine asks for none of these; it is told. A browser has neither files nor threads of this kind: there `browser` stands
//! for them, with the same names.

pub mod aside;
pub mod clock;

#[cfg(not(target_arch = "wasm32"))]
pub mod fs;
#[cfg(not(target_arch = "wasm32"))]
pub mod memory;
#[cfg(not(target_arch = "wasm32"))]
pub mod sync;
#[cfg(not(target_arch = "wasm32"))]
pub mod temporary;
#[cfg(not(target_arch = "wasm32"))]
pub mod threads;

#[cfg(target_arch = "wasm32")]
pub mod browser;
#[cfg(target_arch = "wasm32")]
pub use browser::{fs, memory, sync, temporary, threads};

pub use memory::free_memory;
pub use threads::process;

use crate::synth::Machine;

/// What the engine is told of this machine: the memory that is free now, and a clock.
#[must_use]
pub fn this_machine() -> Machine {
    Machine { memory: Some(free_memory()), clock: clock::elapsed }
}
