//! Plans → grown layers.

pub mod cascade;
pub mod convergence;
mod correction;
pub mod engine;
pub mod grow_pairs;
mod grow_patches;
pub mod layer;
pub mod layer_pattern;
mod level;
mod merged_spots;
pub mod multigrid_levels;
pub mod obstacles;
mod own_levels;
pub mod pairs;
pub mod passing;
pub mod patch;
pub mod patches;
pub mod pattern;
pub mod pinned_correction;
pub mod position_control;
pub mod probe;
pub mod refine;
pub mod settle;
pub mod snapshot;
mod spot_control;
mod stripes_of_threads;
mod stroke_control;
