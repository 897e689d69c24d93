//! The machine that the program runs on: its memory, clocks and threads.
//!
//! The engine does not ask the system for any of these; the caller passes them to it. A browser has neither files nor
//! threads of this kind: there the module `browser` replaces them, with the same names.

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

/// The properties of this machine that the engine needs: the memory that is free now, and a clock.
#[must_use]
pub fn this_machine() -> Machine {
    Machine { memory: Some(free_memory()), clock: clock::elapsed }
}
