//! Fields of points: values or labels of scattered points, interpolated.

pub mod advice;
mod describe;
pub mod grow;
pub mod grown;
mod kind;
pub mod plan;
pub mod report;

pub use grown::GrownPoints;
pub use kind::Points;
