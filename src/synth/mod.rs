//! The thread: a document in, a grown texture out.

mod aim;
pub mod beneath;
pub mod drawn;
mod engine;
mod grow;
pub mod keep;
mod ladder;
mod lattice;
pub mod memory;
mod patch;
pub mod pattern;
mod pitches;
pub mod plan;
pub mod probe;
pub mod recipe;
mod refine;
pub mod report;
mod settle;
mod spread;
mod training;
mod watch;

pub use engine::Engine;
pub use grow::{GrowError, Grown, GrownLayer, Options, grow};
pub use patch::{Patch, Sample};
pub use refine::Measured;
pub use settle::settle;
pub use training::Training;
pub use watch::{Cancelled, Stage, Watch};
