//! Streaks and cracks as a kind of layer.

use crate::document::{Document, LineKind};
use crate::grid::{Domain, Field};
use crate::points::discs::Laying;
use crate::synth::error::LayerError;
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Request, Seen, Setting, Trial, Work,
};
use crate::synth::lines::describe::described;
use crate::synth::lines::grow::{LAID, LinesGrowth};
use crate::synth::lines::grown::GrownLines;
use crate::synth::lines::plan::LinePlan;
use crate::synth::lines::report::{line_regions, share};
use crate::synth::marks::grow::obstacles::obstacles;
use crate::synth::memory;
use crate::synth::pattern::LayerPattern;
use crate::synth::profile::{Section, during};
use crate::synth::report::LayerReport;
use crate::synth::time::TRY_SECONDS;
use crate::synth::watch::Stage;

/// Layers of streaks or cracks.
#[derive(Debug)]
pub struct Lines;

/// Memory per cell for streaks and cracks, besides their points, bytes: labels, pattern, spline, the best pattern so far, distances
/// from obstacles.
const LINE: f64 = 50.0;
/// Time per cell for streaks and cracks on one core, s.
const CELL_SECONDS: f64 = 4e-6;
/// Time per point and layout on one core, s.
const POINT_SECONDS: f64 = 1e-4;

impl Kind for Lines {
    type Plan = LinePlan;
    type Growth<'a> = LinesGrowth;
    type Grown = GrownLines;

    fn takes(document: &Document, index: usize) -> bool {
        document.layers[index].point_lines().is_some()
    }

    fn read(request: &Request) -> Result<LinePlan, LayerError> {
        let Request { document, index, source, size, .. } = *request;
        let kind = document.layers[index].point_lines().unwrap_or(LineKind::Streaks);
        Ok(LinePlan::read(document, index, kind, source, size)?)
    }

    fn planned(plan: &LinePlan) -> Planned {
        Planned { system: plan.kind.description(), grid: plan.grid }
    }

    fn bytes(plan: &LinePlan, size: [f64; 2], grid: [usize; 2]) -> f64 {
        let times = (grid[0] * grid[1]) as f64 / plan.grid.cells() as f64;
        memory::of_cells(LINE, size, grid) + times * memory::of_points(&plan.laying())
    }

    fn seconds(plan: &LinePlan) -> f64 {
        let Laying { points, tries, .. } = plan.laying();
        let each = points * POINT_SECONDS + tries * TRY_SECONDS;
        plan.grid.cells() as f64 * CELL_SECONDS + LAID as f64 * each
    }

    fn trial(plan: &LinePlan, _seed: u64) -> Option<Trial> {
        let look = Box::new(Field::flat(plan.grid.size[0], plan.grid.size[1], plan.grid.edges, 0.0));
        Some(Trial { work: Work::Seconds(Self::seconds(plan)), look })
    }

    fn describe(plan: &LinePlan, request: &Request, notes: Vec<String>) -> Described {
        described(plan, request, notes)
    }

    fn no_morph(document: &Document, index: usize) -> Option<String> {
        let name = document.layers[index].point_lines()?.description().name;
        Some(format!("{name} grow on its layer; allowed: systems of spots or stripes"))
    }

    fn begin<'a>(plan: LinePlan, beneath: &Beneath, setting: Setting<'a>) -> Result<LinesGrowth, LayerError> {
        let obstacles = during(Section::LayOut, || obstacles(beneath, plan.grid.size, &|_| false));
        LinesGrowth::begin(LinePlan { obstacles, ..plan }, &setting)
    }

    fn advance(growth: &mut LinesGrowth, _budget: u64) -> Result<Advanced, LayerError> {
        growth.advance()
    }

    fn progress(growth: &LinesGrowth) -> (Stage, f64) {
        growth.progress()
    }

    fn updates_in(_growth: &LinesGrowth, _time: f64) -> u64 {
        1
    }

    fn seen<'s>(growth: &'s LinesGrowth) -> Option<Seen<'s>> {
        growth.now().map(|field| Seen::of_areas(0, field))
    }

    fn complete(growth: LinesGrowth) -> Option<GrownLines> {
        growth.complete()
    }

    fn planned_of(grown: &GrownLines) -> Planned {
        Self::planned(&grown.plan)
    }

    /// Nothing reacts.
    fn ending(_grown: &GrownLines) -> Ending {
        Ending { steps: 0, settled: true }
    }

    fn pattern(grown: &GrownLines) -> LayerPattern<'_> {
        Box::new(grown.pattern())
    }

    fn report(grown: &GrownLines, _document: &Document, _index: usize, report: &mut LayerReport) {
        report.regions = line_regions(grown);
        report.share = Some(share(grown));
    }
}
