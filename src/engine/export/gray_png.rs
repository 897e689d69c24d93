//! Gray pictures inside other files, as PNG of 8 bits.

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, Limits};

use crate::export::Stopped;
use crate::export::png::{Header, Samples, write};

/// A gray picture: width and height, px, and its values row by row from the top.
pub type GrayPicture = ([usize; 2], Vec<u8>);

/// The reason why bytes are no gray picture of 8 bits.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotGray {
    /// Not a PNG, or a damaged one.
    #[error("no whole PNG ({0})")]
    Damaged(String),
    /// Colours, opacity, or another depth.
    #[error("a PNG of {0}")]
    Samples(String),
    /// Too many px.
    #[error("a PNG of {}×{} px", .0[0], .0[1])]
    Size([u32; 2]),
}

/// The PNG of a gray picture of `size` px. It holds nothing else; the same values give the same bytes.
///
/// ```
/// use dapple_engine::export::gray_png::{decode, encode};
///
/// let file = encode([2, 1], &[0, 200])?;
/// let (size, values) = decode(&file, 100)?;
/// assert_eq!((size, values), ([2, 1], vec![0, 200]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// A size that PNG cannot hold.
pub fn encode(size: [usize; 2], values: &[u8]) -> Result<Vec<u8>, Stopped> {
    let mut bytes = Vec::new();
    write(&mut bytes, Header::new(size, Samples::Gray8), |rows, band| {
        band.copy_from_slice(&values[rows.start * size[0]..rows.end * size[0]]);
        Ok(())
    })?;
    Ok(bytes)
}

/// Decodes the gray picture in a PNG of at most `most` px a side.
///
/// # Errors
/// [`NotGray`]. The size is checked before any data is unpacked.
pub fn decode(bytes: &[u8], most: u32) -> Result<GrayPicture, NotGray> {
    let damaged = |error: png::DecodingError| NotGray::Damaged(error.to_string());
    let limits = Limits { bytes: 16 << 20 };
    let mut reader = Decoder::new_with_limits(Cursor::new(bytes), limits).read_info().map_err(damaged)?;
    let info = reader.info();
    let (size, depth, colour) = ([info.width, info.height], info.bit_depth, info.color_type);
    if size.iter().any(|side| *side > most) {
        return Err(NotGray::Size(size));
    }
    if depth != BitDepth::Eight || colour != ColorType::Grayscale {
        let kind = match colour {
            ColorType::Grayscale => "gray",
            ColorType::GrayscaleAlpha => "gray and opacity",
            ColorType::Rgb => "red, green and blue",
            ColorType::Rgba => "red, green, blue and opacity",
            ColorType::Indexed => "a palette",
        };
        return Err(NotGray::Samples(format!("{kind}, {} bits", depth as u8)));
    }
    let size = size.map(|side| side as usize);
    let mut values = vec![0; size[0] * size[1]];
    let frame = reader.next_frame(&mut values).map_err(damaged)?;
    if frame.buffer_size() != values.len() {
        return Err(NotGray::Damaged("too few px".to_owned()));
    }
    Ok((size, values))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_unchanged_after_decoding_and_its_file_is_small() {
        let size = [90, 50];
        let values: Vec<u8> = (0..size[0] * size[1]).map(|px| (px % size[0] + px / size[0]) as u8).collect();
        let bytes = encode(size, &values).unwrap();
        assert!(bytes.len() < values.len() / 2, "{}", bytes.len());
        assert_eq!(decode(&bytes, 90), Ok((size, values)));
    }

    #[test]
    fn files_that_are_no_gray_picture_of_that_size_are_refused() {
        let bytes = encode([20, 10], &[7; 200]).unwrap();
        assert_eq!(decode(&bytes, 19), Err(NotGray::Size([20, 10])));
        assert!(matches!(decode(&bytes[..bytes.len() / 2], 20), Err(NotGray::Damaged(_))));
        assert!(matches!(decode(b"GIF89a", 20), Err(NotGray::Damaged(_))));
        let mut colours = Vec::new();
        write(&mut colours, Header::new([4, 4], Samples::Rgb8), |_, _| Ok(())).unwrap();
        assert_eq!(decode(&colours, 20), Err(NotGray::Samples("red, green and blue, 8 bits".to_owned())));
    }
}
