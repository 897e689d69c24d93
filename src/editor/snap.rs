//! Snapping to a grid whose lines start at the upper left corner of the canvas.

use serde::{Deserialize, Serialize};

/// The smallest and the largest distance of the lines, px.
pub const STEPS: [f64; 2] = [2.0, 512.0];

/// Whether what is drawn and moved snaps to a grid.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Snap {
    /// Whether snapping is on.
    pub on: bool,
    /// The distance of the lines, px.
    pub step: f64,
}

impl Default for Snap {
    fn default() -> Self {
        Self { on: false, step: 16.0 }
    }
}

impl Snap {
    /// The nearest point of the grid where snapping is on, else the point itself, px.
    #[must_use]
    pub fn at(self, point: [f64; 2]) -> [f64; 2] {
        let step = self.step.clamp(STEPS[0], STEPS[1]);
        if self.on { point.map(|coordinate| (coordinate / step).round() * step) } else { point }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_snap_to_the_nearest_crossing_while_the_grid_is_on() {
        let snap = Snap { on: true, step: 20.0 };
        assert_eq!(snap.at([29.0, 31.0]), [20.0, 40.0]);
        assert_eq!(Snap { on: false, ..snap }.at([29.0, 31.0]), [29.0, 31.0]);
        // A damaged setting must not cause a division by 0.
        assert_eq!(Snap { on: true, step: 0.0 }.at([29.2, 31.0]), [30.0, 32.0]);
    }
}
