//! A browser: the page opens and takes files, and asks for frames.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::io;
use std::path::{Path, PathBuf};

use egui::{ColorImage, Context, Ui};
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::{ExtendedColorType, ImageEncoder};

use crate::app::asset::{Asset, decoded};
use crate::app::purpose::Purpose;
use crate::editor::task::{StartError, Task, Tasks, Worker};
use crate::machine::browser::page::{self, Request};
use crate::machine::fs::{File, KEPT};
use crate::machine::sync::{Mutex, PoisonError};
use crate::machine::threads;

/// Whether files lie in folders that the user knows.
pub const HAS_FOLDERS: bool = false;
/// Whether the window can be closed by a menu.
pub const CAN_QUIT: bool = false;

/// No bytes: a browser loads the file when it is needed.
macro_rules! asset_bytes {
    ($($part:literal),*) => {
        &[]
    };
}
pub(crate) use asset_bytes;

/// The bytes of a file of the program. Blocks until the file is loaded, so it must not run on the page's thread.
///
/// # Errors
/// Where the file cannot be loaded.
pub fn asset_read(asset: Asset) -> io::Result<Cow<'static, [u8]>> {
    page::load(&format!("{}/{}.{}", asset.folder, asset.name, asset.ending)).map(Cow::Owned)
}

/// The image of a picture of the program; `None` while it is being loaded.
#[must_use]
pub fn asset_image(asset: Asset) -> Option<ColorImage> {
    /// The images that were requested; with the image once it has arrived.
    static ASKED: Mutex<BTreeMap<[&str; 2], Option<ColorImage>>> = Mutex::new(BTreeMap::new());
    let name = [asset.folder, asset.name];
    let asked = || ASKED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = asked().get(&name) {
        return known.clone();
    }
    asked().insert(name, None);
    // The image of a picture that does not arrive stays empty.
    let load = move || {
        if let Ok(image) = asset_read(asset).and_then(|png| decoded(&png)) {
            asked().insert(name, Some(image));
            page::wake();
        }
    };
    let _ = threads::start("loading a picture", load);
    None
}

/// A function that requests a frame from any thread.
pub fn waker(_: &Context) -> impl Fn() + Send + Sync + 'static {
    page::wake
}

/// The folder of the settings and recovery files; the page stores it in the browser.
#[must_use]
pub fn settings_folder() -> Option<PathBuf> {
    Some(PathBuf::from(KEPT))
}

/// The folder in which files are written before the page offers them to the user.
#[must_use]
pub fn folder_of(_: Option<&Path>) -> PathBuf {
    PathBuf::from(page::WRITTEN)
}

/// Does nothing: a browser has no file manager.
pub fn show_folder(_: &Path) {}

/// Lets the page save what was written: a file as it is, a folder as one archive.
pub fn hand_over(path: &Path) {
    page::save(path);
}

/// A picture for the clipboard: the file of a PNG.
pub type Copied = PathBuf;

/// Makes a picture ready for the clipboard. This takes long, so it must not run on the page's thread.
///
/// # Errors
/// Where the picture does not fit into memory.
pub fn for_clipboard(picture: ColorImage) -> io::Result<Copied> {
    let file = Path::new(page::WRITTEN).join("copied.png");
    let px: Vec<u8> = picture.pixels.iter().flat_map(|px| px.to_srgba_unmultiplied()).collect();
    let [width, height] = picture.size.map(|side| side as u32);
    let png = PngEncoder::new_with_quality(File::create(&file)?, CompressionType::Fast, FilterType::Adaptive);
    png.write_image(&px, width, height, ExtendedColorType::Rgba8).map_err(io::Error::other)?;
    Ok(file)
}

/// Asks the page to put a picture on the clipboard.
pub fn copy(_: &Context, picture: Copied) {
    page::ask(Request::Copy(picture));
}

/// What could not be handed over to the page since the last frame, as messages.
#[must_use]
pub fn not_handed_over() -> Vec<String> {
    page::take_failed()
}

/// The name of a file or folder in messages, without its folder, which means nothing to the user of a browser.
#[must_use]
pub fn shown(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The files that were dropped or pasted since the last frame.
#[must_use]
pub fn dropped(_: &Ui) -> Vec<PathBuf> {
    page::take_dropped()
}

/// Whether the system has a dialog to write (`true`) or to read a file: a page has one to read only.
#[must_use]
pub fn has_dialog_to(write: bool) -> bool {
    !write
}

/// Starts the page's dialog.
///
/// # Errors
/// Where no thread can be started.
pub fn system_dialog(
    purpose: Purpose,
    _: &Path,
    _: &str,
    tasks: &Tasks,
) -> Result<Task<Option<PathBuf>>, StartError> {
    tasks.start("the file dialog", move |worker: &Worker<_>| {
        worker.send(page::choose(purpose.endings(), &|| !worker.is_cancelled()));
    })
}
