//! Patches and cells as a kind of layer.

use crate::document::Document;
use crate::grid::{Domain, Field};
use crate::points::discs::Laying;
use crate::synth::areas::describe::described;
use crate::synth::areas::grown::GrownAreas;
use crate::synth::areas::patches::PatchesGrowth;
use crate::synth::areas::plan::{AreaForm, AreaPlan, rows_of_cells};
use crate::synth::areas::polygons::{PolygonGrowth, PolygonSetting};
use crate::synth::areas::report::{area_regions, drawn_areas, gap};
use crate::synth::error::{LayerError, PlanError};
use crate::synth::kind::{
    Advanced, Beneath, Described, Ending, Kind, Planned, Request, Seen, Setting, Trial, Work,
};
use crate::synth::marks::grow::obstacles::obstacles;
use crate::synth::memory;
use crate::synth::pairs::UPDATE_SECONDS;
use crate::synth::pattern::LayerPattern;
use crate::synth::profile::{Section, during};
use crate::synth::report::{DrawnMark, LayerReport};
use crate::synth::time::TRY_SECONDS;
use crate::synth::watch::Stage;

/// Layers of patches or cells.
#[derive(Debug)]
pub struct Areas;

/// Memory per cell for patches, besides their points, bytes: field and spline. A Holstein on 2436² cells took 165 MB in all, and a
/// giraffe on 2180² cells 252 MB; 304 and 272 MB are reserved for them.
const PATCH: f64 = 30.0;
/// Memory per cell that rosettes need beyond their patches, bytes: on 2738² cells a growth took 264 MB with them, 221 MB without.
const ROSETTE: f64 = 10.0;
/// Memory per cell of the grid of cells, bytes: the pair, whose size may vary, its fields, and the distances from borders.
const CELL: f64 = 150.0;
/// Time per cell of the grid of patches on one core, s: including their points, the two documents of [`PATCH`] took 7.4 and 13.9 s.
/// All points are laid before the first one is shown, so that no beginning of the growth can be timed.
const PATCH_SECONDS: f64 = 2.5e-6;
/// Time per point of patches on one core, s.
const PATCH_POINT_SECONDS: f64 = 4e-5;
/// Time of one comparison of two centres, s.
const COMPARED_SECONDS: f64 = 8e-9;
/// Time to compute the distance of a cell from one side of a kept outline, s.
const SIDE_SECONDS: f64 = 3e-9;
/// Time per cell of the grid of cells, besides its reaction, s.
const CELL_SECONDS: f64 = 3e-6;

/// A layer of patches or cells that grows.
pub enum AreasGrowth {
    /// Patches.
    Patches(Box<PatchesGrowth>),
    /// Cells.
    Polygons(Box<PolygonGrowth>),
}

impl Kind for Areas {
    type Plan = AreaPlan;
    type Growth<'a> = AreasGrowth;
    type Grown = GrownAreas;

    fn takes(document: &Document, index: usize) -> bool {
        document.areas(index).is_some()
    }

    fn read(request: &Request) -> Result<AreaPlan, LayerError> {
        let Request { document, index, source, size, training, .. } = *request;
        let rows = rows_of_cells(document, index, training).map_err(PlanError::Training)?;
        Ok(AreaPlan::read(document, index, source, size, rows)?)
    }

    fn planned(plan: &AreaPlan) -> Planned {
        Planned { system: plan.kind().description(), grid: plan.grid }
    }

    fn bytes(plan: &AreaPlan, size: [f64; 2], grid: [usize; 2]) -> f64 {
        let times = (grid[0] * grid[1]) as f64 / plan.grid.cells() as f64;
        match &plan.form {
            AreaForm::Patches(form) => {
                let cell = PATCH + form.rosette.map_or(0.0, |_| ROSETTE);
                memory::of_cells(cell, size, grid) + times * memory::of_points(&form.laying(plan))
            }
            AreaForm::Polygons(form) => {
                memory::of_cells(CELL, size, grid) + times * memory::of_points(&form.laying(plan))
            }
        }
    }

    fn seconds(plan: &AreaPlan) -> f64 {
        let cells = plan.grid.cells() as f64;
        let kept = plan.asked_sides() * SIDE_SECONDS;
        let (compared, own) = match &plan.form {
            AreaForm::Patches(form) => {
                let Laying { points, tries, .. } = form.laying(plan);
                let of_points = points * PATCH_POINT_SECONDS + tries * TRY_SECONDS;
                (form.compared(plan), cells * PATCH_SECONDS + of_points)
            }
            AreaForm::Polygons(form) => {
                (form.compared(plan), cells * CELL_SECONDS + form.updates(plan) * UPDATE_SECONDS)
            }
        };
        kept + compared * COMPARED_SECONDS + own
    }

    fn trial(plan: &AreaPlan, _seed: u64) -> Option<Trial> {
        let look = Box::new(Field::flat(plan.grid.size[0], plan.grid.size[1], plan.grid.edges, 0.0));
        Some(Trial { work: Work::Seconds(Self::seconds(plan)), look })
    }

    fn describe(plan: &AreaPlan, request: &Request, notes: Vec<String>) -> Described {
        described(plan, request, notes)
    }

    fn no_morph(document: &Document, index: usize) -> Option<String> {
        let name = document.areas(index)?.description().name;
        Some(format!("{name} grow on its layer; allowed: systems of spots or stripes"))
    }

    fn begin<'a>(plan: AreaPlan, beneath: &Beneath, setting: Setting<'a>) -> Result<AreasGrowth, LayerError> {
        let Setting { seed, corrects, filmed, .. } = setting;
        let obstacles = during(Section::LayOut, || obstacles(beneath, plan.grid.size, &|_| false));
        let plan = AreaPlan { obstacles, ..plan };
        Ok(match plan.form.clone() {
            AreaForm::Patches(form) => {
                AreasGrowth::Patches(Box::new(PatchesGrowth::begin(plan, &form, seed, filmed)))
            }
            AreaForm::Polygons(form) => {
                let setting = PolygonSetting { seed, corrects };
                AreasGrowth::Polygons(Box::new(PolygonGrowth::begin(plan, form, setting)?))
            }
        })
    }

    fn advance(growth: &mut AreasGrowth, budget: u64) -> Result<Advanced, LayerError> {
        match growth {
            AreasGrowth::Patches(patches) => patches.advance(),
            AreasGrowth::Polygons(cells) => cells.advance(budget),
        }
    }

    fn progress(growth: &AreasGrowth) -> (Stage, f64) {
        match growth {
            AreasGrowth::Patches(patches) => patches.progress(),
            AreasGrowth::Polygons(cells) => cells.progress(),
        }
    }

    /// Cells are shown at fixed intervals of their own time, whatever `_time` is.
    fn updates_in(growth: &AreasGrowth, _time: f64) -> u64 {
        match growth {
            AreasGrowth::Patches(_) => 1,
            AreasGrowth::Polygons(cells) => cells.updates_between(),
        }
    }

    fn seen<'s>(growth: &'s AreasGrowth) -> Option<Seen<'s>> {
        match growth {
            AreasGrowth::Patches(patches) => patches.now().map(|(steps, field)| Seen::of_areas(steps, field)),
            AreasGrowth::Polygons(cells) => cells.seen(),
        }
    }

    fn complete(growth: AreasGrowth) -> Option<GrownAreas> {
        match growth {
            AreasGrowth::Patches(patches) => patches.complete(),
            AreasGrowth::Polygons(cells) => cells.complete(),
        }
    }

    fn planned_of(grown: &GrownAreas) -> Planned {
        Self::planned(&grown.plan)
    }

    /// Areas have a time after which they have settled.
    fn ending(grown: &GrownAreas) -> Ending {
        Ending { steps: grown.steps, settled: true }
    }

    fn pattern(grown: &GrownAreas) -> LayerPattern<'_> {
        Box::new(grown.pattern())
    }

    fn drawn(grown: &GrownAreas) -> Vec<DrawnMark> {
        drawn_areas(grown)
    }

    fn report(grown: &GrownAreas, _document: &Document, _index: usize, report: &mut LayerReport) {
        report.regions = area_regions(grown, &report.drawn);
        report.gap = gap(grown);
    }
}
