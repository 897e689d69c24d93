//! Converts a decoded file to px without opacity: transparent parts become ground.

use image::RgbaImage;

use super::Raster;
use super::decode::Decoded;
use crate::colour::{linear_light, oklab_of_light};

/// px with at least this opacity, of 255, are drawn; the others are ground.
const DRAWN: u8 = 128;
/// Least share of ground px; with less, the transparent px are a border that a program has left.
const LITTLE: f64 = 0.001;
/// An object that is cut out has at least this share of the px in one part, and a deviation of colours, OKLab, of at least this: its marks
/// differ from its ground.
const CUT_OUT: f64 = 0.5;
const VARIED: f64 = 0.04;

impl Raster {
    /// The px of a decoded file. Transparent parts are put on `ground`, or, if none is known, on a colour that contrasts with the
    /// drawn px: on white or black if these are marks, on their own commonest colour if they are a cut-out object with marks on it.
    #[must_use]
    pub fn opaque(decoded: Decoded, ground: Option<[u8; 3]>) -> Self {
        let size = [decoded.image.width() as usize, decoded.image.height() as usize];
        let dpi = decoded.dpi;
        if !decoded.image.color().has_alpha() {
            return Self { size, rgb: decoded.image.into_rgb8().into_raw(), dpi };
        }
        let rgba = decoded.image.into_rgba8();
        let ground = ground.unwrap_or_else(|| ground_of(&rgba));
        let mix = |px: &[u8]| {
            let opacity = u32::from(px[3]);
            [0, 1, 2].map(|k| {
                ((u32::from(px[k]) * opacity + u32::from(ground[k]) * (255 - opacity) + 127) / 255) as u8
            })
        };
        Self { size, rgb: rgba.as_raw().chunks_exact(4).flat_map(mix).collect(), dpi }
    }
}

/// The colour that is put behind the drawn px.
fn ground_of(rgba: &RgbaImage) -> [u8; 3] {
    const WHITE: [u8; 3] = [255; 3];
    let drawn: Vec<[u8; 4]> = rgba.pixels().map(|px| px.0).filter(|px| px[3] >= DRAWN).collect();
    let all = (rgba.width() * rgba.height()) as usize;
    if drawn.is_empty() || (all - drawn.len()) as f64 <= LITTLE * all as f64 {
        return WHITE;
    }
    let light = linear_light();
    let lab = |rgb: [u8; 3]| oklab_of_light(rgb.map(|value| light[usize::from(value)])).map(f64::from);
    let n = drawn.len() as f64;
    let (mut sum, mut squares) = ([0.0; 3], [0.0; 3]);
    for px in &drawn {
        let found = lab([px[0], px[1], px[2]]);
        (0..3).for_each(|k| (sum[k], squares[k]) = (sum[k] + found[k], squares[k] + found[k] * found[k]));
    }
    let mean = sum.map(|sum| sum / n);
    let deviation = (0..3).map(|k| (squares[k] / n - mean[k] * mean[k]).max(0.0)).sum::<f64>().sqrt();
    if deviation > VARIED && largest_part(rgba) as f64 > CUT_OUT * n {
        return [0, 1, 2].map(|k| median(&drawn, k));
    }
    let far = |rgb: [u8; 3]| (0..3).map(|k| (lab(rgb)[k] - mean[k]) * (lab(rgb)[k] - mean[k])).sum::<f64>();
    if far(WHITE) >= far([0; 3]) { WHITE } else { [0; 3] }
}

/// The median of a channel.
fn median(drawn: &[[u8; 4]], channel: usize) -> u8 {
    let mut counts = [0_usize; 256];
    drawn.iter().for_each(|px| counts[usize::from(px[channel])] += 1);
    let mut below = 0;
    let reaches = |count: &usize| {
        below += count;
        2 * below >= drawn.len()
    };
    counts.iter().position(reaches).unwrap_or_default() as u8
}

/// Number of px of the largest connected part of the drawn px.
fn largest_part(rgba: &RgbaImage) -> usize {
    let [width, height] = [rgba.width() as usize, rgba.height() as usize];
    let mut open: Vec<bool> = rgba.pixels().map(|px| px.0[3] >= DRAWN).collect();
    let (mut largest, mut next) = (0, Vec::new());
    for start in 0..open.len() {
        if !std::mem::take(&mut open[start]) {
            continue;
        }
        next.push(start);
        let mut px = 0;
        while let Some(at) = next.pop() {
            px += 1;
            let (x, y) = (at % width, at / width);
            let around = [
                (x > 0, at.wrapping_sub(1)),
                (x + 1 < width, at + 1),
                (y > 0, at.wrapping_sub(width)),
                (y + 1 < height, at + width),
            ];
            for (_, other) in around.into_iter().filter(|(is_inside, _)| *is_inside) {
                if std::mem::take(&mut open[other]) {
                    next.push(other);
                }
            }
        }
        largest = largest.max(px);
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;
    use image::{DynamicImage, Rgba};

    fn raster(px: impl Fn(u32, u32) -> [u8; 4]) -> Raster {
        let image = RgbaImage::from_fn(60, 60, |x, y| Rgba(px(x, y)));
        Raster::opaque(Decoded { image: DynamicImage::ImageRgba8(image), dpi: None, notes: Vec::new() }, None)
    }

    #[test]
    fn transparent_parts_contrast_with_the_marks() {
        let dot = |x: u32, y: u32| (x % 20).abs_diff(10) + (y % 20).abs_diff(10) < 6;
        let marks =
            |colour: u8| raster(move |x, y| if dot(x, y) { [colour, colour, colour, 255] } else { [0; 4] });
        assert_eq!((marks(40).px(0, 0), marks(40).px(10, 10)), ([255; 3], [40; 3]));
        assert_eq!((marks(220).px(0, 0), marks(220).px(10, 10)), ([0; 3], [220; 3]));
    }

    #[test]
    fn a_cut_out_object_is_surrounded_by_its_own_ground() {
        let cut_out = raster(|x, y| match (x, y) {
            _ if x.abs_diff(30) + y.abs_diff(30) > 28 => [255, 255, 255, 0],
            _ if x % 9 < 3 && y % 9 < 3 => [40, 20, 10, 255],
            _ => [200, 160, 100, 255],
        });
        assert_eq!((cut_out.px(0, 0), cut_out.px(30, 32)), ([200, 160, 100], [200, 160, 100]));
    }

    #[test]
    fn half_transparent_px_are_mixed_with_a_given_ground() {
        let image = RgbaImage::from_pixel(2, 2, Rgba([100, 0, 200, 51]));
        let decoded = Decoded { image: DynamicImage::ImageRgba8(image), dpi: None, notes: Vec::new() };
        assert_eq!(Raster::opaque(decoded, Some([0, 100, 0])).px(1, 1), [20, 80, 40]);
    }
}
