//! What others drew, painted and photographed → documents, measured marks, tones.
//!
//! Everything here reads bytes or a stream; names and paths are for messages.

pub mod measured_picture;
pub mod photo;
pub mod svg;
pub mod tone;
