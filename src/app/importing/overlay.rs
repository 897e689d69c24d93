//! The marks that were found, as a transparent picture over the photograph: their edges, and a tint inside.
//!
//! At each px of the picture f = value − level of the segmentation's cells around, blurred by a few px: then f ÷ |∇f| is about
//! the distance to the edge, in px of the picture, positive inside, at sharp edges too.

use egui::{Color32, ColorImage};
use rayon::prelude::*;

use crate::photo::{Corners, Part, Reading, parts};

/// The longer side of the picture, px: about two px a point of a small window, one of a large one.
const LONGER: f64 = 1200.0;
/// Most px of the overlay a px of the photograph.
const FINEST: f64 = 6.0;
/// Half width of the light line along an edge, and of the dark one around it, px.
const LINE: [f64; 2] = [1.7, 3.4];
/// Half width of the light line along the edge of a mark that the border cuts, and of the dark one around it, px.
const THIN: [f64; 2] = [1.0, 2.2];
/// Opacity of the light line of marks that the border cuts, 0..1.
const FAINT: f64 = 0.55;
/// Half width of the blur, px: as far as a line reaches.
const BLUR: usize = 3;
/// Colours of the lines, by layer: light, and saturated as no pelt is.
const LAYERS: [[u8; 3]; 2] = [[0x2d, 0xf0, 0xe0], [0xff, 0x6a, 0xe6]];
/// Opacity of the dark line, of the tint inside, of the dark beyond the corners.
const DARK: f64 = 0.62;
const TINT: f64 = 0.12;
const BEYOND: f64 = 0.6;

/// The values at one px of the picture.
#[derive(Clone, Copy)]
struct Place {
    /// The value above the level; NaN outside the part that was read.
    above: f32,
    part: Part,
}

/// The marks over a photograph of `photo` px, of whose part between `corners` (`None` = all) `size` px were read. `between`: the
/// area between two sizes of spots, px².
#[must_use]
pub fn overlay(
    reading: &Reading,
    size: [usize; 2],
    photo: [usize; 2],
    corners: Option<Corners>,
    between: Option<f64>,
) -> ColorImage {
    let scale = (LONGER / photo[0].max(photo[1]).max(1) as f64).min(FINEST);
    let shown = photo.map(|side| ((side as f64 * scale).round() as usize).max(1));
    let [wide, high] = photo.map(|side| side as f64);
    let corners = corners.unwrap_or(Corners([[0.0, 0.0], [wide, 0.0], [wide, high], [0.0, high]]));
    let unit = corners.unprojection();
    let parts = parts(reading, between);
    let px_of = |axis: usize, k: usize| (k as f64 + 0.5) * photo[axis] as f64 / shown[axis] as f64;
    let look = |px: usize| {
        let at = unit([px_of(0, px % shown[0]), px_of(1, px / shown[0])]);
        if at.iter().any(|share| !(0.0..=1.0).contains(share)) {
            return Place { above: f32::NAN, part: Part::Ground };
        }
        look(reading, &parts, [0, 1].map(|axis| at[axis] * size[axis] as f64))
    };
    let count = shown[0] * shown[1];
    let places: Vec<Place> = (0..count).into_par_iter().with_min_len(shown[0]).map(look).collect();
    let above: Vec<f32> = places.iter().map(|place| place.above).collect();
    let above = blurred(&blurred(&above, shown, 1), shown, shown[0]);
    let pixels = (0..count).into_par_iter().with_min_len(shown[0]);
    let pixels = pixels.map(|px| colour(&places, &above, shown, px));
    ColorImage::new(shown, pixels.collect())
}

/// The values at a place, px of the part that was read.
fn look(reading: &Reading, parts: &[Part], at: [f64; 2]) -> Place {
    let field = &reading.segmentation.field;
    let near = |axis: usize, count: usize| {
        let last = count as f64 - 1.0;
        let place = (at[axis] / field.cell[axis] - 0.5).clamp(0.0, last.max(0.0));
        let low = place.floor();
        (low as usize, (low + 1.0).min(last) as usize, (place - low) as f32)
    };
    let ((left, right, u), (top, bottom, v)) = (near(0, field.width), near(1, field.height));
    let cells =
        [[left, top], [right, top], [left, bottom], [right, bottom]].map(|[x, y]| y * field.width + x);
    let [a, b, c, d] = cells.map(|cell| field.values[cell]);
    let value = (a + u * (b - a)) * (1.0 - v) + (c + u * (d - c)) * v;
    let highest = cells.into_iter().max_by(|one, other| field.values[*one].total_cmp(&field.values[*other]));
    let part = highest.map_or(Part::Ground, |cell| parts[cell]);
    Place { above: value - reading.segmentation.level, part }
}

/// Running means along x (`step` 1) or y (`step` = the width) of the part that was read.
fn blurred(above: &[f32], [width, height]: [usize; 2], step: usize) -> Vec<f32> {
    let mean = |px: usize| {
        let (place, length) = if step == 1 { (px % width, width) } else { (px / width, height) };
        let (from, to) = (place.saturating_sub(BLUR), (place + BLUR).min(length - 1));
        let around =
            (from..=to).map(|at| above[px - place * step + at * step]).filter(|value| !value.is_nan());
        let (sum, count) = around.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
        if above[px].is_nan() { f32::NAN } else { sum / count }
    };
    (0..above.len()).into_par_iter().with_min_len(width).map(mean).collect()
}

/// The mark to which the px belongs, or the mark beside it.
fn part_near(places: &[Place], [width, height]: [usize; 2], px: usize) -> Part {
    let (x, y) = (px % width, px / width);
    let beside = |dx: isize, dy: isize| {
        let (x, y) = (x.checked_add_signed(dx)?, y.checked_add_signed(dy)?);
        (x < width && y < height).then(|| places[y * width + x].part).filter(|part| *part != Part::Ground)
    };
    let far = (BLUR as isize) - 1;
    let all = [
        (0, 0),
        (far, 0),
        (-far, 0),
        (0, far),
        (0, -far),
        (far, far),
        (-far, far),
        (far, -far),
        (-far, -far),
    ];
    all.into_iter().find_map(|(dx, dy)| beside(dx, dy)).unwrap_or(Part::Ground)
}

fn colour(places: &[Place], above: &[f32], [width, height]: [usize; 2], px: usize) -> Color32 {
    if above[px].is_nan() {
        return Color32::from_black_alpha((255.0 * BEYOND) as u8);
    }
    let (layer, widths, light, tint) = match part_near(places, [width, height], px) {
        Part::Ground => return Color32::TRANSPARENT,
        Part::Cut => (0, THIN, FAINT, 0.0),
        Part::Mark(layer) => (usize::from(layer).min(1), LINE, 1.0, TINT),
    };
    let (x, y) = (px % width, px / width);
    let slope = |low: usize, high: usize| {
        let slope = 0.5 * (above[high] - above[low]);
        if slope.is_nan() { 0.0 } else { f64::from(slope) }
    };
    let across = slope(px - usize::from(x > 0), px + usize::from(x + 1 < width));
    let down = slope(px - width * usize::from(y > 0), px + width * usize::from(y + 1 < height));
    let far = f64::from(above[px]) / (across * across + down * down).sqrt().max(1e-6);
    // The share of a px that a line covers, where the middle of the px is this far from the edge.
    let cover = |half: f64| (half + 0.5 - far.abs()).clamp(0.0, 1.0);
    let (line, dark) = (light * cover(widths[0]), DARK * cover(widths[1]));
    let tint = if far > 0.0 { tint } else { 0.0 };
    let [red, green, blue] = LAYERS[layer].map(f64::from);
    // The light line over the dark line over the tint, premultiplied.
    let over = |colour: f64| line * colour + (1.0 - line) * (1.0 - dark) * tint * colour;
    let alpha = line + (1.0 - line) * (dark + (1.0 - dark) * tint);
    let [red, green, blue, alpha] =
        [over(red), over(green), over(blue), 255.0 * alpha].map(|value| value.round() as u8);
    Color32::from_rgba_premultiplied(red, green, blue, alpha)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::{Raster, read};

    /// Dark discs of radius 6 every 24 px.
    fn discs() -> Raster {
        let size = [216, 192];
        let near = |at: usize| (at as f64 + 0.5).rem_euclid(24.0) - 12.0;
        let dark = |k: usize| near(k % size[0]).hypot(near(k / size[0])) < 6.0;
        let px = |k: usize| if dark(k) { [40; 3] } else { [220; 3] };
        Raster { size, rgb: (0..size[0] * size[1]).flat_map(px).collect(), dpi: None }
    }

    #[test]
    fn edges_are_lines_and_the_ground_stays_as_it_is() {
        let raster = discs();
        let shown = overlay(&read(&raster, false).unwrap(), raster.size, raster.size, None, None);
        let scale = shown.size[0] as f64 / 216.0;
        let at = |x: f64, y: f64| shown.pixels[(y * scale) as usize * shown.size[0] + (x * scale) as usize];
        let [red, green, blue] = LAYERS[0];
        assert_eq!(at(66.0, 60.0), Color32::from_rgb(red, green, blue), "6 px from the middle of a disc");
        assert_eq!(at(72.0, 72.0), Color32::TRANSPARENT, "between four discs");
        assert_eq!(at(60.0, 60.0).a(), (255.0 * TINT).round() as u8, "in the middle of one");
    }

    #[test]
    fn marks_of_a_flattened_part_lie_where_they_are_in_the_photograph() {
        let raster = discs();
        let corners = Corners([[24.0, 24.0], [192.0, 24.0], [192.0, 168.0], [24.0, 168.0]]);
        let flat = corners.flattened(&raster);
        let shown = overlay(&read(&flat, false).unwrap(), flat.size, raster.size, Some(corners), None);
        let scale = shown.size[0] as f64 / 216.0;
        let at = |x: f64, y: f64| shown.pixels[(y * scale) as usize * shown.size[0] + (x * scale) as usize];
        let [red, green, blue] = LAYERS[0];
        assert_eq!(at(66.0, 60.0), Color32::from_rgb(red, green, blue));
        assert_eq!(at(12.0, 12.0), Color32::from_black_alpha((255.0 * BEYOND) as u8));
    }
}
