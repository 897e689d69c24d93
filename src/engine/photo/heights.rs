//! Converts a decoded file to heights.

use crate::photo::decode::Decoded;
use crate::surface::HeightField;

/// The heights in a picture as they are stored: gray values; of colours their luminance. 16 bits keep all their steps. `None` if a
/// height is not finite.
#[must_use]
pub fn heights(decoded: &Decoded) -> Option<HeightField> {
    let gray = decoded.image.to_luma32f();
    let size = [gray.width() as usize, gray.height() as usize];
    HeightField::new(size, gray.into_raw())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use image::{DynamicImage, ImageBuffer, Luma};

    #[test]
    fn sixteen_bits_keep_their_steps() {
        let gray: ImageBuffer<Luma<u16>, Vec<u16>> =
            ImageBuffer::from_raw(3, 1, vec![1000, 1001, 1002]).expect("three px");
        let found =
            heights(&Decoded { image: DynamicImage::ImageLuma16(gray), dpi: None, notes: Vec::new() })
                .expect("heights");
        let [rise, _] = found.rise([1, 0], Edges::Closed);
        assert!((rise - 1.0 / 65_535.0).abs() < 1e-8, "{rise}");
    }
}
