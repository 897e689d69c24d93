//! Growth on one of the grids.

use rayon::prelude::*;

use crate::grid::{Domain, exp, ln};
use crate::rd::{
    Growth, InitialConditions, ParameterField, Parameters, System, prolongate, with_obstacle_state,
};
use crate::synth::marks::grow::convergence::ConvergenceMonitor;
use crate::synth::marks::grow::grid_levels;
use crate::synth::marks::grow::grid_levels::Work;
use crate::synth::profile::{Section, during};

/// Growth on one grid.
#[derive(Clone, Debug)]
pub(super) struct GridLevel {
    /// Its index, 0 = the coarsest.
    pub index: usize,
    /// Parameters on this grid; `None` on the planned one.
    pub coarse: Option<ParameterField>,
    pub growth: Growth,
    /// Cells that count for convergence.
    pub counts: Vec<bool>,
    pub monitor: ConvergenceMonitor,
    /// The number of steps at which to move pinned marks next; `None` = never.
    pub next_correction: Option<u64>,
    /// Cell updates expected until it settles.
    pub expected: f64,
}

impl GridLevel {
    /// Schedules the next move of pinned marks after so much normalised time.
    pub fn plan_correction(&mut self, after: f64) {
        let steps = (after * self.monitor.unit()).ceil().max(1.0);
        self.next_correction = Some(self.growth.steps() + steps as u64);
    }
}

/// Steps of a unit of normalised time, `pace` times those in the cells where the reactions are slowest.
pub(super) fn unit(growth: &Growth, pace: f64) -> f64 {
    pace * growth.steps_in(1_000.0) as f64 / 1_000.0
}

/// √(slowest ÷ mean rate): where sizes differ much, most marks settle long before the slowest one, which begins near its final
/// shape.
pub(super) fn evenness(maps: &ParameterField) -> f64 {
    let rates = || maps.parameters.iter().map(|p| f64::from(p.rate));
    let slowest = rates().fold(f64::INFINITY, f64::min);
    // One logarithm for eight cells: the product of their ratios is far below the largest number.
    let of_eight =
        |eight: &[Parameters]| ln(eight.iter().map(|p| f64::from(p.rate) / slowest).product::<f64>());
    let mean = maps.parameters.chunks(8).map(of_eight).sum::<f64>() / maps.parameters.len() as f64;
    exp(-0.5 * mean)
}

/// Starts the growth on grid `index`, from a pattern that was `formed` on another grid, and from marks that start here.
pub(super) fn start_grid_level(
    system: System,
    maps: &ParameterField,
    start: &InitialConditions,
    grids: &[[usize; 2]],
    index: usize,
    formed: Option<([usize; 2], Vec<Vec<f32>>)>,
) -> GridLevel {
    let grid = grids[index];
    let area = |[nx, ny]: [usize; 2]| maps.domain.cells() as f64 / (nx * ny) as f64;
    let (coarse, lost) = match index + 1 < grids.len() {
        true => {
            let (coarse, lost) = during(Section::Parameters, || grid_levels::coarse(system, maps, grid));
            (Some(coarse), lost)
        }
        false => (None, Vec::new()),
    };
    let here = coarse.as_ref().unwrap_or(maps);
    let coarser = formed.as_ref().map(|(from, _)| area(*from) / area(grid));
    let Work { taken, counts, begins, pace } =
        during(Section::Parameters, || grid_levels::work(system, here, &lost, coarser));
    let fresh = |concentrations: Option<Vec<Vec<f32>>>| {
        let afresh = start.on(here, &|cell| lost.get(cell).copied().unwrap_or(false));
        match concentrations {
            None => afresh,
            Some(mut formed) => {
                for (formed, afresh) in formed.iter_mut().zip(&afresh) {
                    for ((formed, afresh), taken) in formed.iter_mut().zip(afresh).zip(&taken) {
                        *formed = taken * *formed + (1.0 - taken) * afresh;
                    }
                }
                formed
            }
        }
    };
    let concentrations = during(Section::Start, || match formed {
        None => fresh(None),
        Some((from, formed)) => {
            let finer = |chemical: Vec<f32>| prolongate(chemical, from, grid, maps.domain.edges);
            let fine = formed.into_par_iter().map(finer).collect();
            if taken.is_empty() { fine } else { fresh(Some(fine)) }
        }
    });
    let concentrations = with_obstacle_state(system, here, concentrations);
    let growth = during(Section::Coefficients, || Growth::resumed(system, here, concentrations))
        .expect("made for this system on this grid");
    let unit = unit(&growth, pace * evenness(here));
    let monitor = ConvergenceMonitor::new(system, unit, begins, growth.marks().values)
        .joining(start.starts_scattered());
    let monitor = if here.obstacles.contains(&true) { monitor.among_obstacles() } else { monitor };
    let expected = ConvergenceMonitor::expected(system, unit, begins) * (grid[0] * grid[1]) as f64;
    GridLevel { index, coarse, growth, counts, monitor, next_correction: None, expected }
}
