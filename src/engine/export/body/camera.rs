//! The view of a model: direction, size of the picture, and perspective.

use super::vector::{Vector, dot, minus, plus};
use crate::surface::Mesh;

/// A direction of view and the size of the picture. The whole model is in the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Degrees around the upward axis: at 0 x points to the right and the viewer is at +z (with y up), at 90 the viewer is at +x.
    pub azimuth: f64,
    /// Degrees above the horizon.
    pub elevation: f64,
    /// Width and height of the picture, px.
    pub size: [u32; 2],
    /// Linear light behind the model; `None` = transparent.
    pub background: Option<[f32; 3]>,
    /// Whether the model casts a shadow on a floor under it.
    pub shadow: bool,
    /// Whether the distance is one from which the whole model is in the picture from all sides: the model can be turned.
    pub turns: bool,
}

impl View {
    /// A view for a picture of this size in px, on a light gray ground with a shadow.
    #[must_use]
    pub fn new(azimuth: f64, elevation: f64, size: [u32; 2]) -> Self {
        Self { azimuth, elevation, size, background: Some([0.76; 3]), shadow: true, turns: false }
    }
}

/// Half the angle of view along the longer side, as its tangent: 14 degrees.
const HALF_ANGLE: f64 = 0.25;
/// Share of each side that stays free around the model.
const MARGIN: f64 = 0.07;

/// A perspective camera that has the whole model in its picture.
pub struct Camera {
    /// Rightward, upward, and toward the viewer.
    pub axes: [Vector; 3],
    pub eye: Vector,
    /// px for a unit of length at distance 1.
    scale: f64,
    middle: [f64; 2],
}

impl Camera {
    pub fn new(view: &View, places: &[Vector]) -> Self {
        let swept = view.turns.then(|| swept(places));
        let places = swept.as_deref().unwrap_or(places);
        let (sin, cos) = libm::sincos(view.azimuth.to_radians());
        let (sine, cosine) = libm::sincos(view.elevation.to_radians());
        let axes = [[cos, 0.0, -sin], [-sin * sine, cosine, -cos * sine], [sin * cosine, sine, cos * cosine]];
        let size = view.size.map(|side| f64::from(side.max(1)));
        let scale = 0.5 * size[0].max(size[1]) / HALF_ANGLE;
        // The tangents of the directions to the borders. A point is in the picture if |x − eye.x| ≤ tangent · (eye.z − z).
        let tangents = size.map(|side| 0.5 * side * (1.0 - 2.0 * MARGIN) / scale);
        let mut reach = [[f64::NEG_INFINITY; 2]; 2];
        let mut nearest = f64::NEG_INFINITY;
        for place in places.iter().filter(|place| place.iter().all(|value| value.is_finite())) {
            let depth = dot(*place, axes[2]);
            nearest = nearest.max(depth);
            for axis in 0..2 {
                let across = dot(*place, axes[axis]);
                reach[axis][0] = reach[axis][0].max(tangents[axis] * depth - across);
                reach[axis][1] = reach[axis][1].max(tangents[axis] * depth + across);
            }
        }
        let needed = [0, 1].map(|axis| (reach[axis][0] + reach[axis][1]) / (2.0 * tangents[axis]));
        let mut distance = needed[0].max(needed[1]);
        // The middle of the box is behind the camera only if the model is a point or empty.
        distance = if distance > nearest { distance } else { nearest + 1.0 };
        let [x, y] = [0, 1].map(|axis| 0.5 * (reach[axis][1] - reach[axis][0]));
        let eye = [(x, axes[0]), (y, axes[1]), (distance, axes[2])]
            .iter()
            .fold([0.0; 3], |eye, (length, axis)| plus(eye, *length, *axis));
        Self { axes, eye, scale, middle: size.map(|side| 0.5 * side) }
    }

    /// Position of a place in the picture, px from the upper left corner, and 1 ÷ its depth.
    pub fn seen(&self, place: Vector) -> [f64; 3] {
        let from = minus(place, self.eye);
        let near = -1.0 / dot(from, self.axes[2]);
        let [x, y] = [0, 1].map(|axis| self.scale * dot(from, self.axes[axis]) * near);
        [self.middle[0] + x, self.middle[1] - y, near]
    }

    /// The length that a px shows of what is seen at this 1 ÷ depth and faces the viewer.
    pub fn px(&self, near: f64) -> f64 {
        1.0 / (self.scale * near)
    }

    /// The direction from the eye to a point of the picture; not of length 1.
    pub fn ray(&self, [x, y]: [f64; 2]) -> Vector {
        let forward = self.axes[2].map(|value| -value);
        let right = plus(forward, (x - self.middle[0]) / self.scale, self.axes[0]);
        plus(right, (self.middle[1] - y) / self.scale, self.axes[1])
    }
}

/// The length that a px shows of the middle of a model with these vertices.
#[must_use]
pub fn length_of_px(view: &View, places: &[Vector]) -> f64 {
    let camera = Camera::new(view, places);
    let [low, high] = Mesh { positions: places.to_vec(), faces: Vec::new() }.bounds();
    let middle = plus(low, 0.5, minus(high, low));
    camera.px(camera.seen(middle)[2])
}

/// Corners around all places, however they are turned about the upward axis through their middle.
fn swept(places: &[Vector]) -> Vec<Vector> {
    /// Corners of a circle.
    const ROUND: usize = 64;
    let finite = || places.iter().filter(|place| place.iter().all(|value| value.is_finite()));
    let range = |axis: usize| {
        let (low, high) =
            finite().fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at[axis]), high.max(at[axis])));
        [low, high]
    };
    let [x, y, z] = [range(0), range(1), range(2)];
    let [x, z] = [x, z].map(|[low, high]| 0.5 * (low + high));
    let radius = finite().map(|at| libm::hypot(at[0] - x, at[2] - z)).fold(0.0, f64::max);
    let corners = (0..ROUND).flat_map(|k| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * k as f64 / ROUND as f64);
        y.map(|height| [x + radius * cos, height, z + radius * sin])
    });
    if finite().next().is_some() { corners.collect() } else { Vec::new() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_whole_model_is_in_the_picture_and_fills_it() {
        let places: Vec<Vector> = (0..8)
            .map(|at| [0, 1, 2].map(|axis| f64::from(at >> axis & 1) * [5.0, 1.0, 2.0][axis]))
            .collect();
        for (azimuth, elevation) in [(0.0, 0.0), (35.0, 20.0), (180.0, -60.0), (270.0, 90.0)] {
            let camera = Camera::new(&View::new(azimuth, elevation, [400, 300]), &places);
            let seen: Vec<[f64; 3]> = places.iter().map(|place| camera.seen(*place)).collect();
            let side = |axis: usize| {
                let values = seen.iter().map(|seen| seen[axis]);
                [values.clone().fold(f64::MAX, f64::min), values.fold(f64::MIN, f64::max)]
            };
            let [[left, right], [top, bottom]] = [side(0), side(1)];
            assert!(left >= 27.9 && right <= 372.1 && top >= 20.9 && bottom <= 279.1, "{seen:?}");
            assert!(right - left > 343.0 || bottom - top > 257.0, "{seen:?}");
            assert!(seen.iter().all(|seen| seen[2] > 0.0));
        }
    }

    #[test]
    fn x_points_right_at_azimuth_0_and_toward_the_viewer_at_90() {
        let seen = |azimuth: f64| {
            let box_corners = [[-1.0, -1.0, -1.0], [-1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0]];
            let camera = Camera::new(&View::new(azimuth, 0.0, [100, 100]), &box_corners);
            [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].map(|place| camera.seen(place))
        };
        let [middle, x, y] = seen(0.0);
        assert!(x[0] > middle[0] + 5.0 && y[1] < middle[1] - 5.0);
        let [middle, x, _] = seen(90.0);
        assert!((x[0] - middle[0]).abs() < 1e-9 && x[2] > middle[2]);
    }

    #[test]
    fn a_ray_passes_through_the_place_seen_in_its_point() {
        let camera = Camera::new(&View::new(30.0, 40.0, [200, 100]), &[[-1.0; 3], [1.0; 3]]);
        let place = [0.3, -0.2, 0.7];
        let [x, y, near] = camera.seen(place);
        let found = plus(camera.eye, 1.0 / near, camera.ray([x, y]));
        assert!((0..3).all(|axis| (found[axis] - place[axis]).abs() < 1e-9), "{found:?}");
    }

    #[test]
    fn a_single_point_and_an_empty_model_have_a_camera() {
        for places in [&[][..], &[[2.0; 3]], &[[f64::NAN; 3]]] {
            let camera = Camera::new(&View::new(0.0, 0.0, [10, 10]), places);
            assert!(places.iter().all(|place| place[0].is_nan() || camera.seen(*place)[2] > 0.0));
        }
    }

    #[test]
    fn a_model_that_turns_keeps_its_size() {
        let bar: Vec<Vector> =
            [[-9.0, 0.0, 0.0], [9.0, 2.0, 0.0], [0.0, 1.0, 1.0], [0.0, 1.0, -1.0]].to_vec();
        let height = |azimuth: f64| {
            let camera = Camera::new(&View { turns: true, ..View::new(azimuth, 0.0, [200, 100]) }, &bar);
            let [low, high] = [0.0, 2.0].map(|y| camera.seen([0.0, y, 0.0])[1]);
            low - high
        };
        assert!([10.0, 90.0, 200.0].iter().all(|azimuth| (height(*azimuth) - height(0.0)).abs() < 0.01));
    }
}
