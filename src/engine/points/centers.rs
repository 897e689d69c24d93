//! The centres of patches and cells: discs at the wanted spacing, moved apart a little.

use rand::Rng;

use crate::attributes::spacing::{mean_length, weighted_edges};
use crate::grid::{Bounds, Edges, IN_A_BUCKET, PointBuckets};
use crate::points::discs::{Laying, POINTS_A_SQUARE, poisson_discs};
use crate::points::extent::Extent;
use crate::points::metric::Metric;

/// Width of the frame beyond closed borders in which centres are laid too, in spacings: nearly two rows. The outer row keeps the
/// inner one in place.
const FRAME: f64 = 1.7;
/// The least aspect that widens the frame: longer ellipses get the same frame.
pub const LONGEST: f64 = 0.15;
/// Number of sampled places along each side.
const SAMPLES: usize = 16;

/// The distance of neighbours around a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pitch {
    /// Distance of neighbours, px.
    pub spacing: f64,
    /// Shortest ÷ longest distance, 0..1.
    pub aspect: f64,
    /// Direction of the longest distance, degrees.
    pub angle: f64,
}

/// The largest value of `of` for the wanted properties, sampled over the canvas.
pub fn largest<T>(extent: &Extent, wanted: &dyn Fn([f64; 2]) -> T, of: impl Fn(&T) -> f64) -> f64 {
    let place = |index: usize| [index % SAMPLES, index / SAMPLES].map(|k| (k as f64 + 0.5) / SAMPLES as f64);
    let at = |index: usize| {
        let [x, y] = place(index);
        of(&wanted([x * extent.size[0], y * extent.size[1]]))
    };
    (0..SAMPLES * SAMPLES).map(at).fold(0.0, f64::max)
}

/// Rounds of repulsion. Few, so that the centres stay as irregular as on an animal; a lattice looks artificial.
const ROUNDS: usize = 4;
/// Neighbours closer than this, in pitches, push each other.
const PUSH: f64 = 1.25;

/// Largest distance between two points in the metric of one of them ÷ root mean square of their distances in both metrics: √2 and a
/// margin for rounding.
const MUTUAL: f64 = 1.415;

/// Accuracy with which centres are laid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effort {
    /// Attempts with different numbers of centres; the nearest result is taken.
    pub tries: usize,
    /// Relative error of the spacing below which no further attempt is made.
    pub close: f64,
}

/// Width of the frame beyond closed borders in which centres are laid too, px.
fn frame(extent: &Extent, wanted: &dyn Fn([f64; 2]) -> Pitch) -> f64 {
    // Along the major axis neighbours are farther apart.
    FRAME * largest(extent, wanted, |wanted| wanted.spacing / wanted.aspect.clamp(LONGEST, 1.0).sqrt())
}

/// The cost of laying centres, for the first attempt.
#[must_use]
pub fn laying(extent: &Extent, wanted: &dyn Fn([f64; 2]) -> Pitch) -> Laying {
    Laying::new(extent, frame(extent, wanted), &|at| disc(&wanted(at), 1.0))
}

/// Upper bound of the number of comparisons of two centres while they are laid: each is compared with those in its bucket and in
/// the eight buckets around it.
#[must_use]
pub fn compared(extent: &Extent, wanted: &dyn Fn([f64; 2]) -> Pitch, effort: Effort) -> f64 {
    let Laying { points, crowding, .. } = laying(extent, wanted);
    points * (9.0 * IN_A_BUCKET * crowding).min(points) * (ROUNDS * effort.tries) as f64
}

/// The disc of a centre, with all distances multiplied by `scale`. There are as many discs as a hexagonal lattice has points: .7 ÷
/// r² = 2 ÷ (√3·pitch²).
fn disc(wanted: &Pitch, scale: f64) -> Metric {
    let share = (POINTS_A_SQUARE * 0.75f64.sqrt()).sqrt();
    Metric::ellipse(share * scale * wanted.spacing, wanted.aspect, wanted.angle)
}

/// Centres over the canvas and its frame at the wanted spacing, around the `pinned` points, which are not part of the result.
/// `ratio` gets all centres, the pinned ones first, and returns the factor by which they are too far apart.
pub fn lay(
    extent: &Extent,
    wanted: &dyn Fn([f64; 2]) -> Pitch,
    pinned: &[[f64; 2]],
    ratio: &dyn Fn(&[[f64; 2]]) -> f64,
    effort: Effort,
    rng: &mut impl Rng,
) -> Vec<[f64; 2]> {
    let frame = frame(extent, wanted);
    let mut scale = 1.0;
    let mut best: (f64, Vec<[f64; 2]>) = (f64::INFINITY, Vec::new());
    for _ in 0..effort.tries {
        // The pitch: distance of neighbours in a hexagonal lattice.
        let metric = |at: [f64; 2]| {
            let wanted = wanted(at);
            Metric::ellipse(scale * wanted.spacing, wanted.aspect, wanted.angle)
        };
        let disc = |at: [f64; 2]| disc(&wanted(at), scale);
        let mut points = poisson_discs(extent, frame, &disc, pinned, rng);
        for _ in 0..ROUNDS {
            points = pushed(&points, pinned.len(), extent, frame, &metric);
        }
        let ratio = ratio(&points);
        let off = libm::log(ratio).abs();
        if off < best.0 {
            best = (off, points);
        }
        if off < effort.close {
            break;
        }
        scale /= ratio;
    }
    best.1.split_off(pinned.len().min(best.1.len()))
}

/// Mean of the lengths of the edges ÷ the spacing wanted at their midpoints; 1 if there is no edge on the canvas.
pub fn ratio_of_spacings(points: &[[f64; 2]], extent: &Extent, wanted: &dyn Fn([f64; 2]) -> Pitch) -> f64 {
    let tile = (extent.wrap == [true; 2]).then_some(extent.size);
    let mut edges = weighted_edges(points, tile, |at| wanted(at).spacing);
    edges.retain(|edge| (0..2).all(|axis| (0.0..=extent.size[axis]).contains(&edge.midpoint[axis])));
    edges.iter_mut().for_each(|edge| edge.length /= wanted(edge.midpoint).spacing);
    mean_length(&edges).unwrap_or(1.0)
}

/// One round: points nearer than [`PUSH`] pitches push each other away; the first `fixed` stay.
fn pushed(
    points: &[[f64; 2]],
    fixed: usize,
    extent: &Extent,
    frame: f64,
    metric: &dyn Fn([f64; 2]) -> Metric,
) -> Vec<[f64; 2]> {
    let metrics: Vec<Metric> = points.iter().map(|at| metric(*at)).collect();
    let reach = PUSH * metrics.iter().map(|metric| metric.half[0].max(metric.half[1])).fold(0.0, f64::max);
    let [low, high] = extent.framed(frame);
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|a, b| points[*a][1].total_cmp(&points[*b][1]).then(a.cmp(b)));
    let mut rank = vec![0; points.len()];
    order.into_iter().enumerate().for_each(|(place, index)| rank[index] = place);
    let edges = if extent.wrap == [true; 2] { Edges::Wrap } else { Edges::Closed };
    let places = PointBuckets::new(Bounds { size: extent.size, edges }, points.to_vec());
    let push = |index: usize| {
        let (at, own) = (points[index], &metrics[index]);
        // d² ≥ ½·own², so points farther away cannot repel it. Summed by rows, so that the sums do not depend on the order of the
        // search.
        let mut near = places.within(at, MUTUAL * PUSH * own.half[0].max(own.half[1]));
        near.sort_unstable_by_key(|other| rank[*other as usize]);
        let mut shift = [0.0; 2];
        // The points in the rows within reach; on a tile, their images too.
        for rows in
            [0.0, -extent.size[1], extent.size[1]].into_iter().filter(|rows| *rows == 0.0 || extent.wrap[1])
        {
            let swept = at[1] - reach + rows..=at[1] + reach + rows;
            let near = near.iter().map(|other| *other as usize).filter(|other| *other != index);
            for other in near.filter(|other| swept.contains(&points[*other][1])) {
                let displacement = extent.shortest([points[other][0] - at[0], points[other][1] - at[1]]);
                let d = (0.5 * (own.square(displacement) + metrics[other].square(displacement))).sqrt();
                if d > 1e-9 && d < PUSH {
                    // Half of the gap, because the other point moves too, damped for six neighbours.
                    let push = 0.22 * (PUSH - d) / d;
                    shift = [shift[0] - push * displacement[0], shift[1] - push * displacement[1]];
                }
            }
        }
        let to = extent.folded([at[0] + shift[0], at[1] + shift[1]]);
        [0, 1].map(|axis| if extent.wrap[axis] { to[axis] } else { to[axis].clamp(low[axis], high[axis]) })
    };
    (0..points.len()).map(|index| if index < fixed { points[index] } else { push(index) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Reference for [`pushed`]: compares all points.
    fn pushed_by_all(
        points: &[[f64; 2]],
        extent: &Extent,
        frame: f64,
        metric: &dyn Fn([f64; 2]) -> Metric,
    ) -> Vec<[f64; 2]> {
        let metrics: Vec<Metric> = points.iter().map(|at| metric(*at)).collect();
        let [low, high] = extent.framed(frame);
        let moved = |index: usize| {
            let mut shift = [0.0; 2];
            for other in (0..points.len()).filter(|other| *other != index) {
                let displacement =
                    extent.shortest([0, 1].map(|axis| points[other][axis] - points[index][axis]));
                let d = (0.5 * (metrics[index].square(displacement) + metrics[other].square(displacement)))
                    .sqrt();
                if d > 1e-9 && d < PUSH {
                    let push = 0.22 * (PUSH - d) / d;
                    shift = [0, 1].map(|axis| shift[axis] - push * displacement[axis]);
                }
            }
            let to = extent.folded([0, 1].map(|axis| points[index][axis] + shift[axis]));
            [0, 1]
                .map(|axis| if extent.wrap[axis] { to[axis] } else { to[axis].clamp(low[axis], high[axis]) })
        };
        (0..points.len()).map(moved).collect()
    }

    #[test]
    fn large_points_push_all_small_points_near_them() {
        let number = |i: usize, step: f64| (0.5 + step * i as f64).fract();
        let points: Vec<[f64; 2]> =
            (0..120).map(|i| [90.0 * number(i, 0.754_877_7), 70.0 * number(i, 0.569_840_3)]).collect();
        let metric = |at: [f64; 2]| Metric::ellipse(if at[0] < 15.0 { 20.0 } else { 6.0 }, 0.5, at[1]);
        for wrap in [[false; 2], [true; 2]] {
            let extent = Extent { size: [90.0, 70.0], wrap };
            let [found, expected] =
                [pushed(&points, 0, &extent, 9.0, &metric), pushed_by_all(&points, &extent, 9.0, &metric)];
            for (found, expected) in found.iter().zip(&expected) {
                let displacement = extent.shortest([found[0] - expected[0], found[1] - expected[1]]);
                assert!(
                    libm::hypot(displacement[0], displacement[1]) < 1e-9,
                    "{wrap:?}: {found:?}, {expected:?}"
                );
            }
        }
    }
}
