//! Bodies, their rotation, and the intersection with a ray.

use super::maps::Maps;
use super::vector::{cross, dot, normalised};

/// Half the height and the radius of the cylinder.
const CYLINDER: [f32; 2] = [1.0, 0.62];

/// A body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Body {
    /// A square piece of a plane, one repetition of the maps.
    #[default]
    Plane,
    /// A sphere.
    Sphere,
    /// A cylinder that stands upright, without its ends.
    Cylinder,
}

impl Body {
    /// All bodies and their names.
    pub const ALL: [(Self, &'static str); 3] =
        [(Self::Plane, "Plane"), (Self::Sphere, "Sphere"), (Self::Cylinder, "Cylinder")];
}

/// The direction from which a body is seen, and how large it is shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Degrees about the vertical, to the right.
    pub yaw: f32,
    /// Degrees about the horizontal, −90..90; positive: seen from above.
    pub pitch: f32,
    /// Magnification: 1 shows the whole body.
    pub zoom: f32,
}

impl Default for Pose {
    fn default() -> Self {
        Self { yaw: -25.0, pitch: 20.0, zoom: 1.0 }
    }
}

impl Pose {
    /// This pose, rotated by a drag over this distance in points.
    #[must_use]
    pub fn turned(self, [x, y]: [f32; 2]) -> Self {
        /// Degrees a point.
        const SPEED: f32 = 0.5;
        let yaw = (self.yaw + SPEED * x + 180.0).rem_euclid(360.0) - 180.0;
        Self { yaw, pitch: (self.pitch + SPEED * y).clamp(-85.0, 85.0), ..self }
    }

    /// This pose, magnified by a further `factor`, at most eight times in all; never smaller than the whole body.
    #[must_use]
    pub fn zoomed(self, factor: f32) -> Self {
        const MOST: f32 = 8.0;
        Self { zoom: (self.zoom * factor).clamp(1.0, MOST), ..self }
    }
}

/// A point of a body: surface coordinates, and the directions to the right and up along the surface and out of it.
pub(super) struct Hit {
    /// Surface coordinates.
    pub(super) uv: [f32; 2],
    /// Directions to the right, up and out.
    pub(super) frame: [[f32; 3]; 3],
}

/// The rotation of a body.
pub(super) struct Turn {
    yaw: [f32; 2],
    pitch: [f32; 2],
}

impl Turn {
    /// The body in this `pose`.
    pub(super) fn new(pose: Pose) -> Self {
        let of = |degrees: f32| {
            let (sin, cos) = libm::sincosf(degrees.to_radians());
            [sin, cos]
        };
        Self { yaw: of(pose.yaw), pitch: of(pose.pitch) }
    }

    /// Transforms a vector from the body to the view.
    pub(super) fn out(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let ([sin, cos], [down, level]) = (self.yaw, self.pitch);
        let [x, z] = [cos * x + sin * z, cos * z - sin * x];
        [x, level * y - down * z, level * z + down * y]
    }

    /// Transforms a vector from the view to the body.
    pub(super) fn back(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let ([sin, cos], [down, level]) = (self.yaw, self.pitch);
        let [y, z] = [level * y + down * z, level * z - down * y];
        [cos * x - sin * z, y, cos * z + sin * x]
    }
}

/// The first intersection of the ray at a point of the view, which runs straight away from the viewer.
pub(super) fn cast(maps: &Maps, body: Body, turn: &Turn, [x, y]: [f32; 2]) -> Option<Hit> {
    use std::f32::consts::{PI, TAU};
    let [from, along] = [turn.back([x, y, 4.0]), turn.back([0.0, 0.0, -1.0])];
    let at = |t: f32| [0, 1, 2].map(|axis| from[axis] + t * along[axis]);
    let (uv, right, normal) = match body {
        Body::Plane => {
            // The back looks like the front.
            let t = -from[2] / along[2];
            let point = at(t);
            let aspect = maps.size[0] as f32 / maps.size[1] as f32;
            let half = if aspect > 1.0 { [1.0, 1.0 / aspect] } else { [aspect, 1.0] };
            if !t.is_finite() || point[0].abs() > half[0] || point[1].abs() > half[1] {
                return None;
            }
            let uv = [0.5 + 0.5 * point[0] / half[0], 0.5 - 0.5 * point[1] / half[1]];
            let front = if along[2] < 0.0 { 1.0 } else { -1.0 };
            (uv, [1.0, 0.0, 0.0], [0.0, 0.0, front])
        }
        Body::Sphere => {
            let b = dot(from, along);
            let root = b * b - (dot(from, from) - 1.0);
            let point = at(-b - (root >= 0.0).then(|| root.sqrt())?);
            let around = libm::atan2f(point[0], point[2]);
            let [columns, rows] = maps.repeats(2.0, 1.0);
            let up = libm::asinf(point[1].clamp(-1.0, 1.0)) / PI + 0.5;
            let right = normalised([point[2], 0.0, -point[0]]);
            ([columns * (0.5 + around / TAU), rows * (1.0 - up)], right, point)
        }
        Body::Cylinder => {
            let [half, radius] = CYLINDER;
            let a = along[0] * along[0] + along[2] * along[2];
            let b = from[0] * along[0] + from[2] * along[2];
            let root = b * b - a * (from[0] * from[0] + from[2] * from[2] - radius * radius);
            let root = (root >= 0.0 && a > 1e-9).then(|| root.sqrt())?;
            // The outside, or else the inside through the open end.
            let hit = |sign: f32| Some(at((-b + sign * root) / a)).filter(|point| point[1].abs() <= half);
            let (point, out) = hit(-1.0).map(|point| (point, 1.0)).or_else(|| Some((hit(1.0)?, -1.0)))?;
            let around = libm::atan2f(point[0], point[2]);
            let [columns, rows] = maps.repeats(TAU * radius, 2.0 * half);
            let uv = [columns * (0.5 + around / TAU), rows * (0.5 - 0.5 * point[1] / half)];
            let normal = [out * point[0] / radius, 0.0, out * point[2] / radius];
            (uv, normalised([point[2], 0.0, -point[0]]), normal)
        }
    };
    let frame = [right, cross(normal, right), normal].map(|axis| turn.out(axis));
    Some(Hit { uv, frame })
}
