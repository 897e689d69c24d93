//! A desktop: its own window, folders, dialogs of the system.

mod dialog;
mod placement;

pub use dialog::{has_dialog_to, system_dialog};

use std::borrow::Cow;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use directories::BaseDirs;
use egui::{Color32, ColorImage, Context, IconData, Ui};

use crate::app::assets::{self, Asset};
use crate::app::settings::Settings;
use crate::app::window::{Start, Window};
use crate::editor::task::Spawn;
use crate::machine::fs;

/// Whether files lie in folders that the user knows.
pub const HAS_FOLDERS: bool = true;
/// Whether the window can be closed by a menu.
pub const CAN_QUIT: bool = true;

/// Delay of the frame that shows what a thread has sent.
const SOON: Duration = Duration::from_millis(1);

/// What the file with this path in the folder `assets` holds.
macro_rules! asset_bytes {
    ($folder:literal, $name:literal) => {
        include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/assets/", $folder, "/", $name, ".png"))
    };
}
pub(crate) use asset_bytes;

/// What a picture of the program holds.
///
/// # Errors
/// None: it is in the program.
pub fn asset_read(asset: Asset) -> io::Result<Cow<'static, [u8]>> {
    Ok(asset.bytes.into())
}

/// The image of a picture of the program.
#[must_use]
pub fn asset_image(asset: Asset) -> Option<ColorImage> {
    // A test decodes them all.
    Some(assets::image(asset).unwrap_or_else(|_| ColorImage::filled([1, 1], Color32::TRANSPARENT)))
}

/// Asks for a frame; from any thread.
pub fn waker(ctx: &Context) -> impl Fn() + Send + Sync + 'static {
    let ctx = ctx.clone();
    // For a request without a delay egui shows two frames.
    move || ctx.request_repaint_after(SOON)
}

/// The folder of the user's settings and recovery files; `None` where the system has none.
#[must_use]
pub fn settings_folder() -> Option<PathBuf> {
    let base = BaseDirs::new()?;
    // On Windows the roaming folder: settings follow the user.
    Some(base.data_dir().join("dapple"))
}

/// The folder in which a dialog begins, where something lies or would be written `at`.
#[must_use]
pub fn folder_of(at: Option<&Path>) -> PathBuf {
    let folder = at.and_then(Path::parent).map(Path::to_owned);
    folder.or_else(|| std::env::current_dir().ok()).unwrap_or_else(|| PathBuf::from("."))
}

/// Opens the folder of `place` in the system's file manager. Where that fails, the notice still says where it is.
pub fn show_folder(place: &Path) {
    let folder = if fs::is_dir(place) { place } else { place.parent().unwrap_or(place) };
    let _ = open::that_detached(folder);
}

/// What was written lies where the user wants it.
pub fn hand_over(_: &Path) {}

/// How a file or folder is called in messages.
#[must_use]
pub fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// The files that were dropped since the last frame.
#[must_use]
pub fn dropped(ui: &Ui) -> Vec<PathBuf> {
    ui.input(|input| input.raw.dropped_files.iter().map(|file| file.path().to_owned()).collect())
}

/// Why the window could not be opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// There is no display.
    #[error("there is no display to open a window on; allowed without one: dapple grow FILE -o OUT.png")]
    NoDisplay,
    /// The window system or the graphics card refused: why.
    #[error("the window could not be opened: {0}; without one: dapple grow FILE -o OUT.png")]
    Refused(String),
}

/// Opens the window, with the document `file` if there is one, and returns when it is closed.
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
    let recovery = settings_folder().map(|folder| folder.join("recovery"));
    let start = Start { file, settings, recovery, native_dialogs: true, spawn: Spawn::default() };
    let create: eframe::AppCreator<'_> = Box::new(move |cc| {
        placement::bring_into_view(cc);
        Ok(Box::new(Window::new(&cc.egui_ctx, start)))
    });
    eframe::run_native("dapple", options, create)
        .map_err(|error| OpenError::Refused(reason(&error.to_string())))
}

/// The message of the window system without its source file and line.
fn reason(said: &str) -> String {
    let after = said.rsplit_once(".rs:").and_then(|(_, place)| place.split_once(": "));
    after.map_or(said, |(_, reason)| reason).to_owned()
}

/// The icon for the window manager. The picture is part of the program and can always be decoded.
fn icon() -> IconData {
    eframe::icon_data::from_png_bytes(include_bytes!("../../../assets/icon/dapple.png")).unwrap_or_default()
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
