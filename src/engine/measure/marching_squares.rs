//! Marching squares: the parts of a square between four nodes that are above the level, exact for values that vary
//! linearly along its sides.

use crate::marks::Moments;

/// A part of a square that is above the level.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) moments: Moments,
    /// Length of the level line in this square, px.
    pub(super) contour: f64,
    /// A corner that belongs to it: 0 upper left, then by +x, +y, −x.
    pub(super) corner: usize,
    /// Another such corner, where the two are joined through the square's centre only.
    pub(super) across: Option<usize>,
}

/// The parts above 0 of the square at `x`, `y` with these sides and corner values (upper left, then by +x, +y,
/// −x), of which some but not all are above 0.
///
/// Where only two opposite corners are above, they are joined if the mean of all four is.
#[inline(always)]
pub(super) fn parts(at: [f64; 2], [w, h]: [f64; 2], v: [f64; 4], mut part: impl FnMut(Part)) {
    let inside = v.map(|v| v > 0.0);
    let square = Square { at, corners: [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]], v };
    if inside[0] == inside[2] && inside[1] == inside[3] {
        return square.saddle(usize::from(!inside[0]), part);
    }
    // The corners inside are consecutive, starting with this one.
    let first = (0..4).find(|k| inside[*k] && !inside[(*k + 3) % 4]).unwrap_or(0);
    part(match inside.iter().filter(|inside| **inside).count() {
        1 => square.cut_off::<1, 3>(first),
        2 => square.cut_off::<2, 4>(first),
        _ => square.cut_off::<3, 5>(first),
    });
}

/// A square that the level line crosses.
struct Square {
    /// Its upper left corner.
    at: [f64; 2],
    /// Its corners from there.
    corners: [[f64; 2]; 4],
    /// Their values.
    v: [f64; 4],
}

impl Square {
    /// The point where the level is crossed between corner `k` and the next one.
    #[inline(always)]
    fn crossing(&self, k: usize) -> [f64; 2] {
        let (a, b) = (k % 4, (k + 1) % 4);
        let t = self.v[a] / (self.v[a] - self.v[b]);
        [0, 1].map(|axis| self.corners[a][axis] + t * (self.corners[b][axis] - self.corners[a][axis]))
    }

    /// The part with `N` corners from corner `first` on and the two crossings beside them, `ENDS` = `N` + 2 in all.
    #[inline(always)]
    fn cut_off<const N: usize, const ENDS: usize>(&self, first: usize) -> Part {
        let mut polygon = [[0.0; 2]; ENDS];
        for (k, corner) in polygon.iter_mut().take(N).enumerate() {
            *corner = self.corners[(first + k) % 4];
        }
        (polygon[N], polygon[N + 1]) = (self.crossing(first + N - 1), self.crossing(first + 3));
        let contour = distance(polygon[N], polygon[N + 1]);
        Part { moments: Moments::polygon(&polygon).moved(self.at), contour, corner: first, across: None }
    }

    /// The parts of a square of which corners `first` and `first` + 2 alone are above the level.
    fn saddle(&self, first: usize, mut part: impl FnMut(Part)) {
        if self.v.iter().sum::<f64>() <= 0.0 {
            part(self.cut_off::<1, 3>(first));
            part(self.cut_off::<1, 3>(first + 2));
            return;
        }
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| self.crossing(first + k));
        let corners = [first, first + 2].map(|k| self.corners[k]);
        let moments = Moments::polygon(&[corners[0], a, b, corners[1], c, d]).moved(self.at);
        // There is a line at each corner that is not above.
        let contour = distance(a, b) + distance(c, d);
        part(Part { moments, contour, corner: first, across: Some(first + 2) });
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn all(v: [f64; 4]) -> Vec<Part> {
        let mut found = Vec::new();
        parts([0.0, 0.0], [1.0, 1.0], v, |part| found.push(part));
        found
    }

    #[test]
    fn every_case_has_the_area_and_line_computed_by_hand() {
        let half = 0.5_f64.sqrt();
        for code in 1..15_u32 {
            let v = [0, 1, 2, 3].map(|k| if code >> k & 1 == 1 { 1.0 } else { -1.0 });
            let (area, contour) = match code {
                3 | 6 | 9 | 12 => (0.5, 1.0),
                5 | 10 => (0.25, 2.0 * half),
                _ if code.count_ones() == 1 => (0.125, half),
                _ => (0.875, half),
            };
            let found = all(v);
            assert!((found.iter().map(|part| part.moments.area).sum::<f64>() - area).abs() < 1e-15, "{code}");
            assert!((found.iter().map(|part| part.contour).sum::<f64>() - contour).abs() < 1e-15, "{code}");
            assert!(found.iter().all(|part| v[part.corner] > 0.0), "{code}");
        }
    }

    #[test]
    fn a_saddle_is_joined_where_its_mean_is_above() {
        let apart = all([1.0, -2.0, 1.0, -2.0]);
        assert_eq!(apart.iter().map(|part| part.corner).collect::<Vec<_>>(), [0, 2]);
        let joined = all([-1.0, 2.0, -1.0, 2.0]);
        assert_eq!(joined.len(), 1);
        assert_eq!((joined[0].corner, joined[0].across), (1, Some(3)));
        let cut = 2.0 * 0.5 / 9.0;
        assert!((joined[0].moments.area - (1.0 - cut)).abs() < 1e-15);
    }
}
