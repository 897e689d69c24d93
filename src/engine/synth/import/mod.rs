//! Imports drawings, paintings and photographs: as documents, as measured marks, or as tones.
//!
//! Everything here reads bytes or a stream; names and paths are for messages.

pub mod measured_picture;
pub mod photo;
pub mod svg;
pub mod tone;
