//! Threads of pairs on a surface: weaves of two directions, and stripes with tips.
//!
//! ```text
//!  phases along the field of directions, or noise ─▶ lines that threads begin from ─▶ grow ─▶ measure ─▶ corrected: grow again
//! ```

mod growth;
mod measured;
mod shown;
mod start;

pub use growth::{GrownThreads, ThreadGrowth};

#[cfg(test)]
mod tests;
