//! Filled rectangles that are lines.

use crate::marks::Line;
use crate::sketch::hull::Hull;

/// A rectangle longer than so many times its width is a line.
const LONG: f64 = 3.0;
/// The least share of its box that a rectangle fills: one with round ends fills 0.93, an ellipse 0.79.
const FILLED: f64 = 0.9;

/// The line that a filled outline is, with the middles of its short sides as ends; `None` where it is no rectangle, or not
/// longer than three times its width. `rim` is the width of the pen that its outline is drawn with, px.
pub(super) fn bar(outline: &[[f64; 2]], rim: f64) -> Option<Line> {
    let hull = Hull::new(outline)?;
    let (area, corners) = (polygon_area(outline), hull.corners());
    let boxes =
        corners.iter().zip(corners.iter().cycle().skip(1)).filter_map(|(a, b)| Frame::along(corners, *a, *b));
    let frame = boxes.min_by(|a, b| a.area().total_cmp(&b.area()))?;
    let [length, width] = frame.sides;
    let is_bar = width > 1e-6 * length && area >= FILLED * frame.area() && length > LONG * width;
    is_bar.then(|| Line {
        from: frame.on_axis(-0.5 * (length + rim)),
        to: frame.on_axis(0.5 * (length + rim)),
        width: width + rim,
    })
}

/// A box around a shape.
struct Frame {
    center: [f64; 2],
    /// Unit vector along the longer side.
    along: [f64; 2],
    /// The longer side and the shorter.
    sides: [f64; 2],
}

impl Frame {
    /// The smallest one around `corners` with a side in the direction from `a` to `b`.
    fn along(corners: &[[f64; 2]], a: [f64; 2], b: [f64; 2]) -> Option<Self> {
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let length = (x * x + y * y).sqrt();
        if length <= 0.0 {
            return None;
        }
        let axes = [[x / length, y / length], [-y / length, x / length]];
        let ranges = axes.map(|axis| {
            let along = corners.iter().map(|corner| axis[0] * corner[0] + axis[1] * corner[1]);
            along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], t| [low.min(t), high.max(t)])
        });
        let [middle_0, middle_1] = ranges.map(|[low, high]| 0.5 * (low + high));
        let sides = ranges.map(|[low, high]| high - low);
        let center = [0, 1].map(|k| middle_0 * axes[0][k] + middle_1 * axes[1][k]);
        let longer = usize::from(sides[1] > sides[0]);
        Some(Self { center, along: axes[longer], sides: [sides[longer], sides[1 - longer]] })
    }

    fn area(&self) -> f64 {
        self.sides[0] * self.sides[1]
    }

    /// The point so far from the middle along the longer side.
    fn on_axis(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|axis| self.center[axis] + t * self.along[axis])
    }
}

fn polygon_area(outline: &[[f64; 2]]) -> f64 {
    let [x0, y0] = outline[0];
    let next = outline.iter().cycle().skip(1);
    let twice: f64 =
        outline.iter().zip(next).map(|(a, b)| (a[0] - x0) * (b[1] - y0) - (b[0] - x0) * (a[1] - y0)).sum();
    0.5 * twice.abs()
}
