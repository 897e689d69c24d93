//! The time and the memory that a growth needs, estimated before it begins.
//!
//! ```text
//! seconds = Σ updates ÷ speed  +  px of the canvas · layers · RULER · painting  +  px of the picture · painting
//! ```
//!
//! The engine gives the expected cell updates. Their speed, and that of painting a px, are measured on this machine on a
//! canvas of the same texture that is no larger than `TRIAL`: marks keep their size, so that both are as they will be.

use crate::document::{AreaKind, Document, LineKind, Points};
use crate::export::png;
use crate::grid::{Domain, Field};
use crate::rd::pairs::{PairGrowth, PairStart};
use crate::rd::{Growth, Maps, System};
use crate::synth::grow::engine::Engine;
use crate::synth::grow::grow_pairs::{begin, whole_time};
use crate::synth::grow::snapshot::{Growing, Snapshot};
use crate::synth::grow::tone_growth::ToneGrowth;
use crate::synth::memory;
use crate::synth::options::{Clock, Machine};
use crate::synth::plan::areas::{AreaPlan, rows_of_cells};
use crate::synth::plan::pairs::{FROM_NOISE, PairPlan};
use crate::synth::plan::point_fields::FieldPlan;
use crate::synth::plan::point_lines::LinePlan;
use crate::synth::plan::tone::{ToneMaps, TonePlan};
use crate::synth::plan::{Lookup, Plan, Targets};
use crate::synth::render::painting::Painting;
use crate::synth::training::Training;
use std::time::Duration;

/// px of the largest canvas that speeds are measured on.
const TRIAL: f64 = 600.0 * 600.0;
/// How long the speed of the steps is measured: long enough for all threads to wake.
const DURATION: Duration = Duration::from_millis(40);
/// Steps between two readings of the clock.
const STEPS: u64 = 8;
/// Sides of the picture that is painted to measure the time of a px.
const PAINTED: [usize; 2] = [256, 256];
/// The time of measuring a pattern ÷ the time of painting it. Not tuned by itself: with it, the estimates of four examples of
/// 2000² to 6000² px are 0.5 to 1 of the time taken, the least where spots are sparse.
const RULER: f64 = 1.0;

/// Seconds of patches a cell: 235 on 1000² px took .62 s (`facts.md` U). Their points are all laid before the first is seen, so that
/// no beginning can be timed.
const PATCHES: f64 = 1e-6;
/// The same of cells.
const CELLS: f64 = 3e-6;

/// The same of streaks and cracks, whose points are laid up to four times.
const LINES: f64 = 4e-6;

/// Seconds of a field of points a cell and octave at L = 1, whose square each cell's supports go with, and of each point.
const FIELD: f64 = 1.5e-7;
/// See [`FIELD`].
const POINT: f64 = 1e-5;

/// A document to be grown, and how large.
pub struct Task<'a> {
    /// The document.
    pub document: &'a Document,
    /// The canvas that is asked for, px.
    pub size: [u32; 2],
    /// What messages call it, such as its path.
    pub source: &'a str,
    /// px along a side of the picture for one of the canvas.
    pub scale: u32,
    /// What it grows on.
    pub machine: Machine,
}

impl Task<'_> {
    /// px of the canvas, and of the picture.
    #[must_use]
    pub fn px(&self) -> [f64; 2] {
        let canvas = f64::from(self.size[0]) * f64::from(self.size[1]);
        [canvas, canvas * f64::from(self.scale) * f64::from(self.scale)]
    }
}

/// What a growth needs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needs {
    /// Time on this machine, as busy as it is now.
    pub seconds: f64,
    /// Bytes of memory.
    pub bytes: f64,
}

impl Needs {
    /// Estimates one growth. `None` where it cannot be planned, or does not fit into memory: growing it says why.
    #[must_use]
    pub fn estimate(task: &Task, training: &Training) -> Option<Self> {
        let Task { document, source, size, machine: Machine { memory: free, clock }, .. } = *task;
        let [canvas, picture] = task.px();
        let times = (canvas / TRIAL).max(1.0);
        let side = |side: u32| (f64::from(side) / times.sqrt()).max(1.0);
        let mut beneath: Option<Lookup> = None;
        let mut needs = Self { seconds: 0.0, bytes: 0.0 };
        for index in 0..document.layers.len() {
            if document.layers[index].is_driven() {
                needs.add_tone(task, index, training)?;
                beneath = None;
                continue;
            }
            if let Some(kind) = document.pairs(index) {
                let rows = training.pairs(kind.description()).ok()?;
                let plan = PairPlan::read(document, index, source, size.map(side), rows).ok()?;
                let whole = plan.grid.size.map(|cells| (cells as f64 * times.sqrt()).round() as usize);
                let (pairs, size) = (plan.threads.len(), size.map(f64::from));
                memory::check_pairs(pairs, size, whole, free).ok()?;
                needs.bytes = needs.bytes.max(memory::needed_by_pairs(pairs, size, whole));
                let (seconds, growth) = seconds_of_pairs(&plan, clock);
                needs.seconds += times * seconds;
                let look = Snapshot { beneath: &[], growing: Growing::Pairs(&plan, &growth), steps: 0 };
                needs.seconds += painted(document, &look, clock) * (canvas * RULER + picture);
                beneath = None;
                continue;
            }
            if document.layers[index].areas().is_some() {
                needs.add_areas(task, index, training)?;
                beneath = None;
                continue;
            }
            if let Some(kind) = document.layers[index].point_lines() {
                needs.add_lines(task, index, kind)?;
                beneath = None;
                continue;
            }
            if let Some(points) = document.layers[index].point_field() {
                needs.add_points(task, index, points)?;
                beneath = None;
                continue;
            }
            let targets = Targets::read(document, index, source, size.map(side), beneath.as_ref()).ok()?;
            let lookup = targets.look_up(training).ok()?;
            let system = lookup.system;
            let whole = lookup.grid.size.map(|cells| (cells as f64 * times.sqrt()).round() as usize);
            memory::check(system, size.map(f64::from), whole, free).ok()?;
            needs.bytes = needs.bytes.max(memory::needed(system, size.map(f64::from), whole));
            let plan = lookup.rough(Vec::new());
            let engine = Engine::new(&plan, document.layer_seed(index));
            needs.seconds +=
                times * share_needed(&engine, system) * engine.updates_left() / speed(&plan, clock)?;
            needs.seconds += painted(document, &Snapshot::of_marks(&[], &plan, &engine), clock)
                * (canvas * RULER + picture);
            beneath = Some(plan.lookup);
        }
        Some(needs)
    }

    /// Adds those of the patches or cells of layer `index`.
    fn add_areas(&mut self, task: &Task, index: usize, training: &Training) -> Option<()> {
        let Task { document, source, size, machine: Machine { memory: free, clock }, .. } = *task;
        let [canvas, picture] = task.px();
        let times = (canvas / TRIAL).max(1.0);
        let trial = size.map(|side| (f64::from(side) / times.sqrt()).max(1.0));
        let rows = rows_of_cells(document, index, training).ok()?;
        let plan = AreaPlan::read(document, index, source, trial, rows).ok()?;
        let whole = plan.grid.size.map(|cells| (cells as f64 * times.sqrt()).round() as usize);
        let size = size.map(f64::from);
        memory::check_areas(plan.kind(), size, whole, free).ok()?;
        self.bytes = self.bytes.max(memory::needed_by_areas(plan.kind(), size, whole));
        let field = Field::flat(plan.grid.size[0], plan.grid.size[1], plan.grid.edges, 0.0);
        let look = Snapshot { beneath: &[], growing: Growing::Areas(&plan, &field), steps: 0 };
        self.seconds += (whole[0] * whole[1]) as f64 * seconds_of_areas(plan.kind());
        self.seconds += painted(document, &look, clock) * (canvas * RULER + picture);
        Some(())
    }

    /// Adds those of the streaks or cracks of layer `index`.
    fn add_lines(&mut self, task: &Task, index: usize, kind: LineKind) -> Option<()> {
        let Task { document, source, size, machine: Machine { memory: free, clock }, .. } = *task;
        let [canvas, picture] = task.px();
        let times = (canvas / TRIAL).max(1.0);
        let trial = size.map(|side| (f64::from(side) / times.sqrt()).max(1.0));
        let plan = LinePlan::read(document, index, kind, source, trial).ok()?;
        let whole = plan.grid.size.map(|cells| (cells as f64 * times.sqrt()).round() as usize);
        let size = size.map(f64::from);
        memory::check_lines(size, whole, free).ok()?;
        self.bytes = self.bytes.max(memory::needed_by_lines(size, whole));
        let field = Field::flat(plan.grid.size[0], plan.grid.size[1], plan.grid.edges, 0.0);
        let look = Snapshot { beneath: &[], growing: Growing::Lines(&plan, &field), steps: 0 };
        self.seconds += (whole[0] * whole[1]) as f64 * LINES;
        self.seconds += painted(document, &look, clock) * (canvas * RULER + picture);
        Some(())
    }

    /// Adds those of the field of `points` of layer `index`.
    fn add_points(&mut self, task: &Task, index: usize, points: Points) -> Option<()> {
        let Task { document, source, machine: Machine { memory: free, clock }, .. } = *task;
        let [canvas, picture] = task.px();
        let size = task.size.map(f64::from);
        let plan = FieldPlan::read(document, index, points, source, size).ok()?;
        memory::check_points(plan.expected_points(), size, plan.grid.size, free).ok()?;
        self.bytes = self.bytes.max(memory::needed_by_points(plan.expected_points(), size, plan.grid.size));
        // Only the time of a px is measured, on a small field of the same pattern's colours.
        let field = Field::flat(64, 64, plan.grid.edges, 0.0);
        let look = Snapshot { beneath: &[], growing: Growing::Points(&plan, &field), steps: 0 };
        let fields = f64::from(plan.points.octaves) * plan.points.axis * plan.points.axis;
        self.seconds += plan.grid.cells() as f64 * fields * FIELD + plan.expected_points() * POINT;
        self.seconds += painted(document, &look, clock) * (canvas * RULER + picture);
        Some(())
    }

    /// Adds those of layer `index`, which a picture or a growth drives.
    fn add_tone(&mut self, task: &Task, index: usize, training: &Training) -> Option<()> {
        let Task { document, source, size, machine: Machine { memory: free, clock }, .. } = *task;
        let [canvas, picture] = task.px();
        let times = (canvas / TRIAL).max(1.0);
        let trial = size.map(|side| (f64::from(side) / times.sqrt()).max(1.0));
        let plan = TonePlan::read(document, index, source, trial, (training, free)).ok()?;
        let [whole, fine] = [plan.grid.size, plan.fine]
            .map(|size| size.map(|cells| (cells as f64 * times.sqrt()).round() as usize));
        let size = size.map(f64::from);
        let growth = plan.system.needed(size, whole);
        memory::check_tone(growth, size, whole, fine, free).ok()?;
        self.bytes = self.bytes.max(memory::needed_by_tone(growth, whole, fine));
        let mut growth = ToneGrowth::new(&plan, document.layer_seed(index));
        self.seconds += times
            * match (&mut growth, plan.maps()) {
                (ToneGrowth::Of(engine), ToneMaps::Of(system, maps)) => {
                    share_needed(engine, system) * engine.updates_left() / speed_of(system, &maps, clock)?
                }
                (ToneGrowth::Pairs(pairs), _) => seconds_for(pairs, FROM_NOISE, clock),
                (ToneGrowth::Of(_), ToneMaps::Pairs(_)) => return None,
            };
        let look = Snapshot { beneath: &[], growing: Growing::Tone(&plan, &growth), steps: 0 };
        self.seconds += painted(document, &look, clock) * (canvas * RULER + picture);
        Some(())
    }
}

/// Cell updates needed ÷ cell updates expected.
fn share_needed(engine: &Engine, system: System) -> f64 {
    let cost = system.definition().cost;
    if engine.level()[1] == 1 { cost.updates_on_one_grid } else { cost.updates }
}

/// Cell updates a second on the grid of `plan`.
fn speed(plan: &Plan, clock: Clock) -> Option<f64> {
    speed_of(plan.lookup.system, &plan.unpitched_maps(), clock)
}

/// Cell updates a second of `system` on the grid of `maps`.
fn speed_of(system: System, maps: &Maps, clock: Clock) -> Option<f64> {
    let cells = maps.domain.cells();
    let concentrations = vec![vec![1.0; cells]; system.chemicals().len()];
    let mut growth = Growth::resumed(system, maps, concentrations)?;
    growth.advance(STEPS);
    let (started, before) = (clock(), growth.steps());
    while clock() - started < DURATION {
        growth.advance(STEPS);
    }
    Some(((growth.steps() - before) * cells as u64) as f64 / (clock() - started).as_secs_f64().max(1e-6))
}

/// Seconds that pairs take to grow as planned, and their growth at its beginning.
fn seconds_of_pairs(plan: &PairPlan, clock: Clock) -> (f64, PairGrowth) {
    let mut growth = begin(plan, &vec![1.0; plan.threads.len()], &PairStart::Noise(0));
    (seconds_for(&mut growth, whole_time(plan.kind()), clock), growth)
}

/// Seconds that a growth of pairs takes for `time`, in 1/b.
fn seconds_for(growth: &mut PairGrowth, time: f64, clock: Clock) -> f64 {
    growth.advance(STEPS);
    let started = clock();
    let before = growth.steps();
    while clock() - started < DURATION {
        growth.advance(STEPS);
    }
    let of_step = (clock() - started).as_secs_f64() / (growth.steps() - before) as f64;
    growth.steps_in(time) as f64 * of_step
}

/// Seconds a cell of the grid of areas.
fn seconds_of_areas(kind: AreaKind) -> f64 {
    match kind {
        AreaKind::Patches => PATCHES,
        AreaKind::Cells => CELLS,
    }
}

/// Seconds of painting and encoding a px.
fn painted(document: &Document, look: &Snapshot, clock: Clock) -> f64 {
    // Once for the whole texture: pattern and colours of the layer.
    let painting = Painting::growing(document, look, PAINTED);
    let started = clock();
    let rgb = painting.rgb();
    // Discarded: only the time counts.
    let _ = png::rgb8(std::io::sink(), PAINTED, None, &rgb);
    (clock() - started).as_secs_f64() / (PAINTED[0] * PAINTED[1]) as f64
}

/// A time in words, such as `about 40 s`: two digits at most.
#[must_use]
pub fn in_words(seconds: f64) -> String {
    let coarse = |value: f64| if value < 10.0 { value.round() } else { (value / 5.0).round() * 5.0 };
    match seconds {
        s if s < 1.0 => "under 1 s".to_owned(),
        s if s < 90.0 => format!("about {:.0} s", coarse(s)),
        s if s < 5400.0 => format!("about {:.0} min", coarse(s / 60.0)),
        s => format!("about {:.1} h", s / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn estimated_times_are_round_numbers() {
        let times = [0.3, 6.4, 41.0, 119.0, 1000.0, 7200.0].map(in_words);
        assert_eq!(
            times,
            ["under 1 s", "about 6 s", "about 40 s", "about 2 min", "about 15 min", "about 2.0 h"]
        );
    }
}
