//! The colours of the ground by place, such as those of a back and a belly.
//!
//! Means over a coarse grid of what lies beyond the blur of marks, with the light divided out; under marks they are filled in from
//! around. Along the first principal axis of these colours, each place has a number from 0 to 1.

use super::channel::first_eigenvector;
use super::lab::Lab;
use super::light::Light;
use super::reading::Reading;
use crate::colour::srgb_of_oklab;
use crate::grid::distance::{length, nearest};
use crate::grid::{Edges, Field};

/// Places along the longer side.
const PLACES: usize = 16;
/// Distance from marks beyond which colours are those of the ground, cells.
const BLUR: f64 = 3.0;
/// Standard deviation of the Gaussian that fills in places, in distances of places.
const FILLED: f64 = 0.8;
/// Greatest distance from which a place is filled in, in places.
const REACH: isize = 8;
/// Quantiles of the places whose colours are the two ends.
const ENDS: [f64; 2] = [0.02, 0.98];
/// Least difference of the two ends, OKLab, from which on the ground changes by place.
const CHANGES: f32 = 0.08;

/// The colours of the ground by place.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundColours {
    /// Columns and rows of places.
    pub size: [usize; 2],
    /// The place of each one's colour between the two ends, 0..1, row by row.
    pub places: Vec<f32>,
    /// The darker and the lighter end: red, green, blue (sRGB).
    pub ends: [[u8; 3]; 2],
}

/// The colours of the ground between the marks of a photograph; `None` if they do not change by place.
#[must_use]
pub fn ground_colours(reading: &Reading) -> Option<GroundColours> {
    let lab = reading.segmentation.lab.as_deref()?;
    let rosettes = reading.rosettes.as_ref();
    let (field, level) = rosettes
        .map_or((&reading.segmentation.field, reading.segmentation.level), |found| (&found.ink, found.level));
    let is_enclosed = |cell: usize| rosettes.is_some_and(|found| found.centres[cell] > 0);
    let (size, means) = means(lab, field, level, is_enclosed)?;
    let filled = filled(&means, size);
    along_axis(&filled, size)
}

/// Sums of L, a and b, and of weights.
type Sum = [f64; 4];

/// The sums over each place of the ground's cells, in full light.
fn means(
    lab: &Lab,
    field: &Field,
    level: f32,
    is_enclosed: impl Fn(usize) -> bool,
) -> Option<([usize; 2], Vec<Sum>)> {
    let grid = field.grid();
    let is_mark: Vec<bool> = field.values.iter().map(|value| *value > level).collect();
    let is_ground: Vec<bool> = is_mark.iter().map(|mark| !mark).collect();
    let (to_mark, to_ground) = (nearest(&is_mark, &grid)?, nearest(&is_ground, &grid)?);
    let far = |offset: [i32; 2]| length(offset, &grid) > BLUR * grid.cell[0];
    let marks: Vec<usize> = (0..is_mark.len()).filter(|cell| far(to_ground[*cell])).collect();
    // What darkens the marks too is light. Light found on the ground would take its colours away.
    let light = Light::of(lab, [&[], &marks]);
    let longer = lab.size[0].max(lab.size[1]);
    let size = lab.size.map(|side| (PLACES * side).div_ceil(longer).max(1));
    let mut sums = vec![[0.0; 4]; size[0] * size[1]];
    for cell in (0..is_mark.len()).filter(|cell| far(to_mark[*cell]) && !is_enclosed(*cell)) {
        let at = [cell % lab.size[0], cell / lab.size[0]];
        let [x, y] = [0, 1].map(|axis| at[axis] * size[axis] / lab.size[axis]);
        let sum = &mut sums[y * size[0] + x];
        let colour = light.divided_out(lab, cell);
        (0..3).for_each(|k| sum[k] += f64::from(colour[k]));
        sum[3] += 1.0;
    }
    Some((size, sums))
}

/// The mean colour at each place, of it and of those around it; `None` where there is no ground far around.
fn filled(sums: &[Sum], [width, height]: [usize; 2]) -> Vec<Option<[f64; 3]>> {
    let at = |place: usize| {
        let (x, y) = ((place % width) as isize, (place / width) as isize);
        let mut all = [0.0; 4];
        for down in -REACH..=REACH {
            for across in -REACH..=REACH {
                let [column, row] = [(x + across, width), (y + down, height)]
                    .map(|(at, count)| Edges::Closed.index(at, count));
                let far = (across * across + down * down) as f64;
                // So small far away that nearer places decide.
                let weight = libm::exp(-0.5 * far / (FILLED * FILLED)).max(1e-30);
                let sum = sums[row * width + column];
                (0..4).for_each(|k| all[k] += weight * sum[k]);
            }
        }
        (all[3] > 0.0).then(|| [0, 1, 2].map(|k| all[k] / all[3]))
    };
    (0..sums.len()).map(at).collect()
}

/// The places along the first principal axis of their colours; `None` if the ends of it hardly differ.
fn along_axis(colours: &[Option<[f64; 3]>], size: [usize; 2]) -> Option<GroundColours> {
    let known: Vec<[f64; 3]> = colours.iter().flatten().copied().collect();
    let count = known.len().max(1) as f64;
    let mean = [0, 1, 2].map(|k| known.iter().map(|colour| colour[k]).sum::<f64>() / count);
    let mut products = [0.0; 6];
    for colour in &known {
        let [l, a, b] = [0, 1, 2].map(|k| colour[k] - mean[k]);
        [l * l, l * a, l * b, a * a, a * b, b * b]
            .iter()
            .zip(&mut products)
            .for_each(|(one, sum)| *sum += one);
    }
    let axis = first_eigenvector(products);
    let along = |colour: &[f64; 3]| (0..3).map(|k| (colour[k] - mean[k]) * axis[k]).sum::<f64>();
    let mut sorted: Vec<f64> = known.iter().map(along).collect();
    sorted.sort_by(f64::total_cmp);
    let last = sorted.len().checked_sub(1)?;
    let ends = ENDS.map(|share| sorted[(share * last as f64).round() as usize]);
    let apart = ends[1] - ends[0];
    if (apart as f32) < CHANGES {
        return None;
    }
    let place = |colour: &Option<[f64; 3]>| {
        colour.as_ref().map_or(0.5, |colour| ((along(colour) - ends[0]) / apart).clamp(0.0, 1.0) as f32)
    };
    let colour = |end: f64| srgb_of_oklab([0, 1, 2].map(|k| (mean[k] + end * axis[k]) as f32));
    Some(GroundColours { size, places: colours.iter().map(place).collect(), ends: ends.map(colour) })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photo::{Raster, read};

    const SIZE: [usize; 2] = [320, 240];

    /// Dark discs on a ground of the colour that `ground` has at a place, in `light`.
    fn picture(ground: impl Fn([f64; 2]) -> [f64; 3], light: impl Fn([f64; 2]) -> f64) -> Raster {
        let px = |k: usize| {
            let at = [k % SIZE[0], k / SIZE[0]].map(|at| at as f64 + 0.5);
            let [x, y] = at.map(|along| along.rem_euclid(40.0) - 20.0);
            let share = (0.5 + (12.0 - x.hypot(y))).clamp(0.0, 1.0);
            let (ground, light) = (ground(at), light(at));
            [0, 1, 2].map(|k| (light * (ground[k] + share * ([70.0, 50.0, 40.0][k] - ground[k]))) as u8)
        };
        Raster { size: SIZE, rgb: (0..SIZE[0] * SIZE[1]).flat_map(px).collect(), dpi: None }
    }

    fn found(raster: &Raster) -> Option<GroundColours> {
        ground_colours(&read(raster, false).expect("discs"))
    }

    const BACK: [f64; 3] = [200.0, 140.0, 70.0];
    const BELLY: [f64; 3] = [240.0, 232.0, 215.0];

    #[test]
    fn a_ground_that_changes_by_place_has_its_two_colours_and_their_places() {
        let mixed = |[_, y]: [f64; 2]| [0, 1, 2].map(|k| BACK[k] + (BELLY[k] - BACK[k]) * y / 240.0);
        let found = found(&picture(mixed, |_| 1.0)).expect("a ground that changes");
        assert_eq!(found.size, [16, 12]);
        for (place, value) in found.places.iter().enumerate() {
            let wanted = (place / 16) as f64 / 11.0;
            assert!((f64::from(*value) - wanted).abs() < 0.12, "{place}: {value} {wanted}");
        }
        for (end, wanted) in found.ends.iter().zip([BACK, BELLY]) {
            let off = (0..3).map(|k| (f64::from(end[k]) - wanted[k]).abs()).fold(0.0, f64::max);
            assert!(off < 14.0, "{end:?} {wanted:?}");
        }
    }

    #[test]
    fn light_that_falls_off_is_no_change_of_the_ground() {
        let light = |[x, y]: [f64; 2]| 1.0 - 0.3 * ((x - 160.0).powi(2) + (y - 120.0).powi(2)) / 40_000.0;
        assert_eq!(found(&picture(|_| BACK, light)), None);
        assert_eq!(found(&picture(|_| BACK, |_| 1.0)), None);
    }
}
