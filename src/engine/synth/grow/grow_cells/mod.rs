//! Plans of cells → grown cells.
//!
//! Points are laid at the distance of the cells, and each owns the places nearest to it. Drawn marks own the places in their outlines
//! instead. The reaction begins as 0 on lines of the wanted width between the owned places, and one pair grows from there: corners
//! round off, and lines become evenly wide. At last the level is moved, region by region, until the areas are right.

mod lines;
mod own_cells;
mod owned;

use rayon::prelude::*;

use crate::grid::{Domain, Field};
use crate::measure::{SpotErrors, stripes};
use crate::rd::pairs::cells::{BLURS, TIME, model};
use crate::rd::pairs::{PairField, PairGrowth, PairMaps, PairStart};
use crate::synth::grow::areas::GrownAreas;
use crate::synth::grow::layer::GrowError;
use crate::synth::grow::measured_areas::{EDGE, measured};
use crate::synth::grow::pattern::share;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::areas::AreaPlan;
use crate::synth::plan::areas::cells::CellForm;
use crate::synth::watch::{Stage, Watch};
use lines::{depths_of_kept, held, lines_between};
use own_cells::own_cells;
use owned::{TAKEN, owned};

/// Time between two calls of the watch, in 1/b: ten of them, each of which makes a pattern.
const BETWEEN: f64 = 1.0;
/// Rounds in which the level is moved.
const ROUNDS: usize = 3;
/// Contour ÷ √area of a cell: a hexagon has 3.72.
const CONTOUR: f64 = 3.72;
/// The levels between which edges are read: beyond, cells merge or die.
const LEVELS: [f64; 2] = [0.25, 0.85];
/// Values this near to the level are those of edges.
const NEAR_EDGE: f32 = 0.12;
/// The gap between cells far apart, in sizes of the pair, see [`crate::rd::pairs::cells`].
const STRAIGHT: f64 = 3.5;

/// The level of C₊ at the edges of straight lines: the blur of a line of width w is ½ + ½ e^(−w/s) there.
fn level_of_straight_lines() -> f64 {
    0.5 + 0.5 * libm::exp(-STRAIGHT)
}

/// How a layer of cells is grown.
pub(super) struct CellGrower<'a> {
    /// Number of the layer, 1 = the lowest.
    pub layer: usize,
    /// Seed of all that is random.
    pub seed: u64,
    /// Progress and cancelling.
    pub watch: Watch<'a>,
    /// Is the level moved?
    pub corrects: bool,
}

impl CellGrower<'_> {
    /// Grows the layer as planned.
    pub(super) fn grow(
        &self,
        plan: &AreaPlan,
        form: &CellForm,
        seen: &mut dyn FnMut(&AreaPlan, &Field, u64),
    ) -> Result<GrownAreas, GrowError> {
        let Self { layer, watch, .. } = *self;
        watch.step(Stage::Plan, 0.5)?;
        let owned = during(Phase::Start, || owned(plan, form, self.seed));
        let first = owned.iter().find(|owner| **owner != TAKEN);
        if first.is_none() {
            return Err(GrowError::NoRoom { layer });
        }
        let depths = during(Phase::Start, || depths_of_kept(plan, form.gap));
        let reaction = during(Phase::Start, || lines_between(&owned, &depths, plan, form.gap));
        let maps = PairMaps {
            grid: plan.grid,
            pairs: vec![pair(plan, form)],
            obstacles: plan.obstacles.clone(),
            raised: held(&depths, plan, form.gap),
        };
        watch.step(Stage::Plan, 1.0)?;
        let start = PairStart::Drawn(reaction);
        let growth = during(Phase::Coefficients, || PairGrowth::new(&maps, &model(), &start));
        let mut growth = growth.expect("maps of one grid");
        let mut levels = vec![level_of_straight_lines(); plan.map.layout().len()];
        let last = growth.steps_in(TIME);
        while growth.steps() < last {
            let between = growth.steps_in(BETWEEN).min(last - growth.steps());
            during(Phase::Steps, || growth.advance(between));
            watch.step(Stage::Grow, growth.steps() as f64 / last as f64)?;
            let now = pattern(&blurred(&growth, plan), plan, &levels, &depths, form.gap);
            seen(plan, &now, growth.steps());
        }
        let blurred = blurred(&growth, plan);
        if blurred.values.iter().any(|value| !value.is_finite()) {
            return Err(GrowError::NoPattern { layer });
        }
        let grown_at = |levels: &[f64]| {
            let field = pattern(&blurred, plan, levels, &depths, form.gap);
            during(Phase::Measure, || measured(plan.clone(), field))
        };
        let mut grown = grown_at(&levels);
        for round in 0..if self.corrects { ROUNDS } else { 0 } {
            watch.step(Stage::Refine, round as f64 / ROUNDS as f64)?;
            move_levels(&mut levels, &blurred, plan, &grown.errors);
            grown = grown_at(&levels);
        }
        if grown.spots.is_empty() {
            return Err(GrowError::Blank { layer, what: "no cells" });
        }
        let gap = stripes(&grown.field, EDGE).map(|found| found.wavelength - found.width);
        let is_kept = |cell: usize| in_kept(&depths, cell, form.gap);
        let own_cells = Some(own_cells(plan, &owned, &grown.field, is_kept));
        Ok(GrownAreas { steps: growth.steps(), gap, own_cells, ..grown })
    }
}

/// The pair that grows the cells.
fn pair(plan: &AreaPlan, form: &CellForm) -> PairField {
    let px = plan.px_a_cell();
    let size = |cell: usize| (form.size(&plan.wanted(plan.grid.center_px(cell))) / px) as f32;
    let size: Vec<f32> = (0..plan.grid.cells()).into_par_iter().map(size).collect();
    PairField { direction: vec![0.0; size.len()], size, blurs: BLURS }
}

/// The blurred reaction, 0..1: what the pattern is made of. Its level lines are smoother than those of the difference, and it rises to
/// the middle of the cells.
fn blurred(growth: &PairGrowth, plan: &AreaPlan) -> Field {
    Field::new(&plan.grid, growth.concentrations().swap_remove(0))
}

/// The pattern of the cells: ½ where `blurred` is at the level of its place, by region; around drawn marks it is that of the law.
fn pattern(blurred: &Field, plan: &AreaPlan, levels: &[f64], depths: &[(f32, u32)], gap: f64) -> Field {
    let layout = *plan.map.layout();
    let value = |(cell, value): (usize, &f32)| {
        let corners = layout.corners(plan.grid.center_px(cell));
        let level = if in_kept(depths, cell, gap) {
            level_of_straight_lines()
        } else {
            corners.iter().map(|(region, weight)| weight * levels[*region]).sum::<f64>()
        };
        share(*value, level as f32)
    };
    let values = blurred.values.par_iter().enumerate().map(value).collect();
    Field { values, ..blurred.clone() }
}

/// Whether a cell of the grid lies in a drawn mark or on the lines round it.
fn in_kept(depths: &[(f32, u32)], cell: usize, gap: f64) -> bool {
    depths.get(cell).is_some_and(|(depth, _)| f64::from(*depth) > -0.5 * gap)
}

/// Moves the levels so that the areas of each region come nearer to what was asked.
fn move_levels(levels: &mut [f64], blurred: &Field, plan: &AreaPlan, errors: &[SpotErrors]) {
    let layout = *plan.map.layout();
    let slope = slope(blurred);
    for (region, level) in levels.iter_mut().enumerate() {
        let wanted = plan.wanted(layout.center(layout.place(region)));
        // The edge has to move by δ where contour · δ is what the area lacks.
        let lacks = -errors[region].area.unwrap_or(0.0) * wanted.area.sqrt() / CONTOUR;
        *level = (*level - lacks * slope).clamp(LEVELS[0], LEVELS[1]);
    }
}

/// Mean slope of `blurred` where edges lie, 1/px.
fn slope(blurred: &Field) -> f64 {
    let (level, [mut sum, mut count]) = (level_of_straight_lines() as f32, [0.0; 2]);
    for (index, value) in blurred.values.iter().enumerate() {
        if (*value - level).abs() > NEAR_EDGE {
            continue;
        }
        let [x, y] = [index % blurred.width, index / blurred.width].map(|k| k as isize);
        let across = (blurred.get(x + 1, y) - blurred.get(x - 1, y)) / (2.0 * blurred.cell[0] as f32);
        let down = (blurred.get(x, y + 1) - blurred.get(x, y - 1)) / (2.0 * blurred.cell[1] as f32);
        sum += f64::from((across * across + down * down).sqrt());
        count += 1.0;
    }
    sum / count.max(1.0)
}
