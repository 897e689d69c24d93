//! Cuts polygons into triangles by ear clipping (Meisters 1975), including those that are not convex.

/// The most corners of a face. Cutting one into triangles takes a time that grows with their square.
pub const MOST_CORNERS: usize = 4096;

/// The triangles of a polygon of at least three corners, as indices of its corners, with its orientation: always two fewer than
/// corners. A polygon that is not plane is projected along its mean normal; if it has no area or crosses itself, some triangles
/// have no area or overlap.
pub fn triangulate(corners: &[[f64; 3]]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..corners.len()).collect();
    let flat = projected(corners);
    let mut triangles = Vec::with_capacity(corners.len().saturating_sub(2));
    let mut at = shortest_diagonal(corners);
    while left.len() > 3 {
        let count = left.len();
        // If there is no ear, any corner is cut off: the polygon gets smaller in any case.
        let ear = (0..count)
            .map(|step| (at + step) % count)
            .find(|at| is_ear(&flat, &left, *at))
            .unwrap_or(at % count);
        triangles.push([left[(ear + count - 1) % count], left[ear], left[(ear + 1) % count]]);
        left.remove(ear);
        // Not the next corner, which would turn a round polygon into a fan of narrow triangles.
        at = (ear + 1) % left.len();
    }
    if let [a, b, c] = left[..] {
        triangles.push([a, b, c]);
    }
    triangles
}

/// The corner whose neighbours are closest to each other: the other diagonal of a quad is longer.
fn shortest_diagonal(corners: &[[f64; 3]]) -> usize {
    let count = corners.len();
    let length = |at: usize| {
        let [a, b] = [corners[(at + count - 1) % count], corners[(at + 1) % count]];
        (0..3).map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis])).sum::<f64>()
    };
    (0..count).min_by(|a, b| length(*a).total_cmp(&length(*b))).unwrap_or(0)
}

/// The corners in a plane, counter-clockwise: projected along the axis nearest to the mean normal (Newell's).
fn projected(corners: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let mut normal = [0.0; 3];
    for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        for (axis, sum) in normal.iter_mut().enumerate() {
            let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
            *sum += (a[u] - b[u]) * (a[v] + b[v]);
        }
    }
    let axis = (0..3).max_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs())).unwrap_or(2);
    let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    let turned = if normal[axis] < 0.0 { [v, u] } else { [u, v] };
    corners.iter().map(|corner| turned.map(|axis| corner[axis])).collect()
}

/// Twice the area of a triangle, positive if it is counter-clockwise.
fn area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether the corner is convex and no other corner lies in the triangle with its neighbours.
fn is_ear(flat: &[[f64; 2]], left: &[usize], at: usize) -> bool {
    let count = left.len();
    let triangle =
        [left[(at + count - 1) % count], left[at], left[(at + 1) % count]].map(|corner| flat[corner]);
    let [a, b, c] = triangle;
    let inside = |point: [f64; 2]| {
        // A corner that coincides with one of the three (of a polygon with a slit) is ignored.
        !triangle.contains(&point)
            && area([a, b, point]) >= 0.0
            && area([b, c, point]) >= 0.0
            && area([c, a, point]) >= 0.0
    };
    area(triangle) > 0.0 && !left.iter().any(|&other| inside(flat[other]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The areas of the triangles, positive if they have the intended orientation of the polygon: counter-clockwise seen from `+z`.
    fn areas(corners: &[[f64; 3]]) -> Vec<f64> {
        let flat = |at: usize| [corners[at][0], corners[at][1]];
        triangulate(corners).into_iter().map(|triangle| area(triangle.map(flat)) / 2.0).collect()
    }

    #[test]
    fn polygons_that_are_not_convex_are_covered_once() {
        let arrow = [[0.0, 0.0, 0.0], [2.0, -1.0, 0.0], [0.0, 3.0, 0.0], [-2.0, -1.0, 0.0]];
        let comb: Vec<[f64; 3]> = (0..20)
            .map(|at| [f64::from(at), [1.0, 5.0, 3.0][at as usize % 3], 0.0])
            .chain([[19.0, 6.0, 0.0], [0.0, 6.0, 0.0]])
            .collect();
        let below: f64 = comb[..20].windows(2).map(|pair| 0.5 * (pair[0][1] + pair[1][1])).sum();
        for (corners, whole) in [(&arrow[..], 6.0), (&comb, 6.0 * 19.0 - below)] {
            let areas = areas(corners);
            assert_eq!(areas.len(), corners.len() - 2);
            assert!(areas.iter().all(|area| *area >= 0.0), "{areas:?}");
            assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-12, "{areas:?}");
        }
    }

    #[test]
    fn a_polygon_keeps_its_sense_of_turning_and_its_tilt_does_not_matter() {
        let arrow = [[0.0, 0.0], [2.0, -1.0], [0.0, 3.0], [-2.0, -1.0]];
        let clockwise: Vec<[f64; 3]> = arrow.iter().rev().map(|[x, y]| [*x, *y, 0.1 * x]).collect();
        let areas = areas(&clockwise);
        assert!(areas.iter().all(|area| *area < 0.0) && (areas.iter().sum::<f64>() + 6.0).abs() < 1e-12);
    }

    #[test]
    fn a_quad_is_cut_along_its_shorter_diagonal() {
        let quad = [[0.0, 0.0, 0.0], [3.0, 1.0, 0.0], [4.0, 4.0, 0.0], [1.0, 3.0, 0.0]];
        assert!(triangulate(&quad).iter().all(|triangle| triangle.contains(&1) && triangle.contains(&3)));
    }

    #[test]
    fn polygons_without_area_or_that_cross_themselves_end() {
        let bow_tie = [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]];
        for corners in [bow_tie, [[1.0; 3]; 4], [[f64::NAN; 3]; 4], [[f64::MAX; 3]; 4]] {
            assert_eq!(triangulate(&corners).len(), 2);
        }
    }
}
