//! The visible triangle at each sample: a z-buffer.

/// Index that means "no triangle".
pub const NONE: u32 = u32::MAX;

/// Corners of a triangle in the picture: x and y in samples, and a nearness that is larger for nearer places, linear in x and y.
pub type Corners = [[f64; 3]; 3];

/// Samples of some rows of a picture.
pub struct Samples {
    pub width: usize,
    pub rows: std::ops::Range<usize>,
    /// By sample: the nearest triangle.
    pub triangles: Vec<u32>,
    near: Vec<f64>,
}

impl Samples {
    pub fn new(width: usize, rows: std::ops::Range<usize>) -> Self {
        let count = width * rows.len();
        Self { width, rows, triangles: vec![NONE; count], near: vec![f64::NEG_INFINITY; count] }
    }

    /// By sample: the nearness of the nearest triangle.
    pub fn near(&self) -> &[f64] {
        &self.near
    }

    /// Draws a triangle, visible from either side. If several are equally near, the first one stays.
    pub fn draw(&mut self, corners: &Corners, triangle: u32) {
        let Some(plane) = Plane::new(corners) else { return };
        let [low, high] = [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|pick| [0, 1].map(|axis| pick(pick(corners[0][axis], corners[1][axis]), corners[2][axis])));
        // Samples lie in the middle of their cells.
        let first = |low: f64, least: usize| (low - 0.5).ceil().max(least as f64) as usize;
        let end = |high: f64, most: usize| ((high - 0.5).floor() + 1.0).clamp(0.0, most as f64) as usize;
        let columns = first(low[0], 0)..end(high[0], self.width);
        for row in first(low[1], self.rows.start)..end(high[1], self.rows.end) {
            let start = (row - self.rows.start) * self.width;
            let y = row as f64 + 0.5;
            for column in columns.clone() {
                let weights = plane.weights([column as f64 + 0.5, y]);
                if weights[0] >= 0.0 && weights[1] >= 0.0 && weights[2] >= 0.0 {
                    let near =
                        weights[0] * corners[0][2] + weights[1] * corners[1][2] + weights[2] * corners[2][2];
                    let sample = start + column;
                    if near > self.near[sample] {
                        self.near[sample] = near;
                        self.triangles[sample] = triangle;
                    }
                }
            }
        }
    }
}

/// The barycentric coordinates of a place of the picture: linear functions that add up to 1.
pub struct Plane([[f64; 3]; 3]);

impl Plane {
    /// `None` if the triangle has no area, or a coordinate is no number.
    pub fn new([a, b, c]: &Corners) -> Option<Self> {
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let is_one =
            area != 0.0 && area.is_finite() && a[2].is_finite() && b[2].is_finite() && c[2].is_finite();
        let weight = |from: &[f64; 3], to: &[f64; 3]| {
            let [x, y] = [(from[1] - to[1]) / area, (to[0] - from[0]) / area];
            [x, y, -x * from[0] - y * from[1]]
        };
        is_one.then(|| Self([weight(b, c), weight(c, a), weight(a, b)]))
    }

    pub fn weights(&self, [x, y]: [f64; 2]) -> [f64; 3] {
        let [a, b, c] = self.0;
        [a[0] * x + a[1] * y + a[2], b[0] * x + b[1] * y + b[2], c[0] * x + c[1] * y + c[2]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_cover_their_square_without_a_gap() {
        let mut samples = Samples::new(20, 0..20);
        let corner = |x, y| [x, y, 1.0];
        let square = [corner(2.2, 3.0), corner(17.0, 4.1), corner(15.3, 18.6), corner(3.7, 16.9)];
        samples.draw(&[square[0], square[1], square[2]], 0);
        samples.draw(&[square[0], square[2], square[3]], 1);
        let area: f64 = (0..4)
            .map(|at| (square[at], square[(at + 1) % 4]))
            .map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0]))
            .sum();
        let covered = samples.triangles.iter().filter(|triangle| **triangle != NONE).count();
        assert!((covered as f64 - area).abs() < 6.0, "{covered} of {area}");
        for row in samples.triangles.chunks(20) {
            let first = row.iter().position(|triangle| *triangle != NONE);
            let last = row.iter().rposition(|triangle| *triangle != NONE);
            if let (Some(first), Some(last)) = (first, last) {
                assert!(row[first..=last].iter().all(|triangle| *triangle != NONE), "{row:?}");
            }
        }
    }

    #[test]
    fn the_nearer_triangle_is_seen_in_any_order() {
        let at = |near| [[0.0, 0.0, near], [9.0, 0.0, near], [0.0, 9.0, near]];
        for order in [[0, 1], [1, 0]] {
            let mut samples = Samples::new(9, 0..9);
            for triangle in order {
                samples.draw(&at(1.0 + f64::from(triangle)), triangle);
            }
            assert_eq!(samples.triangles[0], 1);
        }
    }

    #[test]
    fn triangles_outside_the_picture_or_without_area_draw_nothing() {
        let mut samples = Samples::new(4, 2..4);
        samples.draw(&[[-9.0, -9.0, 1.0], [-8.0, -9.0, 1.0], [-9.0, -8.0, 1.0]], 0);
        samples.draw(&[[1.0, 1.0, 1.0], [3.0, 3.0, 1.0], [2.0, 2.0, 1.0]], 0);
        samples.draw(&[[1.0, 1.0, f64::NAN], [3.0, 3.0, 1.0], [f64::INFINITY, 2.0, 1.0]], 0);
        assert!(samples.triangles.iter().all(|triangle| *triangle == NONE));
        samples.draw(&[[-1e9, -1e9, 1.0], [1e9, -1e9, 1.0], [0.0, 1e9, 1.0]], 7);
        assert_eq!(samples.triangles, [7; 8]);
    }
}
