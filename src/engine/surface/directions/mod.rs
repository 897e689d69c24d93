//! Smooth directions over a surface that follow given ones.
//!
//! A direction and its opposite are equivalent: z = exp(2iθ). The result is the field for which Σ w |zᵥ − rᵥᵤ zᵤ|² + Σ λ |zᵥ − gᵥ|²
//! is least, where r transports a direction from one frame to the next: F. Knöppel et al., "Globally optimal direction fields",
//! SIGGRAPH 2013, with the weights w of the connection Laplacian.

mod coarse;
mod connection;
mod hermitian;
mod singularities;

use super::point::SurfacePoint;
use super::triangle_surface::Surface;
use crate::grid::{Domain, atan2};
use connection::{Complex, connection};
pub use singularities::Singularity;

/// Directions of all vertices.
#[derive(Clone, Debug, Default)]
pub struct Directions {
    /// In the frame of each vertex, 0..180.
    pub degrees: Vec<f64>,
    /// By vertex, the agreement of the directions around it: 1, decreasing to 0 at singularities.
    pub coherence: Vec<f64>,
    /// Points around which the directions rotate.
    pub singularities: Vec<Singularity>,
}

/// Weight of a given direction, relative to the difference of two neighbours.
const HELD: f64 = 100.0;
/// Weight of the first axis of the frames everywhere, so that parts without any given direction have one, too.
const LEAST: f64 = 1e-6;
/// Rounds of averages over neighbours in computing the coherence, which reach about 3 units. Not tuned.
const ROUNDS: usize = 12;

/// Directions that follow the `given` ones (place, degrees in the frame of its cell, weight, usually 1). Elsewhere they follow the
/// first axis of the frames, with the weight `along_weight` per cell: from about 1 ÷ √`along_weight` units away from given ones.
#[must_use]
pub fn directions(surface: &Surface, given: &[(SurfacePoint, f64, f64)], along_weight: f64) -> Directions {
    let mut matrix = connection(surface);
    let along = if along_weight.is_finite() { along_weight.max(LEAST) } else { LEAST };
    for vertex in 0..surface.cells() {
        matrix.hold(vertex, [1.0, 0.0], along * surface.area(vertex) * surface.along_share(vertex).max(1e-3));
    }
    for (place, degrees, weight) in given.iter().filter(|given| given.1.is_finite() && given.2.is_finite()) {
        let cell = surface.vertex_of(*place);
        for (vertex, share) in surface.mesh.faces[place.face as usize].into_iter().zip(place.shares()) {
            let degrees = degrees + surface.transport_angle(cell, vertex as usize);
            let (sin, cos) = libm::sincos(2.0 * degrees.to_radians());
            matrix.hold(vertex as usize, [cos, sin], HELD * share * weight.max(0.0));
        }
    }
    let field: Vec<Complex> = coarse::solve(&matrix).into_iter().map(hermitian::unit).collect();
    let mut mean = field.clone();
    for _ in 0..ROUNDS {
        mean = matrix.averages(&mean);
    }
    Directions {
        degrees: field.iter().map(|[x, y]| (0.5 * atan2(*y, *x).to_degrees()).rem_euclid(180.0)).collect(),
        coherence: mean.iter().map(|[x, y]| (x * x + y * y).sqrt().min(1.0)).collect(),
        singularities: singularities::singularities(surface, &field),
    }
}

#[cfg(test)]
mod tests;
