//! What was asked of spots and stripes, and what grew.

mod drawn;
pub mod pinned;
mod region;

pub use drawn::{drawn_marks, expected_note, left_out};
pub use region::{merged_spots, regions};
