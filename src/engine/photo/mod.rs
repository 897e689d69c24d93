//! Photograph → marks, regions and colours of a sketch.
//!
//! ```text
//!  file ─▶ raster (rotated upright, cropped, flattened) ─▶ lab ─▶ channel ─▶ scale ─▶ ink_shares ─▶ edge ─▶ watershed
//!                                                                                                           │
//!            sketch (layers, regions, marks, stops) ◀─ reading: spots, stripes, or neither and why ◀────────┘
//! ```
//!
//! Uneven light, noise, blur and compression are expected: a place counts as mark or ground by comparison with its surroundings,
//! never by a tone of the whole picture. Everything is measured on a working copy that may have fewer px than the photograph;
//! results are px of the photograph.
//!
//! Results do not depend on the number of threads: rows are computed independently, and sums are taken in their order.

mod channel;
mod coarse;
mod corners;
mod decode;
mod density;
mod edge;
mod edge_blur;
mod foreign;
mod ground;
mod hair;
mod heights;
mod ink_shares;
mod lab;
mod layers;
mod light;
mod lines;
mod mark_colours;
mod opaque;
mod parts;
mod raster;
mod reading;
mod regions;
mod representatives;
mod rosettes;
mod scale;
mod segmentation;
mod sketch;
mod smallest;
mod stops;
pub mod tone;
mod verdict;
mod watershed;

pub use corners::Corners;
pub use decode::{Decoded, PictureError, decode, decode_stored, size};
pub use foreign::{Foreign, START, foreign};
pub use ground::{GroundColours, ground_colours};
pub use hair::{Hair, hair};
pub use heights::heights;
pub use parts::{Part, parts};
pub use raster::{Crop, Raster};
pub use reading::{LEVELS, Limits, Reading, read, read_segmented};
pub use rosettes::FoundRosettes;
pub use segmentation::{Segmentation, known, segment};
pub use sketch::{DENSE, FoundLayer, Sketch, Wanted, sketch};
pub use smallest::remove_below;
pub use stops::Tone;
pub use verdict::{CONTRAST, Neither};
