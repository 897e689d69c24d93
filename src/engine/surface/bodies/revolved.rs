//! Bodies of revolution: sphere, cylinder, capsule, spindle, vase, egg.

use std::f64::consts::{FRAC_PI_2, PI};

use super::super::model::Model;
use super::curve::curve;
use super::rings::{surface, turn};

/// Vertices around.
const AROUND: usize = 96;

/// The surface of revolution of a profile of [radius, height] about the y axis; the profile runs upwards on its outside. Ends at
/// radius 0 are poles.
fn revolved(profile: &[[f64; 2]]) -> Model {
    let ring = |[radius, height]: &[f64; 2]| {
        if *radius == 0.0 {
            return vec![[0.0, *height, 0.0]];
        }
        // From +x toward −z: counter-clockwise seen from above, to the right seen from outside.
        turn(AROUND).map(|[cos, sin]| [radius * cos, *height, -radius * sin]).collect()
    };
    surface(&profile.iter().map(ring).collect::<Vec<_>>(), false)
}

/// A profile for parameters from 0 to 1 in `steps` steps; its ends are poles.
fn profile(steps: usize, at: impl Fn(f64) -> [f64; 2]) -> Vec<[f64; 2]> {
    let mut profile: Vec<[f64; 2]> = (0..=steps).map(|step| at(step as f64 / steps as f64)).collect();
    profile[0][0] = 0.0;
    profile[steps][0] = 0.0;
    profile
}

pub fn sphere() -> Model {
    revolved(&profile(48, |t| {
        let (sin, cos) = libm::sincos(PI * t);
        [sin, -cos]
    }))
}

/// An egg on its blunt end: a sphere whose radius is less toward the top.
pub fn egg() -> Model {
    revolved(&profile(48, |t| {
        let (sin, cos) = libm::sincos(PI * t);
        let height = -cos;
        [0.72 * sin * (1.0 - 0.16 * height), height]
    }))
}

/// A cylinder with flat ends and sharp edges.
pub fn cylinder() -> Model {
    let [radius, half] = [0.6, 1.0];
    let steps = |count: usize| (1..=count).map(move |step| step as f64 / count as f64);
    let mut profile = vec![[0.0, -half]];
    profile.extend(steps(16).map(|t| [radius * t, -half]));
    profile.extend(steps(50).map(|t| [radius, half * (2.0 * t - 1.0)]));
    profile.extend(steps(16).map(|t| [radius * (1.0 - t), half]));
    revolved(&profile)
}

pub fn capsule() -> Model {
    let [radius, half] = [0.5, 0.5];
    let cap = |t: f64, sign: f64| {
        let (sin, cos) = libm::sincos(FRAC_PI_2 * t);
        [radius * sin, sign * (half + radius * cos)]
    };
    let mut profile = vec![[0.0, -half - radius]];
    profile.extend((1..=24).map(|step| cap(f64::from(step) / 24.0, -1.0)));
    profile.extend((1..30).map(|step| [radius, half * (f64::from(step) / 15.0 - 1.0)]));
    profile.extend((0..24).rev().map(|step| cap((f64::from(step) + 1.0) / 24.0, 1.0)));
    profile.push([0.0, half + radius]);
    revolved(&profile)
}

/// A spindle along x, thickest before its middle, its points rounded.
pub fn spindle() -> Model {
    let model = revolved(&profile(64, |t| {
        let (sin, cos) = libm::sincos(PI * t);
        [0.42 * sin * (0.35 + 0.65 * sin) * (1.0 - 0.12 * cos), -cos]
    }));
    // The y axis becomes the x axis.
    let positions = model.positions.iter().map(|[x, y, z]| [*y, -*x, *z]).collect();
    Model { positions, ..model }
}

/// Radius and height of the vase's outside, from the foot to the lip.
const OUTSIDE: [[f64; 2]; 11] = [
    [0.34, -1.0],
    [0.37, -0.97],
    [0.36, -0.9],
    [0.46, -0.7],
    [0.6, -0.35],
    [0.62, 0.0],
    [0.5, 0.35],
    [0.3, 0.62],
    [0.25, 0.78],
    [0.3, 0.92],
    [0.4, 1.0],
];
/// The thickness of its wall.
const WALL: f64 = 0.06;

/// A vase with a belly, a neck and a lip, open above, with an inside.
pub fn vase() -> Model {
    let outside = curve(&OUTSIDE, 6);
    let mut profile: Vec<[f64; 2]> =
        (0..8).map(|step| [OUTSIDE[0][0] * f64::from(step) / 8.0, -1.0]).collect();
    profile.extend(&outside);
    // The lip is half a circle from the outside to the inside.
    let [radius, height] = OUTSIDE[10];
    profile.extend((1..8).map(|step| {
        let (sin, cos) = libm::sincos(PI * f64::from(step) / 8.0);
        [radius - 0.5 * WALL * (1.0 - cos), height + 0.5 * WALL * sin]
    }));
    let inside: Vec<[f64; 2]> = outside.iter().map(|[radius, height]| [radius - WALL, *height]).collect();
    let floor = -1.0 + 1.5 * WALL;
    profile.extend(inside.iter().rev().filter(|[_, height]| *height > floor + 0.04));
    let last = profile[profile.len() - 1][0];
    profile.extend((0..8).map(|step| [0.94 * last * (1.0 - f64::from(step) / 8.0), floor]));
    profile.push([0.0, floor]);
    revolved(&profile)
}
