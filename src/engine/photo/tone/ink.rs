//! The share of ink that a picture asks for.

use crate::photo::tone::gray::{Gray, linear_table};

/// Tiles along each side whose histograms are equalised, as usual (Zuiderveld 1994).
const TILES: usize = 8;
/// The largest share of a tile's px that one gray may have; the excess is distributed over all grays. Contrast is increased by a
/// factor of at most 256 · 0.01. With 0.01 three portraits were best (`facts.md` V).
const LIMIT: f64 = 0.01;

/// The share of ink at each px, 0 = white to 1 = black: 1 − linear luminance, or with `equalise` the share of lighter px around the
/// px.
///
/// Contrast limited adaptive histogram equalisation: K. Zuiderveld, in Graphics Gems IV (1994), 474–485.
#[must_use]
pub fn ink(picture: &Gray, equalise: bool) -> Vec<f32> {
    if !equalise {
        let light = linear_table();
        return picture.values.iter().map(|value| 1.0 - light[usize::from(*value)]).collect();
    }
    let [width, height] = picture.size;
    let tiles = picture.size.map(|side| TILES.min(side));
    let maps: Vec<[f32; 256]> = (0..tiles[0] * tiles[1])
        .map(|tile| {
            let span = |axis: usize, k: usize| {
                let side = picture.size[axis];
                k * side / tiles[axis]..(k + 1) * side / tiles[axis]
            };
            let rows = span(1, tile / tiles[0]);
            let px = rows.flat_map(|y| {
                let columns = span(0, tile % tiles[0]);
                picture.values[y * width + columns.start..y * width + columns.end].iter().copied()
            });
            shares(px)
        })
        .collect();
    let [columns, rows] = [0, 1].map(|axis| between(picture.size[axis], tiles[axis]));
    let mut ink = Vec::with_capacity(width * height);
    for (y, (top, bottom, v)) in rows.iter().enumerate() {
        for (x, (left, right, u)) in columns.iter().enumerate() {
            let value = usize::from(picture.values[y * width + x]);
            let at = |column: &usize, row: &usize| maps[row * tiles[0] + column][value];
            let upper = at(left, top) + u * (at(right, top) - at(left, top));
            let lower = at(left, bottom) + u * (at(right, bottom) - at(left, bottom));
            ink.push(1.0 - (upper + v * (lower - upper)));
        }
    }
    ink
}

/// For each gray, the share of these px that are darker, plus half of those that are equal.
fn shares(px: impl Iterator<Item = u8>) -> [f32; 256] {
    let mut counts = [0.0_f64; 256];
    let mut total = 0.0;
    for value in px {
        counts[usize::from(value)] += 1.0;
        total += 1.0;
    }
    let limit = LIMIT * total;
    let above: f64 = counts.iter().map(|count| (count - limit).max(0.0)).sum();
    let mut sum = 0.0;
    counts.map(|count| {
        let count = count.min(limit) + above / 256.0;
        let share = (sum + 0.5 * count) / total.max(1.0);
        sum += count;
        share as f32
    })
}

/// For each px of a side, the two tiles between whose centres it lies, and its position between them, 0..1.
fn between(side: usize, tiles: usize) -> Vec<(usize, usize, f32)> {
    let place = |px: usize| {
        let at = ((px as f32 + 0.5) * tiles as f32 / side as f32 - 0.5).clamp(0.0, tiles as f32 - 1.0);
        let first = at as usize;
        (first, (first + 1).min(tiles - 1), at - first as f32)
    };
    (0..side).map(place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_has_no_ink_and_black_all() {
        let picture = Gray { size: [3, 1], values: vec![255, 188, 0] };
        let ink = ink(&picture, false);
        assert!(ink[0] == 0.0 && (ink[1] - 0.5).abs() < 0.01 && ink[2] == 1.0, "{ink:?}");
    }

    #[test]
    fn equalising_spreads_a_dull_picture_and_keeps_the_order_of_grays() {
        let value = |x: usize, y: usize| 100 + ((x * 7 + y * 13) % 40) as u8;
        let values: Vec<u8> = (0..64 * 64).map(|px| value(px % 64, px / 64)).collect();
        let picture = Gray { size: [64, 64], values };
        let [plain, even] = [false, true].map(|equalise| ink(&picture, equalise));
        let range = |ink: &[f32]| {
            ink.iter().fold(0.0_f32, |high, ink| high.max(*ink))
                - ink.iter().fold(1.0_f32, |low, ink| low.min(*ink))
        };
        // 40 of 256 grays with a slope of 2.56.
        assert!(
            range(&plain) < 0.2 && (0.3..0.5).contains(&range(&even)),
            "{} {}",
            range(&plain),
            range(&even)
        );
        let darker = (0..64 * 63).filter(|px| picture.values[*px] < picture.values[px + 64]);
        assert!(darker.into_iter().all(|px| even[px] > even[px + 64] - 0.05));
    }
}
