//! Triangles in space.

use super::vector::{Vector, cross, dot, length, minus};

/// Triangles that share vertices, counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The position of each vertex.
    pub positions: Vec<[f64; 3]>,
    /// The vertices of each triangle.
    pub faces: Vec<[u32; 3]>,
}

impl Mesh {
    /// The positions of the corners of a face.
    #[must_use]
    pub fn corners(&self, face: usize) -> [[f64; 3]; 3] {
        self.faces[face].map(|vertex| self.positions[vertex as usize])
    }

    /// A vector along the normal of a face; its length is twice the area of the face.
    #[must_use]
    pub fn area_vector(&self, face: usize) -> [f64; 3] {
        area_vector(self.corners(face))
    }

    /// The area of all faces.
    ///
    /// ```
    /// use dapple_engine::surface::Mesh;
    ///
    /// let positions = vec![[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
    /// let mesh = Mesh { positions, faces: vec![[0, 1, 2]] };
    /// assert_eq!(mesh.area(), 6.0);
    /// ```
    #[must_use]
    pub fn area(&self) -> f64 {
        (0..self.faces.len()).map(|face| 0.5 * length(self.area_vector(face))).sum()
    }

    /// The volume that a closed mesh encloses; below 0 if its normals point inwards.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let [low, high] = self.bounds();
        let middle = [0, 1, 2].map(|axis| 0.5 * (low[axis] + high[axis]));
        let of_face = |face| {
            let [a, b, c] = self.corners(face).map(|corner| minus(corner, middle));
            dot(a, cross(b, c)) / 6.0
        };
        (0..self.faces.len()).map(of_face).sum()
    }

    /// The corners of the bounding box of all vertices; both are 0 without vertices.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        bounds(&self.positions)
    }

    /// The longest side of [`Self::bounds`].
    #[must_use]
    pub fn size(&self) -> f64 {
        let [low, high] = self.bounds();
        (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max)
    }
}

/// A vector along the normal of a triangle; its length is twice the area.
pub fn area_vector([a, b, c]: [Vector; 3]) -> Vector {
    cross(minus(b, a), minus(c, a))
}

/// The corners of the bounding box of all points; both are 0 without points.
pub fn bounds(points: &[Vector]) -> [Vector; 2] {
    let Some(first) = points.first() else { return [[0.0; 3]; 2] };
    points.iter().fold([*first; 2], |[low, high], at| {
        [[0, 1, 2].map(|axis| low[axis].min(at[axis])), [0, 1, 2].map(|axis| high[axis].max(at[axis]))]
    })
}

#[cfg(test)]
mod tests {
    use crate::surface::test_meshes::{cube, sphere};

    #[test]
    fn area_and_volume_of_a_cube_are_exact_wherever_it_is() {
        let mut mesh = cube(3, 2.0);
        assert!((mesh.area() - 24.0).abs() < 1e-12 && (mesh.volume() - 8.0).abs() < 1e-12);
        mesh.positions.iter_mut().for_each(|at| at[0] += 1e7);
        assert!((mesh.volume() - 8.0).abs() < 1e-6 && (mesh.size() - 2.0).abs() < 1e-6);
    }

    #[test]
    fn area_of_a_sphere_of_many_triangles_is_4_pi() {
        let mesh = sphere(32, 1.0);
        assert!((mesh.area() / (4.0 * std::f64::consts::PI) - 1.0).abs() < 1e-3);
        assert!(mesh.volume() > 0.0);
    }
}
