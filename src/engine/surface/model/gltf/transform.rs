//! The transformation of a node: an affine map.

use crate::surface::vector::{cross, dot, times};

/// An affine map: three columns, then the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    columns: [[f64; 3]; 4],
}

impl Default for Transform {
    fn default() -> Self {
        Self { columns: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.0; 3]] }
    }
}

impl From<[[f32; 4]; 4]> for Transform {
    /// The transformation of a matrix that is stored column by column.
    fn from(matrix: [[f32; 4]; 4]) -> Self {
        Self { columns: matrix.map(|[x, y, z, _]| [x, y, z].map(f64::from)) }
    }
}

impl Transform {
    /// The composition: first `inner`, then this one.
    #[must_use]
    pub fn then(&self, inner: &Self) -> Self {
        let [x, y, z, origin] = inner.columns;
        Self { columns: [self.vector(x), self.vector(y), self.vector(z), self.point(origin)] }
    }

    /// The image of a point.
    #[must_use]
    pub fn point(&self, at: [f64; 3]) -> [f64; 3] {
        let moved = self.vector(at);
        std::array::from_fn(|axis| moved[axis] + self.columns[3][axis])
    }

    fn vector(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c, _] = self.columns;
        std::array::from_fn(|axis| x * a[axis] + y * b[axis] + z * c[axis])
    }

    /// The image of a normal: by the cofactors, which keep it perpendicular to the surface.
    #[must_use]
    pub fn normal(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [a, b, c, _] = self.columns;
        let [u, v, w] = [cross(b, c), cross(c, a), cross(a, b)];
        let turned = std::array::from_fn(|axis| x * u[axis] + y * v[axis] + z * w[axis]);
        times(turned, if self.is_mirrored() { -1.0 } else { 1.0 })
    }

    /// Whether the transformation reverses orientations, like a mirror.
    #[must_use]
    pub fn is_mirrored(&self) -> bool {
        let [a, b, c, _] = self.columns;
        dot(cross(a, b), c) < 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_move_and_normals_stay_upright() {
        let [x, y, z] = [[2.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, -3.0, 0.0, 0.0]];
        let map = Transform::from([x, y, z, [5.0, 6.0, 7.0, 1.0]]);
        assert_eq!(map.point([1.0, 1.0, 1.0]), [7.0, 3.0, 8.0]);
        // The plane x + y = 0 before, x ÷ 2 + z = const. after.
        let normal = map.normal([1.0, 1.0, 0.0]);
        assert!((normal[0] * 2.0 - normal[2]).abs() < 1e-12 && normal[1] == 0.0, "{normal:?}");
        assert!(!map.is_mirrored());
        let moved = Transform::from([
            [1.0, 0.0, 0.0, 0.0],
            [0.0, 1.0, 0.0, 0.0],
            [0.0, 0.0, -1.0, 0.0],
            [0.0, 0.0, 1.0, 1.0],
        ]);
        assert!(moved.is_mirrored());
        assert_eq!(map.then(&moved).point([1.0, 0.0, 3.0]), map.point([1.0, 0.0, -2.0]));
    }

    #[test]
    fn a_mirror_keeps_normals_outside() {
        let mirror =
            Transform::from([[-1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0; 4]]);
        assert_eq!(mirror.normal([1.0, 0.0, 0.0]), [-1.0, 0.0, 0.0]);
        assert_eq!(mirror.normal([0.0, 1.0, 0.0]), [0.0, 1.0, 0.0]);
    }
}
