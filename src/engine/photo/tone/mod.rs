//! The pattern that a gray picture asks for at each place: amount of ink, direction and fineness.
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
