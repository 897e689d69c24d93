//! Reads a picture as the tone of a layer.

use std::io::{BufRead, Seek};
use std::path::Path;

use crate::document::{Colours, Document, Tone, ToneImage, limits};
use crate::photo;
use crate::synth::import::measured_picture::MeasureError;
use crate::synth::memory;

/// Bytes per px of a decoded picture and its copy with opacity.
const PX: f64 = 8.0;
/// Colours of a tone on a layer without colours: paper and ink. The edge is at ½. The transition between the two is about one px
/// wide, so that the share of ink is the one that is asked for.
const PAPER_AND_INK: [(f64, [u8; 3]); 4] = [(0.0, PAPER), (0.46, PAPER), (0.54, INK), (1.0, INK)];
/// A warm white.
const PAPER: [u8; 3] = [0xfb, 0xf9, 0xf4];
/// Nearly black.
const INK: [u8; 3] = [0x16, 0x14, 0x13];

/// Reads a picture (JPEG, PNG, WebP, TIFF, BMP, GIF) as the image of a tone: gray, rotated by its EXIF data, of at most
/// [`limits::TONE_SIDE`] px a side. Messages call it `path`. At most `free` bytes of memory may be used.
///
/// # Errors
/// It cannot be read as a picture, or does not fit into memory.
pub fn read_tone(
    mut stream: impl BufRead + Seek,
    path: &Path,
    free: Option<f64>,
) -> Result<ToneImage, MeasureError> {
    let unreadable = |source| MeasureError::Unreadable { path: path.to_owned(), source };
    let size = photo::size(&mut stream).map_err(unreadable)?;
    if let Err(error) = memory::check_picture(size, PX, free) {
        let memory::TooLargePicture { size, needed, free } = error;
        return Err(MeasureError::TooLarge { path: path.to_owned(), size, needed, free });
    }
    let decoded = photo::decode(&mut stream).map_err(unreadable)?;
    let gray = photo::tone::gray(&decoded, limits::TONE_SIDE as usize);
    let without_px = || unreadable(std::io::Error::other("it has no px").into());
    ToneImage::new(gray.size, gray.values).ok_or_else(without_px)
}

/// Lets a picture drive a layer of a document: the one that a picture drives already, or else the lowest. That layer is painted as
/// ink on paper if it has no colours of its own.
pub fn drive(document: &mut Document, image: ToneImage) {
    let driven = document.layers.iter().position(|layer| layer.tone.is_some()).unwrap_or(0);
    let Some(layer) = document.layers.get_mut(driven) else { return };
    layer.tone = Some(match layer.tone.take() {
        Some(tone) => Tone { image, ..tone },
        None => Tone::new(image),
    });
    layer.colours.get_or_insert_with(|| Colours::new(PAPER_AND_INK));
}
