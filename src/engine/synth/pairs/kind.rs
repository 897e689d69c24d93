//! Pairs of morphogens as a kind of layer.

use crate::document::Document;
use crate::grid::{Domain, Field};
use crate::rd::pairs::{PairGrowth, PairKind, PairStart};
use crate::synth::error::{LayerError, PlanError};
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Previewed, Request, Seen, Setting, Trial, Work,
};
use crate::synth::memory;
use crate::synth::pairs::describe::described;
use crate::synth::pairs::grow::{PairsGrowth, begin, seen, whole_time};
use crate::synth::pairs::grown::GrownPairs;
use crate::synth::pairs::plan::PairPlan;
use crate::synth::pairs::report;
use crate::synth::pairs::stripes_of_threads::{StripesNeed, needed_by_stripes};
use crate::synth::pattern::LayerPattern;
use crate::synth::report::{DrawnMark, LayerReport, drawn};
use crate::synth::watch::Stage;

/// Layers that a system of pairs of morphogens grows.
#[derive(Debug)]
pub struct Pairs;

/// Time of an update of one morphogen in one cell on one core, s.
pub(in crate::synth) const UPDATE_SECONDS: f64 = 2e-9;
/// Time per cell and direction of the other work, s: laying lines, measuring threads.
const CELL_SECONDS: f64 = 3e-6;
/// Steps of the part of a growth that is timed.
const STEPS: u64 = 8;

/// The plan of a layer of pairs, and the index of the layer.
#[derive(Clone)]
pub struct PlannedPairs {
    /// Its plan.
    pub plan: PairPlan,
    /// The index of the layer in the document.
    pub index: usize,
    /// The time and memory of the stripes along which its threads begin.
    pub stripes: StripesNeed,
}

impl Kind for Pairs {
    type Plan = PlannedPairs;
    type Growth<'a> = PairsGrowth<'a>;
    type Grown = GrownPairs;

    fn takes(document: &Document, index: usize) -> bool {
        document.pairs(index).is_some()
    }

    fn read(request: &Request) -> Result<PlannedPairs, LayerError> {
        let Request { document, index, source, size, training, .. } = *request;
        let kind = document.pairs(index).unwrap_or(PairKind::Weave);
        let rows = training.pairs(kind.description()).map_err(PlanError::Training)?;
        let plan = PairPlan::read(document, index, source, size, rows)?;
        let stripes = needed_by_stripes(request, &plan)?;
        Ok(PlannedPairs { plan, index, stripes })
    }

    fn planned(PlannedPairs { plan, .. }: &PlannedPairs) -> Planned {
        Planned { system: plan.kind().description(), grid: plan.grid }
    }

    fn bytes(PlannedPairs { plan, stripes, .. }: &PlannedPairs, size: [f64; 2], grid: [usize; 2]) -> f64 {
        let times = (grid[0] * grid[1]) as f64 / plan.grid.cells() as f64;
        memory::needed_by_pairs(plan.threads.len(), size, grid).max(times * stripes.bytes)
    }

    fn seconds(PlannedPairs { plan, index, stripes }: &PlannedPairs) -> f64 {
        let updates = plan.updates(whole_time(plan.kind()), *index > 0);
        let of_cell = CELL_SECONDS * plan.threads.len() as f64;
        stripes.seconds + updates * UPDATE_SECONDS + of_cell * plan.grid.cells() as f64
    }

    fn trial(PlannedPairs { plan, .. }: &PlannedPairs, _seed: u64) -> Option<Trial> {
        let factors = vec![1.0; plan.threads.len()];
        let mut growth = begin(plan, &factors, &PairStart::Noise(0));
        growth.advance(STEPS);
        let look = Box::new(Begun { plan: plan.clone(), growth: growth.clone() });
        let work = timed(growth, whole_time(plan.kind()));
        Some(Trial { work, look })
    }

    fn describe(plan: &PlannedPairs, request: &Request, notes: Vec<String>) -> Described {
        described(&plan.plan, request, notes)
    }

    fn no_morph(document: &Document, index: usize) -> Option<String> {
        let name = document.pairs(index)?.description().name;
        Some(format!("its layer is a {name:?}; allowed: systems of spots or stripes"))
    }

    fn begin<'a>(
        plan: PlannedPairs,
        beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<PairsGrowth<'a>, LayerError> {
        Ok(PairsGrowth::begin(plan.plan, plan.index, beneath, setting))
    }

    fn advance(growth: &mut PairsGrowth<'_>, budget: u64) -> Result<Advanced, LayerError> {
        growth.advance(budget)
    }

    fn progress(growth: &PairsGrowth<'_>) -> (Stage, f64) {
        growth.progress()
    }

    fn updates_in(growth: &PairsGrowth<'_>, time: f64) -> u64 {
        growth.updates_in(time)
    }

    fn seen<'s>(growth: &'s PairsGrowth<'_>) -> Option<Seen<'s>> {
        growth.seen()
    }

    fn complete(growth: PairsGrowth<'_>) -> Option<GrownPairs> {
        growth.complete()
    }

    fn planned_of(grown: &GrownPairs) -> Planned {
        Planned { system: grown.plan.kind().description(), grid: grown.plan.grid }
    }

    /// Pairs have a time after which they have settled.
    fn ending(grown: &GrownPairs) -> Ending {
        Ending { steps: grown.steps, settled: true }
    }

    fn pattern(grown: &GrownPairs) -> LayerPattern<'_> {
        Box::new(grown.pattern())
    }

    fn drawn(grown: &GrownPairs) -> Vec<DrawnMark> {
        report::drawn_lines(grown)
    }

    fn report(grown: &GrownPairs, _document: &Document, _index: usize, into: &mut LayerReport) {
        into.threads = report::threads(grown);
        into.blotches = report::blotches(grown);
        into.note_on_drawn = drawn::note(&into.drawn, Some("threads"));
        into.notes = report::notes(grown).into_iter().chain(into.note_on_drawn.clone()).collect();
    }

    fn chemicals(grown: &GrownPairs) -> Vec<(String, Field)> {
        let signs = (0..).flat_map(|pair| ["+", "-"].map(|sign| format!("C{}{sign}", pair + 1)));
        let field = |values: &Vec<f32>| Field::new(&grown.plan.grid, values.clone());
        signs.zip(grown.concentrations.iter().map(field)).collect()
    }
}

/// The steps of a growth of pairs for `time`, in 1/b, of which some are timed.
pub(in crate::synth) fn timed(mut growth: PairGrowth, time: f64) -> Work {
    let units = growth.steps_in(time) as f64;
    let part = move || {
        let before = growth.steps();
        growth.advance(STEPS);
        (growth.steps() - before) as f64
    };
    Work::Units { units, part: Box::new(part) }
}

/// Pairs after a few steps.
struct Begun {
    plan: PairPlan,
    growth: PairGrowth,
}

impl Previewed for Begun {
    fn seen(&self) -> Seen<'_> {
        seen(&self.plan, &self.growth, 0)
    }
}
