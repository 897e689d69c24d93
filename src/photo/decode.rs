//! A file → an upright picture.

use std::io::{BufRead, Seek};

use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, ImageError, ImageReader};

use super::{Raster, density};

/// A decoded file.
#[derive(Debug)]
pub struct Decoded {
    /// The picture, turned as its EXIF orientation says.
    pub image: DynamicImage,
    /// px an inch, where the file says it.
    pub dpi: Option<f64>,
}

/// Width and height of the picture in a file as they are stored, px, from its head alone.
///
/// # Errors
/// It is no picture that can be read (PNG, JPEG, WebP, TIFF, BMP, GIF).
pub fn size(stream: &mut (impl BufRead + Seek)) -> Result<[usize; 2], ImageError> {
    stream.rewind()?;
    let (width, height) = ImageReader::new(stream).with_guessed_format()?.into_dimensions()?;
    Ok([width as usize, height as usize])
}

/// Decodes a file of any of these formats; of several pictures the first.
///
/// # Errors
/// As [`size`], and damaged px.
pub fn decode(stream: &mut (impl BufRead + Seek)) -> Result<Decoded, ImageError> {
    stream.rewind()?;
    let mut decoder = ImageReader::new(&mut *stream).with_guessed_format()?.into_decoder()?;
    // Damaged EXIF data are none: what is wanted is the picture.
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let exif = decoder.exif_metadata().ok().flatten();
    let mut image = DynamicImage::from_decoder(decoder)?;
    image.apply_orientation(orientation);
    Ok(Decoded { image, dpi: density::dpi(stream, exif.as_deref()) })
}

impl From<Decoded> for Raster {
    fn from(decoded: Decoded) -> Self {
        let rgb = decoded.image.into_rgb8();
        let size = [rgb.width() as usize, rgb.height() as usize];
        Self { size, rgb: rgb.into_raw(), dpi: decoded.dpi }
    }
}
