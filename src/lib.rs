//! dapple: a sketch of a pattern in, a grown texture out.
//!
//! ```text
//!  hand ──▶ sketch ──┐
//!                    ├─▶ Marks ─▶ Attributes ─▶ learn ─▶ Parameters ─▶ rd ─▶ Field ─▶ colour ─▶ Image ─▶ export
//!  image ─▶ measure ─┘   └─────────────── synth holds this thread, layer by layer ───────────────┘
//! ```
//!
//! The rooms below stand in the order in which data meets them. *Ground* is the words that everyone
//! uses; each knows only the ones above it. *Steps* know the ground and never each other. Only the
//! *thread*, [`synth`], knows the steps; the *doors* know everything and nothing knows them.
//! `tests/layering` holds these arrows. The only way back, from a grown field to parameters, goes
//! through a file: `data-gen` writes `training/`, [`learn`] reads it.
//!
//! ```
//! use dapple::document::Document, synth::{Options, grow};
//!
//! let text = r#"{"format": "dapple", "version": 1, "size": [96, 96], "layers": [{"strokes": [
//!     {"kind": "ellipse", "center": [30, 30], "radii": [8, 5], "angle": 30}]}]}"#;
//! let document = Document::parse(text, "three lines")?;
//! let grown = grow(&document, &Options::default())?;
//! let pattern = grown.layers[0].pattern().field(96, 96);
//! assert!(pattern.values.iter().any(|value| *value > 0.9));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Lengths are px of the canvas unless a line says cells; x runs right, y down; angles are degrees
//! from +x towards +y and axial (read mod 180).

// Ground: words.
pub mod grid;
pub mod marks;
// (marks before attributes: attributes are numbers about marks)
pub mod attributes;

// Steps: know the ground, never each other.
pub mod colour;
pub mod export;
pub mod learn;
pub mod measure;
pub mod rd;
pub mod sketch;

// Thread.
pub mod document;
pub mod synth;

// Beside the thread.
pub mod editor;

// Doors.
#[cfg(feature = "app")]
pub mod app;
#[cfg(feature = "cli")]
pub mod cli;
