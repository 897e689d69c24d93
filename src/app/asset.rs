//! A picture that belongs to the program.

use std::io;

use egui::ColorImage;

/// A picture of the program, PNG, in the folder `assets`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Asset {
    /// The folder in that folder.
    pub folder: &'static str,
    /// Its name, without the ending.
    pub name: &'static str,
    /// What it holds; nothing where it is loaded.
    pub bytes: &'static [u8],
}

/// The image of a `png`.
///
/// # Errors
/// It is none.
pub fn decoded(png: &[u8]) -> io::Result<ColorImage> {
    let image = image::load_from_memory(png).map_err(io::Error::other)?.into_rgba8();
    let size = [image.width() as usize, image.height() as usize];
    Ok(ColorImage::from_rgba_unmultiplied(size, image.as_raw()))
}
