//! Decodes a file to an upright picture.

mod jpeg;
mod stretch;
mod tiff;

use std::io::{self, BufRead, Seek, SeekFrom};

use ::tiff::TiffError;
use image::error::ImageFormatHint;
use image::metadata::Orientation;
use image::{DynamicImage, ImageDecoder, ImageError, ImageFormat, ImageReader};

use super::density;
use super::foreign::{Foreign, START, foreign};

/// Size up to which any file is unpacked, bytes: the `image` crate's own limit.
const SURE: u64 = 512 << 20;
/// Largest ratio of unpacked to packed bytes of a larger picture: Deflate reaches 1,032, LZW with codes of 12 bits 2,730. A damaged
/// header could otherwise ask for gigabytes.
const UNPACKED: u64 = 4_096;

/// The reason why a file is not read as a picture.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The file is of another kind.
    #[error("{0}")]
    Foreign(Foreign),
    /// Its end is missing.
    #[error(
        "it is damaged or cut short: its end is missing; allowed: a whole file; copy or download it again, or save it anew"
    )]
    CutShort,
    /// A kind of TIFF that is not read.
    #[error(
        "this kind of TIFF is not read ({0}); save it as RGB or gray of 8 or 16 bits, without a palette and special compression"
    )]
    Tiff(String),
    /// Its kind is unknown.
    #[error(
        "it is of no format that is read; allowed: JPEG, PNG, WebP, TIFF, BMP, GIF; save or export it as JPEG or PNG"
    )]
    Unknown,
    /// The picture cannot be decoded.
    #[error(transparent)]
    Image(ImageError),
}

impl From<ImageError> for PictureError {
    fn from(error: ImageError) -> Self {
        let ends = |text: &str| {
            ["nexpected end", "nexpected End", "fill whole buffer"].iter().any(|end| text.contains(end))
        };
        match &error {
            ImageError::IoError(io) if io.kind() == io::ErrorKind::UnexpectedEof || ends(&io.to_string()) => {
                Self::CutShort
            }
            ImageError::Decoding(why) if ends(&why.to_string()) => Self::CutShort,
            ImageError::Unsupported(what) if what.format_hint() == ImageFormatHint::Unknown => Self::Unknown,
            ImageError::Unsupported(what)
                if what.format_hint() == ImageFormatHint::Exact(ImageFormat::Tiff) =>
            {
                Self::Tiff(what.to_string())
            }
            _ => Self::Image(error),
        }
    }
}

impl From<io::Error> for PictureError {
    fn from(error: io::Error) -> Self {
        ImageError::from(error).into()
    }
}

/// A decoded file.
#[derive(Debug)]
pub struct Decoded {
    /// The picture, rotated by its EXIF orientation.
    pub image: DynamicImage,
    /// px an inch, if the file states it.
    pub dpi: Option<f64>,
    /// Notes on the conversion: a stretched range, pictures that were left out.
    pub notes: Vec<String>,
}

/// The first bytes of a stream, which is then at its start again.
fn start(stream: &mut (impl BufRead + Seek)) -> io::Result<Vec<u8>> {
    let mut start = Vec::new();
    stream.rewind()?;
    io::Read::read_to_end(&mut io::Read::take(&mut *stream, START), &mut start)?;
    stream.rewind()?;
    Ok(start)
}

/// All bytes of a stream.
fn all(stream: &mut (impl BufRead + Seek)) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    stream.rewind()?;
    stream.read_to_end(&mut bytes)?;
    stream.rewind()?;
    Ok(bytes)
}

/// A reader of the format that a file begins with.
fn reader<R: BufRead + Seek>(stream: R, start: &[u8]) -> Result<ImageReader<R>, PictureError> {
    if let Some(other) = foreign(start) {
        return Err(PictureError::Foreign(other));
    }
    if tiff::is_tiff(start) {
        return Ok(ImageReader::with_format(stream, ImageFormat::Tiff));
    }
    Ok(ImageReader::new(stream).with_guessed_format()?)
}

/// Width and height of the picture in a file as they are stored, px, from its header alone.
///
/// # Errors
/// It is no picture that can be read (PNG, JPEG, WebP, TIFF, BMP, GIF).
pub fn size(stream: &mut (impl BufRead + Seek)) -> Result<[usize; 2], PictureError> {
    let start = start(stream)?;
    match reader(&mut *stream, &start)?.into_dimensions() {
        Ok((width, height)) => Ok([width as usize, height as usize]),
        Err(ImageError::Unsupported(_)) if tiff::is_tiff(&start) => {
            tiff::size(&all(stream)?).map_err(tiff_error)
        }
        Err(error) => Err(error.into()),
    }
}

/// Decodes a file of any of these formats; the first picture if it holds several. A narrow range of 16-bit or floating-point values
/// is stretched, with a note.
///
/// # Errors
/// Those of [`size`]; damaged px, a missing end, or a size that is impossible for so short a file.
pub fn decode(stream: &mut (impl BufRead + Seek)) -> Result<Decoded, PictureError> {
    let mut decoded = decode_stored(stream)?;
    let (image, said) = stretch::widened(decoded.image);
    decoded.notes.extend(said);
    Ok(Decoded { image, ..decoded })
}

/// Decodes a file of any of these formats with the stored values. Values that cannot be kept (TIFFs of floating point and the like)
/// are stretched, with a note.
///
/// # Errors
/// Those of [`decode`].
pub fn decode_stored(stream: &mut (impl BufRead + Seek)) -> Result<Decoded, PictureError> {
    let length = stream.seek(SeekFrom::End(0))?;
    let start = start(stream)?;
    let is_tiff = tiff::is_tiff(&start);
    if !is_tiff && start.starts_with(&[0xff, 0xd8]) && jpeg::is_cut_short(&all(stream)?) {
        return Err(PictureError::CutShort);
    }
    if webp_length(&start).is_some_and(|whole| whole > length) {
        return Err(PictureError::CutShort);
    }
    let mut notes = Vec::new();
    let read = match reader(&mut *stream, &start)?.into_decoder() {
        Ok(decoder) => Some(upright(decoder, length)?),
        Err(ImageError::Unsupported(_)) if is_tiff => None,
        Err(error) => return Err(error.into()),
    };
    let (image, exif) = match read {
        Some(read) => read,
        None => {
            let bytes = all(stream)?;
            let [width, height] = tiff::size(&bytes).map_err(tiff_error)?;
            check_size([width as u64, height as u64], (width * height) as u64, length)?;
            let (image, said) = tiff::decode(&bytes).map_err(tiff_error)?;
            notes.extend(said);
            (image, None)
        }
    };
    if is_tiff && tiff::has_several(&all(stream)?) {
        notes.push("it holds several pictures; the first was read".to_owned());
    }
    Ok(Decoded { image, dpi: density::dpi(stream, exif.as_deref()), notes })
}

/// The length that a WebP states for itself, bytes (RIFF: the length of what follows the first 8).
fn webp_length(start: &[u8]) -> Option<u64> {
    let length = start.get(4..8).filter(|_| start.starts_with(b"RIFF"))?;
    Some(8 + u64::from(u32::from_le_bytes(length.try_into().ok()?)))
}

/// The picture of a decoder, rotated by its EXIF data, and these data.
fn upright(
    mut decoder: impl ImageDecoder,
    length: u64,
) -> Result<(DynamicImage, Option<Vec<u8>>), PictureError> {
    let (width, height) = decoder.dimensions();
    check_size([width.into(), height.into()], decoder.total_bytes(), length)?;
    // Damaged EXIF data are ignored: only the picture matters.
    let orientation = decoder.orientation().unwrap_or(Orientation::NoTransforms);
    let exif = decoder.exif_metadata().ok().flatten();
    let mut image = DynamicImage::from_decoder(decoder)?;
    image.apply_orientation(orientation);
    Ok((image, exif))
}

/// Refuses a size that is impossible for a file of this length.
fn check_size([width, height]: [u64; 2], bytes: u64, length: u64) -> Result<(), PictureError> {
    if bytes <= SURE.max(UNPACKED.saturating_mul(length)) {
        return Ok(());
    }
    let found = format!("{width}×{height} px are too many for a file of {length} bytes: it is damaged");
    Err(io::Error::new(io::ErrorKind::InvalidData, found).into())
}

/// A damaged file is not an unknown kind of TIFF.
fn tiff_error(error: TiffError) -> PictureError {
    match error {
        TiffError::IoError(error) if error.kind() == io::ErrorKind::UnexpectedEof => PictureError::CutShort,
        TiffError::IoError(error) => error.into(),
        other => PictureError::Tiff(other.to_string()),
    }
}

#[cfg(test)]
mod tests;
