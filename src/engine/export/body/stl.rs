//! Models as binary STL, for printers.

use std::io::{self, Write};

use super::vector::{cross, minus, unit};
use crate::export::Stopped;
use crate::surface::Mesh;

/// Writes a binary `.stl` of some meshes. Triangles that share a vertex have exactly the same coordinates there, so that programs find
/// a closed mesh closed.
///
/// # Errors
/// The bytes cannot be written, or there are more triangles than the format counts: 2³² − 1.
pub fn stl(mut out: impl Write, meshes: &[&Mesh]) -> Result<(), Stopped> {
    let mut head = format!("dapple {}", env!("CARGO_PKG_VERSION")).into_bytes();
    head.resize(80, b' ');
    let count: usize = meshes.iter().map(|mesh| mesh.faces.len()).sum();
    let count =
        u32::try_from(count).map_err(|_| io::Error::other("an .stl holds at most 2^32 - 1 triangles"))?;
    out.write_all(&head)?;
    out.write_all(&count.to_le_bytes())?;
    for mesh in meshes {
        for face in 0..mesh.faces.len() {
            let [a, b, c] = mesh.corners(face);
            let normal = unit(cross(minus(b, a), minus(c, a)));
            let mut bytes = Vec::with_capacity(50);
            bytes.extend([normal, a, b, c].iter().flatten().flat_map(|part| (*part as f32).to_le_bytes()));
            bytes.extend([0, 0]);
            out.write_all(&bytes)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::test_meshes::sphere;
    use crate::surface::{prepare, read_model};

    #[test]
    fn a_closed_mesh_is_read_back_closed() {
        let ball = sphere(7, 33.3);
        let mut bytes = Vec::new();
        stl(&mut bytes, &[&ball]).unwrap();
        assert_eq!(bytes.len(), 84 + 50 * ball.faces.len());
        let read = read_model(&bytes, "a.stl").unwrap().mesh(&[]).unwrap();
        let (mesh, repairs) = prepare(&read).unwrap();
        assert_eq!((mesh.positions.len(), mesh.faces.len()), (ball.positions.len(), ball.faces.len()));
        assert!((mesh.volume() / ball.volume() - 1.0).abs() < 1e-6, "{repairs:?}");
    }
}
