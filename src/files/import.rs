//! Drawings, photographs and pictures in files.

use std::io::{self, Read};
use std::path::Path;

use super::input::{Input, input, is_pipe};
use crate::document::{ToneImage, limits};
use crate::machine::free_memory;
use crate::synth::import::measured_picture::{self, Framing, MeasureError, MeasuredPicture, OpenedPicture};
use crate::synth::import::photo::{self, ImportedPhoto, PhotoImportError, PhotoOptions};
use crate::synth::import::svg::{self, ImportError, Imported};
use crate::synth::import::tone;

/// Whether the file `path` is a drawing: by its ending, or by what it begins with.
///
/// # Errors
/// It cannot be read.
pub fn is_svg(path: &Path) -> io::Result<bool> {
    let is_drawing =
        |ending: &std::ffi::OsStr| ["svg", "svgz"].iter().any(|name| ending.eq_ignore_ascii_case(name));
    if path.extension().is_some_and(is_drawing) {
        return Ok(true);
    }
    Ok(svg::begins_a_drawing(&beginning(path, svg::START)?))
}

/// Reads the SVG `path` as a document with `dpi` px per inch (`None` = the number in the file), named like the file.
///
/// # Errors
/// [`ImportError`].
pub fn import_svg(path: &Path, dpi: Option<f64>) -> Result<Imported, ImportError> {
    let file = path.display().to_string();
    let bytes = beginning(path, limits::MAX_FILE)
        .map_err(|source| ImportError::Unreadable { file: file.clone(), source })?;
    let mut imported = Imported::read(&bytes, dpi, &file)?;
    if is_pipe(path) {
        imported.document.name.clear();
    }
    Ok(imported)
}

/// The first bytes of a file, at most `most`.
fn beginning(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    input(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// A picture file as a stream.
fn stream(path: &Path) -> Result<Input, MeasureError> {
    let unreadable =
        |error: io::Error| MeasureError::Unreadable { path: path.to_owned(), source: error.into() };
    input(path).map_err(unreadable)
}

/// Makes a document from the photograph `path`, named like the file.
///
/// # Errors
/// [`PhotoImportError`].
pub fn import_photo(path: &Path, options: &PhotoOptions) -> Result<ImportedPhoto, PhotoImportError> {
    let mut imported = photo::import_photo(stream(path)?, path, options, Some(free_memory()))?;
    if is_pipe(path) {
        imported.document.name.clear();
    }
    Ok(imported)
}

/// Measures the marks in the picture file `path`, in the part that `framing` names.
///
/// # Errors
/// It cannot be read as a picture, or has neither spots nor stripes.
pub fn measure_file(path: &Path, framing: &Framing) -> Result<MeasuredPicture, MeasureError> {
    measured_picture::measure_stream(stream(path)?, path, framing, Some(free_memory()))
}

/// Measures the patches in the picture file `path`, whose outlines may be of any shape, in the part that `framing` names.
///
/// # Errors
/// It cannot be read as a picture, has too little contrast, or no patch is whole.
pub fn measure_patches(path: &Path, framing: &Framing) -> Result<MeasuredPicture, MeasureError> {
    measured_picture::measure_patches(stream(path)?, path, framing, Some(free_memory()))
}

/// Decodes a picture file.
///
/// # Errors
/// It cannot be read as a picture, or is too large.
pub fn open_picture(path: &Path) -> Result<OpenedPicture, MeasureError> {
    measured_picture::open_stream(stream(path)?, path, Some(free_memory()))
}

/// Reads a picture (JPEG, PNG, WebP, TIFF, BMP, GIF), turned as its EXIF data say, as the image of a tone: gray, and at
/// most [`limits::TONE_SIDE`] px along each side.
///
/// # Errors
/// It cannot be read as a picture, or does not fit into memory.
pub fn read_tone(path: &Path) -> Result<ToneImage, MeasureError> {
    tone::read_tone(stream(path)?, path, Some(free_memory()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_picture_is_named() {
        let none =
            measure_file(Path::new("no such picture.png"), &Framing::default()).unwrap_err().to_string();
        assert!(none.starts_with("no such picture.png: cannot be read"), "{none}");
    }
}
