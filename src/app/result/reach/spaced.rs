//! Moving the marks of a region apart.

use crate::attributes::regions::RegionGrid;
use crate::editor::shape;
use crate::marks::Mark;

/// Distance of marks from the border of their region, px.
const RIM: f64 = 0.5;

/// Half the width and height of an ellipse that is scaled by `factor`, px.
pub(super) fn reach_of(mark: &Mark, factor: f64) -> [f64; 2] {
    let extent = shape::extent([mark]).unwrap_or_default();
    [0, 1].map(|axis| 0.5 * factor * (extent[1][axis] - extent[0][axis]))
}

/// The centres, scaled by `by` about the centre of their region; `None` where they do not fit into it. A mark that was
/// wholly on the canvas stays wholly on it: `reaches` is half the width and height of each mark.
pub(super) fn spaced(
    centers: &[[f64; 2]],
    reaches: &[[f64; 2]],
    by: f64,
    layout: &RegionGrid,
    place: [usize; 2],
) -> Option<Vec<[f64; 2]>> {
    let midpoint = layout.center(place);
    let mut moved: Vec<[f64; 2]> = centers
        .iter()
        .map(|at| [0, 1].map(|axis| midpoint[axis] + by * (at[axis] - midpoint[axis])))
        .collect();
    for axis in 0..2 {
        let side = layout.size[axis] / layout.grid[axis] as f64;
        let [low, high] = [-0.5, 0.5].map(|half| midpoint[axis] + half * side);
        // How far each centre is from its lower limit, and from its upper one.
        let mut room = [f64::INFINITY; 2];
        for ((before, after), reach) in centers.iter().zip(&moved).zip(reaches) {
            let (before, after, reach) = (before[axis], after[axis], reach[axis]);
            let at_start = if low <= 0.0 { reach.min(before).max(RIM) } else { RIM };
            let at_end =
                if high >= layout.size[axis] { reach.min(layout.size[axis] - before).max(RIM) } else { RIM };
            room = [room[0].min(after - low - at_start), room[1].min(high - at_end - after)];
        }
        if room[0] + room[1] < 0.0 {
            return None;
        }
        let by = (-room[0]).max(0.0) - (-room[1]).max(0.0);
        moved.iter_mut().for_each(|at| at[axis] += by);
    }
    Some(moved)
}
