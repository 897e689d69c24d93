//! A ring.

use super::super::model::Model;
use super::rings::{surface, turn};

/// A torus that lies flat: around the y axis.
pub fn torus() -> Model {
    let [large, small] = [0.72, 0.28];
    let ring = |[cos, sin]: [f64; 2]| {
        let [radius, height] = [large + small * cos, small * sin];
        turn(120).map(|[cos, sin]| [radius * cos, height, -radius * sin]).collect()
    };
    surface(&turn(48).map(ring).collect::<Vec<_>>(), true)
}
