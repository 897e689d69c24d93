//! Documents → grown textures: planned, grown, painted and reported layer by layer.
//!
//! ```text
//!  kind                 what every kind of layer can do
//!  marks pairs areas lines points tone     the kinds: each is planned, grows and is reported in a folder of its own
//!  layer                the list of the kinds: nothing else tells them apart
//!  growth               the cascade of the layers of a document, as a value that is advanced
//!  estimate, render, layer_report          what is made of plans and of grown layers
//! ```

// The common parts of all kinds of layers.
pub mod drawn;
pub mod error;
pub mod kind;
pub mod memory;
mod options;
pub mod passes;
pub mod pattern;
pub mod profile;
pub mod report;
pub mod shaped;
pub mod thinned;
pub mod time;
mod training;
mod watch;

// The kinds.
pub mod areas;
#[cfg(test)]
mod flat;
pub mod lines;
pub mod marks;
pub mod pairs;
pub mod points;
pub mod tone;

// Documents.
pub mod body;
pub mod check;
pub mod edge_search;
pub mod estimate;
pub mod growth;
pub mod layer;
pub mod layer_report;
pub mod one_value;
pub mod pair_patch;
pub mod render;
mod short_way;
pub mod warped;

// Besides growing: laws without a canvas, and documents made from pictures.
pub mod closed_form;
pub mod import;
pub mod measured_weave;

pub use areas::GrownAreas;
pub use error::{GrowError, LayerError};
pub use growth::{Grown, Growth, Progress, Snapshot, unchanged};
pub use layer::{GrownLayer, LayerKind, LayerPlan};
pub use marks::GrownMarks;
pub use marks::grow::UPDATES;
pub use marks::grow::engine::Engine;
pub use marks::grow::measured::Measured;
pub use marks::grow::probe_patch::{ProbePatch, Sample};
pub use marks::plan::looked_up::LookedUp;
pub use options::{Clock, Machine, Options, Settings};
pub use pair_patch::{Drawn, PairPatch, PairReason, side_by_side};
pub use pairs::GrownPairs;
pub use tone::GrownTone;
pub use training::Training;
pub use watch::{Cancelled, Stage, Watch};
