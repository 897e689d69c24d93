//! Makes a sketch from a photograph: the marks that were found are shown over the photograph, a few choices can be
//! corrected, then the sketch is opened.
//!
//! ```text
//!  choices ─▶ job, on a thread: opened ─▶ segmented ─▶ found, and its picture (overlay)
//!     ▲                            (each is kept as long as the choices leave it as it is)
//!     └─────── dialog: words, sliders, corners (view) ◀──────────────────────┘
//! ```

mod choices;
mod dialog;
mod job;
mod overlay;
mod refusals;
mod view;
mod words;

pub use dialog::{Importing, PhotoAction};
pub use job::Found;
