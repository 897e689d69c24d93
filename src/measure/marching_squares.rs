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
pub(super) fn parts([x, y]: [f64; 2], [w, h]: [f64; 2], v: [f64; 4], mut part: impl FnMut(Part)) {
    let inside = v.map(|v| v > 0.0);
    let corners = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]];
    let crossing = |k: usize| {
        let (a, b) = (k % 4, (k + 1) % 4);
        let t = v[a] / (v[a] - v[b]);
        [0, 1].map(|axis| corners[a][axis] + t * (corners[b][axis] - corners[a][axis]))
    };
    let mut emit = |polygon: &[[f64; 2]], contour: f64, corner: usize, across: Option<usize>| {
        part(Part { moments: Moments::polygon(polygon).moved([x, y]), contour, corner, across });
    };
    let saddle = inside[0] == inside[2] && inside[1] == inside[3];
    let joined = v.iter().sum::<f64>() > 0.0;
    if saddle && !joined {
        for k in (0..4).filter(|k| inside[*k]) {
            let (before, behind) = (crossing(k + 3), crossing(k));
            emit(&[before, corners[k], behind], distance(before, behind), k, None);
        }
        return;
    }
    let mut polygon = [[0.0; 2]; 8];
    let mut n = 0;
    let mut ends = [[0.0; 2]; 4];
    let mut crossings = 0;
    let first = (0..4).find(|k| inside[*k] && !inside[(*k + 3) % 4]).unwrap_or(0);
    for k in first..first + 4 {
        if inside[k % 4] {
            polygon[n] = corners[k % 4];
            n += 1;
        }
        if inside[k % 4] != inside[(k + 1) % 4] {
            polygon[n] = crossing(k);
            ends[crossings] = polygon[n];
            (n, crossings) = (n + 1, crossings + 1);
        }
    }
    // From the first inside corner on, the outline leaves and enters alternately: each pair of crossings is a line.
    let mut contour = distance(ends[0], ends[1]);
    if saddle {
        contour += distance(ends[2], ends[3]);
    }
    emit(&polygon[..n], contour, first, saddle.then_some((first + 2) % 4));
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
