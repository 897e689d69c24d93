//! Large picture → small picture.

use image::imageops::{FilterType, resize};
use image::{ImageBuffer, Rgb};
use palette::encoding::{FromLinear, IntoLinear, Srgb};

/// Scales `rgb` (8-bit sRGB, three bytes a px) of `size` px down to `smaller` px.
///
/// Linear light is averaged, not sRGB values, so that a fine pattern keeps its brightness. The filter is a triangle two new px
/// wide: no ringing at hard edges and no staircases.
///
/// ```
/// use dapple_engine::export::downscale;
///
/// assert_eq!(downscale(&[90; 3 * 16], [4, 4], [2, 2]), [90; 3 * 4]);
/// ```
///
/// # Panics
/// If `rgb` is shorter than `size` needs, or a side is 0.
#[must_use]
pub fn downscale(rgb: &[u8], size: [usize; 2], smaller: [usize; 2]) -> Vec<u8> {
    let light: Vec<f32> = (0..=255).map(|value| linear(f64::from(value) / 255.0) as f32).collect();
    let side = |length: usize| u32::try_from(length).expect("no picture is as wide as that");
    let [width, height] = size.map(side);
    let lit = ImageBuffer::<Rgb<f32>, _>::from_fn(width, height, |x, y| {
        let px = 3 * (y as usize * size[0] + x as usize);
        Rgb([0, 1, 2].map(|channel| light[usize::from(rgb[px + channel])]))
    });
    let small = resize(&lit, side(smaller[0]), side(smaller[1]), FilterType::Triangle);
    small
        .into_raw()
        .into_iter()
        .map(|value| (255.0 * srgb_from_linear(f64::from(value))).round() as u8)
        .collect()
}

/// sRGB value → linear light, both 0..1.
fn linear(value: f64) -> f64 {
    <Srgb as IntoLinear<f64, f64>>::into_linear(value)
}

/// Linear light, clipped to 0..1 → sRGB value.
#[must_use]
pub fn srgb_from_linear(light: f64) -> f64 {
    <Srgb as FromLinear<f64, f64>>::from_linear(light.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_colour_stays_that_colour() {
        for colour in [[0, 0, 0], [255, 255, 255], [17, 128, 3]] {
            let rgb = colour.repeat(60 * 40);
            assert_eq!(downscale(&rgb, [60, 40], [20, 10]), colour.repeat(200));
        }
    }

    #[test]
    fn linear_light_is_averaged() {
        let chequered: Vec<u8> = (0..64 * 64).flat_map(|px| [[0; 3], [255; 3]][(px + px / 64) % 2]).collect();
        let gray = downscale(&chequered, [64, 64], [8, 8]);
        // Half the light is 188 in sRGB.
        assert!(gray.iter().all(|value| value.abs_diff(188) <= 2), "{gray:?}");
    }

    #[test]
    fn positions_are_kept() {
        let halves: Vec<u8> = (0..80 * 40).flat_map(|px| [if px % 80 < 40 { 0 } else { 255 }; 3]).collect();
        let small = downscale(&halves, [80, 40], [8, 4]);
        let row: Vec<u8> = small[..24].iter().step_by(3).copied().collect();
        assert_eq!((row[0], row[7]), (0, 255));
        assert!(row.windows(2).all(|pair| pair[0] <= pair[1]), "{row:?}");
    }
}
