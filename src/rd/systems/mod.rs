//! The reaction-diffusion systems, one file each.

pub mod meinhardt_lines;
pub mod meinhardt_spots;
pub mod meinhardt_stripes;
pub mod turing_spots;
