//! Fields of points as a kind of layer.

use crate::document::Document;
use crate::grid::{Domain, Field};
use crate::points::fields::POINTS;
use crate::synth::error::LayerError;
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Request, Seen, Setting, Trial, Work,
};
use crate::synth::marks::grow::obstacles::obstacles;
use crate::synth::memory;
use crate::synth::pattern::LayerPattern;
use crate::synth::points::advice::advice;
use crate::synth::points::describe::described;
use crate::synth::points::grow::PointsGrowth;
use crate::synth::points::grown::GrownPoints;
use crate::synth::points::plan::FieldPlan;
use crate::synth::points::report::{notes, points_report};
use crate::synth::profile::{Section, during};
use crate::synth::report::LayerReport;
use crate::synth::time::TRY_SECONDS;
use crate::synth::watch::Stage;

/// Layers of a field of points.
#[derive(Debug)]
pub struct Points;

/// Memory per cell of a field of points, besides its points, bytes: 4000² cells with 311,000 points took 388 MB in all, 2000² with
/// 700,000 points 657 MB; 532 and 707 MB are reserved.
const CELL: f64 = 12.0;
/// Time per cell and octave of a field of points at L = 1, s; the supports of each cell increase with the square of L.
const CELL_SECONDS: f64 = 1.5e-7;
/// Cells along a side of the field whose painting is timed.
const PAINTED: usize = 64;

impl Kind for Points {
    type Plan = FieldPlan;
    type Growth<'a> = PointsGrowth;
    type Grown = GrownPoints;

    /// The distances of points can depend on the size of the canvas.
    const SCALES: bool = false;

    fn takes(document: &Document, index: usize) -> bool {
        document.layers[index].point_field().is_some()
    }

    fn read(request: &Request) -> Result<FieldPlan, LayerError> {
        let Request { document, index, source, size, .. } = *request;
        let points = document.layers[index].point_field().unwrap_or_default();
        Ok(FieldPlan::read(document, index, points, source, size)?)
    }

    fn planned(plan: &FieldPlan) -> Planned {
        Planned { system: &POINTS, grid: plan.grid }
    }

    fn bytes(plan: &FieldPlan, size: [f64; 2], grid: [usize; 2]) -> f64 {
        memory::of_cells(CELL, size, grid) + memory::of_points(&plan.laying())
    }

    fn seconds(plan: &FieldPlan) -> f64 {
        let fields = f64::from(plan.points.octaves) * plan.points.axis * plan.points.axis;
        plan.grid.cells() as f64 * fields * CELL_SECONDS + plan.laying().tries * TRY_SECONDS
    }

    fn trial(plan: &FieldPlan, _seed: u64) -> Option<Trial> {
        let seconds = Self::seconds(plan);
        // Only the time of a px is measured.
        let look = Box::new(Field::flat(PAINTED, PAINTED, plan.grid.edges, 0.0));
        Some(Trial { work: Work::Seconds(seconds), look })
    }

    fn describe(plan: &FieldPlan, request: &Request, notes: Vec<String>) -> Described {
        described(plan, request, notes)
    }

    fn no_morph(document: &Document, index: usize) -> Option<String> {
        document.layers[index].point_field()?;
        Some(format!("{} grow on its layer; allowed: systems of spots or stripes", POINTS.name))
    }

    fn begin<'a>(
        mut plan: FieldPlan,
        beneath: &Beneath,
        setting: Setting<'a>,
    ) -> Result<PointsGrowth, LayerError> {
        plan.obstacles = during(Section::LayOut, || obstacles(beneath, plan.grid.size, &|_| false));
        PointsGrowth::begin(plan, &setting)
    }

    fn advance(growth: &mut PointsGrowth, _budget: u64) -> Result<Advanced, LayerError> {
        growth.advance()
    }

    fn progress(growth: &PointsGrowth) -> (Stage, f64) {
        growth.progress()
    }

    fn updates_in(_growth: &PointsGrowth, _time: f64) -> u64 {
        1
    }

    fn seen<'s>(growth: &'s PointsGrowth) -> Option<Seen<'s>> {
        growth.now().map(|(steps, field)| Seen::of_areas(steps, field))
    }

    fn complete(growth: PointsGrowth) -> Option<GrownPoints> {
        growth.complete()
    }

    fn planned_of(grown: &GrownPoints) -> Planned {
        Self::planned(&grown.plan)
    }

    /// Nothing reacts.
    fn ending(_grown: &GrownPoints) -> Ending {
        Ending { steps: 0, settled: true }
    }

    fn pattern(grown: &GrownPoints) -> LayerPattern<'_> {
        Box::new(grown.pattern())
    }

    fn advice(grown: &GrownPoints, _full: bool) -> &'static str {
        advice(&grown.plan.points.labels)
    }

    fn report(grown: &GrownPoints, _document: &Document, _index: usize, report: &mut LayerReport) {
        report.points = Some(points_report(grown));
        report.notes = notes(grown);
    }
}
