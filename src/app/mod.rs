//! The window: draw, and it grows. All of the window toolkit lives in this room.
//!
//! ```text
//!  pointer, keys ─▶ canvas ─▶ desk (document, selection, history) ─▶ growth (a thread) ─▶ texture
//!                     ▲                 ▲                                │
//!                     └── panels ── actions ◀── menus, keys, files       └─▶ exporting (a thread)
//! ```
//!
//! Panels and keys give [`Action`]s, [`Window`] carries them out. The desk knows nothing of the screen.

mod action;
mod alternatives;
mod canvas;
mod chooser;
mod cloud;
mod desk;
mod examples;
mod exporting;
mod files;
mod growth;
mod history;
mod icons;
mod layer_choices;
mod layering;
mod notice;
mod pages;
mod palettes;
mod panels;
mod perform;
mod reference;
mod result;
mod selection;
mod settings;
mod shape;
mod shortcuts;
mod texture;
mod theme;
mod trace;
mod underlay;
mod window;

pub use action::{Action, Page};
pub use alternatives::{Alternative, Alternatives, small};
pub use canvas::tool::Tool;
pub use cloud::{Cloud, Points};
pub use desk::Desk;
pub use growth::{Growth, Phase};
pub use notice::Notice;
pub use panels::Tab;
pub use result::{Outcome, Reach, RegionResult, Results, Verdict};
pub use selection::{Place, Selection};
pub use settings::Settings;
pub use window::{Start, Window};

use std::path::PathBuf;

use eframe::egui::{IconData, ViewportBuilder};

/// Why no window was opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// There is nothing to show it on.
    #[error("there is no display to open a window on; allowed without one: dapple grow FILE -o OUT.png")]
    NoDisplay,
    /// The display or the graphics card does not do it.
    #[error("the window could not be opened: {0}; without one: dapple grow FILE -o OUT.png")]
    Refused(String),
}

/// Opens the window, with a document if there is one, and stays until it is closed.
///
/// `DAPPLE_RENDERER=glow` takes OpenGL instead of the system's newest graphics; `DAPPLE_TRACE=FILE` writes down how
/// long each frame took.
///
/// # Errors
/// Where there is no display.
pub fn run(file: Option<PathBuf>) -> Result<(), OpenError> {
    if !has_display() {
        return Err(OpenError::NoDisplay);
    }
    let glow = std::env::var("DAPPLE_RENDERER").is_ok_and(|renderer| renderer == "glow");
    let options = eframe::NativeOptions {
        viewport: ViewportBuilder::default()
            .with_title("dapple")
            .with_app_id("dapple")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([760.0, 480.0])
            .with_drag_and_drop(true)
            .with_icon(IconData::default()),
        renderer: if glow { eframe::Renderer::Glow } else { eframe::Renderer::Wgpu },
        centered: true,
        ..Default::default()
    };
    let start = Start { file, settings: Settings::of_user(), native_dialogs: true };
    eframe::run_native("dapple", options, Box::new(move |cc| Ok(Box::new(Window::new(&cc.egui_ctx, start)))))
        .map_err(|error| OpenError::Refused(error.to_string()))
}

fn has_display() -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value: std::ffi::OsString| !value.is_empty());
    !cfg!(target_os = "linux") || ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].into_iter().any(set)
}
