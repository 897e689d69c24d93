//! Spots and stripes as a kind of layer.

use crate::attributes::{Attributes, Polarity};
use crate::document::{After, Document};
use crate::grid::{Domain, Field};
use crate::rd::{Growth, ParameterField, System};
use crate::synth::error::LayerError;
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Previewed, Request, Seen, Setting, Trial, Work,
};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::describe::described;
use crate::synth::marks::grow::MarksGrowth;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::grid_levels::LEAST_SIDE;
use crate::synth::marks::grow::obstacles::obstacles;
use crate::synth::marks::grow::passing::crosses;
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::plan::{Lookup, Plan, Targets};
use crate::synth::marks::planned::{MarksPlan, looked_up};
use crate::synth::marks::report::{drawn_marks, left_out, merged_spots, regions};
use crate::synth::memory;
use crate::synth::pattern::LayerPattern;
use crate::synth::report::{DrawnMark, LayerReport};
use crate::synth::watch::Stage;

/// Layers of spots or stripes of one system with training rows.
#[derive(Debug)]
pub struct Marks;

/// Cell updates before the first picture is taken: enough for marks and ground to separate.
const PREVIEWED: u64 = 100_000;
/// Steps of the part of a growth that is timed.
const STEPS: u64 = 8;

impl Kind for Marks {
    type Plan = MarksPlan;
    type Growth<'a> = MarksGrowth<'a>;
    type Grown = GrownMarks;

    /// Accepts every layer that no other kind accepts.
    fn takes(_document: &Document, _index: usize) -> bool {
        true
    }

    fn read(request: &Request) -> Result<MarksPlan, LayerError> {
        let Request { document, index, source, size, training, beneath, .. } = *request;
        let targets = Targets::read(document, index, source, size, looked_up(beneath))?;
        let layer = &document.layers[index];
        Ok(MarksPlan { lookup: targets.look_up(training)?, options: layer.options, after: layer.after })
    }

    fn is_final(plan: &MarksPlan) -> bool {
        plan.after != After::Inside
    }

    fn planned(plan: &MarksPlan) -> Planned {
        Planned { system: plan.lookup.system.description(), grid: plan.lookup.grid }
    }

    fn bytes(plan: &MarksPlan, size: [f64; 2], grid: [usize; 2]) -> f64 {
        memory::needed(plan.lookup.system, size, grid)
    }

    fn seconds(plan: &MarksPlan) -> f64 {
        let Lookup { system, grid, map, .. } = &plan.lookup;
        let of_cells = system.definition().cost.seconds_a_cell * grid.cells() as f64;
        let areas = map.samples().into_iter().map(|wanted| match wanted {
            Attributes::Spots(spots) => spots.area,
            Attributes::Stripes(stripes) => stripes.width * stripes.width,
        });
        let [least, largest] =
            areas.fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], area| [low.min(area), high.max(area)]);
        // Large marks need more steps in proportion to their cells, but on a grid on which fewer cells suffice in the same
        // proportion.
        let coarser = (grid.size[0].min(grid.size[1]) as f64 / LEAST_SIDE).max(1.0).powi(2);
        of_cells * (largest / least / (coarser * coarser)).max(1.0)
    }

    fn trial(plan: &MarksPlan, seed: u64) -> Option<Trial> {
        let begun = plan.lookup.clone().rough(Vec::new()).begin(seed);
        let engine = Engine::new(&begun, seed);
        let plan = begun.plan;
        let system = plan.lookup.system;
        let units = share_needed(&engine, system) * engine.updates_left();
        let part = stepped(system, &plan.unpitched_maps())?;
        Some(Trial { work: Work::Units { units, part }, look: Box::new(Rough { plan, engine }) })
    }

    fn describe(plan: &MarksPlan, request: &Request, notes: Vec<String>) -> Described {
        described(plan, request, notes)
    }

    fn preview(plan: &MarksPlan, beneath: &Beneath, seed: u64) -> Option<Box<dyn Previewed>> {
        if !beneath.layers.is_empty() && !plan.after.keeps_away() {
            // The full layout is needed first.
            return None;
        }
        let lookup = &plan.lookup;
        let obstacles = obstacles(beneath, lookup.grid.size, &|layer| crosses(lookup, layer));
        let plan = lookup.clone().rough(obstacles);
        // The marks are at the system's own distance: correcting the spacing takes several times as long.
        let mut engine = Engine::from_maps(plan.lookup.system, plan.unpitched_maps(), seed);
        if !engine.can_start() {
            return None;
        }
        engine.advance(PREVIEWED);
        Some(Box::new(Rough { plan, engine }))
    }

    fn no_morph(_document: &Document, _index: usize) -> Option<String> {
        None
    }

    fn begin<'a>(
        plan: MarksPlan,
        beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<MarksGrowth<'a>, LayerError> {
        MarksGrowth::begin(plan.lookup, plan.options, beneath, setting)
    }

    fn advance(growth: &mut MarksGrowth<'_>, budget: u64) -> Result<Advanced, LayerError> {
        growth.advance(budget)
    }

    fn progress(growth: &MarksGrowth<'_>) -> (Stage, f64) {
        growth.progress()
    }

    fn updates_in(growth: &MarksGrowth<'_>, time: f64) -> u64 {
        growth.updates_in(time)
    }

    fn seen<'s>(growth: &'s MarksGrowth<'_>) -> Option<Seen<'s>> {
        growth.seen()
    }

    fn left_out(growth: &MarksGrowth<'_>) -> Vec<DrawnMark> {
        left_out(growth.left_out())
    }

    fn complete(growth: MarksGrowth<'_>) -> Option<GrownMarks> {
        growth.complete()
    }

    fn planned_of(grown: &GrownMarks) -> Planned {
        let lookup = &grown.plan.lookup;
        Planned { system: lookup.system.description(), grid: lookup.grid }
    }

    fn ending(grown: &GrownMarks) -> Ending {
        Ending { steps: grown.steps, settled: grown.settled }
    }

    fn pattern(grown: &GrownMarks) -> LayerPattern<'_> {
        Box::new(grown.pattern())
    }

    fn drawn(grown: &GrownMarks) -> Vec<DrawnMark> {
        let [nx, ny] = grown.plan.lookup.grid.size;
        drawn_marks(grown, &|| grown.whole_pattern().field(nx, ny))
    }

    fn left_out_of(grown: &GrownMarks) -> Vec<DrawnMark> {
        left_out(grown.corrections.left_out())
    }

    fn report(grown: &GrownMarks, document: &Document, index: usize, report: &mut LayerReport) {
        report.inverted = grown.plan.lookup.polarity == Polarity::Negative;
        report.regions = regions(document, index, grown, &report.drawn);
        report.merged = merged_spots(grown);
        report.half_grown.clone_from(&grown.half_grown);
    }

    fn chemicals(grown: &GrownMarks) -> Vec<(String, Field)> {
        let named = grown.plan.lookup.system.chemicals().iter().zip(&grown.concentrations);
        let field = |values: &Vec<f32>| Field { values: values.clone(), ..grown.marks.clone() };
        named.map(|(letter, values)| ((*letter).to_owned(), field(values))).collect()
    }
}

/// Cell updates needed ÷ cell updates expected.
pub(in crate::synth) fn share_needed(engine: &Engine, system: System) -> f64 {
    let cost = system.definition().cost;
    if engine.grid_level()[1] == 1 { cost.updates_on_one_grid } else { cost.updates }
}

/// A part of the work: some steps of `system` on the grid of `maps`. Returns the number of cell updates.
pub(in crate::synth) fn stepped(system: System, maps: &ParameterField) -> Option<Box<dyn FnMut() -> f64>> {
    let cells = maps.domain.cells();
    let concentrations = vec![vec![1.0; cells]; system.chemicals().len()];
    let mut growth = Growth::resumed(system, maps, concentrations)?;
    Some(Box::new(move || {
        let before = growth.steps();
        growth.advance(STEPS);
        ((growth.steps() - before) * cells as u64) as f64
    }))
}

/// A rough plan that has hardly grown.
struct Rough {
    plan: Plan,
    engine: Engine,
}

impl Previewed for Rough {
    fn seen(&self) -> Seen<'_> {
        let Self { plan, engine } = self;
        let pattern = || Pattern::new(&plan.lookup, &plan.levelled(engine.marks()));
        Seen {
            steps: engine.steps(),
            grid: engine.grid(),
            canvas: plan.lookup.grid.bounds_px().size,
            pattern: Box::new(move || Box::new(pattern())),
        }
    }
}
