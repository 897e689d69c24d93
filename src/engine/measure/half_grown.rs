//! Half-grown marks: pattern values that are neither ground nor mark.
//!
//! The pattern is 0 on the ground, ½ at the edge of a mark and 1 in its middle. Where a stripe ends, its axis passes through all
//! values within about two widths. Where the axis stays between ground and mark for longer, the stripe has not formed, and appears
//! as a gray area in a picture. The same holds for a spot whose highest value is too low.

use rayon::prelude::*;

use crate::grid::{Edges, Field};
use crate::measure::Spot;

/// On the ground the pattern at the axis of a mark is below the first of these values; in a mark that has formed it is above the
/// second.
const BETWEEN: [f32; 2] = [0.2, 0.8];
/// Least difference between the axis and the places beside it. Not tuned.
const HIGHER: f32 = 0.05;
/// Distance of these places from the axis, in widths: the stripe extends to half a width. At a quarter, stripes of half the height
/// could not be distinguished from flat ground if their axis lay between two cells.
const BESIDE: f64 = 0.35;
/// At the tip of a stripe the axis passes from above the second of these values to below the first: the piece begins near one end
/// of [`BETWEEN`] and ends near the other. Not tuned.
const TIP: [f32; 2] = [0.35, 0.65];
/// Largest length of a tip, in widths: in the examples of stripes and lines it is 1.0 to 1.7.
const TAPER: f64 = 2.0;
/// A spot with a smaller share of the asked area than this is half grown.
const SMALLEST: f64 = 0.5;

/// A piece of the axis of a stripe that is neither ground nor mark.
#[derive(Clone, Debug, PartialEq)]
pub struct FadedAxis {
    /// A place in its middle, px.
    pub at: [f64; 2],
    /// Length from end to end, px.
    pub length: f64,
}

/// The pieces of stripes whose axis stays between ground and mark over more than the width of the stripe, or over more than twice
/// the width at the tip of a stripe. `width` gives the width of the stripes wanted at a place, px; `None` where none are wanted.
#[must_use]
pub fn faded_axes(pattern: &Field, width: &(dyn Fn([f64; 2]) -> Option<f64> + Sync)) -> Vec<FadedAxis> {
    let cells = pattern.width * pattern.height;
    let on_axis: Vec<bool> = (0..cells)
        .into_par_iter()
        .map(|cell| is_on_axis(pattern, cell, &|| width(center(pattern, cell))))
        .collect();
    let mut seen = vec![false; cells];
    let mut found = Vec::new();
    for start in 0..cells {
        if on_axis[start] && !seen[start] {
            let piece = piece_from(pattern, start, &on_axis, &mut seen);
            found.extend(faded(pattern, &piece, width));
        }
    }
    found
}

/// A piece of an axis that is longer than allowed; `None` for other pieces. Its cells are columns and rows.
fn faded(pattern: &Field, piece: &[[i64; 2]], width: &dyn Fn([f64; 2]) -> Option<f64>) -> Option<FadedAxis> {
    let cell_of = |[x, y]: [i64; 2]| {
        let (column, row) = (x.rem_euclid(pattern.width as i64), y.rem_euclid(pattern.height as i64));
        row as usize * pattern.width + column as usize
    };
    let apart = |a: [i64; 2], b: [i64; 2]| {
        let [x, y] = [0, 1].map(|axis| (a[axis] - b[axis]) as f64 * pattern.cell[axis]);
        libm::hypot(x, y)
    };
    let farthest = |from: [i64; 2]| {
        let far = piece.iter().copied().max_by(|a, b| apart(*a, from).total_cmp(&apart(*b, from)));
        far.unwrap_or(from)
    };
    let one = farthest(piece[0]);
    let other = farthest(one);
    let length = apart(one, other) + (pattern.cell[0] * pattern.cell[1]).sqrt();
    let ends = [one, other].map(|end| pattern.values[cell_of(end)]);
    let is_tip = ends[0].min(ends[1]) < TIP[0] && ends[0].max(ends[1]) > TIP[1];
    let at = center(pattern, cell_of(piece[piece.len() / 2]));
    let longest = if is_tip { TAPER } else { 1.0 } * width(at)?;
    (length > longest).then_some(FadedAxis { at, length })
}

/// The centre of a cell, px.
fn center(field: &Field, cell: usize) -> [f64; 2] {
    let place = [cell % field.width, cell / field.width];
    [0, 1].map(|axis| (place[axis] as f64 + 0.5) * field.cell[axis])
}

/// The centres, px, of the whole spots that are too low, or smaller than half of the `asked` area at their place.
#[must_use]
pub fn half_grown_spots(spots: &[Spot], asked: &dyn Fn([f64; 2]) -> Option<f64>) -> Vec<[f64; 2]> {
    let is_half = |spot: &&Spot| {
        let small = asked(spot.ellipse.center).is_some_and(|area| spot.ellipse.area() < SMALLEST * area);
        spot.whole && (spot.peak < BETWEEN[1] || small)
    };
    spots.iter().filter(is_half).map(|spot| spot.ellipse.center).collect()
}

/// Whether a cell lies on the axis of a mark that is neither ground nor mark there.
fn is_on_axis(pattern: &Field, cell: usize, width: &dyn Fn() -> Option<f64>) -> bool {
    let value = pattern.values[cell];
    if !(BETWEEN[0]..BETWEEN[1]).contains(&value) {
        return false;
    }
    let [x, y] = [cell % pattern.width, cell / pattern.width];
    let inside =
        |k: usize, count: usize| pattern.edges == Edges::Wrap || (2..count.saturating_sub(2)).contains(&k);
    if !inside(x, pattern.width) || !inside(y, pattern.height) {
        return false;
    }
    let near = |dx: isize, dy: isize| {
        let column = pattern.edges.index(x as isize + dx, pattern.width);
        pattern.values[pattern.edges.index(y as isize + dy, pattern.height) * pattern.width + column]
    };
    // The direction of the most negative curvature is the one across the stripe.
    let xx = near(1, 0) - 2.0 * value + near(-1, 0);
    let yy = near(0, 1) - 2.0 * value + near(0, -1);
    let xy = 0.25 * (near(1, 1) - near(-1, 1) - near(1, -1) + near(-1, -1));
    let Some(across) = across(f64::from(xx), f64::from(yy), f64::from(xy)) else { return false };
    let Some(width) = width() else { return false };
    let cell = (pattern.cell[0] * pattern.cell[1]).sqrt();
    let beside = |by: f64| {
        let to = [0, 1].map(|axis| [x, y][axis] as f64 + by * across[axis]);
        [between(pattern, to), between(pattern, [0, 1].map(|axis| 2.0 * [x, y][axis] as f64 - to[axis]))]
    };
    let far = (BESIDE * width / cell).max(1.5);
    beside(1.0).iter().all(|other| *other <= value) && beside(far).iter().all(|other| value - other > HIGHER)
}

/// The unit direction of the most negative curvature; `None` where none is negative.
fn across(xx: f64, yy: f64, xy: f64) -> Option<[f64; 2]> {
    let half = 0.5 * (xx - yy);
    let root = libm::hypot(half, xy);
    if 0.5 * (xx + yy) - root >= 0.0 {
        return None;
    }
    // An eigenvector of the smaller eigenvalue of [[xx, xy], [xy, yy]].
    let [a, b] = if half > 0.0 { [-xy, half + root] } else { [root - half, -xy] };
    let length = libm::hypot(a, b);
    Some(if length > 0.0 { [a / length, b / length] } else { [1.0, 0.0] })
}

/// The field between the centres of its cells, bilinear; `at` in cells from the first centre.
fn between(field: &Field, at: [f64; 2]) -> f32 {
    let low = at.map(f64::floor);
    let share = [0, 1].map(|axis| (at[axis] - low[axis]) as f32);
    let value = |dx: isize, dy: isize| {
        let column = field.edges.index(low[0] as isize + dx, field.width);
        field.values[field.edges.index(low[1] as isize + dy, field.height) * field.width + column]
    };
    let row = |dy: isize| value(0, dy) + share[0] * (value(1, dy) - value(0, dy));
    row(0) + share[1] * (row(1) - row(0))
}

/// The cells connected to `start` by sides or corners, as columns and rows that continue beyond a border that wraps.
fn piece_from(pattern: &Field, start: usize, on_axis: &[bool], seen: &mut [bool]) -> Vec<[i64; 2]> {
    let [nx, ny] = [pattern.width as i64, pattern.height as i64];
    seen[start] = true;
    let mut piece = vec![[start as i64 % nx, start as i64 / nx]];
    let mut next = 0;
    while let Some([x, y]) = piece.get(next).copied() {
        next += 1;
        for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
            let (to_x, to_y) = (x + dx, y + dy);
            let outside = !(0..nx).contains(&to_x) || !(0..ny).contains(&to_y);
            if pattern.edges != Edges::Wrap && outside {
                continue;
            }
            let cell = (to_y.rem_euclid(ny) * nx + to_x.rem_euclid(nx)) as usize;
            if on_axis[cell] && !seen[cell] {
                seen[cell] = true;
                piece.push([to_x, to_y]);
            }
        }
    }
    piece
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stripes along x, 20 px apart and 10 px wide. The one at y = 30 has only the height `height` for x from 40 to 40 + `length`.
    fn stripes(height: f32, length: f64, edges: Edges) -> Field {
        Field::from_fn([120, 60], [1.0, 1.0], edges, |[x, y]| {
            let wave = (0.5 - 0.5 * libm::cos(std::f64::consts::TAU * y / 20.0)) as f32;
            let low = (20.0..40.0).contains(&y) && (40.0..40.0 + length).contains(&x);
            if low { height * wave } else { wave }
        })
    }

    #[test]
    fn a_stripe_that_stays_between_ground_and_mark_for_longer_than_its_width_is_found() {
        let found = |height, length| faded_axes(&stripes(height, length, Edges::Wrap), &|_| Some(10.0));
        assert_eq!(found(1.0, 30.0), []);
        assert_eq!(found(0.5, 6.0), []);
        let [FadedAxis { at: [x, y], length }] = found(0.5, 30.0)[..] else {
            panic!("{:?}", found(0.5, 30.0))
        };
        assert!((x - 55.0).abs() < 16.0 && (y - 30.0).abs() < 2.0, "{x} {y}");
        assert!((length - 30.0).abs() < 3.0, "{length}");
        // Lower values are ground, and higher ones a mark.
        assert!(found(0.1, 30.0).is_empty() && found(0.9, 30.0).is_empty());
    }

    #[test]
    fn a_tip_may_taper_for_two_widths() {
        // The stripe at y = 30 falls from 1 to 0 from x = 40 on.
        let tapered = |length: f64| {
            let field = Field::from_fn([120, 60], [1.0, 1.0], Edges::Wrap, |[x, y]| {
                let wave = (0.5 - 0.5 * libm::cos(std::f64::consts::TAU * y / 20.0)) as f32;
                let height = (1.0 - (x - 40.0) / length).clamp(0.0, 1.0) as f32;
                if (20.0..40.0).contains(&y) { height * wave } else { wave }
            });
            faded_axes(&field, &|_| Some(10.0)).len()
        };
        // Between 0.8 and 0.2 it is 0.6 of that long.
        assert_eq!([tapered(20.0), tapered(30.0)], [0, 0]);
        assert_eq!(tapered(45.0), 1);
    }

    #[test]
    fn a_piece_across_the_border_of_a_tile_is_one() {
        let mut field = stripes(0.5, 30.0, Edges::Wrap);
        for row in field.values.chunks_mut(120) {
            row.rotate_left(55);
        }
        assert_eq!(faded_axes(&field, &|_| Some(10.0)).len(), 1);
    }

    #[test]
    fn spots_that_are_low_or_small_are_found() {
        let spot = |x: f64, area: f64, peak: f32| Spot {
            ellipse: crate::marks::Ellipse::from_area([x, 0.0], area, 1.0, 0.0),
            whole: true,
            endless: false,
            contour: 1.0,
            fill: 1.0,
            peak,
        };
        let spots = [spot(1.0, 100.0, 1.0), spot(2.0, 100.0, 0.7), spot(3.0, 40.0, 1.0)];
        let found = half_grown_spots(&spots, &|_| Some(100.0));
        assert_eq!(found.iter().map(|at| at[0]).collect::<Vec<_>>(), [2.0, 3.0]);
    }
}
