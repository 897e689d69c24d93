//! Moments of triangles in a plane.

/// Sums over triangles, each with an area of its own: its area on the surface.
#[derive(Clone, Copy, Debug, Default)]
pub struct PlaneMoments {
    area: f64,
    first: [f64; 2],
    /// xx, xy, yy.
    second: [f64; 3],
}

impl PlaneMoments {
    /// Adds a triangle with this area and these corners.
    pub fn add(&mut self, area: f64, corners: [[f64; 2]; 3]) {
        let sum = |k: usize| corners[0][k] + corners[1][k] + corners[2][k];
        let square = |i: usize, j: usize| {
            // The mean of x·y over a triangle: (Σ xᵢyᵢ + Σxᵢ·Σyᵢ) ÷ 12.
            let own: f64 = corners.iter().map(|corner| corner[i] * corner[j]).sum();
            (own + sum(i) * sum(j)) / 12.0
        };
        self.area += area;
        (0..2).for_each(|k| self.first[k] += area * sum(k) / 3.0);
        for (second, [i, j]) in self.second.iter_mut().zip([[0, 0], [0, 1], [1, 1]]) {
            *second += area * square(i, j);
        }
    }

    /// The centre of mass; the origin without triangles.
    pub fn middle(&self) -> [f64; 2] {
        if self.area > 0.0 { self.first.map(|first| first / self.area) } else { [0.0; 2] }
    }

    /// The second moments about the centre of mass, of an area of 1.
    pub fn central(&self) -> [f64; 3] {
        if self.area <= 0.0 {
            return [0.0; 3];
        }
        let [x, y] = self.middle();
        let [xx, xy, yy] = self.second.map(|second| second / self.area);
        [xx - x * x, xy - x * y, yy - y * y]
    }
}
