//! The engine of dapple: from the bytes of a document to a grown texture.
//!
//! ```text
//!  hand ──▶ sketch ──┐
//!                    ├─▶ Marks ─▶ Attributes ─▶ learn ─▶ Parameters ─▶ rd | points ─▶ Field ─▶ colour ─▶ Image ─▶ export
//!  photo ─▶ measure ─┘   └─────────────────── synth holds this thread, layer by layer ────────────────────┘
//! ```
//!
//! The modules below stand in the order in which data meets them. The map at the head of the package `dapple` says which of
//! them may know which.
//!
//! It asks for nothing: reading takes bytes and a name, writing goes to any writer, and the caller tells how much memory may be
//! used, what time it is, and where work is done that cannot be interrupted.

// Ground.
pub mod grid;
pub mod surface;
// (surface: triangles to grow on, a domain as the grid is)
pub mod marks;
// (marks before attributes: attributes are numbers about marks)
pub mod attributes;

// Steps.
pub mod colour;
pub mod export;
pub mod learn;
pub mod measure;
pub mod points;
pub mod rd;
pub mod sketch;

// Thread.
pub mod photo;
// (photo: it reads pictures with measure and colour, and makes what a document holds)
pub mod document;
pub mod synth;
