//! A snake that lies in curves, with its head slightly raised.

use std::f64::consts::PI;

use super::super::model::Model;
use super::rings::{surface, turn};

/// Rings along the snake.
const ALONG: usize = 320;
/// Vertices around it.
const AROUND: usize = 40;
/// Half the thickness of its body.
const THICK: f64 = 0.105;

/// The centre line, 0 at the tip of the tail, 1 at the snout.
fn line(t: f64) -> [f64; 3] {
    // The tail is less bent, the neck is straight, and its end is lifted.
    let bend = 0.42 * (0.35 + 0.65 * smooth_step(t / 0.35)) * (1.0 - 0.85 * smooth_step((t - 0.76) / 0.22));
    let lift = 0.13 * smooth_step((t - 0.74) / 0.20);
    [1.9 * t - 0.95, half_sizes(t.min(0.9))[1] + lift, bend * libm::sin(3.5 * PI * t + 0.6)]
}

/// Half the width and half the height.
fn half_sizes(t: f64) -> [f64; 2] {
    let tail = 1.0 - square(1.0 - (t / 0.6).min(1.0));
    let body = THICK * tail * (1.0 - 0.40 * smooth_step((t - 0.6) / 0.26));
    let head = bump((t - 0.945) / 0.075);
    // Its end is round: the section of a circle.
    let snout = (1.0 - square(((t - 0.93) / 0.07).max(0.0))).max(0.0).sqrt();
    [(body + 0.050 * head) * snout, (body + 0.010 * head) * snout]
}

fn smooth_step(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// 1 at 0, and 0 from 1 on.
fn bump(t: f64) -> f64 {
    square(1.0 - square(t).min(1.0))
}

fn square(value: f64) -> f64 {
    value * value
}

pub fn snake() -> Model {
    let ring = |step: usize| {
        // More rings toward the snout, where the section changes fast.
        let left = 1.0 - step as f64 / ALONG as f64;
        let t = 1.0 - left * (0.4 * left + 0.6 * left * (1.0 - left) + 0.6 * left * left);
        let middle = line(t);
        if step == 0 || step == ALONG {
            return vec![middle];
        }
        let [before, after] = [line(t - 1e-4), line(t + 1e-4)];
        let ahead = unit([0, 1, 2].map(|axis| after[axis] - before[axis]));
        // The back is up.
        let side = unit([-ahead[2], 0.0, ahead[0]]);
        let up = [
            side[1] * ahead[2] - side[2] * ahead[1],
            side[2] * ahead[0] - side[0] * ahead[2],
            side[0] * ahead[1] - side[1] * ahead[0],
        ];
        let [width, height] = half_sizes(t);
        let point = |[cos, sin]: [f64; 2]| {
            [0, 1, 2].map(|axis| middle[axis] - width * cos * side[axis] + height * sin * up[axis])
        };
        turn(AROUND).map(point).collect()
    };
    surface(&(0..=ALONG).map(ring).collect::<Vec<_>>(), false)
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let length = vector.iter().map(|value| value * value).sum::<f64>().sqrt();
    vector.map(|value| value / length)
}
