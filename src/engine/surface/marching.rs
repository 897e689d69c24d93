//! How far a third corner of a triangle is from a source, by what is known of the other two.
//!
//! R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", PNAS 95 (1998), with the exact distance from a point: the triangle
//! and the source are laid out in a plane, as by E. L. Melvær, M. Reimers, "Geodesic polar coordinates on polygonal meshes", Computer
//! Graphics Forum 31 (2012).

/// How a corner is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Its distance from the source.
    pub distance: f64,
    /// Where the way to it crosses the side between the other two, from the first to the second: 0..1.
    pub share: f64,
}

/// The corner opposite to a side, whose ends are these distances from the source. `side`, `first` and `second` are the lengths of the
/// side and of those from its ends to the corner.
#[inline]
pub fn reached(known: [f64; 2], side: f64, [first, second]: [f64; 2]) -> Reached {
    let [near, far] = known;
    let x = (side * side + first * first - second * second) / (2.0 * side);
    let y = (first * first - x * x).max(0.0).sqrt();
    // The source lies on the other side.
    let from_x = (near * near - far * far + side * side) / (2.0 * side);
    let from_y = (near * near - from_x * from_x).max(0.0).sqrt();
    let (across, up) = (x - from_x, y + from_y);
    let crossing = (from_x + across * from_y / up) / side;
    if crossing >= 0.0 && crossing <= 1.0 {
        return Reached { distance: (across * across + up * up).sqrt(), share: crossing };
    }
    // Not through the side: past one of its ends.
    let along = [near + first, far + second];
    if along[1] < along[0] {
        Reached { distance: along[1], share: 1.0 }
    } else {
        Reached { distance: along[0], share: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_corner_in_the_plane_of_the_source_is_reached_exactly() {
        let (source, ends, corner) = ([0.3f64, -2.0], [[0.0, 0.0], [1.0, 0.1]], [0.4, 0.9]);
        let far = |a: [f64; 2], b: [f64; 2]| ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt();
        let known = ends.map(|end| far(source, end));
        let found = reached(known, far(ends[0], ends[1]), ends.map(|end| far(corner, end)));
        assert!((found.distance - far(source, corner)).abs() < 1e-12);
        let at = [0, 1].map(|axis| ends[0][axis] + found.share * (ends[1][axis] - ends[0][axis]));
        assert!((far(source, at) + far(at, corner) - found.distance).abs() < 1e-12);
    }

    #[test]
    fn a_corner_behind_an_end_is_reached_past_it() {
        let found = reached([1.0, 2.0], 1.0, [1.0, 1.5]);
        assert_eq!(found, Reached { distance: 2.0, share: 0.0 });
        assert!((reached([0.0, 1.0], 1.0, [1.0, 1.0]).distance - 1.0).abs() < 1e-12);
    }
}
