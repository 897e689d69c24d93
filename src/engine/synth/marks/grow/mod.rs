//! The growth of spots and stripes from their plan.

mod blank;
pub mod convergence;
mod correction;
pub mod corrections;
pub mod engine;
mod grid_level;
pub mod grid_levels;
mod grown;
mod half_grown;
mod layer_growth;
mod level_steps;
mod levelled;
mod local_separation;
pub mod marks_layer;
pub mod measured;
mod mending;
mod merged_spots;
pub mod obstacles;
mod own_levels;
pub mod passing;
pub mod pattern;
mod pinned_correction;
pub mod position_control;
pub mod probe;
pub mod probe_patch;
pub mod ragged;
pub mod ragged_edges;
mod spot_control;
mod stroke_control;

pub use corrections::Corrections;
pub use grown::GrownMarks;
pub use layer_growth::MarksGrowth;
pub use marks_layer::MarksLayer;
pub use pinned_correction::matched;

/// Cell updates between two moments at which a growth can be shown or cancelled: some milliseconds.
pub const UPDATES: u64 = 4_000_000;
