//! Even triangles of wanted sizes on an unchanged surface.
//!
//! M. Botsch, L. Kobbelt, "A remeshing approach to multiresolution modeling", SGP 2004. Several times over, long edges are split,
//! short ones collapsed, edges flipped towards valence six, and vertices moved along the surface to the centre of their faces.
//! Borders and sharp edges stay where they are. This is done for edges twice as long; then each triangle is cut into four.

mod collapse;
mod features;
mod flip;
mod half_edges;
mod order;
mod relax;
mod remeshing;
mod split;
mod subdivide;

use super::mesh::Mesh;
pub use remeshing::Remeshing;

/// Longer edges are split, in wanted lengths.
const LONG: f64 = 4.0 / 3.0;
/// Shorter edges are collapsed, in wanted lengths.
const SHORT: f64 = 4.0 / 5.0;

/// The surface of a mesh that [`prepare`](super::prepare()) returned, with edges about as long as `edge` gives at a place: the mean
/// area of a vertex's cell is √3 ÷ 2 of the square of it. Vertices are in Morton order. Corners, borders and sharp edges are kept,
/// unless they are much smaller than an edge.
#[must_use]
pub fn remesh(mesh: &Mesh, edge: &(impl Fn([f64; 3]) -> f64 + Sync)) -> Mesh {
    let mut remeshing = Remeshing::new(mesh, edge);
    while remeshing.advance(edge) {}
    let [_, fine] = remeshing.into_meshes();
    fine
}

#[cfg(test)]
mod tests;
