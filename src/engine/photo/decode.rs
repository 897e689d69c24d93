//! A file → an upright picture.

use std::io::{self, BufRead, Seek, SeekFrom};

use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, ImageError, ImageReader};

use super::{Raster, density};

/// So many bytes are unpacked from any file: the `image` crate's own limit.
const SURE: u64 = 512 << 20;
/// Of a larger picture, at most so many bytes are unpacked from one: Deflate reaches 1,032, LZW with codes of 12 bits 2,730. A damaged
/// head would otherwise ask for gigabytes.
const UNPACKED: u64 = 4_096;

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
/// As [`size`], damaged px, and a size that is absurd for so short a file.
pub fn decode(stream: &mut (impl BufRead + Seek)) -> Result<Decoded, ImageError> {
    let length = stream.seek(SeekFrom::End(0))?;
    stream.rewind()?;
    let mut decoder = ImageReader::new(&mut *stream).with_guessed_format()?.into_decoder()?;
    if decoder.total_bytes() > SURE.max(UNPACKED.saturating_mul(length)) {
        let (width, height) = decoder.dimensions();
        let found = format!("{width}×{height} px are too many for a file of {length} bytes: it is damaged");
        return Err(ImageError::IoError(io::Error::new(io::ErrorKind::InvalidData, found)));
    }
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    /// Found by fuzzing: the head of a damaged file can say any size.
    #[test]
    fn a_few_bytes_are_not_unpacked_to_gigabytes() {
        let mut file = Vec::new();
        let picture = image::RgbImage::new(4, 4);
        picture.write_to(&mut Cursor::new(&mut file), image::ImageFormat::Bmp).expect("a bitmap");
        assert!(decode(&mut Cursor::new(&file)).is_ok());
        // Width and height stand at bytes 18 and 22.
        for at in [18, 22] {
            file[at..at + 4].copy_from_slice(&30_000u32.to_le_bytes());
        }
        let error = decode(&mut Cursor::new(&file)).expect_err("2.7 GB");
        assert_eq!(
            error.to_string(),
            format!("30000×30000 px are too many for a file of {} bytes: it is damaged", file.len())
        );
    }
}
