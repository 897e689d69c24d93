//! Points around which directions rotate.

use std::f64::consts::{PI, TAU};

use super::connection::{Complex, doubled_turn};
use crate::grid::atan2;
use crate::surface::adjacency::next;
use crate::surface::point::SurfacePoint;
use crate::surface::triangle_surface::Surface;

/// A face around which directions rotate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Singularity {
    /// The middle of the face.
    pub place: SurfacePoint,
    /// Number of rotations in one circuit around it, in the sense of the circuit: a multiple of ½. On a closed surface they add up
    /// to V − E + F.
    pub index: f64,
}

/// The singularities of a field of unit directions.
pub fn singularities(surface: &Surface, field: &[Complex]) -> Vec<Singularity> {
    let angles: Vec<f64> = field.iter().map(|[x, y]| atan2(*y, *x)).collect();
    let wrapped = |angle: f64| (angle + PI).rem_euclid(TAU) - PI;
    let found = (0..surface.mesh.faces.len()).filter_map(|face| {
        let (mut turned, mut carried) = (0.0, 0.0);
        for half in 3 * face as u32..3 * face as u32 + 3 {
            let [from, to] =
                [half, next(half)].map(|half| surface.mesh.faces[face][half as usize % 3] as usize);
            let turn = doubled_turn(surface, half);
            turned += wrapped(angles[to] - angles[from] - turn);
            carried += turn;
        }
        // Angles increase clockwise, and the corners are ordered counter-clockwise.
        let turns = -((turned + wrapped(carried)) / TAU).round();
        let place = SurfacePoint { face: face as u32, weights: [1.0 / 3.0; 2] };
        (turns != 0.0).then_some(Singularity { place, index: 0.5 * turns })
    });
    found.collect()
}
