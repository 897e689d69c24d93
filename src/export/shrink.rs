//! A picture, smaller.

use image::imageops::{FilterType, resize};
use image::{ImageBuffer, Rgb};

/// `rgb` (8-bit sRGB, three bytes a px) of `size` px as a picture of `smaller` px, no larger either way.
///
/// The px are averaged as light, not as sRGB's numbers, so that a fine pattern keeps its brightness; by triangles twice
/// a new px wide, which neither ring beside hard edges nor leave staircases.
///
/// # Panics
/// Where `rgb` is shorter than `size` asks for, or a side is 0.
#[must_use]
pub fn shrink(rgb: &[u8], size: [usize; 2], smaller: [usize; 2]) -> Vec<u8> {
    let light: Vec<f32> = (0..=255).map(|value| to_light(f64::from(value) / 255.0) as f32).collect();
    let side = |length: usize| u32::try_from(length).expect("no picture is as wide as that");
    let [width, height] = size.map(side);
    let lit = ImageBuffer::<Rgb<f32>, _>::from_fn(width, height, |x, y| {
        let px = 3 * (y as usize * size[0] + x as usize);
        Rgb([0, 1, 2].map(|channel| light[usize::from(rgb[px + channel])]))
    });
    let small = resize(&lit, side(smaller[0]), side(smaller[1]), FilterType::Triangle);
    small.into_raw().into_iter().map(|value| (255.0 * from_light(f64::from(value))).round() as u8).collect()
}

/// sRGB's number, 0..1 → light, 0..1 (IEC 61966-2-1).
pub(super) fn to_light(s: f64) -> f64 {
    if s <= 0.04045 { s / 12.92 } else { libm::pow((s + 0.055) / 1.055, 2.4) }
}

/// The other way round; what lies beyond 0..1 is brought there.
fn from_light(l: f64) -> f64 {
    let l = l.clamp(0.0, 1.0);
    if l <= 0.003_130_8 { 12.92 * l } else { 1.055 * libm::pow(l, 1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_colour_stays_that_colour() {
        for colour in [[0, 0, 0], [255, 255, 255], [17, 128, 3]] {
            let rgb = colour.repeat(60 * 40);
            assert_eq!(shrink(&rgb, [60, 40], [20, 10]), colour.repeat(200));
        }
    }

    #[test]
    fn light_is_averaged_and_not_its_numbers() {
        let chequered: Vec<u8> = (0..64 * 64).flat_map(|px| [[0; 3], [255; 3]][(px + px / 64) % 2]).collect();
        let gray = shrink(&chequered, [64, 64], [8, 8]);
        // Half the light is 188 in sRGB.
        assert!(gray.iter().all(|value| value.abs_diff(188) <= 2), "{gray:?}");
    }

    #[test]
    fn what_is_left_stays_left() {
        let halves: Vec<u8> = (0..80 * 40).flat_map(|px| [if px % 80 < 40 { 0 } else { 255 }; 3]).collect();
        let small = shrink(&halves, [80, 40], [8, 4]);
        let row: Vec<u8> = small[..24].iter().step_by(3).copied().collect();
        assert_eq!((row[0], row[7]), (0, 255));
        assert!(row.windows(2).all(|pair| pair[0] <= pair[1]), "{row:?}");
    }
}
