//! A gray picture → what it asks of a pattern at each place: how much ink, in which direction, how fine.
//!
//! ```text
//!  file ─▶ gray (8 bits, at most so many px a side) ─▶ the part that covers the canvas ─▶ ink (equalised)
//!                                                                                     └─▶ structure tensor ─▶ direction, detail
//! ```

mod gray;
mod ink;
mod sampling;
mod tensor;

pub use gray::{Gray, gray};
pub use ink::ink;
pub use sampling::{Frame, sampled};
pub use tensor::{Constant, Tensors, directions_of, edges_of, structure};
