//! The connection Laplacian of a surface.

pub use super::hermitian::Complex;
use super::hermitian::Hermitian;
use crate::surface::adjacency::{NONE, next, previous};
use crate::surface::triangle_surface::Surface;
use crate::surface::vector::{cross, dot, length, minus};

/// Least weight, so that all neighbours have an effect.
const LEAST: f64 = 0.05;

/// Twice the angle of the parallel transport from the frame of the vertex that a half-edge leaves to that of its target.
pub fn doubled_turn(surface: &Surface, half: u32) -> f64 {
    2.0 * surface.tangents.transport(&surface.adjacency, half)
}

/// The equations between neighbours, without any direction given.
pub fn connection(surface: &Surface) -> Hermitian {
    let vertices = surface.mesh.positions.len();
    let origin = |half: u32| surface.mesh.faces[half as usize / 3][half as usize % 3];
    let place = |half: u32| surface.mesh.positions[origin(half) as usize];
    // Half of the cotangent of the angle opposite to a half-edge.
    let cotangent = |half: u32| {
        let apex = place(previous(half));
        let (a, b) = (minus(place(half), apex), minus(place(next(half)), apex));
        0.5 * dot(a, b) / length(cross(a, b)).max(f64::MIN_POSITIVE)
    };
    let mut entries: Vec<(u32, u32, Complex)> = Vec::with_capacity(7 * vertices);
    for half in 0..surface.adjacency.twins.len() as u32 {
        let twin = surface.adjacency.twins[half as usize];
        if twin != NONE && twin < half {
            continue;
        }
        let beyond = if twin == NONE { 0.0 } else { cotangent(twin) };
        let weight = (cotangent(half) + beyond).clamp(LEAST, 1.0 / LEAST);
        let (sin, cos) = libm::sincos(doubled_turn(surface, half));
        let (from, to) = (origin(half), origin(next(half)));
        entries.push((to, from, [weight * cos, weight * sin]));
        entries.push((from, to, [weight * cos, -weight * sin]));
    }
    entries.sort_unstable_by_key(|(row, column, _)| (*row, *column));
    let mut matrix = Hermitian {
        starts: vec![0; vertices + 1],
        diagonal: vec![0.0; vertices],
        right: vec![[0.0; 2]; vertices],
        ..Hermitian::default()
    };
    for (row, column, [a, b]) in entries {
        matrix.starts[row as usize + 1] += 1;
        matrix.columns.push(column);
        matrix.couplings.push([a, b]);
        matrix.diagonal[row as usize] += (a * a + b * b).sqrt();
    }
    for row in 0..vertices {
        matrix.starts[row + 1] += matrix.starts[row];
    }
    matrix
}
