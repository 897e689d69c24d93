//! The engine of dapple: from the bytes of a document to a grown texture.
//!
//! ```text
//!  hand ──▶ sketch ──┐
//!                    ├─▶ Marks ─▶ Attributes ─▶ learn ─▶ Parameters ─▶ rd | points ─▶ Field ─▶ colour ─▶ Image ─▶ export
//!  photo ─▶ measure ─┘   └──────────────────── synth runs these steps for each layer ─────────────────────┘
//! ```
//!
//! The modules below are listed in the order in which data passes through them. The table in the documentation of the package
//! `dapple` lists the allowed dependencies between them.
//!
//! The engine does not access the operating system: readers take bytes and a name, writers take any stream, and the caller
//! provides the amount of free memory, the time, and a function that runs work that cannot be interrupted.

// Ground.
pub mod grid;
pub mod surface;
// (surface: triangles on which patterns grow, a domain like the grid)
pub mod marks;
// (marks before attributes: attributes are numbers about marks)
pub mod attributes;

// Steps.
pub mod colour;
pub mod export;
pub mod finish;
pub mod learn;
pub mod measure;
pub mod points;
pub mod rd;
pub mod sketch;

// Thread.
pub mod photo;
// (photo: reads pictures with measure and colour, and makes the parts of documents)
pub mod document;
pub mod synth;

// Beside it.
pub mod data_set;
