//! Opening the window on a desktop.

mod placement;

use std::path::PathBuf;

use egui::IconData;

use super::platform;
use super::settings::Settings;
use super::window::{Start, Window};
use crate::files::as_link;

/// Why the window could not be opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// There is no display.
    #[error(
        "there is no display on which a window could open; without a display, use: dapple grow FILE -o OUT.png"
    )]
    NoDisplay,
    /// The window system or the graphics card refused: why.
    #[error("the window could not be opened: {0}; without a window, use: dapple grow FILE -o OUT.png")]
    Refused(String),
}

/// Opens the window, with the document in `file` or in the link in its place if there is one, and returns when it is closed.
///
/// `DAPPLE_TRACE=FILE` writes the time of each frame to a file.
///
/// # Errors
/// Where there is no display.
pub fn run(file: Option<PathBuf>) -> Result<(), OpenError> {
    if !has_display() {
        return Err(OpenError::NoDisplay);
    }
    let settings = Settings::for_user();
    let options = eframe::NativeOptions {
        viewport: placement::placed(&settings.layout)
            .with_title("dapple")
            .with_app_id("dapple")
            .with_min_inner_size([760.0, 480.0])
            .with_drag_and_drop(true)
            .with_icon(icon()),
        centered: settings.layout.position.is_none(),
        ..Default::default()
    };
    let recovery = platform::settings_folder().map(|folder| folder.join("recovery"));
    let link = file.as_deref().and_then(as_link).map(str::to_owned);
    let file = file.filter(|_| link.is_none());
    let start = Start { file, link, settings, recovery, native_dialogs: true, ..Start::default() };
    let create: eframe::AppCreator<'_> = Box::new(move |cc| {
        placement::bring_into_view(cc);
        Ok(Box::new(Window::new(&cc.egui_ctx, start)))
    });
    eframe::run_native("dapple", options, create)
        .map_err(|error| OpenError::Refused(reason(&error.to_string())))
}

/// The message of the window system, without the name and line of its source file.
fn reason(said: &str) -> String {
    let after = said.rsplit_once(".rs:").and_then(|(_, place)| place.split_once(": "));
    after.map_or(said, |(_, reason)| reason).to_owned()
}

/// The icon for the window manager. The picture is part of the program and can always be decoded.
fn icon() -> IconData {
    eframe::icon_data::from_png_bytes(include_bytes!("../../assets/icon/dapple.png")).unwrap_or_default()
}

fn has_display() -> bool {
    let set = |name| std::env::var_os(name).is_some_and(|value: std::ffi::OsString| !value.is_empty());
    !cfg!(target_os = "linux") || ["DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET"].into_iter().any(set)
}

#[cfg(test)]
mod tests {
    use super::reason;

    #[test]
    fn messages_of_the_window_system_are_shown_without_their_source() {
        let said = "winit EventLoopError: os error at /home/a/winit/linux/mod.rs:788: Failed to open connection to X server";
        assert_eq!(reason(said), "Failed to open connection to X server");
        assert_eq!(reason("no OpenGL: 3.2 is needed"), "no OpenGL: 3.2 is needed");
    }
}
