//! The window, in which the texture grows while the sketch is drawn. Only this room knows the window toolkit.
//!
//! ```text
//!  pointer, keys ─▶ canvas ─▶ session (document, selection, history) ─▶ growth (a thread) ─▶ texture
//!                     ▲                 ▲                                │
//!                     └── panels ── actions ◀── menus, keys, files       └─▶ exporting (a thread)
//! ```
//!
//! Panels and keys give [`Action`]s, [`Window`] carries them out. `editor` knows nothing of the screen.

mod action;
mod alternatives;
mod asset;
mod assets;
mod canvas;
mod checkerboard;
mod chooser;
mod cloud;
mod examples;
mod exporting;
mod fields;
mod goals;
pub(crate) mod growth;
mod icons;
mod importing;
mod notice;
#[cfg(not(target_arch = "wasm32"))]
mod open;
mod pages;
mod panels;
mod platform;
mod preferences;
mod presentation;
mod purpose;
mod recovery;
mod result;
mod settings;
mod shortcuts;
mod small_growth;
mod small_screen;
mod small_sketch;
mod texture;
mod theme;
mod trace;
mod underlay;
mod units;
mod window;

pub use crate::editor::backdrop::Placement;
pub use crate::editor::goal::Goal;
pub use crate::editor::selection::{Place, Selection};
pub use crate::editor::session::Session;
pub use crate::editor::task::Spawn;
pub use crate::editor::units::{Ruler, Units};
pub use crate::editor::wheel::Wheel;
pub use action::{Action, Page, Tab};
pub use alternatives::{Alternative, Alternatives};
pub use canvas::tool::Tool;
pub use canvas::wanted::Glyph;
pub use cloud::{Axis, Cloud, Points};
pub use exporting::{Choices, ExportKind, FinishedPreview, PictureContent, PreviewImages, Size};
pub use goals::{Goals, ShownGoal};
pub use growth::{Growth, GrowthState};
pub use importing::{Found, Importing};
pub use notice::Notice;
#[cfg(not(target_arch = "wasm32"))]
pub use open::{OpenError, run};
pub use pages::New;
pub use presentation::Presentation;
pub use result::{Outcome, Reach, RegionResult, Results, Verdict};
pub use settings::{Layout, Settings};
pub use small_growth::small;
pub use window::{Start, Window};
