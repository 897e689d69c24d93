//! Layers that a picture or Turing's growth drives, as a kind of layer.

use crate::document::Document;
use crate::grid::{Domain, Field};
use crate::synth::error::LayerError;
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Previewed, Request, Seen, Setting, Trial, Work,
};
use crate::synth::marks::{share_needed, stepped};
use crate::synth::memory;
use crate::synth::pairs::plan::FROM_NOISE;
use crate::synth::pairs::{UPDATE_SECONDS, timed};
use crate::synth::pattern::LayerPattern;
use crate::synth::report::LayerReport;
use crate::synth::tone::advice::advice;
use crate::synth::tone::describe::described;
use crate::synth::tone::grow::{DrivenGrowth, seen};
use crate::synth::tone::grown::GrownTone;
use crate::synth::tone::growth::ToneGrowth;
use crate::synth::tone::plan::{ToneMaps, TonePlan, ToneSystem};
use crate::synth::tone::report::{growth_report, tone_report};
use crate::synth::watch::Stage;

/// Layers that a picture or Turing's growth drives.
#[derive(Debug)]
pub struct Driven;

/// Time per px of the tone, s.
const FINE_SECONDS: f64 = 4e-7;

impl Kind for Driven {
    type Plan = TonePlan;
    type Growth<'a> = DrivenGrowth;
    type Grown = GrownTone;

    fn takes(document: &Document, index: usize) -> bool {
        document.layers[index].is_driven()
    }

    fn read(request: &Request) -> Result<TonePlan, LayerError> {
        let Request { document, index, source, size, training, memory, .. } = *request;
        Ok(TonePlan::read(document, index, source, size, (training, memory))?)
    }

    fn planned(plan: &TonePlan) -> Planned {
        Planned { system: plan.system.description(), grid: plan.grid }
    }

    fn bytes(plan: &TonePlan, size: [f64; 2], grid: [usize; 2]) -> f64 {
        let times = grid[0] as f64 / plan.grid.size[0] as f64;
        let fine = plan.fine.map(|px| (px as f64 * times).round() as usize);
        memory::needed_by_tone(plan.system.needed(size, grid), grid, fine)
    }

    fn seconds(plan: &TonePlan) -> f64 {
        let fine = (plan.fine[0] * plan.fine[1]) as f64 * FINE_SECONDS;
        fine + match plan.system {
            ToneSystem::Of(system) => plan.grid.cells() as f64 * system.definition().cost.seconds_a_cell,
            ToneSystem::PairStripes => plan.updates_of_pair() * UPDATE_SECONDS,
        }
    }

    fn trial(plan: &TonePlan, seed: u64) -> Option<Trial> {
        let growth = ToneGrowth::new(plan, seed);
        let work = match (&growth, plan.maps()) {
            (ToneGrowth::Of(engine), ToneMaps::Of(system, maps)) => {
                let units = share_needed(engine, system) * engine.updates_left();
                Work::Units { units, part: stepped(system, &maps)? }
            }
            (ToneGrowth::Pairs(pairs), _) => timed((**pairs).clone(), FROM_NOISE),
            (ToneGrowth::Of(_), ToneMaps::Pairs(_)) => return None,
        };
        Some(Trial { work, look: Box::new(Begun { plan: plan.clone(), growth }) })
    }

    fn describe(plan: &TonePlan, request: &Request, notes: Vec<String>) -> Described {
        described(plan, request, notes)
    }

    fn no_morph(document: &Document, index: usize) -> Option<String> {
        let layer = &document.layers[index];
        Some(match layer.tone {
            Some(_) => "a picture drives its layer; allowed: layers without a tone".to_owned(),
            None => "a growth drives its layer; allowed: systems of spots or stripes".to_owned(),
        })
    }

    fn begin<'a>(
        plan: TonePlan,
        _beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<DrivenGrowth, LayerError> {
        DrivenGrowth::begin(plan, &setting)
    }

    fn advance(growth: &mut DrivenGrowth, budget: u64) -> Result<Advanced, LayerError> {
        growth.advance(budget)
    }

    fn progress(growth: &DrivenGrowth) -> (Stage, f64) {
        growth.progress()
    }

    fn updates_in(growth: &DrivenGrowth, time: f64) -> u64 {
        growth.updates_in(time)
    }

    fn seen<'s>(growth: &'s DrivenGrowth) -> Option<Seen<'s>> {
        growth.seen()
    }

    fn complete(growth: DrivenGrowth) -> Option<GrownTone> {
        growth.complete()
    }

    fn planned_of(grown: &GrownTone) -> Planned {
        Self::planned(&grown.plan)
    }

    fn ending(grown: &GrownTone) -> Ending {
        Ending { steps: grown.steps, settled: grown.settled }
    }

    fn pattern(grown: &GrownTone) -> LayerPattern<'_> {
        Box::new(grown.pattern())
    }

    fn advice(grown: &GrownTone, full: bool) -> &'static str {
        advice(&grown.plan, full)
    }

    fn report(grown: &GrownTone, document: &Document, index: usize, report: &mut LayerReport) {
        let tone = document.layers[index].tone.as_ref();
        report.tone = tone.and_then(|tone| tone_report(tone, grown));
        report.growth = growth_report(grown);
    }

    fn chemicals(grown: &GrownTone) -> Vec<(String, Field)> {
        let named = grown.plan.system.chemicals().into_iter().zip(&grown.concentrations);
        let field = |values: &Vec<f32>| Field { values: values.clone(), ..grown.relief.clone() };
        named.map(|(letter, values)| (letter.to_owned(), field(values))).collect()
    }
}

/// The layer after a few steps.
struct Begun {
    plan: TonePlan,
    growth: ToneGrowth,
}

impl Previewed for Begun {
    fn seen(&self) -> Seen<'_> {
        seen(&self.plan, &self.growth)
    }
}
