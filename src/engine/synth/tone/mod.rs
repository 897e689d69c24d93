//! Layers that a picture or Turing's growth drives: spots and stripes whose size, distance or direction follow a tone.

pub mod advice;
mod describe;
pub mod grow;
pub mod grown;
pub mod growth;
mod kind;
pub mod plan;
pub mod report;

pub use grown::GrownTone;
pub use kind::Driven;
