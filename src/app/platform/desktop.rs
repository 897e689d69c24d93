//! A desktop: the window is its own, and folders and dialogs are those of the system.

mod dialog;

pub use dialog::{has_dialog_to, system_dialog};

use std::borrow::Cow;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use directories::BaseDirs;
use egui::{Color32, ColorImage, Context, Ui};

use crate::app::asset::{Asset, decoded};
use crate::machine::fs;

/// Whether files lie in folders that the user knows.
pub const HAS_FOLDERS: bool = true;
/// Whether the window can be closed by a menu.
pub const CAN_QUIT: bool = true;

/// Delay of the frame that shows what a thread has sent.
const SOON: Duration = Duration::from_millis(1);

/// The bytes of the file with this path, which is given in parts.
macro_rules! asset_bytes {
    ($($part:literal),*) => {
        include_bytes!(concat!(env!("CARGO_MANIFEST_DIR"), "/", $($part),*))
    };
}
pub(crate) use asset_bytes;

/// The bytes of a file of the program.
///
/// # Errors
///
/// None: the bytes are part of the program.
pub fn asset_read(asset: Asset) -> io::Result<Cow<'static, [u8]>> {
    Ok(asset.bytes.into())
}

/// The image of a picture of the program.
#[must_use]
pub fn asset_image(asset: Asset) -> Option<ColorImage> {
    // Decoding cannot fail: a test decodes all of them.
    Some(
        asset_read(asset)
            .and_then(|png| decoded(&png))
            .unwrap_or_else(|_| ColorImage::filled([1, 1], Color32::TRANSPARENT)),
    )
}

/// A function that requests a frame from any thread.
pub fn waker(ctx: &Context) -> impl Fn() + Send + Sync + 'static {
    let ctx = ctx.clone();
    // egui shows two frames for a request without a delay.
    move || ctx.request_repaint_after(SOON)
}

/// The folder of the user's settings and recovery files; `None` where the system has none.
#[must_use]
pub fn settings_folder() -> Option<PathBuf> {
    let base = BaseDirs::new()?;
    // On Windows this is the roaming folder, so that the settings follow the user to other machines.
    Some(base.data_dir().join("dapple"))
}

/// The folder in which a dialog begins, where a file lies or would be written `at`.
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

/// Does nothing: the file lies where the user wants it.
pub fn hand_over(_: &Path) {}

/// Nothing: on a desktop files are written directly.
#[must_use]
pub fn not_handed_over() -> Vec<String> {
    Vec::new()
}

/// A picture for the clipboard.
pub type Copied = ColorImage;

/// Makes a picture ready for the clipboard, on any thread.
///
/// # Errors
/// None.
pub fn for_clipboard(picture: ColorImage) -> io::Result<Copied> {
    Ok(picture)
}

/// Puts a picture into the clipboard.
pub fn copy(ctx: &Context, picture: Copied) {
    ctx.copy_image(picture);
}

/// The name of a file or folder in messages.
#[must_use]
pub fn shown(path: &Path) -> String {
    path.display().to_string()
}

/// The files that were dropped since the last frame.
#[must_use]
pub fn dropped(ui: &Ui) -> Vec<PathBuf> {
    ui.input(|input| input.raw.dropped_files.iter().map(|file| file.path().to_owned()).collect())
}
