//! The thread: a document in, a grown texture out.

mod aim;
mod around;
pub mod beneath;
mod cascade;
pub mod course;
pub mod drawn;
mod engine;
mod grow;
pub mod inside;
pub mod keep;
mod ladder;
mod lattice;
pub mod memory;
pub mod outlining;
pub mod painting;
mod patch;
pub mod pattern;
pub mod pitches;
pub mod plan;
pub mod probe;
pub mod recipe;
mod refine;
pub mod report;
mod settle;
mod spread;
mod training;
mod watch;

pub use cascade::{grow, placed_over, planned, regrow, regrow_seen, unchanged};
pub use engine::Engine;
pub use grow::{GrowError, Grown, GrownLayer, Options};
pub use patch::{Patch, Sample};
pub use refine::Measured;
pub use settle::{settle, settle_seen};
pub use training::Training;
pub use watch::{Cancelled, Stage, Watch};
