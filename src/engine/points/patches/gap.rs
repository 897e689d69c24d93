//! Gaps between drawn marks, where no patch is to be laid.

use crate::points::centers::Pitch;
use crate::points::extent::Extent;
use crate::points::metric::Metric;

/// Marks nearer than this, in spacings, are neighbours of a place. Not tuned: the first ring of a lattice and a margin.
const BESIDE: f64 = 1.4;
/// Largest angle, radians, between successive neighbours that surround a place: outside of a row of marks it is π or more.
const LARGEST: f64 = 0.8 * std::f64::consts::PI;
/// A place among neighbours that is nearer to one of them than this, in spacings, is a gap. Where a mark of a lattice is missing,
/// the distance is 1. Not tuned.
const NEAR: f64 = 0.9;

/// Whether a place lies among the centres of drawn marks, nearer to one of them than the marks are to each other.
pub(super) fn is_gap(
    at: [f64; 2],
    drawn: &[[f64; 2]],
    extent: &Extent,
    pitch: &dyn Fn([f64; 2]) -> Pitch,
) -> bool {
    let Pitch { spacing, aspect, angle } = pitch(at);
    let metric = Metric::ellipse(spacing, aspect, angle);
    let mut nearest = f64::INFINITY;
    let mut angles = Vec::new();
    for center in drawn {
        let displacement = extent.shortest([0, 1].map(|axis| center[axis] - at[axis]));
        let square = metric.square(displacement);
        nearest = nearest.min(square);
        if square < BESIDE * BESIDE {
            angles.push(libm::atan2(displacement[1], displacement[0]));
        }
    }
    nearest < NEAR * NEAR && are_around(angles)
}

/// Whether no angle between successive directions, radians, is larger than [`LARGEST`].
fn are_around(mut angles: Vec<f64>) -> bool {
    angles.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (angles.first(), angles.last()) else { return false };
    let across = first + 2.0 * std::f64::consts::PI - last;
    angles.windows(2).map(|pair| pair[1] - pair[0]).fold(across, f64::max) <= LARGEST
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXTENT: Extent = Extent { size: [200.0, 200.0], wrap: [false; 2] };

    fn pitch(_: [f64; 2]) -> Pitch {
        Pitch { spacing: 20.0, aspect: 1.0, angle: 0.0 }
    }

    /// Six centres around [100, 100].
    fn ring(radius: f64) -> Vec<[f64; 2]> {
        let at = |k: u32| {
            let (s, c) = libm::sincos(std::f64::consts::TAU * f64::from(k) / 6.0);
            [100.0 + radius * c, 100.0 + radius * s]
        };
        (0..6).map(at).collect()
    }

    #[test]
    fn a_place_among_marks_is_a_gap_unless_one_mark_of_a_lattice_is_missing_there() {
        let gap = |radius: f64| is_gap([100.0, 100.0], &ring(radius), &EXTENT, &pitch);
        assert_eq!([12.0, 17.0, 19.0, 30.0].map(gap), [true, true, false, false]);
    }

    #[test]
    fn a_place_beside_marks_is_no_gap() {
        let half: Vec<[f64; 2]> = ring(16.0).into_iter().filter(|at| at[1] > 95.0).collect();
        assert!(!is_gap([100.0, 100.0], &half, &EXTENT, &pitch));
        assert!(!is_gap([100.0, 100.0], &[], &EXTENT, &pitch));
    }
}
