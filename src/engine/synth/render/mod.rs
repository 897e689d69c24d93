//! Grown layers → pictures, outlines and films.

pub mod clip;
pub mod film;
pub mod lit;
pub mod morph;
pub mod outlining;
pub mod painting;
mod palette;
