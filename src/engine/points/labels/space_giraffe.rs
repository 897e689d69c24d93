//! The space giraffe: rays of two points each, the inner one dark and the outer one light, round each centre (the paper's figure
//! 12).

use std::ops::Range;

use rand::{Rng, RngExt};

use crate::points::delaunay::Delaunay;
use crate::points::graph::PointGraph;

/// Radii of the points, in halves of the distance to the nearest centre. The paper prints 0–1, which breaks into fragments.
const RADII: Range<f64> = 0.5..1.0;

/// Points and labels for cells round the points of `centers`: each centre, and the points of its rays ([`ray_points`]).
pub fn space_giraffe(
    centers: &Delaunay,
    rays: &Range<usize>,
    rng: &mut impl Rng,
) -> (Vec<[f64; 2]>, Vec<bool>) {
    let (mut points, mut labels) = (Vec::new(), Vec::new());
    for (index, [x, y]) in centers.points.iter().enumerate() {
        let Some(around) = ray_points(centers, index, rays, rng) else { continue };
        points.push([*x, *y]);
        labels.push(true);
        for ([along, down], dark) in around {
            points.push([x + along, y + down]);
            labels.push(dark);
        }
    }
    (points, labels)
}

/// The displacements, px, of the points round a centre of a cell, and whether each is dark: on `rays.start` to `rays.end` − 1 rays (the
/// paper uses 10–20) a dark point each and a light one farther out. `None` of a centre that is alone.
pub fn ray_points(
    centers: &impl PointGraph,
    index: usize,
    rays: &Range<usize>,
    rng: &mut impl Rng,
) -> Option<Vec<([f64; 2], bool)>> {
    let squares =
        centers.axes(index).iter().map(|axis| axis.displacement[0].powi(2) + axis.displacement[1].powi(2));
    let nearest = squares.fold(f64::INFINITY, f64::min).sqrt();
    if !nearest.is_finite() {
        return None;
    }
    let span = rays.end.saturating_sub(rays.start) as f64;
    let count = (rays.start + (span * rng.random::<f64>()) as usize).max(3);
    let mut around = Vec::with_capacity(2 * count);
    for ray in 0..count {
        let (s, c) = libm::sincos(std::f64::consts::TAU * ray as f64 / count as f64);
        let mut radius = || 0.5 * nearest * (RADII.start + (RADII.end - RADII.start) * rng.random::<f64>());
        let (one, other) = (radius(), radius());
        around.extend(
            [(one.min(other), true), (one.max(other), false)].map(|(r, dark)| ([r * c, r * s], dark)),
        );
    }
    Some(around)
}
