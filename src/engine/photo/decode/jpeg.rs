//! Whether a JPEG is complete. The decoder fills missing parts with gray, without an error.

/// Whether a file is a JPEG without an end (ITU-T T.81, annex B): cut short, or the rest was never written.
pub(super) fn is_cut_short(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0xff, 0xd8]) && !has_end(bytes)
}

/// Whether the end marker is found after the segments and the px. A preview in a segment has an end marker of its own, which is
/// ignored.
fn has_end(bytes: &[u8]) -> bool {
    let mut at = 2;
    while let Some(rest) = bytes.get(at..) {
        // Finds the next marker: in px, 0xff occurs only before 0 and before restart markers.
        let Some(found) = rest.windows(2).position(|pair| pair[0] == 0xff && !matches!(pair[1], 0 | 0xff))
        else {
            return false;
        };
        let marker = rest[found + 1];
        at += found + 2;
        match marker {
            0xd9 => return true,
            // Markers without a length.
            0x01 | 0xd0..=0xd8 => {}
            _ => {
                let Some(&[high, low]) = bytes.get(at..at + 2) else { return false };
                at += usize::from(u16::from_be_bytes([high, low])).max(2);
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{DynamicImage, ImageFormat, RgbImage};
    use std::io::Cursor;

    #[test]
    fn every_jpeg_that_lacks_its_end_is_cut_short() {
        let mut file = Cursor::new(Vec::new());
        let picture =
            RgbImage::from_fn(40, 30, |x, y| image::Rgb([(x * 7) as u8, (y * 9) as u8, (x * y) as u8]));
        DynamicImage::ImageRgb8(picture).write_to(&mut file, ImageFormat::Jpeg).expect("a JPEG");
        let whole = file.into_inner();
        assert!(!is_cut_short(&whole) && !is_cut_short(&[&whole[..], b"\0more"].concat()));
        assert!((2..whole.len() - 1).all(|length| is_cut_short(&whole[..length])));
        // A preview in a segment.
        let mut with_preview = vec![0xff, 0xd8, 0xff, 0xe1, 0, 8, 0xff, 0xd8, 0xff, 0xd9, 0, 0];
        with_preview.extend(&whole[2..whole.len() - 40]);
        assert!(is_cut_short(&with_preview) && !is_cut_short(b"\x89PNG"));
    }
}
