//! What a picture drives, or a growth: spots and stripes whose size, distance or direction follow its tone.

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
