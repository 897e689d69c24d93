//! The thread: a document in, a grown texture out.

pub mod drawn;
mod grow;
mod lattice;
pub mod memory;
pub mod pattern;
pub mod plan;
pub mod recipe;
mod refine;
pub mod report;
mod settle;
mod spread;
mod training;
mod watch;

pub use grow::{GrowError, Grown, GrownLayer, Options, grow};
pub use refine::Measured;
pub use settle::settle;
pub use training::Training;
pub use watch::{Cancelled, Stage, Watch};
