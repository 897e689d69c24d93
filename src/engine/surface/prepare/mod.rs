//! Converts any triangles to a manifold that points outwards: all defects of a mesh are repaired, and counted.

mod link;
mod orient;
mod repairs;
mod weld;

use super::mesh::Mesh;
use super::vector::{length, minus, times};
pub use repairs::Repairs;

/// The reason why nothing can grow on a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SurfaceError {
    /// There is no face.
    #[error("the model has no faces; it needs at least one triangle")]
    Empty,
    /// All faces were dropped.
    #[error(
        "none of the {faces} triangles of the model has an area: their corners coincide, lie in a line or are no finite \
         numbers; export the model again"
    )]
    NoArea {
        /// Number of faces.
        faces: usize,
    },
}

/// Vertices closer to each other than this share of the size of the mesh are joined. Coordinates in files have at least 6 digits.
const WELD: f64 = 1e-5;

/// Ratio of length to height from which on a face counts as having no area.
const FLAT: f64 = 1e-7;

/// The mesh as a manifold. Vertices are welded; faces without area, duplicate faces and vertices without faces are dropped. The
/// mesh is cut open where more than two faces meet at an edge, where faces meet only in a vertex, and where no orientation fits.
/// Faces are counter-clockwise seen from outside. Positions are those of the mesh.
///
/// # Errors
/// No face is left.
pub fn prepare(mesh: &Mesh) -> Result<(Mesh, Repairs), SurfaceError> {
    if mesh.faces.is_empty() {
        return Err(SurfaceError::Empty);
    }
    let mut repairs = Repairs::default();
    let mesh_of = finite(mesh, &mut repairs);
    let no_area = SurfaceError::NoArea { faces: mesh.faces.len() };
    let [low, high] = used_bounds(&mesh_of);
    let size = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
    if !(size > 0.0 && size.is_finite()) {
        return Err(no_area);
    }
    // Scaled to size 1 about the origin, so that no product of lengths overflows or underflows.
    let normal = |at: [f64; 3]| times(minus(at, low), 1.0 / size);
    let mut unit =
        Mesh { positions: mesh_of.positions.iter().map(|at| normal(*at)).collect(), faces: mesh_of.faces };
    let own: Vec<usize> = weld::weld(&mut unit, WELD, &mut repairs);
    weld::drop_doubled(&mut unit, &mut repairs);
    weld::drop_flat(&mut unit, FLAT, &mut repairs);
    if unit.faces.is_empty() {
        return Err(no_area);
    }
    let links = link::links(&unit, &mut repairs);
    let links = orient::orient(&mut unit, links, &mut repairs);
    let from = link::detach(&mut unit, &links, &mut repairs);
    unit.positions = from.iter().map(|vertex| mesh.positions[own[*vertex as usize]]).collect();
    Ok((unit, repairs))
}

/// The mesh without faces that have a corner that is not finite.
fn finite(mesh: &Mesh, repairs: &mut Repairs) -> Mesh {
    let is_there = |vertex: &u32| {
        mesh.positions.get(*vertex as usize).is_some_and(|at| at.iter().all(|part| part.is_finite()))
    };
    let faces: Vec<[u32; 3]> = mesh.faces.iter().filter(|face| face.iter().all(is_there)).copied().collect();
    repairs.unreal = mesh.faces.len() - faces.len();
    // Vertices that no face uses do not matter.
    let positions =
        mesh.positions.iter().map(|at| if at.iter().all(|p| p.is_finite()) { *at } else { [0.0; 3] });
    Mesh { positions: positions.collect(), faces }
}

/// The bounds of the vertices that faces use.
fn used_bounds(mesh: &Mesh) -> [[f64; 3]; 2] {
    let used = mesh.faces.iter().flatten().map(|vertex| mesh.positions[*vertex as usize]);
    Mesh { positions: used.collect(), faces: Vec::new() }.bounds()
}

/// Height of a triangle over its longest side, and that side.
fn flatness(mesh: &Mesh, face: usize) -> [f64; 2] {
    let [a, b, c] = mesh.corners(face);
    let longest = [minus(b, a), minus(c, b), minus(a, c)].map(length).into_iter().fold(0.0, f64::max);
    [length(mesh.area_vector(face)) / longest.max(f64::MIN_POSITIVE), longest]
}

#[cfg(test)]
mod tests;
