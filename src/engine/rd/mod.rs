//! Parameters → field: reaction and diffusion.

mod bells;
pub mod benchmark;
mod by_ratio;
mod chemicals;
mod coefficients;
mod compensate;
mod decay_noise;
mod definition;
mod diffusion;
mod explicit;
mod fineness;
mod gabor;
mod gabor_wave;
mod growth;
mod growth_map;
mod initial_conditions;
mod kinetics;
mod line_noise;
mod local_warp;
mod nuclei;
mod nucleus;
mod on_surface;
mod oriented_waves;
pub mod pairs;
mod parameter_field;
mod plane;
mod problem;
mod prolongation;
mod restart;
mod runs;
mod seeding;
pub mod selling;
mod shepard;
mod simd_step;
mod solver;
mod sparse;
mod start;
mod stencil_lanes;
mod stencil_sets;
mod stepper;
mod super_step;
mod sweep;
mod systems;
mod vector;
mod wavefront;

#[cfg(test)]
mod domain_tests;

pub use definition::{
    Begin, Bounds, Convergence, Cost, CurveLaw, DecayNoise, Definition, ErrorBounds, Laws, LinesAlongCurves,
    MarkCells, MergingDistance, OwnVariation, Resolution, Scatter, SpotLimits, SweepQuantity, System,
    TurnLimit, Variation,
};
pub use fineness::{Fineness, fineness};
pub use growth::{Growth, initial_marks};
pub use growth_map::GrowthMap;
pub use initial_conditions::{
    InitialConditions, NucleiBefore, from_places, from_wave_values, initial_waves, nuclei, nuclei_after,
    nuclei_among, with_obstacle_state,
};
pub use kinetics::{Kinetics, Spreading};
pub use line_noise::GuideLine;
pub use local_warp::LocalWarp;
pub use nuclei::{Hindrance, PinnedSpot, Places, ROUNDS, adjust_to_walls, placeable, relax_places};
pub use on_surface::{SurfaceGrowth, SurfacePair, SurfacePairField};
pub use oriented_waves::{GuideSegment, WaveStart, WaveValue, waves_from};
pub use parameter_field::{GuideCurves, ParameterField, Parameters};
pub use prolongation::prolongate;
pub use restart::restart;
pub use seeding::Seeding;
pub use shepard::{Kernel, interpolate, interpolate_parameters};
pub use solver::Solver;
pub use sparse::Operators;
pub use vector::Number;
pub use wavefront::{Instructions, Tiling};
