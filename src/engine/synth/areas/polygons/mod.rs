//! The growth of cells from their plan.
//!
//! Points are laid at the distance of the cells, and each owns the places nearest to it. Drawn marks own the places in their
//! outlines instead. The reaction begins as 0 on lines of the wanted width between the owned places. One pair grows from there:
//! corners round off, and lines become evenly wide. Finally the threshold is moved, region by region, until the areas are right.

mod lines;
mod own_polygons;
mod owned;

use rayon::prelude::*;

use crate::grid::{Domain, Field};
use crate::measure::{SpotErrors, stripes};
use crate::rd::pairs::polygons::{BLURS, SMOOTHING, TIME, model};
use crate::rd::pairs::{PairField, PairGrowth, PairParameterField, PairStart};
use crate::synth::areas::grown::GrownAreas;
use crate::synth::areas::measured::{EDGE, measured};
use crate::synth::areas::plan::AreaPlan;
use crate::synth::areas::plan::polygons::PolygonForm;
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, Seen};
use crate::synth::pattern::AreaPattern;
use crate::synth::pattern::share;
use crate::synth::profile::{Section, during};
use crate::synth::watch::Stage;
use lines::{depths_of_kept, held, lines_between};
use own_polygons::own_polygons;
use owned::{TAKEN, owned};

/// Time between two pictures of the growth, in 1/b. There are ten of them, each of which costs the time of a pattern.
const BETWEEN: f64 = 1.0;
/// Rounds of moving the threshold.
const ROUNDS: usize = 3;
/// Contour ÷ √area of a cell: a hexagon has 3.72.
const CONTOUR: f64 = 3.72;
/// The thresholds between which edges are read: beyond, cells merge or vanish.
const LEVELS: [f64; 2] = [0.25, 0.85];
/// Values this near to the threshold are those of edges.
const NEAR_EDGE: f32 = 0.12;
/// The gap between cells far apart, in sizes of the pair, see [`crate::rd::pairs::polygons`].
const STRAIGHT: f64 = 3.5;

/// The threshold of C₊ at the edges of straight lines: the blur of a line of width w is ½ + ½ e^(−w/s) there.
fn level_of_straight_lines() -> f64 {
    0.5 + 0.5 * libm::exp(-STRAIGHT)
}

/// A layer of cells that grows.
pub struct PolygonGrowth {
    setting: PolygonSetting,
    plan: AreaPlan,
    form: PolygonForm,
    /// The owner of each place.
    owned: Vec<u32>,
    /// By place, the depth inside a drawn mark and the index of this mark.
    depths: Vec<(f32, u32)>,
    /// Increase of the threshold by cell of the grid; empty = none.
    raised: Vec<f32>,
    growth: PairGrowth,
    /// The step from which on edges are smoothed.
    smooth: u64,
    /// The step at which the growth ends.
    last: u64,
    /// The thresholds of the edges, by region.
    levels: Vec<f64>,
    /// The grown cells, with their blurred reaction and the number of rounds in which their thresholds were moved.
    grown: Option<(GrownAreas, Field, usize)>,
    done: bool,
}

/// Settings for the growth of a layer of cells.
#[derive(Clone, Copy)]
pub(super) struct PolygonSetting {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Whether the threshold is moved.
    pub corrects: bool,
}

impl PolygonGrowth {
    /// Lays the cells of `plan`, and begins to grow them.
    ///
    /// # Errors
    /// There is no room.
    pub(super) fn begin(
        plan: AreaPlan,
        form: PolygonForm,
        setting: PolygonSetting,
    ) -> Result<Self, LayerError> {
        let owned = during(Section::Start, || owned(&plan, &form, setting.seed));
        if owned.owners.iter().all(|owner| *owner == TAKEN) {
            return Err(LayerError::NoRoom);
        }
        let depths = during(Section::Start, || depths_of_kept(&plan, form.gap));
        let reaction = during(Section::Start, || lines_between(&owned, &depths, &plan, form.gap));
        let maps = PairParameterField {
            grid: plan.grid,
            pairs: vec![pair(&plan, &form)],
            obstacles: plan.obstacles.clone(),
            raised: held(&depths, &plan, form.gap),
        };
        let start = PairStart::Drawn(reaction);
        let growth = during(Section::Coefficients, || PairGrowth::new(&maps, &model(), &start));
        let growth = growth.expect("maps of one grid");
        let levels = vec![level_of_straight_lines(); plan.map.layout().len()];
        let [smooth, last] = [TIME, TIME + SMOOTHING].map(|time| growth.steps_in(time));
        let grown = None;
        Ok(Self {
            setting,
            plan,
            form,
            owned: owned.owners,
            depths,
            raised: maps.raised,
            growth,
            smooth,
            last,
            levels,
            grown,
            done: false,
        })
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Nothing grew.
    pub fn advance(&mut self, budget: u64) -> Result<Advanced, LayerError> {
        let cells = self.plan.grid.cells();
        let before = self.growth.steps();
        if before < self.last {
            if before < self.smooth {
                let steps = (budget / cells as u64).clamp(1, self.smooth - before);
                during(Section::Steps, || self.growth.advance(steps));
            } else {
                let taken = during(Section::Steps, || self.growth.advance_by_shares(&model(), &self.raised));
                taken.expect("maps of one grid");
            }
            return Ok(Advanced::seen((self.growth.steps() - before) * cells as u64));
        }
        match self.grown.take() {
            None => {
                let blurred = blurred(&self.growth, &self.plan);
                if blurred.values.iter().any(|value| !value.is_finite()) {
                    return Err(LayerError::NoPattern);
                }
                self.grown = Some((self.measured(&blurred), blurred, 0));
            }
            Some((grown, blurred, round)) if self.setting.corrects && round < ROUNDS => {
                move_levels(&mut self.levels, &blurred, &self.plan, &grown.errors);
                self.grown = Some((self.measured(&blurred), blurred, round + 1));
            }
            Some((grown, ..)) if grown.spots.is_empty() => {
                return Err(LayerError::Blank { what: "no cells", advice: LayerError::MARKS });
            }
            Some(grown) => {
                self.grown = Some(grown);
                self.done = true;
                return Ok(Advanced::done(cells));
            }
        }
        Ok(Advanced::by(cells))
    }

    /// The grown cells with the current thresholds, measured.
    fn measured(&self, blurred: &Field) -> GrownAreas {
        let field = pattern(blurred, &self.plan, &self.levels, &self.depths, self.form.gap);
        during(Section::Measure, || measured(self.plan.clone(), field))
    }

    /// The current stage, and the finished share of it.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.grown {
            None => (Stage::Grow, (self.growth.steps() as f64 / self.last as f64).min(1.0)),
            Some((_, _, round)) => (Stage::Refine, *round as f64 / ROUNDS as f64),
        }
    }

    /// Cell updates between two pictures; a pattern is made for each.
    #[must_use]
    pub fn updates_between(&self) -> u64 {
        self.growth.steps_in(BETWEEN) * self.plan.grid.cells() as u64
    }

    /// The cells as they are now; `None` while they do not grow.
    #[must_use]
    pub fn seen(&self) -> Option<Seen<'_>> {
        let steps = self.growth.steps();
        if steps == 0 || self.grown.is_some() {
            return None;
        }
        let now = || {
            let blurred = blurred(&self.growth, &self.plan);
            pattern(&blurred, &self.plan, &self.levels, &self.depths, self.form.gap)
        };
        Some(Seen {
            steps,
            grid: self.plan.grid.size,
            canvas: self.plan.grid.bounds_px().size,
            pattern: Box::new(move || Box::new(AreaPattern::new(&now()))),
        })
    }

    /// The grown areas; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownAreas> {
        let (grown, ..) = self.grown.filter(|_| self.done)?;
        let gap = stripes(&grown.field, EDGE).map(|found| found.wavelength - found.width);
        let is_kept = |cell: usize| in_kept(&self.depths, cell, self.form.gap);
        let own_polygons = Some(own_polygons(&self.plan, &self.owned, &grown.field, is_kept));
        Some(GrownAreas { steps: self.growth.steps(), gap, own_polygons, ..grown })
    }
}

/// The pair that grows the cells.
fn pair(plan: &AreaPlan, form: &PolygonForm) -> PairField {
    let px = plan.px_a_cell();
    let size = |cell: usize| (form.size(&plan.wanted(plan.grid.center_px(cell))) / px) as f32;
    let size: Vec<f32> = (0..plan.grid.cells()).into_par_iter().map(size).collect();
    PairField { direction: vec![0.0; size.len()], size, blurs: BLURS }
}

/// The blurred reaction, 0..1, from which the pattern is made. Its level lines are smoother than those of the difference, and it
/// rises up to the middle of the cells.
fn blurred(growth: &PairGrowth, plan: &AreaPlan) -> Field {
    Field::new(&plan.grid, growth.concentrations().swap_remove(0))
}

/// The pattern of the cells: ½ where `blurred` equals the threshold of its place, by region; around drawn marks the threshold is
/// that of the law.
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

/// Whether a cell of the grid lies in a drawn mark or on the lines around it.
fn in_kept(depths: &[(f32, u32)], cell: usize, gap: f64) -> bool {
    depths.get(cell).is_some_and(|(depth, _)| f64::from(*depth) > -0.5 * gap)
}

/// Moves the thresholds so that the areas of each region come closer to those asked for.
fn move_levels(levels: &mut [f64], blurred: &Field, plan: &AreaPlan, errors: &[SpotErrors]) {
    let layout = *plan.map.layout();
    let slope = slope(blurred);
    for (region, level) in levels.iter_mut().enumerate() {
        let wanted = plan.wanted(layout.center(layout.place(region)));
        // The edge has to move by δ, where contour · δ is the missing area.
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
