//! Kinds of TIFF that the `image` crate does not read: palettes, floating point and signed numbers, JPEG in TIFF, several bands.
//!
//! TIFF Revision 6.0 (Adobe, 1992), BigTIFF (2007).

use std::io::Cursor;

use image::{DynamicImage, GrayImage, RgbImage};
use tiff::decoder::{Decoder, DecodingResult, Limits};
use tiff::tags::Tag;
use tiff::{ColorType, TiffError};

use super::stretch::{range, said, stretched};

/// The tag with the meaning of values: 3 for a palette and 1 for gray.
const PHOTOMETRIC: u64 = 262;

/// Whether bytes begin a TIFF, or a BigTIFF.
pub(super) fn is_tiff(start: &[u8]) -> bool {
    [&b"II*\0"[..], b"MM\0*", b"II+\0", b"MM\0+"].iter().any(|mark| start.starts_with(mark))
}

/// Whether there are more pictures than the first.
pub(super) fn has_several(bytes: &[u8]) -> bool {
    Decoder::new(Cursor::new(bytes)).is_ok_and(|decoder| decoder.more_images())
}

/// Width and height, px.
pub(super) fn size(bytes: &[u8]) -> Result<[usize; 2], TiffError> {
    let (width, height) = Decoder::new(Cursor::new(bytes))?.dimensions()?;
    Ok([width as usize, height as usize])
}

/// The first picture, and a note on it.
pub(super) fn decode(bytes: &[u8]) -> Result<(DynamicImage, Option<String>), TiffError> {
    // The decoder refuses indices into a palette, so they are read as gray values.
    let as_gray = with_gray_for_palette(bytes);
    let mut decoder =
        Decoder::new(Cursor::new(as_gray.as_deref().unwrap_or(bytes)))?.with_limits(Limits::unlimited());
    let (width, height) = decoder.dimensions()?;
    let kind = decoder.colortype()?;
    let mut read = DecodingResult::U8(Vec::new());
    let layout = decoder.read_image_to_buffer(&mut read)?;
    let planes = layout.planes.max(1);
    let channels = usize::from(kind.num_samples());
    let px = width as usize * height as usize;
    let bits = usize::from(kind.bit_depth());
    let values = spread(values(read), bits, width as usize, channels, planes);
    if values.len() < px * channels {
        return Err(TiffError::IoError(std::io::ErrorKind::UnexpectedEof.into()));
    }
    let gray = |bytes| GrayImage::from_raw(width, height, bytes).map(DynamicImage::ImageLuma8);
    let rgb = |bytes| RgbImage::from_raw(width, height, bytes).map(DynamicImage::ImageRgb8);
    if as_gray.is_some() {
        let map = decoder.get_tag_u16_vec(Tag::ColorMap)?;
        return whole(
            rgb(values[..px].iter().flat_map(|value| of_palette(&map, *value as usize)).collect()),
            None,
        );
    }
    match kind {
        ColorType::YCbCr(8) => whole(rgb(values.chunks_exact(3).flat_map(of_ycbcr).collect()), None),
        ColorType::Lab(_) | ColorType::CMYK(_) | ColorType::CMYKA(_) => {
            let unsupported = tiff::TiffUnsupportedError::UnsupportedColorType(kind);
            Err(TiffError::UnsupportedError(unsupported))
        }
        _ => {
            // With one or two bands the first is the picture, with more the first three; the others are opacity or something else.
            let shown = if channels < 3 { 1 } else { 3 };
            let taken: Vec<f64> =
                values.chunks_exact(channels).flat_map(|px| &px[..shown]).copied().collect();
            let few_bits = bits <= 8 && taken.iter().all(|value| *value >= 0.0);
            let full = [0.0, ((1_u64 << bits.min(8)) - 1) as f64];
            let ends = range(taken.iter().copied()).unwrap_or(full);
            let said = (!few_bits).then(|| said(ends));
            let byte = |value: &f64| {
                if few_bits { (255.0 * value / full[1]).round() as u8 } else { stretched(*value, ends) }
            };
            let bytes = taken.iter().map(byte).collect();
            whole(if shown == 1 { gray(bytes) } else { rgb(bytes) }, said)
        }
    }
}

fn whole(
    image: Option<DynamicImage>,
    said: Option<String>,
) -> Result<(DynamicImage, Option<String>), TiffError> {
    Ok((image.ok_or(TiffError::IntSizeError)?, said))
}

/// All samples as numbers.
fn values(read: DecodingResult) -> Vec<f64> {
    fn of<T: Copy + Into<f64>>(values: &[T]) -> Vec<f64> {
        values.iter().map(|value| (*value).into()).collect()
    }
    match read {
        DecodingResult::U8(values) => of(&values),
        DecodingResult::U16(values) => of(&values),
        DecodingResult::U32(values) => of(&values),
        DecodingResult::U64(values) => values.iter().map(|value| *value as f64).collect(),
        DecodingResult::F16(values) => values.iter().map(|value| f64::from(value.to_f32())).collect(),
        DecodingResult::F32(values) => of(&values),
        DecodingResult::F64(values) => values,
        DecodingResult::I8(values) => of(&values),
        DecodingResult::I16(values) => of(&values),
        DecodingResult::I32(values) => of(&values),
        DecodingResult::I64(values) => values.iter().map(|value| *value as f64).collect(),
    }
}

/// The samples px by px: samples of fewer than 8 bits are packed, each row into whole bytes, and planes are stored one after the
/// other.
fn spread(values: Vec<f64>, bits: usize, width: usize, channels: usize, planes: usize) -> Vec<f64> {
    let a_row = width * if planes > 1 { 1 } else { channels };
    let unpacked = if bits >= 8 {
        values
    } else {
        let row = (a_row * bits).div_ceil(8).max(1);
        let sample = |row: &[f64], k: usize| {
            // A sample of 3, 5, 6 or 7 bits may extend over two bytes.
            let byte = |at: usize| row.get(at).copied().unwrap_or(0.0) as u32;
            let first = k * bits / 8;
            let both = byte(first) << 8 | byte(first + 1);
            f64::from(both >> (16 - bits - k * bits % 8) & ((1 << bits) - 1))
        };
        values.chunks(row).flat_map(|row| (0..a_row).map(move |k| sample(row, k))).collect()
    };
    if planes < 2 {
        return unpacked;
    }
    let px = unpacked.len() / planes;
    (0..px * planes).map(|at| unpacked[at % planes * px + at / planes]).collect()
}

/// A colour of a palette: all reds, then all greens, then all blues, of 16 bits; some programs write 8 bits.
fn of_palette(map: &[u16], index: usize) -> [u8; 3] {
    let shift = if map.iter().all(|value| *value < 256) { 0 } else { 8 };
    [0, 1, 2]
        .map(|channel| map.get(channel * (map.len() / 3) + index).map_or(0, |value| (value >> shift) as u8))
}

/// Y, Cb, Cr of 8 bits (ITU-R BT.601, full range, as in JPEG) → red, green, blue.
fn of_ycbcr(px: &[f64]) -> [u8; 3] {
    let [y, cb, cr] = [px[0], px[1] - 128.0, px[2] - 128.0];
    [y + 1.402 * cr, y - 0.344_136 * cb - 0.714_136 * cr, y + 1.772 * cb]
        .map(|value| value.round().clamp(0.0, 255.0) as u8)
}

/// The file changed to gray instead of a palette; `None` if it has no palette.
fn with_gray_for_palette(bytes: &[u8]) -> Option<Vec<u8>> {
    let little = bytes.starts_with(b"II");
    let number = |at: usize, length: usize| -> Option<u64> {
        let digits = bytes.get(at..at.checked_add(length)?)?.iter();
        let add = |number: u64, byte: &u8| number << 8 | u64::from(*byte);
        Some(if little { digits.rev().fold(0, add) } else { digits.fold(0, add) })
    };
    let big = number(2, 2)? == 43;
    let directory = usize::try_from(if big { number(8, 8)? } else { number(4, 4)? }).ok()?;
    let (head, entry, value) = if big { (8, 20, 12) } else { (2, 12, 8) };
    let count = usize::try_from(number(directory, head)?).ok()?.min(1 << 16);
    let entries = (0..count).map(|k| directory + head + k * entry);
    let at = entries.into_iter().find(|at| number(*at, 2) == Some(PHOTOMETRIC))? + value;
    (number(at, 2)? == 3).then(|| {
        let mut changed = bytes.to_vec();
        changed[if little { at } else { at + 1 }] = 1;
        changed
    })
}
