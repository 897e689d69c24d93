//! Continues the growth of a settled pattern after some spots have been changed.

use crate::grid::Domain;
use crate::rd::{Growth, restart};
use crate::synth::marks::grow::convergence::{ConvergenceMonitor, LONGEST};
use crate::synth::marks::grow::corrections::Corrections;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::grid_level::{GridLevel, evenness, unit};
use crate::synth::marks::grow::position_control::PositionControl;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::passes::Restart;
use crate::synth::profile::{Section, during};

impl Engine {
    /// Restarts spots, with the corrected parameters of the pinned ones, and continues the growth of the settled pattern.
    pub fn restart(&mut self, plan: &Plan, corrections: &Corrections, request: &Restart) {
        let Restart { away, again, changed, .. } = request;
        let Some(spots) = &mut self.varied else { return };
        let at = |index: &usize| spots.places[*index];
        let mut places: Vec<[f64; 2]> = away.iter().chain(again).map(at).collect();
        let to_settle: Vec<[f64; 2]> = again.iter().chain(changed).map(at).collect();
        if let Some(control) = self.position_control.as_mut().filter(|_| !again.is_empty()) {
            // Also at the places to which they have moved, if no other spot is there.
            places.extend(control.forget(again, &self.maps.domain));
        }
        during(Section::Parameters, || {
            spots.correct(plan, away, corrections.offsets(), &mut self.maps.parameters);
        });
        self.start = self.start.clone().with_places(&self.maps, &spots.places);
        self.grow_on(&places, &to_settle);
        if request.leave_out {
            self.position_control = PositionControl::new(plan, corrections);
        }
    }

    /// The spot nearest to `spot` among the first `drawn` ones, and among the others; none if spots do not differ.
    #[must_use]
    pub fn beside(&self, spot: usize, drawn: usize) -> [Option<usize>; 2] {
        let Some(spots) = &self.varied else { return [None; 2] };
        let all = spots.places.len();
        [0..drawn, drawn..all].map(|among| spots.nearest_beside(spot, among, self.system, &self.maps.domain))
    }

    /// Continues the growth with the spots near the places `again`, cells, in their initial state. Spots at the places `changed`
    /// have to settle.
    pub(super) fn grow_on(&mut self, again: &[[f64; 2]], changed: &[[f64; 2]]) {
        let mut concentrations = self.grid_level.growth.concentrations();
        if !again.is_empty() {
            let places = self.varied.iter().flat_map(|spots| &spots.places);
            let stay: Vec<[f64; 2]> = places.filter(|at| !again.contains(at)).copied().collect();
            let afresh = |cells: &[usize], near: &dyn Fn([f64; 2], f64) -> bool| {
                self.start.in_cells(&self.maps, cells, near)
            };
            restart(self.system, &self.maps, &mut concentrations, [again, &stay], afresh);
        }
        let growth =
            during(Section::Coefficients, || Growth::resumed(self.system, &self.maps, concentrations))
                .expect("made for this system on this grid");
        // Only the changed spots have to settle.
        let rates = changed.iter().map(|at| f64::from(self.maps.at(*at).rate));
        let slowest = self.maps.parameters.iter().map(|p| f64::from(p.rate)).fold(f64::INFINITY, f64::min);
        let evenness = evenness(&self.maps);
        let pace = (slowest / rates.fold(f64::INFINITY, f64::min)).min(evenness * evenness);
        // At most half of the time that the pattern took; more would cost more than it gains.
        let grown = *self.grown.get_or_insert(self.updates.div_ceil(self.maps.domain.cells() as u64));
        let most = 0.5 * grown as f64 / ConvergenceMonitor::expected(self.system, 1.0, false);
        let unit = unit(&growth, pace).min(most.max(1.0));
        let cells = self.maps.domain.cells();
        self.grid_level = GridLevel {
            index: self.grids.len() - 1,
            coarse: None,
            monitor: ConvergenceMonitor::new(self.system, unit, false, growth.marks().values),
            counts: vec![true; cells],
            next_correction: None,
            expected: ConvergenceMonitor::expected(self.system, unit, false) * cells as f64,
            growth,
        };
        self.done = false;
        if let Some(control) = &self.position_control {
            let longest = LONGEST / self.grid_level.growth.euler_steps_a_step();
            self.grid_level.monitor.hold_corrected_marks(control.keeps_moving().then_some(longest));
            self.grid_level.plan_correction(control.every());
        }
    }
}
