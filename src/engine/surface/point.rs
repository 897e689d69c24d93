//! Places on triangles.

/// A point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// The triangle that it lies in.
    pub face: u32,
    /// Barycentric coordinates of the first two corners of the triangle; that of the third is the rest to 1.
    pub weights: [f64; 2],
}

impl SurfacePoint {
    /// The point with these barycentric coordinates in a face. They are made non-negative, with the sum 1.
    pub(super) fn new(face: u32, weights: [f64; 3]) -> Self {
        let weights = weights.map(|weight| if weight > 0.0 { weight } else { 0.0 });
        let sum: f64 = weights.iter().sum();
        let share = |weight: f64| if sum > 0.0 { (weight / sum).min(1.0) } else { 1.0 / 3.0 };
        Self { face, weights: [share(weights[0]), share(weights[1])] }
    }

    /// Barycentric coordinates of the three corners.
    #[must_use]
    pub fn shares(&self) -> [f64; 3] {
        let [a, b] = self.weights;
        // A point on a vertex has exactly 0 for the other corners.
        [a, b, (1.0 - a - b).max(0.0)]
    }

    /// The corner with the largest coordinate; the first of several.
    pub(super) fn corner(&self) -> usize {
        let [a, b, c] = self.shares();
        if a >= b && a >= c {
            0
        } else if b >= c {
            1
        } else {
            2
        }
    }
}
