//! Straight lines over the faces.

use super::adjacency::{NONE, next, previous};
use super::point::SurfacePoint;
use super::triangle_surface::Surface;

/// Most faces that are crossed on a line of the length 0, and their increase per unit.
const FACES: [f64; 2] = [100.0, 50.0];

type Point = [f64; 2];

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

impl Surface {
    /// The place at the end of a straight line, whose displacement is given in the frame of its start; the place on the border if
    /// it leads there.
    #[must_use]
    pub fn walk(&self, from: SurfacePoint, displacement: [f64; 2]) -> SurfacePoint {
        let far = (displacement[0] * displacement[0] + displacement[1] * displacement[1]).sqrt();
        if far == 0.0 || !far.is_finite() {
            return from;
        }
        let Some((half, angle)) = self.heading(from, displacement) else { return from };
        // The face in a plane, with its corner at the vertex of the place at the origin, and the first side along x.
        let mut half = half;
        let mut corners = self.laid_out(half, [0.0; 2], [self.tangents.lengths[half as usize], 0.0]);
        let shares = if half / 3 == from.face { from.shares() } else { at_corner(half) };
        let [b, c] = [next(half), previous(half)].map(|half| shares[half as usize % 3]);
        let mut at = [0, 1].map(|axis| b * corners[1][axis] + c * corners[2][axis]);
        let (sin, cos) = libm::sincos(angle);
        let ahead = [cos, sin];
        let mut left = far;
        let mut faces = FACES[0] + FACES[1] * far / self.unit();
        loop {
            let (steps, side) = exit(corners, at, ahead);
            let end = [at[0] + ahead[0] * steps.min(left), at[1] + ahead[1] * steps.min(left)];
            let leaves = [half, next(half), previous(half)][side];
            let twin = self.adjacency.twins[leaves as usize];
            faces -= 1.0;
            if left <= steps || twin == NONE || faces < 0.0 {
                return place_at(half, corners, end);
            }
            left -= steps;
            at = end;
            corners = self.laid_out(twin, corners[(side + 1) % 3], corners[side]);
            half = twin;
        }
    }

    /// The corner in which a line from a place begins, as half-edge, and the angle from that half-edge, counter-clockwise. `None`
    /// if it leads over the border at once.
    fn heading(&self, from: SurfacePoint, displacement: [f64; 2]) -> Option<(u32, f64)> {
        let corner = from.corner();
        let own = 3 * from.face + corner as u32;
        let vertex = self.mesh.faces[from.face as usize][corner] as usize;
        let angle = libm::atan2(displacement[1], displacement[0]);
        let from_half = |half: u32| {
            let turned = self.tangents.angles[half as usize] - angle;
            turned.rem_euclid(std::f64::consts::TAU)
        };
        let scale = self.tangents.scales[vertex];
        if from.shares()[corner] < 1.0 {
            let turned = from_half(own);
            // Also behind the corner: less than 180° either way.
            let turned = if turned > std::f64::consts::PI { turned - std::f64::consts::TAU } else { turned };
            return Some((own, turned / scale));
        }
        let inside = self.adjacency.fan(vertex).map(|half| (half, from_half(half) / scale));
        let (half, angle) = inside.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let [_, _, apex] = self.laid_out(half, [0.0; 2], [self.tangents.lengths[half as usize], 0.0]);
        let opening = libm::atan2(apex[1], apex[0]);
        (angle <= opening + 1e-9).then_some((half, angle))
    }

    /// The corners of a face in a plane, beginning with the vertex that a half-edge leaves, from the positions of its ends.
    fn laid_out(&self, half: u32, from: Point, to: Point) -> [Point; 3] {
        let lengths = &self.tangents.lengths;
        let [side, second, first] = [half, next(half), previous(half)].map(|half| lengths[half as usize]);
        let along = (side * side + first * first - second * second) / (2.0 * side);
        let up = (first * first - along * along).max(0.0).sqrt();
        let axis = [(to[0] - from[0]) / side, (to[1] - from[1]) / side];
        let apex = [from[0] + along * axis[0] - up * axis[1], from[1] + along * axis[1] + up * axis[0]];
        [from, to, apex]
    }
}

fn at_corner(half: u32) -> [f64; 3] {
    let mut shares = [0.0; 3];
    shares[half as usize % 3] = 1.0;
    shares
}

/// The distance to the exit from a triangle, and the side of the exit.
fn exit(corners: [Point; 3], at: Point, ahead: Point) -> (f64, usize) {
    let mut found = (f64::INFINITY, 0);
    for side in 0..3 {
        let edge = minus(corners[(side + 1) % 3], corners[side]);
        // The inside lies to the left of each side.
        let leaving = cross(edge, ahead);
        if leaving < 0.0 {
            let steps = (cross(edge, minus(corners[side], at)) / leaving).max(0.0);
            if steps < found.0 {
                found = (steps, side);
            }
        }
    }
    found
}

/// The place in a face with these corners in the plane.
fn place_at(half: u32, corners: [Point; 3], at: Point) -> SurfacePoint {
    let [a, b, c] = corners;
    let area = cross(minus(b, a), minus(c, a)).max(f64::MIN_POSITIVE);
    let second = cross(minus(at, a), minus(c, a)) / area;
    let third = cross(minus(b, a), minus(at, a)) / area;
    let mut shares = [0.0; 3];
    for (half, share) in
        [half, next(half), previous(half)].into_iter().zip([1.0 - second - third, second, third])
    {
        shares[half as usize % 3] = share;
    }
    SurfacePoint::new(half / 3, shares)
}
