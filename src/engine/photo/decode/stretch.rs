//! Converts values of more than 8 bits to 8 bits: narrow ranges are stretched.

use image::DynamicImage;

/// The share of values that may lie beyond either end of their range: noise and dust of single px.
const BEYOND: f64 = 0.001;
/// Ranges that take less than this share of all values are stretched.
const NARROW: f64 = 0.25;
/// The ends of a stretched range, of 255. Between them, lightness is proportional to the values within 3 %.
const TO: [f64; 2] = [64.0, 224.0];
/// Number of values that are sampled.
const ENOUGH: usize = 1 << 20;

/// The range of finite values, without the few beyond either end; `None` without any.
pub(super) fn range(values: impl ExactSizeIterator<Item = f64>) -> Option<[f64; 2]> {
    let step = values.len() / ENOUGH + 1;
    let mut some: Vec<f64> = values.step_by(step).filter(|value| value.is_finite()).collect();
    let last = some.len().checked_sub(1)?;
    let beyond = (last as f64 * BEYOND) as usize;
    let mut at = |rank: usize| *some.select_nth_unstable_by(rank, f64::total_cmp).1;
    Some([at(beyond), at(last - beyond)])
}

/// A value of a stretched range, 0 to 255. NaN becomes the lowest value.
pub(super) fn stretched(value: f64, [low, high]: [f64; 2]) -> u8 {
    let share = ((value - low) / (high - low).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    // NaN becomes 0, too.
    let share = if share > 0.0 { share } else { 0.0 };
    (TO[0] + share * (TO[1] - TO[0])).round() as u8
}

/// The note on a range that was stretched.
pub(super) fn said([low, high]: [f64; 2]) -> String {
    // In the digits of single precision.
    let [low, high] = [low as f32, high as f32];
    format!("its values lie between {low} and {high}; this range was stretched")
}

/// A picture of 16 bits or of floating point whose values cover a small part of their range, stretched, with a note; any other
/// picture unchanged.
pub(super) fn widened(image: DynamicImage) -> (DynamicImage, Option<String>) {
    let (values, most): (Vec<f64>, f64) = match &image {
        DynamicImage::ImageLuma16(picture) => (doubles(picture.as_raw()), 65535.0),
        DynamicImage::ImageRgb16(picture) => (doubles(picture.as_raw()), 65535.0),
        DynamicImage::ImageRgb32F(picture) => (doubles(picture.as_raw()), 1.0),
        _ => return (image, None),
    };
    let Some([low, high]) = range(values.iter().copied()) else { return (image, None) };
    let is_outside = low < 0.0 || high > most;
    if high <= low || !is_outside && high - low >= NARROW * most {
        return (image, None);
    }
    let bytes: Vec<u8> = values.iter().map(|value| stretched(*value, [low, high])).collect();
    let [width, height] = [image.width(), image.height()];
    let gray = matches!(image, DynamicImage::ImageLuma16(_));
    let widened = if gray {
        image::GrayImage::from_raw(width, height, bytes).map(DynamicImage::ImageLuma8)
    } else {
        image::RgbImage::from_raw(width, height, bytes).map(DynamicImage::ImageRgb8)
    };
    widened.map_or((image, None), |widened| (widened, Some(said([low, high]))))
}

fn doubles<T: Copy + Into<f64>>(values: &[T]) -> Vec<f64> {
    values.iter().map(|value| (*value).into()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{ImageBuffer, Luma};

    #[test]
    fn twelve_bits_in_sixteen_are_stretched_and_a_wide_range_stays() {
        let picture = |most: u32| {
            let of = move |x: u32, y: u32| Luma([((x + 16 * y) * most / 255) as u16]);
            DynamicImage::ImageLuma16(ImageBuffer::from_fn(16, 16, of))
        };
        let (widened, said) = widened(picture(4095));
        let gray = widened.to_luma8();
        assert_eq!((gray.get_pixel(0, 0).0, gray.get_pixel(15, 15).0), ([64], [224]));
        assert_eq!(said.as_deref(), Some("its values lie between 0 and 4095; this range was stretched"));
        assert_eq!(super::widened(picture(65535)), (picture(65535), None));
    }

    #[test]
    fn nan_is_ground() {
        assert_eq!(range([f64::NAN, 1.0, f64::INFINITY, 3.0].into_iter()), Some([1.0, 3.0]));
        assert_eq!(
            [f64::NAN, 1.0, 2.0, 3.0, 9.0].map(|value| stretched(value, [1.0, 3.0])),
            [64, 64, 144, 224, 224]
        );
    }
}
