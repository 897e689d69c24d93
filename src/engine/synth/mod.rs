//! Documents → grown textures: planned, grown, painted and reported layer by layer.

mod cpu_time;
pub mod estimate;
pub mod grow;
pub mod import;
pub mod map_import;
pub mod measured_picture;
pub mod measured_weave;
pub mod memory;
mod options;
pub mod phases;
pub mod photo_import;
pub mod plan;
pub mod render;
pub mod report;
mod short_way;
pub mod tone_import;
mod training;
mod watch;

pub use grow::areas::GrownAreas;
pub use grow::cascade::{grow, grow_seen, regrow, regrow_seen, unchanged};
pub use grow::engine::Engine;
pub use grow::layer::{GrowError, Grown, GrownLayer, GrownMarks};
pub use grow::pair_patch::{Drawn, PairPatch, PairReason, side_by_side};
pub use grow::pairs::GrownPairs;
pub use grow::patch::{Patch, Sample};
pub use grow::refine::Measured;
pub use grow::settle::{settle, settle_seen};
pub use grow::snapshot::Snapshot;
pub use grow::tone::GrownTone;
pub use options::{Options, Settings};
pub use plan::looked_up::LookedUp;
pub use training::Training;
pub use watch::{Cancelled, Stage, Watch};
