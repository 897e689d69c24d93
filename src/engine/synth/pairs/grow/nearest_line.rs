//! The drawn line that is nearest to each cell.

use crate::grid::Domain;
use crate::marks::{Path, distance_to_segment};
use crate::points::extent::Extent;
use crate::synth::pairs::plan::PairPlan;

/// A drawn line beside a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct NearestLine {
    /// Its direction, as the index of a thread.
    pub direction: usize,
    /// Its distance from the cell, px.
    pub away: f64,
    /// The period that is wanted there, px.
    pub period: f64,
}

/// The nearest drawn line of each cell, up to `reach` periods away; `None` where there is none.
pub(super) fn nearest_lines(plan: &PairPlan, reach: f64) -> Vec<Option<NearestLine>> {
    let extent = Extent::from(plan.canvas());
    let mut nearest: Vec<Option<NearestLine>> = vec![None; plan.grid.cells()];
    for (direction, threads) in plan.threads.iter().enumerate() {
        for (_, line) in threads.lines.iter().filter(|_| threads.keeps_lines()) {
            let period = threads.threads_at(line.center()).period;
            let reach = reach * period;
            let [low, high] = line.bounds();
            let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
            let half = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]) + reach);
            for (cell, nearest) in nearest.iter_mut().enumerate() {
                let [x, y] = plan.grid.center_px(cell);
                let way = extent.shortest([x - middle[0], y - middle[1]]);
                if way[0].abs() > half[0] || way[1].abs() > half[1] {
                    continue;
                }
                let away = distance_to(line, [middle[0] + way[0], middle[1] + way[1]]);
                if away < nearest.map_or(reach, |line| line.away.min(reach)) {
                    *nearest = Some(NearestLine { direction, away, period });
                }
            }
        }
    }
    nearest
}

/// The distance of a point from the middle of a line, px.
fn distance_to(line: &Path, point: [f64; 2]) -> f64 {
    let sides = line.points.windows(2);
    sides.map(|side| distance_to_segment(point, [side[0], side[1]])).fold(f64::INFINITY, f64::min)
}
