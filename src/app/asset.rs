//! A file that belongs to the program: a picture, or the document of an example.

use std::io;

use egui::ColorImage;

/// A file of the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asset {
    /// Its folder beside the page of a browser.
    pub folder: &'static str,
    /// Its name, without the ending.
    pub name: &'static str,
    /// The ending of its name.
    pub ending: &'static str,
    /// The bytes of the file; none in a browser, which loads the file when it is needed.
    pub bytes: &'static [u8],
}

/// The image in the bytes of a PNG.
///
/// # Errors
/// They are no picture.
pub fn decoded(png: &[u8]) -> io::Result<ColorImage> {
    let image = image::load_from_memory(png).map_err(io::Error::other)?.into_rgba8();
    let size = [image.width() as usize, image.height() as usize];
    Ok(ColorImage::from_rgba_unmultiplied(size, image.as_raw()))
}
