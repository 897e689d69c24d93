//! The distance of the third corner of a triangle from a source, computed from the distances of the other two.
//!
//! R. Kimmel, J. A. Sethian, "Computing geodesic paths on manifolds", PNAS 95 (1998), with the exact distance from a point: the triangle
//! and the source are laid out in a plane, as by E. L. Melvær, M. Reimers, "Geodesic polar coordinates on polygonal meshes", Computer
//! Graphics Forum 31 (2012).

/// The way in which a corner is reached.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reached {
    /// Its distance from the source.
    pub distance: f64,
    /// The point at which the displacement to it crosses the side between the other two, as a share from the first to the second:
    /// 0..1.
    pub share: f64,
}

/// A side of a triangle with the corner opposite to it, in a plane.
#[derive(Clone, Copy, Debug)]
pub struct Opposite {
    /// Length of the side.
    pub side: f64,
    /// Position of the corner: along the side from its first end, and its distance from the side.
    pub along: f64,
    pub off: f64,
}

impl Opposite {
    /// The corner opposite to a side of this length, at these distances from its ends.
    pub fn new(side: f64, [first, second]: [f64; 2]) -> Self {
        let along = (side * side + first * first - second * second) / (2.0 * side);
        Self { side, along, off: (first * first - along * along).max(0.0).sqrt() }
    }

    /// The corner, if the ends of the side have these distances from the source, which lies on the other side of it.
    #[inline]
    pub fn reached(&self, [near, far]: [f64; 2]) -> Reached {
        let Self { side, along, off } = *self;
        let source = (near * near - far * far + side * side) / (2.0 * side);
        let behind = (near * near - source * source).max(0.0).sqrt();
        let (across, up) = (along - source, off + behind);
        // The straight line crosses the side at source + across · behind ÷ up.
        let crossing = source * up + across * behind;
        if crossing >= 0.0 && crossing <= side * up {
            return Reached { distance: (across * across + up * up).sqrt(), share: crossing / (side * up) };
        }
        // Not through the side, but past one of its ends.
        let beyond = side - along;
        let past = [near + (along * along + off * off).sqrt(), far + (beyond * beyond + off * off).sqrt()];
        if past[1] < past[0] {
            Reached { distance: past[1], share: 1.0 }
        } else {
            Reached { distance: past[0], share: 0.0 }
        }
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
        let found = Opposite::new(far(ends[0], ends[1]), ends.map(|end| far(corner, end))).reached(known);
        assert!((found.distance - far(source, corner)).abs() < 1e-12);
        let at = [0, 1].map(|axis| ends[0][axis] + found.share * (ends[1][axis] - ends[0][axis]));
        assert!((far(source, at) + far(at, corner) - found.distance).abs() < 1e-12);
    }

    #[test]
    fn a_corner_behind_an_end_is_reached_past_it() {
        let found = Opposite::new(1.0, [1.0, 1.5]).reached([1.0, 2.0]);
        assert!(found.share == 0.0 && (found.distance - 2.0).abs() < 1e-12);
        assert!((Opposite::new(1.0, [1.0, 1.0]).reached([0.0, 1.0]).distance - 1.0).abs() < 1e-12);
    }
}
