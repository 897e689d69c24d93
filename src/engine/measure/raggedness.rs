//! Raggedness: the squared ratio of the length of an outline to that of the ellipse with equal moments.
//!
//! ```text
//! raggedness = (contour ÷ contour of the ellipse)²
//! ```
//! with the ellipse that has the outline's area, aspect and second moments: 1 for ellipses, 1.15–1.25 for a square, 2 and more for
//! fringes. The outline is first smoothed along itself by a Gaussian of 0.05·√area, so that px and the unsteadiness of a hand have
//! no effect; area and moments are those of the smoothed outline, so that ellipses still have 1.

use std::f64::consts::PI;

use crate::grid::marching_squares::lines;
use crate::grid::{Edges, Field};
use crate::marks::Moments;
use crate::measure::spots::{SPECK_CELLS, SPECK_SHARE, usual_area};

/// Standard deviation of the smoothing along the outline, √area.
const SMOOTHING: f64 = 0.05;
/// Points of the smoothed outline per standard deviation: its chords are then shorter than the finest details that remain.
const STEPS: f64 = 4.0;
/// The Gaussian is cut here, standard deviations.
const CUT: f64 = 3.5;
/// Fewest points of an outline.
const LEAST: usize = 48;
/// Most points of an outline: one a hundred times as long as that of a disc is not a spot.
const MOST: usize = 20_000;

/// The raggedness of the closed polygon with these corners, px; the last is joined to the first. `None` if it encloses no area.
///
/// ```
/// use dapple_engine::measure::raggedness;
///
/// let disc: Vec<[f64; 2]> = (0..90)
///     .map(|k| (f64::from(k) / 90.0 * std::f64::consts::TAU).sin_cos())
///     .map(|(sin, cos)| [20.0 * cos, 20.0 * sin])
///     .collect();
/// assert!((raggedness(&disc).unwrap() - 1.0).abs() < 0.01);
/// ```
#[must_use]
pub fn raggedness(corners: &[[f64; 2]]) -> Option<f64> {
    let area = Moments::polygon(corners).area.abs();
    if corners.len() < 3 || !(area > 0.0 && area.is_finite()) {
        return None;
    }
    let sigma = SMOOTHING * area.sqrt();
    let length = perimeter(corners);
    let count = ((STEPS * length / sigma).ceil() as usize).clamp(LEAST, MOST);
    let smooth = smoothed(&resampled(corners, length, count), sigma * count as f64 / length);
    let moments = Moments::polygon(&smooth);
    let (_, [xx, xy, yy]) = moments.central();
    let apart = (0.25 * (xx - yy) * (xx - yy) + xy * xy).sqrt();
    let mean = 0.5 * (xx + yy);
    let aspect = ((mean - apart).max(0.0) / (mean + apart)).sqrt();
    let ratio = perimeter(&smooth) / ellipse(moments.area.abs(), aspect.max(1e-6));
    Some(ratio * ratio)
}

/// The raggedness of each whole spot above `level`: regions that touch no closed edge and are not endless, without specks and
/// holes. In reading order of their first row.
#[must_use]
pub fn spot_raggedness(field: &Field, level: f32) -> Vec<f64> {
    spot_raggedness_at(field, level).into_iter().map(|(_, raggedness)| raggedness).collect()
}

/// The raggedness of each whole spot above `level` with its centroid, px of the canvas.
#[must_use]
pub fn spot_raggedness_at(field: &Field, level: f32) -> Vec<([f64; 2], f64)> {
    let loops: Vec<(f64, Vec<[f64; 2]>)> = outlines(field, level);
    let usual = usual_area(loops.iter().map(|(area, _)| *area));
    let least = (SPECK_SHARE * usual).max(SPECK_CELLS * field.cell[0] * field.cell[1]);
    let bounds = field.grid().bounds_px();
    let of_loop = |(_, corners): &(f64, Vec<[f64; 2]>)| {
        let (center, _) = Moments::polygon(corners).central();
        Some((bounds.inside(center), raggedness(corners)?))
    };
    loops.iter().filter(|(area, _)| *area >= least).filter_map(of_loop).collect()
}

/// Contour of the ellipse with this area and aspect: Ramanujan's second formula, exact to 10⁻⁵ from an aspect of .1 on.
fn ellipse(area: f64, aspect: f64) -> f64 {
    let minor = (area * aspect / PI).sqrt();
    let major = minor / aspect;
    let h = ((major - minor) / (major + minor)).powi(2);
    PI * (major + minor) * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()))
}

fn perimeter(corners: &[[f64; 2]]) -> f64 {
    let next = corners.iter().cycle().skip(1);
    corners.iter().zip(next).map(|(a, b)| libm::hypot(b[0] - a[0], b[1] - a[1])).sum()
}

/// `count` points at equal distances along a closed polygon.
fn resampled(corners: &[[f64; 2]], length: f64, count: usize) -> Vec<[f64; 2]> {
    let mut points = Vec::with_capacity(count);
    let step = length / count as f64;
    let mut passed = 0.0;
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let side = libm::hypot(b[0] - a[0], b[1] - a[1]);
        while points.len() < count && points.len() as f64 * step < passed + side {
            let t = (points.len() as f64 * step - passed) / side;
            points.push([0, 1].map(|axis| a[axis] + t * (b[axis] - a[axis])));
        }
        passed += side;
    }
    // The last point may be lost by rounding.
    points.resize(count, corners[0]);
    points
}

/// A closed row of points, each the mean of its neighbours by a Gaussian of `sigma` steps.
fn smoothed(points: &[[f64; 2]], sigma: f64) -> Vec<[f64; 2]> {
    let reach = ((CUT * sigma).ceil() as usize).min(points.len() / 2);
    let kernel: Vec<f64> =
        (0..=2 * reach).map(|k| libm::exp(-0.5 * ((k as f64 - reach as f64) / sigma).powi(2))).collect();
    let total: f64 = kernel.iter().sum();
    let count = points.len();
    let at = |k: usize| {
        let mut sum = [0.0; 2];
        for (j, weight) in kernel.iter().enumerate() {
            let point = points[(k + count + j - reach) % count];
            sum = [sum[0] + weight * point[0], sum[1] + weight * point[1]];
        }
        sum.map(|sum| sum / total)
    };
    (0..count).map(at).collect()
}

/// No line continues from here.
const NOWHERE: u32 = u32::MAX;

/// The closed level lines around regions above `level`, each with the area inside, px². Lines around holes, lines that reach a
/// closed edge and lines that go around a tile are left out.
///
/// Marching squares between the cells' centres; a line leaves a square where it enters the next one, with the region on its
/// right. Of two opposite corners above the level, both are joined where the mean of all four is above it.
fn outlines(field: &Field, level: f32) -> Vec<(f64, Vec<[f64; 2]>)> {
    let (nx, ny) = (field.width, field.height);
    let wraps = field.edges == Edges::Wrap;
    let squares = if wraps { [nx, ny] } else { [nx.saturating_sub(1), ny.saturating_sub(1)] };
    // Sides of squares: 2·cell is the one to the right of the cell's centre, 2·cell + 1 the one downwards.
    let mut next = vec![NOWHERE; 2 * nx * ny];
    for y in 0..squares[1] {
        for x in 0..squares[0] {
            let (right, down) = ((x + 1) % nx, (y + 1) % ny);
            let cells = [y * nx + x, y * nx + right, down * nx + right, down * nx + x];
            let above = cells.map(|cell| field.values[cell] > level);
            if above == [above[0]; 4] {
                continue;
            }
            let sides = [2 * cells[0], 2 * cells[1] + 1, 2 * cells[3], 2 * cells[0] + 1];
            let joined = cells.iter().map(|cell| field.values[*cell]).sum::<f32>() > 4.0 * level;
            for [enter, leave] in lines(above, || joined) {
                next[sides[enter]] = sides[leave] as u32;
            }
        }
    }
    let mut found = Vec::new();
    for start in 0..next.len() {
        if let Some(corners) = follow(field, level, &mut next, start) {
            let area = Moments::polygon(&corners).area;
            if area > 0.0 {
                found.push((area, corners));
            }
        }
    }
    found
}

/// The line from side `start` on, px, continued without breaks across the borders of a tile; `None` unless it comes back to its
/// start.
fn follow(field: &Field, level: f32, next: &mut [u32], start: usize) -> Option<Vec<[f64; 2]>> {
    if next[start] == NOWHERE {
        return None;
    }
    let extent = field.extent();
    let mut corners: Vec<[f64; 2]> = Vec::new();
    let mut side = start;
    loop {
        let mut at = crossing(field, level, side);
        if let Some(last) = corners.last() {
            for axis in 0..2 {
                at[axis] -= extent[axis] * ((at[axis] - last[axis]) / extent[axis]).round();
            }
        }
        corners.push(at);
        let to = std::mem::replace(&mut next[side], NOWHERE);
        if to == NOWHERE {
            return None;
        }
        side = to as usize;
        if side == start {
            break;
        }
    }
    let (first, last) = (corners[0], corners[corners.len() - 1]);
    let closed = (0..2).all(|axis| (first[axis] - last[axis]).abs() < 0.5 * extent[axis]);
    closed.then_some(corners)
}

/// The point at which the level is reached on a side between the centres of two cells, px.
fn crossing(field: &Field, level: f32, side: usize) -> [f64; 2] {
    let (cell, axis) = (side / 2, side % 2);
    let mut at = [cell % field.width, cell / field.width];
    let here = f64::from(field.values[cell]);
    let corner = at.map(|k| k as f64 + 0.5);
    at[axis] = (at[axis] + 1) % [field.width, field.height][axis];
    let there = f64::from(field.values[at[1] * field.width + at[0]]);
    let mut place = corner;
    place[axis] += (f64::from(level) - here) / (there - here);
    [place[0] * field.cell[0], place[1] * field.cell[1]]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(count: usize, radius: impl Fn(f64) -> f64, aspect: f64) -> Vec<[f64; 2]> {
        let at = |k: usize| {
            let turn = 2.0 * PI * k as f64 / count as f64;
            let (s, c) = libm::sincos(turn);
            [radius(turn) * c, aspect * radius(turn) * s]
        };
        (0..count).map(at).collect()
    }

    #[test]
    fn ellipses_have_1_whatever_their_aspect() {
        for aspect in [1.0, 0.7, 0.4, 0.25] {
            let found = raggedness(&polygon(300, |_| 40.0, aspect)).expect("an area");
            assert!((found - 1.0).abs() < 0.004, "{aspect}: {found}");
        }
    }

    #[test]
    fn known_shapes_have_the_values_worked_out_by_hand() {
        // Without smoothing: for a square 16 ÷ 4π = 1.273, for a flower of seven petals the ratio of the integrals.
        let square = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        let found = raggedness(&square).expect("an area");
        assert!((1.15..1.26).contains(&found), "{found}");
        let flower = polygon(4_000, |turn| 40.0 * (1.0 + 0.25 * libm::cos(7.0 * turn)), 1.0);
        let rough = perimeter(&flower).powi(2) / (4.0 * PI * Moments::polygon(&flower).area);
        let found = raggedness(&flower).expect("an area");
        assert!(found > 0.75 * rough && found < rough, "{found}, {rough}");
        // The finer the fringe, the more of it the smoothing removes.
        let fringe = |petals: f64| polygon(8_000, |turn| 40.0 * (1.0 + 0.04 * libm::cos(petals * turn)), 1.0);
        let [coarse, fine] = [7.0, 60.0].map(|petals| raggedness(&fringe(petals)).expect("an area"));
        assert!(coarse > 1.02 && fine < 1.01, "{coarse}, {fine}");
    }

    #[test]
    fn size_place_direction_and_order_of_corners_do_not_matter() {
        let shape = polygon(500, |turn| 30.0 * (1.0 + 0.3 * libm::cos(5.0 * turn)), 0.6);
        let expected = raggedness(&shape).expect("an area");
        let (s, c) = libm::sincos(0.7);
        let moved: Vec<[f64; 2]> =
            shape.iter().rev().map(|[x, y]| [9.0 + 3.0 * (c * x - s * y), 3.0 * (s * x + c * y)]).collect();
        assert!((raggedness(&moved).expect("an area") / expected - 1.0).abs() < 1e-3);
        assert_eq!(raggedness(&shape[..2]), None);
        assert_eq!(raggedness(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), None);
    }

    /// A smooth field whose level line ½ is the flower about each of `centers`.
    fn flowers(centers: &[[f64; 2]], depth: f64, edges: Edges) -> Field {
        let tile = Field::flat(160, 120, edges, 0.0).grid().bounds();
        Field::from_fn([160, 120], [1.0, 1.0], edges, |at| {
            let value = |center: &[f64; 2]| {
                let way = tile.shortest([at[0] - center[0], at[1] - center[1]]);
                let turn = libm::atan2(way[1], way[0]);
                0.5 + (20.0 * (1.0 + depth * libm::cos(5.0 * turn)) - libm::hypot(way[0], way[1])) / 40.0
            };
            centers.iter().map(value).fold(0.0, f64::max) as f32
        })
    }

    #[test]
    fn a_field_s_spots_have_the_raggedness_of_their_outlines() {
        for depth in [0.0, 0.25] {
            let drawn = polygon(800, |turn| 20.0 * (1.0 + depth * libm::cos(5.0 * turn)), 1.0);
            let expected = raggedness(&drawn).expect("an area");
            let closed = spot_raggedness(&flowers(&[[40.0, 60.0], [110.0, 61.5]], depth, Edges::Closed), 0.5);
            // The second lies across all borders of the tile.
            let tile = spot_raggedness(&flowers(&[[80.0, 60.0], [0.5, 0.5]], depth, Edges::Wrap), 0.5);
            assert_eq!((closed.len(), tile.len()), (2, 2));
            for found in closed.into_iter().chain(tile) {
                assert!((found / expected - 1.0).abs() < 0.02, "{depth}: {found}, {expected}");
            }
        }
    }

    #[test]
    fn squares_that_meet_at_a_corner_are_joined_where_the_mean_is_above_the_level() {
        let squares = |high: f32| {
            Field::from_fn([40, 40], [1.0, 1.0], Edges::Closed, |[x, y]| {
                let inside = (5.0..20.0).contains(&x) && (5.0..20.0).contains(&y);
                let other = (20.0..35.0).contains(&x) && (20.0..35.0).contains(&y);
                if inside || other { high } else { 0.0 }
            })
        };
        assert_eq!((outlines(&squares(1.2), 0.5).len(), outlines(&squares(0.8), 0.5).len()), (1, 2));
    }

    #[test]
    fn cut_spots_holes_specks_and_bands_round_a_tile_do_not_count() {
        let cut = flowers(&[[40.0, 60.0], [158.0, 61.5]], 0.1, Edges::Closed);
        assert_eq!(spot_raggedness(&cut, 0.5).len(), 1);
        let mut ring = flowers(&[[60.0, 60.0]], 0.0, Edges::Closed);
        ring.values.iter_mut().filter(|value| **value > 0.8).for_each(|value| *value = 0.0);
        assert_eq!(spot_raggedness(&ring, 0.5).len(), 1);
        let band = Field::from_fn([60, 40], [1.0, 1.0], Edges::Wrap, |[_, y]| f32::from(u8::from(y < 20.0)));
        assert!(spot_raggedness(&band, 0.5).is_empty());
        let mut speck = flowers(&[[60.0, 60.0]], 0.0, Edges::Closed);
        [5, 6, 165, 166].iter().for_each(|cell| speck.values[*cell + 1600] = 1.0);
        assert_eq!(spot_raggedness(&speck, 0.5).len(), 1);
    }
}
