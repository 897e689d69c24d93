//! Growing as a value: advanced a little at a time, looked at, left.
//!
//! ```text
//!  coarsest grid ──▶ settled ──▶ next finer ──▶ settled ──▶ … ──▶ the planned grid ──▶ settled
//!       begun          what was formed is brought over; what was too small for the coarser grid begins
//! ```
//!
//! The same pattern comes out however it was advanced and whether it was looked at. To pause, do not advance; to
//! cancel, drop it. It has no threads of its own.

use crate::grid::{Domain, Field};
use crate::rd::{Growth, InitialConditions, Maps, System, prolongate, with_obstacle_state};
use crate::synth::grow::convergence::{Rest, Verdict};
use crate::synth::grow::multigrid_levels;
use crate::synth::grow::multigrid_levels::Work;
use crate::synth::grow::pattern::Pattern;
use crate::synth::grow::position_control::PositionControl;
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::layer_lookup::Lookup;
use crate::synth::plan::mark_cells::largest_mark;
use crate::synth::plan::pinned_marks::guide_lines;
use crate::synth::plan::spacing_correction::pitches;
use crate::synth::plan::spread::{Varied, vary};

/// A layer being grown.
#[derive(Clone, Debug)]
pub struct Engine {
    system: System,
    /// Parameters on the planned grid.
    maps: Maps,
    start: InitialConditions,
    /// Brings pinned marks back to their places.
    position_control: Option<PositionControl>,
    /// From the coarsest to the planned one.
    grids: Vec<[usize; 2]>,
    stage: Stage,
    /// Cell updates that were to be expected on the grids before this one.
    passed: f64,
    /// Cell updates done.
    updates: u64,
    /// The progress told last.
    progress: f64,
    /// Has each grid settled so far?
    settled: bool,
    done: bool,
}

/// Growth on one grid.
#[derive(Clone, Debug)]
struct Stage {
    level: usize,
    /// Parameters on this grid; `None` on the planned one.
    coarse: Option<Maps>,
    growth: Growth,
    counts: Vec<bool>,
    rest: Rest,
    /// Cell updates to be expected on this grid, as one that the pattern needs to settle on.
    expected: f64,
}

impl Engine {
    /// Growth of `plan` from `seed`.
    #[must_use]
    pub fn new(plan: &Plan, seed: u64) -> Self {
        let Lookup { system, irregular, seeding, map, .. } = &plan.lookup;
        let (system, layout) = (*system, map.layout());
        let noisy = |maps: Maps| maps.with_decay_noise(system, *irregular, seed);
        if let Some(Varied { maps, places, largest }) = vary(plan, seed) {
            let maps = noisy(maps);
            let start = InitialConditions::at_places(system, &maps, seed, &places);
            let engine = Self::starting_from(system, maps, start, largest);
            return Self { position_control: PositionControl::new(plan), ..engine };
        }
        let (maps, start) = match plan.places() {
            Some(places) => {
                let maps = noisy(plan.unpitched_maps());
                let places = plan.lookup.all_to_cells(places);
                let start = InitialConditions::at_places(system, &maps, seed, &places);
                (maps, start)
            }
            None => {
                let maps = noisy(plan.maps(&pitches(plan, seed)));
                let start = InitialConditions::new(system, &maps, seed);
                let lines = guide_lines(plan.pinned_lines(), layout.size);
                let start = start.with_seeding(&maps, *seeding, lines);
                (maps, start)
            }
        };
        let largest = largest_mark(system, &maps);
        Self::starting_from(system, maps, start, largest)
    }

    /// Growth of `maps` from `seed`.
    #[must_use]
    pub fn from_maps(system: System, maps: Maps, seed: u64) -> Self {
        let start = InitialConditions::new(system, &maps, seed);
        let largest = largest_mark(system, &maps);
        Self::starting_from(system, maps, start, largest)
    }

    /// Marks of up to `largest` cells may be formed on grids that smaller ones are too small for.
    fn starting_from(system: System, maps: Maps, start: InitialConditions, largest: f64) -> Self {
        let grids = multigrid_levels::grids(system, &maps, largest);
        let stage = stage(system, &maps, &start, &grids, 0, None);
        Self {
            system,
            maps,
            start,
            position_control: None,
            grids,
            stage,
            passed: 0.0,
            progress: 0.0,
            updates: 0,
            settled: true,
            done: false,
        }
    }

    /// Growth of `plan` from what `before` has grown, where that is a grid of `plan` too; for a sketch that was
    /// changed a little. What comes out depends on `before`: another pattern than that of a new engine.
    #[must_use]
    pub fn warm(plan: &Plan, seed: u64, before: &Self) -> Option<Self> {
        let mut engine = Self::new(plan, seed);
        let grid = before.grids[before.stage.level];
        let level = engine.grids.iter().position(|other| *other == grid)?;
        if engine.system != before.system || engine.maps.grid.edges != before.maps.grid.edges {
            return None;
        }
        let saved = before.stage.growth.concentrations();
        engine.stage =
            stage(engine.system, &engine.maps, &engine.start, &engine.grids, level, Some((grid, saved)));
        // Nothing begins here, but all of it may change.
        engine.stage.counts.fill(true);
        let unit = unit(&engine.stage.growth, 1.0);
        engine.stage.rest = Rest::new(engine.system, unit, true, engine.marks().values);
        Some(engine)
    }

    /// Is there a place for anything to begin?
    #[must_use]
    pub fn begins(&self) -> bool {
        self.start.has_marks()
            && (self.maps.obstacles.is_empty() || self.maps.obstacles.iter().any(|taken| !taken))
    }

    /// Goes on for about `updates` cell updates, at least a step; gives whether it is still growing.
    ///
    /// Also returns early when it comes to a finer grid.
    pub fn advance(&mut self, updates: u64) -> bool {
        let level = self.stage.level;
        let [nx, ny] = self.grids[level];
        let cells = (nx * ny) as u64;
        let mut left = updates;
        while !self.done && self.stage.level == level {
            let growth = &mut self.stage.growth;
            let steps = (left / cells).max(1).min(self.stage.rest.next() - growth.steps());
            growth.advance(steps);
            self.updates += steps * cells;
            if growth.steps() == self.stage.rest.next() {
                self.look_whether_settled();
            }
            left = left.saturating_sub(steps * cells);
            if left < cells {
                break;
            }
        }
        self.progress = self.progress.max(self.share());
        !self.done
    }

    fn look_whether_settled(&mut self) {
        let marks = self.marks().values;
        let stage = &mut self.stage;
        let verdict = stage.rest.look(marks, &stage.counts, stage.growth.steps());
        if verdict == Verdict::Forming {
            return self.bring_back();
        }
        self.settled &= verdict == Verdict::Settled;
        if stage.level + 1 == self.grids.len() {
            self.done = true;
            return;
        }
        self.passed += stage.expected;
        let formed = (self.grids[stage.level], stage.growth.concentrations());
        let level = stage.level + 1;
        self.stage = self::stage(self.system, &self.maps, &self.start, &self.grids, level, Some(formed));
    }

    /// Moves back what is to stay where it was drawn.
    fn bring_back(&mut self) {
        let Some(control) = &self.position_control else { return };
        let maps = self.stage.coarse.as_ref().unwrap_or(&self.maps);
        let warps = control.warps(&self.stage.growth.marks(maps), maps);
        if !warps.is_empty() {
            self.stage.growth.warp(maps, &warps);
        }
    }

    /// Cell updates that make up `time` of normalised time on the grid it is on.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        let [nx, ny] = self.grids[self.stage.level];
        self.stage.growth.steps_in(time) * (nx * ny) as u64
    }

    /// Steps of the grid it is on that make up a unit of normalised time.
    #[must_use]
    pub fn steps_in_unit(&self) -> f64 {
        unit(&self.stage.growth, 1.0)
    }

    /// Cell updates still to be expected.
    #[must_use]
    pub fn updates_left(&self) -> f64 {
        if self.done {
            return 0.0;
        }
        let cells = |grid: &[usize; 2]| (grid[0] * grid[1]) as f64;
        let here = cells(&self.grids[self.stage.level]);
        let left = (self.stage.expected - self.stage.growth.steps() as f64 * here).max(0.0);
        let finer: f64 = self.grids[self.stage.level + 1..].iter().map(cells).sum();
        left + finer * self.stage.expected / here
    }

    /// How far it is, 0..1; never falls.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.progress
    }

    fn share(&self) -> f64 {
        if self.done {
            return 1.0;
        }
        let [nx, ny] = self.grids[self.stage.level];
        let here = self.stage.growth.steps() as f64 * (nx * ny) as f64;
        let ahead: f64 = self.grids[self.stage.level + 1..].iter().map(|[nx, ny]| (nx * ny) as f64).sum();
        // A finer grid takes about as many steps as this one.
        let ahead = ahead * self.stage.expected / (nx * ny) as f64;
        (self.passed + here.min(self.stage.expected)) / (self.passed + self.stage.expected + ahead)
    }

    /// Has it settled? False where it still grows, or was given up.
    #[must_use]
    pub fn settled(&self) -> bool {
        self.done && self.settled
    }

    /// Is it still growing?
    #[must_use]
    pub fn growing(&self) -> bool {
        !self.done
    }

    /// The grid it is on, of how many: 1, 2, …
    #[must_use]
    pub fn level(&self) -> [usize; 2] {
        [self.stage.level + 1, self.grids.len()]
    }

    /// Steps taken, counted as such of the planned grid: cell updates ÷ its cells.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.updates.div_ceil(self.maps.grid.cells() as u64)
    }

    /// The concentration that shows the marks as a share of the local peak, on the grid it is on.
    #[must_use]
    pub fn marks(&self) -> Field {
        self.stage.growth.marks(self.stage.coarse.as_ref().unwrap_or(&self.maps))
    }

    /// The concentrations of each chemical, on the grid it is on.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        self.stage.growth.concentrations()
    }

    /// The pattern as far as it has grown, at `width` × `height` px. `plan` is that of the engine.
    #[must_use]
    pub fn look(&self, plan: &Plan, width: usize, height: usize) -> Field {
        Pattern::new(&plan.lookup, &plan.levelled(self.marks())).field(width, height)
    }
}

/// Steps a unit of time, `pace` times those where the reactions are slowest.
fn unit(growth: &Growth, pace: f64) -> f64 {
    pace * growth.steps_in(1_000.0) as f64 / 1_000.0
}

/// Growth on grid `level`: of what was `formed` on another, and of what begins here.
fn stage(
    system: System,
    maps: &Maps,
    start: &InitialConditions,
    grids: &[[usize; 2]],
    level: usize,
    formed: Option<([usize; 2], Vec<Vec<f32>>)>,
) -> Stage {
    let grid = grids[level];
    let area = |[nx, ny]: [usize; 2]| maps.grid.cells() as f64 / (nx * ny) as f64;
    let (coarse, lost) = match level + 1 < grids.len() {
        true => {
            let (coarse, lost) = multigrid_levels::coarse(system, maps, grid);
            (Some(coarse), lost)
        }
        false => (None, Vec::new()),
    };
    let here = coarse.as_ref().unwrap_or(maps);
    let coarser = formed.as_ref().map(|(from, _)| area(*from) / area(grid));
    let Work { kept, counts, begins, pace } = multigrid_levels::work(system, here, &lost, coarser);
    let fresh = |concentrations: Option<Vec<Vec<f32>>>| {
        let afresh = start.on(here, &|cell| lost.get(cell).copied().unwrap_or(false));
        match concentrations {
            None => afresh,
            Some(mut formed) => {
                for (formed, afresh) in formed.iter_mut().zip(&afresh) {
                    for ((formed, afresh), kept) in formed.iter_mut().zip(afresh).zip(&kept) {
                        *formed = kept * *formed + (1.0 - kept) * afresh;
                    }
                }
                formed
            }
        }
    };
    let concentrations = match formed {
        None => fresh(None),
        Some((from, formed)) => {
            let fine =
                formed.iter().map(|chemical| prolongate(chemical, from, grid, maps.grid.edges)).collect();
            if kept.iter().all(|kept| *kept == 1.0) { fine } else { fresh(Some(fine)) }
        }
    };
    let concentrations = with_obstacle_state(system, here, concentrations);
    let growth = Growth::resumed(system, here, &concentrations).expect("made for this system on this grid");
    let unit = unit(&growth, pace);
    let rest = Rest::new(system, unit, begins, growth.marks(here).values).healing(start.starts_scattered());
    let rest = if here.obstacles.contains(&true) { rest.among_frozen() } else { rest };
    let expected = Rest::expected(system, unit, begins) * (grid[0] * grid[1]) as f64;
    Stage { level, coarse, growth, counts, rest, expected }
}

#[cfg(test)]
#[path = "engine_tests.rs"]
mod tests;
