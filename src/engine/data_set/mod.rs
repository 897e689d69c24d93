//! Data sets: labelled textures of random sketches, by the thousand.
//!
//! ```text
//!  seed, index ─▶ dice ─▶ kind ─▶ sketch ─▶ grown ─▶ marks, tips, asked ─▶ item ─▶ files
//! ```
//!
//! An item is a function of the seed, its index and [`Settings`] alone: items can be made in any order, by any number of processes, on
//! any machine, with the same bytes.

mod asked;
mod dice;
mod files;
mod item;
mod kind;
mod marks;
mod skeleton;
mod sketch;
mod tips;

pub use asked::AskedFields;
pub use files::{FILES, manifest};
pub use item::{Item, ItemError, Settings, item};
pub use kind::Kind;
pub use marks::LabelledMark;
pub use sketch::sketch;
pub use tips::{Tip, TipKind};
