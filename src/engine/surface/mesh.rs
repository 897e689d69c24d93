//! Triangles in space.

/// Triangles, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The vertices.
    pub positions: Vec<[f64; 3]>,
    /// The triangles: indices of vertices.
    pub faces: Vec<[u32; 3]>,
}
