//! The space giraffe: rays of two points each, the inner one dark and the outer one light, round each centre (the paper's figure
//! 12).

use std::ops::Range;

use rand::{Rng, RngExt};

use crate::points::delaunay::Delaunay;

/// Radii of the points, in halves of the distance to the nearest centre. The paper prints 0–1, which breaks into fragments.
const RADII: Range<f64> = 0.5..1.0;

/// Points and labels for cells round the points of `centers`: each centre, and `rays.start` to `rays.end` − 1 rays round it (the
/// paper uses 10–20), each with a dark point and a light one farther out.
pub fn space_giraffe(
    centers: &Delaunay,
    rays: &Range<usize>,
    rng: &mut impl Rng,
) -> (Vec<[f64; 2]>, Vec<bool>) {
    let (mut points, mut labels) = (Vec::new(), Vec::new());
    for (index, center) in centers.points.iter().enumerate() {
        let squares = centers
            .axes(index)
            .iter()
            .map(|axis| axis.displacement[0].powi(2) + axis.displacement[1].powi(2));
        let nearest = squares.fold(f64::INFINITY, f64::min).sqrt();
        if !nearest.is_finite() {
            continue;
        }
        points.push(*center);
        labels.push(true);
        let span = rays.end.saturating_sub(rays.start) as f64;
        let count = (rays.start + (span * rng.random::<f64>()) as usize).max(3);
        for ray in 0..count {
            let (s, c) = libm::sincos(std::f64::consts::TAU * ray as f64 / count as f64);
            let mut radius =
                || 0.5 * nearest * (RADII.start + (RADII.end - RADII.start) * rng.random::<f64>());
            let (one, other) = (radius(), radius());
            for (radius, dark) in [(one.min(other), true), (one.max(other), false)] {
                points.push([center[0] + radius * c, center[1] + radius * s]);
                labels.push(dark);
            }
        }
    }
    (points, labels)
}
