//! The directions of the edges in a picture.

use dapple_engine::grid::Field;
use dapple_engine::marks::turn;

/// An edge counts for a direction within this angle, degrees.
const WITHIN: f64 = 15.0;

/// The share of the edges, weighted by their gradient, that are within 15° of one of these `angles`.
pub fn along(pattern: &Field, angles: &[f64]) -> f64 {
    shares(pattern, angles).iter().sum()
}

/// For each of these `angles`, the share of the edges that are within 15° of it, and closer to it than to the others.
pub fn shares(pattern: &Field, angles: &[f64]) -> Vec<f64> {
    let (mut own, mut all) = (vec![0.0; angles.len()], 0.0);
    let [nx, ny] = [pattern.width, pattern.height];
    for (x, y) in (0..ny).flat_map(|y| (0..nx).map(move |x| (x, y))) {
        let at = |dx: isize, dy: isize| {
            let [x, y] =
                [(x as isize + dx, nx), (y as isize + dy, ny)].map(|(i, n)| pattern.edges.index(i, n));
            f64::from(pattern.values[y * nx + x])
        };
        // Scharr's derivative, whose directions are accurate to 0.1° at any angle.
        let gx =
            3.0 * (at(1, -1) - at(-1, -1)) + 10.0 * (at(1, 0) - at(-1, 0)) + 3.0 * (at(1, 1) - at(-1, 1));
        let gy =
            3.0 * (at(-1, 1) - at(-1, -1)) + 10.0 * (at(0, 1) - at(0, -1)) + 3.0 * (at(1, 1) - at(1, -1));
        let (weight, direction) = (libm::hypot(gx, gy), libm::atan2(gy, gx).to_degrees() + 90.0);
        all += weight;
        let off = |index: &usize| turn(direction, angles[*index]).abs();
        let nearest = (0..angles.len()).min_by(|a, b| off(a).total_cmp(&off(b)));
        if let Some(nearest) = nearest.filter(|nearest| off(nearest) < WITHIN) {
            own[nearest] += weight;
        }
    }
    own.into_iter().map(|own| own / f64::max(all, f64::MIN_POSITIVE)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use dapple::document::Edges;

    #[test]
    fn edges_of_two_directions_have_their_shares() {
        // Left half: lines along y; right half: lines along x.
        let value = |[x, y]: [f64; 2]| {
            let across = if x < 60.0 { x } else { y };
            0.5 + 0.5 * libm::sin(across * std::f64::consts::TAU / 12.0)
        };
        let field = Field::from_fn([120, 120], [1.0; 2], Edges::Closed, |at| value(at) as f32);
        let found = shares(&field, &[0.0, 90.0]);
        assert!(found.iter().all(|share| (0.47..0.53).contains(share)), "{found:?}");
        assert!(along(&field, &[45.0]) < 0.02);
    }
}
