//! Converts a decoded file to a gray picture of few px.

use rayon::prelude::*;

use crate::photo::decode::Decoded;

/// A picture without colours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gray {
    /// Width and height, px.
    pub size: [usize; 2],
    /// The luminance of each px in the coding of sRGB, row by row from the top.
    pub values: Vec<u8>,
}

/// Shares of linear red, green and blue in the luminance: IEC 61966-2-1, whose primaries are those of ITU-R BT.709.
const LUMINANCE: [f32; 3] = [0.2126, 0.7152, 0.0722];

/// The linear light of a value of sRGB, 0..1 (IEC 61966-2-1).
fn linear(value: f64) -> f64 {
    if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
}

/// The linear light of each of the 256 values of sRGB, 0..1.
pub(super) fn linear_table() -> [f32; 256] {
    let mut table = [0.0; 256];
    for (value, entry) in table.iter_mut().enumerate() {
        *entry = linear(value as f64 / 255.0) as f32;
    }
    table
}

/// The gray picture of a decoded file with at most `most` px a side: each px is the mean linear light of its part. Transparent
/// parts are put on white.
#[must_use]
pub fn gray(decoded: &Decoded, most: usize) -> Gray {
    let rgba = decoded.image.to_rgba8();
    let [width, height] = [rgba.width() as usize, rgba.height() as usize];
    let table = linear_table();
    let light = |px: &[u8]| {
        let coded: f32 = (0..3).map(|k| LUMINANCE[k] * table[usize::from(px[k])]).sum();
        let opaque = f32::from(px[3]) / 255.0;
        opaque * coded + (1.0 - opaque)
    };
    let longest = width.max(height);
    let side = |side: usize| {
        if longest <= most { side } else { ((side * most + longest / 2) / longest).clamp(1, most) }
    };
    let size = [side(width), side(height)];
    let parts = [0, 1].map(|axis| parts([width, height][axis], size[axis]));
    let thresholds = thresholds();
    let mut values = vec![0; size[0] * size[1]];
    values.par_chunks_mut(size[0].max(1)).zip(&parts[1]).for_each(|(row, down)| {
        for (value, across) in row.iter_mut().zip(&parts[0]) {
            let mut sum = 0.0;
            for (y, share) in down {
                let start = 4 * y * width;
                let of_row: f32 = across
                    .iter()
                    .map(|(x, weight)| weight * light(&rgba.as_raw()[start + 4 * x..start + 4 * x + 4]))
                    .sum();
                sum += share * of_row;
            }
            *value = thresholds.partition_point(|threshold| *threshold <= sum) as u8;
        }
    });
    Gray { size, values }
}

/// The linear light values at which the sRGB value is rounded to the next one: 255 of them.
fn thresholds() -> Vec<f32> {
    (0..255).map(|value| linear((f64::from(value) + 0.5) / 255.0) as f32).collect()
}

/// For each of `to` px the px of `from` that it covers, with their shares.
fn parts(from: usize, to: usize) -> Vec<Vec<(usize, f32)>> {
    let part = |k: usize| {
        let [low, high] = [k, k + 1].map(|k| k as f64 * from as f64 / to as f64);
        let covered = |i: usize| {
            let length = (high.min(i as f64 + 1.0) - low.max(i as f64)) / (high - low);
            (length > 0.0).then_some((i, length as f32))
        };
        (low as usize..from.min(high.ceil() as usize)).filter_map(covered).collect()
    };
    (0..to).map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{DynamicImage, Rgba, RgbaImage};

    fn decoded(size: [u32; 2], px: impl Fn(u32, u32) -> [u8; 4]) -> Decoded {
        let image = RgbaImage::from_fn(size[0], size[1], |x, y| Rgba(px(x, y)));
        Decoded { image: DynamicImage::ImageRgba8(image), dpi: None, notes: Vec::new() }
    }

    #[test]
    fn grays_stay_as_they_are() {
        let gray = gray(&decoded([256, 1], |x, _| [x as u8, x as u8, x as u8, 255]), 1024);
        assert_eq!(gray.size, [256, 1]);
        assert!(gray.values.iter().enumerate().all(|(x, value)| usize::from(*value) == x));
    }

    #[test]
    fn a_large_picture_is_reduced_by_the_mean_light() {
        // Columns of black and white: half of the light is 188 in sRGB, not 128.
        let striped = decoded([400, 200], |x, _| if x % 2 == 0 { [0, 0, 0, 255] } else { [255; 4] });
        let gray = gray(&striped, 100);
        assert_eq!(gray.size, [100, 50]);
        assert!(gray.values.iter().all(|value| *value == 188), "{:?}", &gray.values[..4]);
    }

    #[test]
    fn what_is_transparent_is_white() {
        let gray = gray(&decoded([2, 1], |x, _| [0, 0, 0, if x == 0 { 255 } else { 0 }]), 8);
        assert_eq!(gray.values, [0, 255]);
    }
}
