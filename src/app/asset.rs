//! A picture that belongs to the program.

use std::io;

use egui::ColorImage;

/// A picture of the program: the PNG file `assets/FOLDER/NAME.png`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asset {
    /// Its folder in `assets`.
    pub folder: &'static str,
    /// Its name, without the ending.
    pub name: &'static str,
    /// The bytes of the PNG; none in a browser, which loads them.
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
