//! The initial lines of threads: with the wanted width and distance, all over the canvas.
//!
//! Threads follow the crests of a phase with their directions and distances, see [`ThreadPhase`]. If there is no such phase,
//! stripes with these directions and distances are grown through the drawn lines; each thread then begins along the middle of a
//! stripe.

use std::f64::consts::TAU;

use rayon::prelude::*;

use crate::grid::{Domain, Field};
use crate::rd::pairs::PairKind;
use crate::synth::pairs::grown::ThreadPhase;
use crate::synth::pairs::plan::PairPlan;
use crate::synth::pairs::plan::thread_map::ThreadMap;

/// The initial state of threads.
pub(super) struct SeedLines {
    /// The reaction at each cell, 0..1: 1 on a line.
    pub reaction: Vec<f32>,
    /// Increase of the threshold at each cell, in K₀. It is 0 on the lines and beside them. Between them it is so large that no other
    /// thread grows and that these stay where they are: otherwise curved threads would move to the inside of the curve. Empty for a
    /// maze, which grows between its pieces.
    pub raised: Vec<f32>,
}

/// Distances from the middle of a line, in its widths, between which the increase of the threshold rises from 0 to its full value.
/// Edges are at one half.
const FREE: [f64; 2] = [0.65, 1.0];
/// Increase of the threshold between lines, in K₀: larger than any difference.
const RAISED: f64 = 1.0;

impl SeedLines {
    /// No lines yet.
    pub(super) fn none(plan: &PairPlan) -> Self {
        let cells = plan.grid.cells();
        let is_maze = plan.kind() == PairKind::Maze;
        let raised = if is_maze { Vec::new() } else { vec![RAISED as f32; cells] };
        Self { reaction: vec![0.0; cells], raised }
    }

    /// Adds the lines of one `direction`, by the distance of each cell from the middle of one, px; for a maze on its own pieces.
    pub(super) fn add(&mut self, plan: &PairPlan, direction: usize, from_middle: &[f32]) {
        let threads = &plan.threads[direction];
        let line = |(cell, from_middle): (usize, &f32)| {
            let (width, from_middle) = (threads.at(plan.grid.center_px(cell)).width, f64::from(*from_middle));
            let covered = ((0.5 * width - from_middle) / plan.px_a_cell() + 0.5).clamp(0.0, 1.0);
            let away = ((from_middle / width - FREE[0]) / (FREE[1] - FREE[0])).clamp(0.0, 1.0);
            [covered as f32, (RAISED * away * away * (3.0 - 2.0 * away)) as f32]
        };
        let own: Vec<[f32; 2]> = from_middle.par_iter().enumerate().map(line).collect();
        let is_maze = plan.kind() == PairKind::Maze;
        let is_own = |cell: usize| !is_maze || plan.piece_at(plan.grid.center_px(cell)) == direction;
        let Self { reaction, raised } = self;
        for (cell, (reaction, own)) in
            reaction.iter_mut().zip(&own).enumerate().filter(|(cell, _)| is_own(*cell))
        {
            *reaction = reaction.max(own[0]);
            if let Some(raised) = raised.get_mut(cell) {
                *raised = raised.min(own[1]);
            }
        }
    }

    /// Removes the parts of lines on marks of the layers beneath.
    pub(super) fn beside_obstacles(&mut self, plan: &PairPlan) {
        for (value, taken) in self.reaction.iter_mut().zip(&plan.obstacles) {
            *value *= f32::from(u8::from(!taken));
        }
    }
}

/// The distance of each cell from the middle of a line of these threads, px; `None` if they follow no phase, so that stripes have
/// to be grown.
pub(super) fn from_phase(threads: &ThreadMap, plan: &PairPlan) -> Option<Vec<f32>> {
    let phase = ThreadPhase::new(threads, &plan.canvas())?;
    Some(along_crests(&phase, plan))
}

/// The distance of each cell from the nearest crest of a phase, px.
fn along_crests(phase: &ThreadPhase, plan: &PairPlan) -> Vec<f32> {
    let cell = plan.px_a_cell();
    let distance = |index: usize| {
        let [x, y] = plan.grid.center_px(index);
        let periods = phase.periods_at([x, y]);
        // The wave vector there, periods per px.
        let slope = [[0.5 * cell, 0.0], [0.0, 0.5 * cell]].map(|[dx, dy]| {
            let [ahead, behind] = [1.0, -1.0].map(|side| phase.periods_at([x + side * dx, y + side * dy]));
            (ahead - behind) / cell
        });
        let slope = (slope[0] * slope[0] + slope[1] * slope[1]).sqrt().max(f64::MIN_POSITIVE);
        ((periods - periods.round()).abs() / slope) as f32
    };
    (0..plan.grid.cells()).into_par_iter().map(distance).collect()
}

/// The distance of each cell from the middles of the stripes in `pattern`, px.
///
/// Across a stripe the pattern is about ½ + ½ cos of the phase from its middle.
pub(super) fn from_middles(pattern: &Field, threads: &ThreadMap, plan: &PairPlan) -> Vec<f32> {
    let distance = |(index, value): (usize, &f32)| {
        let turns = libm::acos((2.0 * f64::from(*value) - 1.0).clamp(-1.0, 1.0)) / TAU;
        (turns * threads.threads_at(plan.grid.center_px(index)).period) as f32
    };
    pattern.values.par_iter().enumerate().map(distance).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Document, Layer, Stroke, SystemChoice};
    use crate::grid::resample::Spline;

    #[test]
    fn curved_lines_begin_where_they_were_drawn() {
        let wave = |y: f64| -> Vec<[f64; 2]> {
            (0..=36).map(|i| 20.0 + 10.0 * f64::from(i)).map(|x| [x, y + 25.0 * (x / 80.0).sin()]).collect()
        };
        let waves = [100.0, 128.0, 156.0].map(|y| Stroke::path(wave(y), 8.0));
        let lines = [150.0, 190.0].map(|x| Stroke::line([x, 20.0], [x + 10.0, 280.0], 8.0));
        let layer = Layer::new(waves.into_iter().chain(lines))
            .with_system(SystemChoice::Of(PairKind::Weave.description()));
        let document = Document::new([400, 300]).with_layer(layer);
        let plan = PairPlan::read(&document, 0, "waves", [400.0, 300.0], None).expect("two directions");
        for threads in &plan.threads {
            let phase = ThreadPhase::new(threads, &plan.canvas()).expect("a phase");
            let surface = Spline::new(&Field::new(&plan.grid, along_crests(&phase, &plan)));
            for (_, line) in &threads.lines {
                let covered = line.samples(50).iter().filter(|s| surface.at(s.point) < 2.0).count();
                assert!(covered >= 48, "{covered} of 50 of {:?}", line.points[0]);
            }
        }
    }
}
