//! Growth of one layer as a value that is advanced in small parts.
//!
//! ```text
//!  coarsest grid ──▶ settled ──▶ next finer ──▶ settled ──▶ … ──▶ the planned grid ──▶ settled
//!      start          formed marks are prolongated; marks too small for the coarser grid start here
//! ```
//!
//! The pattern does not depend on how the engine was advanced, nor on whether it was read in between. To pause, do not
//! advance; to cancel, drop it. It has no threads of its own.

use crate::grid::{Cutout, Domain, Field};
use crate::measure::Spot;
use crate::rd::{InitialConditions, ParameterField, System};
use crate::synth::marks::grow::UPDATES;
use crate::synth::marks::grow::convergence::{LONGEST, Verdict};
use crate::synth::marks::grow::corrections::Corrections;
use crate::synth::marks::grow::grid_level::{GridLevel, evenness, start_grid_level, unit};
use crate::synth::marks::grow::grid_levels;
use crate::synth::marks::grow::merged_spots::merged_spots;
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::grow::position_control::PositionControl;
use crate::synth::marks::plan::begun::{Begun, Nuclei};
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::marks::plan::layer_lookup::Lookup;
use crate::synth::marks::plan::mark_cells::largest_mark;
use crate::synth::marks::plan::pinned_marks::guide_lines;
use crate::synth::marks::plan::spread::VariedSpots;
use crate::synth::passes::MergedSpots;
use crate::synth::profile::{Section, during};
use crate::synth::watch::{Cancelled, Stage, Watch};

/// A layer being grown.
#[derive(Clone, Debug)]
pub struct Engine {
    pub(super) system: System,
    /// Parameters on the planned grid.
    pub(super) maps: ParameterField,
    pub(super) start: InitialConditions,
    /// Moves pinned marks back to their places.
    pub(super) position_control: Option<PositionControl>,
    /// Spots with parameters of their own.
    pub(super) varied: Option<VariedSpots>,
    /// The grids from the coarsest to the planned one.
    pub(super) grids: Vec<[usize; 2]>,
    pub(super) grid_level: GridLevel,
    /// Cell updates that were expected on the coarser grids.
    pub(super) expected_before: f64,
    /// Cell updates done.
    pub(super) updates: u64,
    /// Steps taken before the first correction of pinned spots.
    pub(super) grown: Option<u64>,
    /// The most recent progress.
    pub(super) progress: f64,
    /// Whether every grid has settled so far.
    pub(super) settled: bool,
    pub(super) done: bool,
}

impl Engine {
    /// Growth of a finished plan from `seed`.
    #[must_use]
    pub fn new(Begun { plan, nuclei }: &Begun, seed: u64) -> Self {
        let Lookup { system, polarity, irregular, seeding, map, .. } = &plan.lookup;
        let (system, layout) = (*system, map.layout());
        let maps = match nuclei {
            Nuclei::Spots(spots) => spots.maps(plan),
            Nuclei::Apart(pitch) => plan.lookup.repitch(plan.unpitched_maps(), pitch),
        };
        let maps = maps.with_decay_noise(system, *irregular, seed);
        let (start, varied) = match (nuclei, plan.places()) {
            (Nuclei::Spots(spots), _) => {
                (InitialConditions::at_places(system, &maps, seed, &spots.places), Some(spots.clone()))
            }
            (Nuclei::Apart(_), Some(places)) => {
                let places = plan.lookup.all_to_cells(places);
                (InitialConditions::at_places(system, &maps, seed, &places), None)
            }
            (Nuclei::Apart(_), None) => {
                let start = InitialConditions::new(system, &maps, seed);
                let lines = guide_lines(plan.pinned_lines(), layout.size);
                (start.with_seeding(&maps, *seeding, lines).with_polarity(*polarity), None)
            }
        };
        let largest = varied.as_ref().map_or_else(|| largest_mark(system, &maps), |spots| spots.largest);
        let engine = Self::starting_from(system, maps, start, largest);
        let position_control = PositionControl::new(plan, &Corrections::none(plan));
        let mut engine = Self { position_control, varied, ..engine };
        engine.hold_marks();
        engine
    }

    /// Growth with the parameters `maps`, from `seed`.
    #[must_use]
    pub fn from_maps(system: System, maps: ParameterField, seed: u64) -> Self {
        let start = InitialConditions::new(system, &maps, seed);
        let largest = largest_mark(system, &maps);
        Self::starting_from(system, maps, start, largest)
    }

    /// Growth from `start`. Marks of up to `largest` cells may form on grids that are too coarse for smaller ones.
    fn starting_from(system: System, maps: ParameterField, start: InitialConditions, largest: f64) -> Self {
        let grids = grid_levels::grids(system, &maps, largest);
        let grid_level = start_grid_level(system, &maps, &start, &grids, 0, None);
        Self {
            system,
            maps,
            start,
            position_control: None,
            varied: None,
            grids,
            grid_level,
            expected_before: 0.0,
            progress: 0.0,
            updates: 0,
            grown: None,
            settled: true,
            done: false,
        }
    }

    /// The spots of `grown` that have merged with another one; the first `pinned` ones were drawn. None if the places were given.
    #[must_use]
    pub fn merged(&self, plan: &Plan, pinned: usize, grown: &[Spot]) -> MergedSpots {
        let Some(spots) = self.varied.as_ref().filter(|_| plan.places().is_none()) else {
            return MergedSpots::default();
        };
        let places = plan.lookup.all_to_px(&spots.places);
        merged_spots(&places, pinned, grown, plan.lookup.map.layout())
    }

    /// Whether there is a place where marks can start.
    #[must_use]
    pub fn can_start(&self) -> bool {
        self.start.has_marks()
            && (self.maps.obstacles.is_empty() || self.maps.obstacles.iter().any(|taken| !taken))
    }

    /// Advances by about `updates` cell updates, at least a step. Returns whether it is still growing.
    ///
    /// Returns early where a finer grid starts.
    pub fn advance(&mut self, updates: u64) -> bool {
        let index = self.grid_level.index;
        let [nx, ny] = self.grids[index];
        let cells = (nx * ny) as u64;
        let mut left = updates;
        while !self.done && self.grid_level.index == index {
            let growth = &mut self.grid_level.growth;
            let next =
                self.grid_level.monitor.next_check().min(self.grid_level.next_correction.unwrap_or(u64::MAX));
            let before = growth.steps();
            let steps = (left / cells).min(next.saturating_sub(before)).max(1);
            during(Section::Steps, || growth.advance(steps));
            let taken = growth.steps();
            let updates = (taken - before) * cells;
            self.updates += updates;
            if self.grid_level.next_correction.is_some_and(|next| taken >= next) {
                during(Section::Moves, || self.correct_positions());
            }
            if taken >= self.grid_level.monitor.next_check() {
                during(Section::Checks, || self.check_convergence());
            }
            left = left.saturating_sub(updates);
            if left < cells {
                break;
            }
        }
        self.progress = self.progress.max(self.share());
        !self.done
    }

    fn check_convergence(&mut self) {
        let current = &mut self.grid_level;
        let (growth, counts) = (&current.growth, &current.counts);
        let update = |marks: &mut [f32]| growth.update_marks(marks, counts);
        let verdict = current.monitor.check(growth.steps(), update);
        if verdict == Verdict::Forming {
            return;
        }
        // Spots that are corrected have settled before.
        self.settled &= verdict == Verdict::Settled || self.grown.is_some();
        if current.index + 1 == self.grids.len() {
            self.done = true;
            return;
        }
        self.expected_before += current.expected;
        let formed = (self.grids[current.index], current.growth.concentrations());
        let next = current.index + 1;
        self.grid_level =
            start_grid_level(self.system, &self.maps, &self.start, &self.grids, next, Some(formed));
        self.hold_marks();
    }

    /// Prepares the current grid level for pinned marks.
    fn hold_marks(&mut self) {
        if let Some(control) = &self.position_control {
            let maps = self.grid_level.coarse.as_ref().unwrap_or(&self.maps);
            let pace = if control.keeps_moving() { evenness(maps) } else { 1.0 };
            let longest = LONGEST / self.grid_level.growth.euler_steps_a_step();
            self.grid_level.monitor.hold_marks(control.keeps_moving().then_some(longest), pace);
            self.grid_level.expected *= pace;
            self.grid_level.plan_correction(control.every());
        }
    }

    /// Moves pinned marks towards their places.
    fn correct_positions(&mut self) {
        let Some(control) = &mut self.position_control else { return };
        let maps = self.grid_level.coarse.as_ref().unwrap_or(&self.maps);
        let warps = control.warps(&self.grid_level.growth.marks(), maps);
        if !warps.is_empty() {
            self.grid_level.growth.warp(maps, &warps);
        }
        self.grid_level.plan_correction(control.every());
    }

    /// Cell updates of `time` of normalised time on the current grid.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        let [nx, ny] = self.grids[self.grid_level.index];
        self.grid_level.growth.steps_in(time) * (nx * ny) as u64
    }

    /// Steps of a unit of normalised time on the current grid.
    #[must_use]
    pub fn steps_in_unit(&self) -> f64 {
        unit(&self.grid_level.growth, 1.0)
    }

    /// Cells of the current grid.
    #[must_use]
    pub fn cells(&self) -> usize {
        let [nx, ny] = self.grid();
        nx * ny
    }

    /// Cell updates done.
    #[must_use]
    pub fn updates(&self) -> u64 {
        self.updates
    }

    /// Advances until nothing grows any more. Returns whether the pattern settled within its time.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn settle(&mut self, watch: &Watch) -> Result<bool, Cancelled> {
        while self.advance(UPDATES) {
            watch.step(Stage::Grow, self.progress())?;
        }
        Ok(self.settled())
    }

    /// Cell updates still expected.
    #[must_use]
    pub fn updates_left(&self) -> f64 {
        if self.done {
            return 0.0;
        }
        let cells = |grid: &[usize; 2]| (grid[0] * grid[1]) as f64;
        let here = cells(&self.grids[self.grid_level.index]);
        let left = (self.grid_level.expected - self.grid_level.growth.steps() as f64 * here).max(0.0);
        let finer: f64 = self.grids[self.grid_level.index + 1..].iter().map(cells).sum();
        left + finer * self.grid_level.expected / here
    }

    /// The share of the work that is done, 0..1; never decreases.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.progress
    }

    fn share(&self) -> f64 {
        if self.done {
            return 1.0;
        }
        let [nx, ny] = self.grids[self.grid_level.index];
        let here = self.grid_level.growth.steps() as f64 * (nx * ny) as f64;
        let ahead: f64 =
            self.grids[self.grid_level.index + 1..].iter().map(|[nx, ny]| (nx * ny) as f64).sum();
        // A finer grid takes about as many steps as this one.
        let ahead = ahead * self.grid_level.expected / (nx * ny) as f64;
        (self.expected_before + here.min(self.grid_level.expected))
            / (self.expected_before + self.grid_level.expected + ahead)
    }

    /// Whether it has settled: false while it grows, and if it was given up.
    #[must_use]
    pub fn settled(&self) -> bool {
        self.done && self.settled
    }

    /// Whether it is still growing.
    #[must_use]
    pub fn growing(&self) -> bool {
        !self.done
    }

    /// Number of the current grid (1 = the coarsest), and number of grids.
    #[must_use]
    pub fn grid_level(&self) -> [usize; 2] {
        [self.grid_level.index + 1, self.grids.len()]
    }

    /// Steps taken, in steps of the planned grid: cell updates ÷ its cells.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.updates.div_ceil(self.maps.domain.cells() as u64)
    }

    /// Cells along x and y of the current grid.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.grids[self.grid_level.index]
    }

    /// The concentration that shows the marks as a share of the local peak, on the current grid.
    #[must_use]
    pub fn marks(&self) -> Field {
        self.grid_level.growth.marks()
    }

    /// [`Self::marks`] in the cells of `cutout`.
    #[must_use]
    pub fn marks_in(&self, cutout: &Cutout) -> Vec<f32> {
        self.grid_level.growth.marks_in(cutout)
    }

    /// The concentrations of each chemical, on the current grid.
    #[must_use]
    pub fn concentrations(&self) -> Vec<Vec<f32>> {
        self.grid_level.growth.concentrations()
    }

    /// The current pattern, at `width` × `height` px. `plan` is that of the engine.
    #[must_use]
    pub fn pattern(&self, plan: &Plan, width: usize, height: usize) -> Field {
        Pattern::new(&plan.lookup, &plan.levelled(self.marks())).field(width, height)
    }
}

#[cfg(test)]
#[path = "engine_tests.rs"]
mod tests;
