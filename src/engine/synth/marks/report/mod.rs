//! The report of spots and stripes: what was asked for, and what grew.

mod drawn;
pub mod pinned;
mod region;

pub use drawn::{drawn_marks, expected_note, left_out};
pub use region::{merged_spots, regions};
