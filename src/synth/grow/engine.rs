//! Growth of one layer as a value that is advanced in small parts.
//!
//! ```text
//!  coarsest grid ──▶ settled ──▶ next finer ──▶ settled ──▶ … ──▶ the planned grid ──▶ settled
//!      start          formed marks are prolongated; marks too small for the coarser grid start here
//! ```
//!
//! The pattern does not depend on how the engine was advanced, nor on whether it was read in between. To pause, do not
//! advance; to cancel, drop it. It has no threads of its own.

use crate::grid::{Domain, Field};
use crate::rd::{Growth, InitialConditions, Maps, System, prolongate, restart, with_obstacle_state};
use crate::synth::grow::convergence::{ConvergenceMonitor, Verdict};
use crate::synth::grow::multigrid_levels;
use crate::synth::grow::multigrid_levels::Work;
use crate::synth::grow::pattern::Pattern;
use crate::synth::grow::pinned_correction::PinnedCorrection;
use crate::synth::grow::position_control::{EVERY, PositionControl};
use crate::synth::phases::{Phase, during};
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::layer_lookup::Lookup;
use crate::synth::plan::mark_cells::largest_mark;
use crate::synth::plan::pinned_marks::guide_lines;
use crate::synth::plan::spacing_correction::pitched_maps;
use crate::synth::plan::spread::{Varied, VariedSpots, vary};

/// A layer being grown.
#[derive(Clone, Debug)]
pub struct Engine {
    system: System,
    /// Parameters on the planned grid.
    maps: Maps,
    start: InitialConditions,
    /// Brings pinned marks back to their places.
    position_control: Option<PositionControl>,
    /// Spots with parameters of their own.
    varied: Option<VariedSpots>,
    /// From the coarsest to the planned one.
    grids: Vec<[usize; 2]>,
    level: Level,
    /// Cell updates that were expected on the coarser grids.
    expected_before: f64,
    /// Cell updates done.
    updates: u64,
    /// Steps until the first correction of pinned spots.
    grown: Option<u64>,
    /// The last progress.
    progress: f64,
    /// Has every grid settled so far?
    settled: bool,
    done: bool,
}

/// Growth on one grid.
#[derive(Clone, Debug)]
struct Level {
    /// Its index, 0 = the coarsest.
    index: usize,
    /// Parameters on this grid; `None` on the planned one.
    coarse: Option<Maps>,
    growth: Growth,
    /// Cells that count for convergence.
    counts: Vec<bool>,
    monitor: ConvergenceMonitor,
    /// The number of steps at which to move pinned marks next; `None` = never.
    next_correction: Option<u64>,
    /// Cell updates expected until it settles.
    expected: f64,
}

impl Level {
    /// Decides when to move pinned marks next.
    fn plan_correction(&mut self) {
        let steps = (EVERY * self.monitor.unit()).ceil().max(1.0);
        self.next_correction = Some(self.growth.steps() + steps as u64);
    }
}

impl Engine {
    /// Growth of `plan` from `seed`.
    #[must_use]
    pub fn new(plan: &Plan, seed: u64) -> Self {
        let Lookup { system, polarity, irregular, seeding, map, .. } = &plan.lookup;
        let (system, layout) = (*system, map.layout());
        let noisy = |maps: Maps| maps.with_decay_noise(system, *irregular, seed);
        if let Some(Varied { maps, spots, largest }) = vary(plan, seed) {
            let maps = noisy(maps);
            let start = InitialConditions::at_places(system, &maps, seed, &spots.places);
            let engine = Self::starting_from(system, maps, start, largest);
            let position_control = PositionControl::new(plan);
            let mut engine = Self { position_control, varied: Some(spots), ..engine };
            engine.hold_marks();
            return engine;
        }
        let (maps, start) = match plan.places() {
            Some(places) => {
                let maps = noisy(plan.unpitched_maps());
                let places = plan.lookup.all_to_cells(places);
                let start = InitialConditions::at_places(system, &maps, seed, &places);
                (maps, start)
            }
            None => {
                let maps = noisy(pitched_maps(plan, seed));
                let start = InitialConditions::new(system, &maps, seed);
                let lines = guide_lines(plan.pinned_lines(), layout.size);
                let start = start.with_seeding(&maps, *seeding, lines).with_polarity(*polarity);
                (maps, start)
            }
        };
        let largest = largest_mark(system, &maps);
        let mut engine = Self::starting_from(system, maps, start, largest);
        engine.position_control = PositionControl::new(plan);
        engine.hold_marks();
        engine
    }

    /// Growth with the parameters `maps`, from `seed`.
    #[must_use]
    pub fn from_maps(system: System, maps: Maps, seed: u64) -> Self {
        let start = InitialConditions::new(system, &maps, seed);
        let largest = largest_mark(system, &maps);
        Self::starting_from(system, maps, start, largest)
    }

    /// Marks of up to `largest` cells may be formed on grids that are too coarse for smaller ones.
    fn starting_from(system: System, maps: Maps, start: InitialConditions, largest: f64) -> Self {
        let grids = multigrid_levels::grids(system, &maps, largest);
        let level = start_level(system, &maps, &start, &grids, 0, None);
        Self {
            system,
            maps,
            start,
            position_control: None,
            varied: None,
            grids,
            level,
            expected_before: 0.0,
            progress: 0.0,
            updates: 0,
            grown: None,
            settled: true,
            done: false,
        }
    }

    /// Growth of `plan` from the pattern of `before` (a warm start), where both have its grid: for a sketch that has changed
    /// a little. The result depends on `before`, and differs from that of a new engine.
    #[must_use]
    pub fn warm(plan: &Plan, seed: u64, before: &Self) -> Option<Self> {
        let mut engine = Self::new(plan, seed);
        let grid = before.grids[before.level.index];
        let level = engine.grids.iter().position(|other| *other == grid)?;
        if engine.system != before.system || engine.maps.domain.edges != before.maps.domain.edges {
            return None;
        }
        let saved = before.level.growth.concentrations();
        engine.level = start_level(
            engine.system,
            &engine.maps,
            &engine.start,
            &engine.grids,
            level,
            Some((grid, saved)),
        );
        // Nothing begins here, but all of it may change.
        engine.level.counts.fill(true);
        let unit = unit(&engine.level.growth, 1.0);
        engine.level.monitor = ConvergenceMonitor::new(engine.system, unit, true, engine.marks().values);
        Some(engine)
    }

    /// Takes the parameters of the pinned spots from `plan`, where they have been corrected, and goes on growing what has
    /// settled. The lost ones begin again.
    pub fn correct(&mut self, plan: &Plan, correction: &PinnedCorrection) {
        let Some(spots) = &mut self.varied else { return };
        let lost = &correction.lost;
        self.maps.parameters = during(Phase::Parameters, || spots.corrected(plan, &self.maps));
        let mut concentrations = self.level.growth.concentrations();
        if !lost.is_empty() {
            let (mut again, mut stay): (Vec<[f64; 2]>, Vec<[f64; 2]>) = (Vec::new(), Vec::new());
            for (index, at) in spots.places.iter().enumerate() {
                if lost.contains(&index) { again.push(*at) } else { stay.push(*at) }
            }
            // Also where they have moved to, if no other spot is there.
            again.extend(
                self.position_control.iter_mut().flat_map(|control| control.forget(lost, &self.maps.domain)),
            );
            let afresh = self.start.on(&self.maps, &|_| false);
            restart(self.system, &self.maps, &mut concentrations, &afresh, [&again, &stay]);
        }
        let growth =
            during(Phase::Coefficients, || Growth::resumed(self.system, &self.maps, &concentrations))
                .expect("made for this system on this grid");
        // Only what has changed has to settle.
        let rates = correction.changed().map(|index| f64::from(self.maps.at(spots.places[index]).rate));
        let slowest = self.maps.parameters.iter().map(|p| f64::from(p.rate)).fold(f64::INFINITY, f64::min);
        let evenness = evenness(&self.maps);
        let pace = (slowest / rates.fold(f64::INFINITY, f64::min)).min(evenness * evenness);
        // Not more than half of the time that the pattern took, or it would pay less than it costs.
        let grown = *self.grown.get_or_insert(self.updates.div_ceil(self.maps.domain.cells() as u64));
        let most = 0.5 * grown as f64 / ConvergenceMonitor::expected(self.system, 1.0, false);
        let unit = unit(&growth, pace).min(most.max(1.0));
        let cells = self.maps.domain.cells();
        self.level = Level {
            index: self.grids.len() - 1,
            coarse: None,
            monitor: ConvergenceMonitor::new(self.system, unit, false, growth.marks(&self.maps).values),
            counts: vec![true; cells],
            next_correction: None,
            expected: ConvergenceMonitor::expected(self.system, unit, false) * cells as f64,
            growth,
        };
        self.done = false;
        if let Some(control) = &self.position_control {
            self.level.monitor.hold_corrected_marks(control.keeps_moving());
            self.level.plan_correction();
        }
    }

    /// Is there a place where marks can start?
    #[must_use]
    pub fn can_start(&self) -> bool {
        self.start.has_marks()
            && (self.maps.obstacles.is_empty() || self.maps.obstacles.iter().any(|taken| !taken))
    }

    /// Advances by about `updates` cell updates, at least a step. Returns whether it is still growing.
    ///
    /// Returns early where a finer grid starts.
    pub fn advance(&mut self, updates: u64) -> bool {
        let level = self.level.index;
        let [nx, ny] = self.grids[level];
        let cells = (nx * ny) as u64;
        let mut left = updates;
        while !self.done && self.level.index == level {
            let growth = &mut self.level.growth;
            let next = self.level.monitor.next_check().min(self.level.next_correction.unwrap_or(u64::MAX));
            let steps = (left / cells).max(1).min(next - growth.steps());
            during(Phase::Steps, || growth.advance(steps));
            let taken = growth.steps();
            self.updates += steps * cells;
            if Some(taken) == self.level.next_correction {
                during(Phase::Moves, || self.correct_positions());
            }
            if taken == self.level.monitor.next_check() {
                during(Phase::Checks, || self.check_convergence());
            }
            left = left.saturating_sub(steps * cells);
            if left < cells {
                break;
            }
        }
        self.progress = self.progress.max(self.share());
        !self.done
    }

    fn check_convergence(&mut self) {
        let marks = self.marks().values;
        let current = &mut self.level;
        let verdict = current.monitor.check(marks, &current.counts, current.growth.steps());
        if verdict == Verdict::Forming {
            return;
        }
        // What is corrected afterwards has settled before.
        self.settled &= verdict == Verdict::Settled || self.grown.is_some();
        if current.index + 1 == self.grids.len() {
            self.done = true;
            return;
        }
        self.expected_before += current.expected;
        let formed = (self.grids[current.index], current.growth.concentrations());
        let next = current.index + 1;
        self.level = start_level(self.system, &self.maps, &self.start, &self.grids, next, Some(formed));
        self.hold_marks();
    }

    /// Prepares the current level for pinned marks.
    fn hold_marks(&mut self) {
        if let Some(control) = &self.position_control {
            let maps = self.level.coarse.as_ref().unwrap_or(&self.maps);
            let pace = if control.keeps_moving() { evenness(maps) } else { 1.0 };
            self.level.monitor.hold_marks(control.keeps_moving(), pace);
            self.level.expected *= pace;
            self.level.plan_correction();
        }
    }

    /// Moves pinned marks towards their places.
    fn correct_positions(&mut self) {
        let Some(control) = &mut self.position_control else { return };
        let maps = self.level.coarse.as_ref().unwrap_or(&self.maps);
        let warps = control.warps(&self.level.growth.marks(maps), maps);
        if !warps.is_empty() {
            self.level.growth.warp(maps, &warps);
        }
        self.level.plan_correction();
    }

    /// Cell updates of `time` of normalised time on the current grid.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        let [nx, ny] = self.grids[self.level.index];
        self.level.growth.steps_in(time) * (nx * ny) as u64
    }

    /// Steps of a unit of normalised time on the current grid.
    #[must_use]
    pub fn steps_in_unit(&self) -> f64 {
        unit(&self.level.growth, 1.0)
    }

    /// Cell updates still expected.
    #[must_use]
    pub fn updates_left(&self) -> f64 {
        if self.done {
            return 0.0;
        }
        let cells = |grid: &[usize; 2]| (grid[0] * grid[1]) as f64;
        let here = cells(&self.grids[self.level.index]);
        let left = (self.level.expected - self.level.growth.steps() as f64 * here).max(0.0);
        let finer: f64 = self.grids[self.level.index + 1..].iter().map(cells).sum();
        left + finer * self.level.expected / here
    }

    /// The share that is done, 0..1; never falls.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.progress
    }

    fn share(&self) -> f64 {
        if self.done {
            return 1.0;
        }
        let [nx, ny] = self.grids[self.level.index];
        let here = self.level.growth.steps() as f64 * (nx * ny) as f64;
        let ahead: f64 = self.grids[self.level.index + 1..].iter().map(|[nx, ny]| (nx * ny) as f64).sum();
        // A finer grid takes about as many steps as this one.
        let ahead = ahead * self.level.expected / (nx * ny) as f64;
        (self.expected_before + here.min(self.level.expected))
            / (self.expected_before + self.level.expected + ahead)
    }

    /// Has it settled? False while it grows, and where it was given up.
    #[must_use]
    pub fn settled(&self) -> bool {
        self.done && self.settled
    }

    /// Is it still growing?
    #[must_use]
    pub fn growing(&self) -> bool {
        !self.done
    }

    /// The current grid (1 = the coarsest), of how many.
    #[must_use]
    pub fn level(&self) -> [usize; 2] {
        [self.level.index + 1, self.grids.len()]
    }

    /// Steps taken, as many as the same work is on the planned grid: cell updates ÷ its cells.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.updates.div_ceil(self.maps.domain.cells() as u64)
    }

    /// The concentration that shows the marks as a share of the local peak, on the current grid.
    #[must_use]
    pub fn marks(&self) -> Field {
        self.level.growth.marks(self.level.coarse.as_ref().unwrap_or(&self.maps))
    }

    /// The concentrations of each chemical, on the current grid.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        self.level.growth.concentrations()
    }

    /// The pattern as it is now, at `width` × `height` px. `plan` is that of the engine.
    #[must_use]
    pub fn pattern(&self, plan: &Plan, width: usize, height: usize) -> Field {
        Pattern::new(&plan.lookup, &plan.levelled(self.marks())).field(width, height)
    }
}

/// Steps of a unit of normalised time, `pace` times those where the reactions are slowest.
fn unit(growth: &Growth, pace: f64) -> f64 {
    pace * growth.steps_in(1_000.0) as f64 / 1_000.0
}

/// √(slowest ÷ mean rate): where sizes differ much, most of the marks settle long before the slowest does, which begins near
/// its final shape.
fn evenness(maps: &Maps) -> f64 {
    let rates = maps.parameters.iter().map(|p| f64::from(p.rate));
    let (slowest, sum) =
        rates.fold((f64::INFINITY, 0.0), |(slow, sum), rate| (slow.min(rate), sum + libm::log(rate)));
    (slowest / libm::exp(sum / maps.parameters.len() as f64)).sqrt()
}

/// Starts growth on grid `index`: of what was `formed` on another grid, and of marks that start here.
fn start_level(
    system: System,
    maps: &Maps,
    start: &InitialConditions,
    grids: &[[usize; 2]],
    index: usize,
    formed: Option<([usize; 2], Vec<Vec<f32>>)>,
) -> Level {
    let grid = grids[index];
    let area = |[nx, ny]: [usize; 2]| maps.domain.cells() as f64 / (nx * ny) as f64;
    let (coarse, lost) = match index + 1 < grids.len() {
        true => {
            let (coarse, lost) = during(Phase::Parameters, || multigrid_levels::coarse(system, maps, grid));
            (Some(coarse), lost)
        }
        false => (None, Vec::new()),
    };
    let here = coarse.as_ref().unwrap_or(maps);
    let coarser = formed.as_ref().map(|(from, _)| area(*from) / area(grid));
    let Work { taken, counts, begins, pace } =
        during(Phase::Parameters, || multigrid_levels::work(system, here, &lost, coarser));
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
    let concentrations = during(Phase::Start, || match formed {
        None => fresh(None),
        Some((from, formed)) => {
            let fine =
                formed.iter().map(|chemical| prolongate(chemical, from, grid, maps.domain.edges)).collect();
            if taken.iter().all(|taken| *taken == 1.0) { fine } else { fresh(Some(fine)) }
        }
    });
    let concentrations = with_obstacle_state(system, here, concentrations);
    let growth = during(Phase::Coefficients, || Growth::resumed(system, here, &concentrations))
        .expect("made for this system on this grid");
    let unit = unit(&growth, pace * evenness(here));
    let monitor = ConvergenceMonitor::new(system, unit, begins, growth.marks(here).values)
        .joining(start.starts_scattered());
    let monitor = if here.obstacles.contains(&true) { monitor.among_obstacles() } else { monitor };
    let expected = ConvergenceMonitor::expected(system, unit, begins) * (grid[0] * grid[1]) as f64;
    Level { index, coarse, growth, counts, monitor, next_correction: None, expected }
}

#[cfg(test)]
#[path = "engine_tests.rs"]
mod tests;
