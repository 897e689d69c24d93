//! Growing on from a settled pattern of which some spots are changed.

use crate::grid::Domain;
use crate::rd::{Growth, restart};
use crate::synth::marks::grow::convergence::{ConvergenceMonitor, LONGEST};
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::level::{Level, evenness, unit};
use crate::synth::marks::grow::merged_spots::MergedSpots;
use crate::synth::marks::grow::pinned_correction::{PinnedCorrection, Rounds};
use crate::synth::marks::grow::position_control::PositionControl;
use crate::synth::marks::plan::laid_out::Plan;
use crate::synth::phases::{Phase, during};

/// What makes room for lost spots, by the indices of spots.
#[derive(Default)]
struct Room {
    /// Those that are taken away.
    away: Vec<usize>,
    /// Those that begin again.
    again: Vec<usize>,
}

impl Engine {
    /// Makes the corrections that are worth their time. Returns whether there was one, so that the pattern grows on.
    pub fn grow_on_corrected(
        &mut self,
        plan: &mut Plan,
        rounds: &mut Rounds,
        found: &PinnedCorrection,
        merged: &MergedSpots,
    ) -> bool {
        if rounds.separate(merged) {
            self.separate(plan, &merged.surplus, &merged.kept, &[]);
            return true;
        }
        let room = self.room_beside(plan, &found.crowded);
        if !room.again.is_empty() && rounds.make_room_first(found) {
            found.apply(plan);
            self.make_room(plan, &room, found);
            return true;
        }
        if rounds.is_worth(found) {
            found.apply(plan);
            self.correct(plan, found);
            return true;
        }
        if rounds.make_room(found) {
            let room = self.room_beside(plan, &found.lost);
            if !room.again.is_empty() {
                self.make_room(plan, &room, &PinnedCorrection::default());
                return true;
            }
        }
        let leaves_out = rounds.leave_out(merged);
        if leaves_out {
            self.leave_out(plan, merged);
        }
        leaves_out
    }

    /// Takes the parameters of the pinned spots from `plan`, where they have been corrected, and goes on growing what has
    /// settled. The lost ones begin again.
    pub fn correct(&mut self, plan: &Plan, correction: &PinnedCorrection) {
        let Some(spots) = &mut self.varied else { return };
        let lost = &correction.lost;
        during(Phase::Parameters, || spots.correct(plan, &[], &mut self.maps.parameters));
        let mut again: Vec<[f64; 2]> = lost.iter().map(|index| spots.places[*index]).collect();
        let changed: Vec<[f64; 2]> = correction.changed().map(|index| spots.places[index]).collect();
        if !lost.is_empty() {
            // Also where they have moved to, if no other spot is there.
            again.extend(
                self.position_control.iter_mut().flat_map(|control| control.forget(lost, &self.maps.domain)),
            );
        }
        self.grow_on(&again, &changed);
    }

    /// The room that is made for the `lost` spots: the nearest spot that was not drawn is taken from beside each, and it begins
    /// again at the same time as the nearest drawn one, since beside one that has already grown it would die again.
    fn room_beside(&self, plan: &Plan, lost: &[usize]) -> Room {
        let mut room = Room::default();
        let Some(spots) = &self.varied else { return room };
        let pinned = plan.pinned_spots().len();
        for index in lost {
            let beside = |among| spots.nearest_beside(*index, among, self.system, &self.maps.domain);
            let (undrawn, drawn) = (beside(pinned..spots.places.len()), beside(0..pinned));
            if undrawn.or(drawn).is_some() {
                room.away.extend(undrawn);
                room.again.extend(drawn);
                room.again.push(*index);
            }
        }
        for indices in [&mut room.away, &mut room.again] {
            indices.sort_unstable();
            indices.dedup();
        }
        room
    }

    /// Makes `room`. The others that are corrected, or begin again, do so at the same time.
    fn make_room(&mut self, plan: &mut Plan, room: &Room, correction: &PinnedCorrection) {
        plan.undo_corrections(&room.again);
        let others = correction.lost.iter().filter(|index| !room.again.contains(index));
        let again: Vec<usize> = room.again.iter().chain(others).copied().collect();
        self.separate(plan, &room.away, &again, &correction.different);
    }

    /// Leaves the pinned spots out that grow together with another pinned one, whatever their parameters.
    fn leave_out(&mut self, plan: &mut Plan, merged: &MergedSpots) {
        let pinned = plan.pinned_spots().len();
        let stays = |index: &&usize| **index < pinned && !merged.crowded.contains(index);
        let kept: Vec<usize> = merged.kept.iter().filter(stays).copied().collect();
        plan.undo_corrections(&kept);
        plan.leave_out(&merged.crowded);
        self.separate(plan, &merged.crowded, &kept, &[]);
        self.position_control = PositionControl::new(plan);
    }

    /// Takes the spots `away` that leave those `kept` too little room. These begin again. The parameters of others have been
    /// `corrected`.
    fn separate(&mut self, plan: &Plan, away: &[usize], kept: &[usize], corrected: &[usize]) {
        let Some(spots) = &mut self.varied else { return };
        let at = |index: &usize| spots.places[*index];
        let mut again: Vec<[f64; 2]> = away.iter().chain(kept).map(at).collect();
        let changed: Vec<[f64; 2]> = kept.iter().chain(corrected).map(at).collect();
        if let Some(control) = &mut self.position_control {
            again.extend(control.forget(kept, &self.maps.domain));
        }
        during(Phase::Parameters, || spots.correct(plan, away, &mut self.maps.parameters));
        self.start = self.start.clone().with_places(&self.maps, &spots.places);
        self.grow_on(&again, &changed);
    }

    /// Goes on growing with the spots near the places `again`, cells, as they began. Those at the places `changed` have to settle.
    pub(super) fn grow_on(&mut self, again: &[[f64; 2]], changed: &[[f64; 2]]) {
        let mut concentrations = self.level.growth.concentrations();
        if !again.is_empty() {
            let places = self.varied.iter().flat_map(|spots| &spots.places);
            let stay: Vec<[f64; 2]> = places.filter(|at| !again.contains(at)).copied().collect();
            let afresh = |cells: &[usize], near: &dyn Fn([f64; 2], f64) -> bool| {
                self.start.in_cells(&self.maps, cells, near)
            };
            restart(self.system, &self.maps, &mut concentrations, [again, &stay], afresh);
        }
        self.grow_on_from(concentrations, changed);
    }

    /// Goes on growing from these concentrations. What is at the places `changed`, cells, has to settle.
    pub(super) fn grow_on_from(&mut self, concentrations: Vec<Vec<f32>>, changed: &[[f64; 2]]) {
        let growth = during(Phase::Coefficients, || Growth::resumed(self.system, &self.maps, concentrations))
            .expect("made for this system on this grid");
        // Only what has changed has to settle.
        let rates = changed.iter().map(|at| f64::from(self.maps.at(*at).rate));
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
            monitor: ConvergenceMonitor::new(self.system, unit, false, growth.marks().values),
            counts: vec![true; cells],
            next_correction: None,
            expected: ConvergenceMonitor::expected(self.system, unit, false) * cells as f64,
            growth,
        };
        self.done = false;
        if let Some(control) = &self.position_control {
            let longest = LONGEST / self.level.growth.euler_steps_a_step();
            self.level.monitor.hold_corrected_marks(control.keeps_moving().then_some(longest));
            self.level.plan_correction(control.every());
        }
    }
}
