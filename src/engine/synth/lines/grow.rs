//! The growth of streaks and cracks from their plan.
//!
//! The labels of the points are interpolated. A threshold in each region sets the share that is covered; the scale of all discs
//! sets the width, and each change of it needs a new layout of points.

use rayon::prelude::*;

use crate::document::LineKind;
use crate::grid::{Domain, Field};
use crate::measure::{Regions, Target, areas, stripe_errors};
use crate::points::appearance::Appearance;
use crate::points::level::level_of_share;
use crate::points::lines::{LaidLines, Lines};
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, FILM_STAGES, Setting};
use crate::synth::lines::grown::GrownLines;
use crate::synth::lines::grown::LineShare;
use crate::synth::lines::plan::LinePlan;
use crate::synth::pattern::share as pattern_value;
use crate::synth::profile::{Section, during};
use crate::synth::watch::Stage;

/// The threshold of the edge.
const EDGE: f32 = 0.5;
/// Largest number of layouts of points.
pub const LAID: usize = 4;
/// A relative error of the width that needs no other attempt: the random error of the next attempt is larger.
const CLOSE: f64 = 0.004;
/// Factors of the discs' radii.
const SCALES: [f64; 2] = [0.8, 1.6];
/// Rounds of moving thresholds: after them, the shares of forty sketches were right within 0.01 % of the canvas.
const ROUNDS: usize = 6;
/// d share ÷ d threshold, before it is measured: for shares from 0.3 to 0.6 it is −0.6 to −0.8.
const SLOPE: f64 = -0.7;
/// Slopes that follow from two thresholds are limited to this range.
const SLOPES: [f64; 2] = [-3.0, -0.2];
/// Range of thresholds: beyond, lines are dots or the canvas is full.
const LEVELS: [f64; 2] = [0.05, 0.95];

/// A layer of lines that grows.
pub struct LinesGrowth {
    seed: u64,
    /// Whether width and share are corrected.
    corrects: bool,
    /// Whether the lines are shown as they appear, not after each correction.
    filmed: bool,
    plan: LinePlan,
    /// Cells that no line may cover; empty = none.
    blocked: Vec<bool>,
    /// The factor of the discs' radii that is tried next.
    scale: f64,
    tries: usize,
    best: Option<Try>,
    state: State,
}

/// The next part of the work.
enum State {
    /// Points are laid.
    Lay,
    /// Lines are made from the points. Holds the result of the last attempt.
    Try(Option<Field>),
    /// The best lines appear. Holds the next stage.
    Appear(Appearance, usize, Option<Field>),
    /// All is done.
    Grown,
}

/// One attempt at lines.
struct Try {
    /// Relative error of the width, without its sign.
    off: f64,
    labels: LaidLines,
    /// The threshold of each region.
    levels: Vec<f64>,
    grown: GrownLines,
}

impl LinesGrowth {
    /// Begins to grow `plan`.
    ///
    /// # Errors
    /// There is no room.
    pub fn begin(plan: LinePlan, setting: &Setting) -> Result<Self, LayerError> {
        let Setting { seed, corrects, filmed, .. } = *setting;
        let blocked = during(Section::LayOut, || plan.blocked());
        if !blocked.is_empty() && blocked.iter().all(|taken| *taken) {
            return Err(LayerError::NoRoom);
        }
        let state = State::Lay;
        Ok(Self { seed, corrects, filmed, plan, blocked, scale: 1.0, tries: 0, best: None, state })
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Nothing grew, or nothing but lines.
    pub fn advance(&mut self) -> Result<Advanced, LayerError> {
        let cells = self.plan.grid.cells();
        match std::mem::replace(&mut self.state, State::Grown) {
            State::Lay | State::Try(_) => {
                let again = self.try_lines();
                let now = self.best.as_ref().filter(|_| !self.filmed).map(|best| best.grown.field.clone());
                self.state = match (again, self.filmed, &self.best) {
                    (true, ..) => State::Try(now),
                    (false, true, Some(best)) => State::Appear(best.labels.appearance(), 1, None),
                    _ => State::Grown,
                };
                let done = matches!(self.state, State::Grown);
                if done {
                    self.check()?;
                }
                Ok(Advanced { updates: cells as u64, seen: !self.filmed, done })
            }
            State::Appear(appearance, stage, _) if stage < FILM_STAGES => {
                let Some(Try { labels, levels, .. }) = &self.best else { return Ok(Advanced::done(0)) };
                let share = stage as f64 / FILM_STAGES as f64;
                let labels = labels.appearing(&appearance, share, &self.plan.grid);
                let now = pattern(&labels, &self.plan, levels);
                self.state = State::Appear(appearance, stage + 1, Some(now));
                Ok(Advanced::seen(cells as u64))
            }
            State::Appear(..) => {
                self.check()?;
                Ok(Advanced { updates: 1, seen: true, done: true })
            }
            State::Grown => Ok(Advanced::done(0)),
        }
    }

    /// Lays points and makes lines of them. Returns whether another attempt may come closer to the wanted width.
    fn try_lines(&mut self) -> bool {
        let plan = &self.plan;
        let labels = during(Section::Steps, || self.laid(plan, &self.blocked, self.scale));
        let field = during(Section::Steps, || labels.field(&plan.grid));
        let (grown, levels) = during(Section::Measure, || self.levelled(plan, &field));
        let off = width_error(&grown);
        let tried = Try { off: off.map_or(f64::INFINITY, f64::abs), labels, levels, grown };
        if self.best.as_ref().is_none_or(|best| tried.off < best.off) {
            self.best = Some(tried);
        }
        self.tries += 1;
        match off {
            Some(off) if off.abs() >= CLOSE => {
                self.scale = (self.scale / (1.0 + off)).clamp(SCALES[0], SCALES[1]);
                self.tries < if self.corrects { LAID } else { 1 }
            }
            _ => false,
        }
    }

    /// Whether lines and ground have grown.
    fn check(&self) -> Result<(), LayerError> {
        let grown = &self.best.as_ref().ok_or(LayerError::NoRoom)?.grown;
        let is_line = |value: &f32| *value >= EDGE;
        let values = &grown.field.values;
        let what = match (values.iter().any(is_line), values.iter().all(is_line)) {
            (false, _) => "no lines",
            (_, true) => "lines without any ground between them",
            _ => return Ok(()),
        };
        Err(LayerError::Blank { what, advice: LayerError::MARKS })
    }

    /// The current stage, and the finished share of it.
    pub fn progress(&self) -> (Stage, f64) {
        match &self.state {
            State::Lay | State::Try(_) => (Stage::Grow, self.tries as f64 / LAID as f64),
            State::Appear(..) | State::Grown => (Stage::Refine, 0.0),
        }
    }

    /// The current pattern; `None` while there is nothing to show.
    pub fn now(&self) -> Option<&Field> {
        match &self.state {
            State::Lay => None,
            State::Try(now) | State::Appear(_, _, now) => now.as_ref(),
            State::Grown => self.best.as_ref().map(|best| &best.grown.field),
        }
    }

    /// The grown lines; `None` before the end.
    pub fn complete(self) -> Option<GrownLines> {
        self.best.map(|best| best.grown)
    }

    /// The points laid at this scale, with their labels.
    fn laid(&self, plan: &LinePlan, blocked: &[bool], scale: f64) -> LaidLines {
        let is_blocked = |at: [f64; 2]| {
            let cell = plan.grid.cell_at(plan.grid.to_cells(plan.canvas().inside(at)));
            blocked.get(cell).is_some_and(|taken| *taken)
        };
        let lines = Lines {
            grid: plan.grid,
            wanted: &|at| plan.wanted(at),
            blocked: if blocked.is_empty() { None } else { Some(&is_blocked) },
            course: plan.course(),
            scale,
            seed: self.seed,
        };
        lines.laid()
    }

    /// Turns the labels into a pattern with the wanted shares, and measures it; also returns the threshold of each region.
    fn levelled(&self, plan: &LinePlan, labels: &Field) -> (GrownLines, Vec<f64>) {
        let layout = *plan.map.layout();
        let region_of = |at: [f64; 2]| layout.index(layout.region_of(at));
        // For each region the free area, and the part of it that lines are to cover, px².
        let cell = plan.grid.cell[0] * plan.grid.cell[1];
        let mut free = vec![[0.0; 2]; layout.len()];
        for index in
            (0..plan.grid.cells()).filter(|cell| !plan.obstacles.get(*cell).is_some_and(|taken| *taken))
        {
            let at = plan.grid.center_px(index);
            let [area, wanted] = &mut free[region_of(at)];
            *area += cell;
            *wanted += cell * plan.wanted(at).share;
        }
        let canvas: f64 = plan.canvas().size.iter().product();
        let whole = free.iter().map(|[_, wanted]| wanted).sum::<f64>() / canvas;
        let mut levels = vec![f64::from(level_of_share(labels, whole)); layout.len()];
        let mut field = pattern(labels, plan, &levels);
        let mut got = areas(&field, EDGE, Regions::Grid(&layout));
        let mut slopes = vec![SLOPE; layout.len()];
        for _ in 0..if self.corrects { ROUNDS } else { 0 } {
            let before = (levels.clone(), got.clone());
            for region in (0..layout.len()).filter(|region| free[*region][0] > 0.0) {
                let [area, wanted] = free[region];
                let step = (wanted - got[region]) / area / slopes[region];
                levels[region] = (levels[region] + step).clamp(LEVELS[0], LEVELS[1]);
            }
            field = pattern(labels, plan, &levels);
            got = areas(&field, EDGE, Regions::Grid(&layout));
            for region in 0..layout.len() {
                let moved = levels[region] - before.0[region];
                if moved.abs() > 1e-4 {
                    let slope = (got[region] - before.1[region]) / free[region][0] / moved;
                    slopes[region] = slope.clamp(SLOPES[0], SLOPES[1]);
                }
            }
        }
        let errors = stripe_errors(
            &field,
            EDGE,
            &Target {
                bounds: plan.canvas(),
                regions: Regions::Grid(&layout),
                covered: &|at| plan.is_taken(at),
                wanted: &|at| plan.asked(at),
                surface: None,
            },
        );
        let share = |([area, wanted], got): (&[f64; 2], &f64)| {
            let area = area.max(cell);
            LineShare { asked: wanted / area, got: got / area }
        };
        let shares = free.iter().zip(&got).map(share).collect();
        (GrownLines { plan: plan.clone(), field, errors, shares }, levels)
    }
}

/// got ÷ wanted − 1 of the width, its mean over the regions; `None` without lines.
fn width_error(grown: &GrownLines) -> Option<f64> {
    let errors: Vec<f64> = grown.errors.iter().filter_map(|errors| errors.width).collect();
    (!errors.is_empty()).then(|| errors.iter().sum::<f64>() / errors.len() as f64)
}

/// The pattern of `labels`: ½ where they equal the threshold of their place, which depends on the region and, for streaks, on the
/// wanted share there.
fn pattern(labels: &Field, plan: &LinePlan, levels: &[f64]) -> Field {
    let layout = *plan.map.layout();
    let mean = plan.mean_share();
    let value = |(cell, value): (usize, &f32)| {
        let at = plan.grid.center_px(cell);
        let corners = layout.corners(at);
        let level: f64 = corners.iter().map(|(region, weight)| weight * levels[*region]).sum();
        // The meshes of cracks have the wanted density; streaks have one density everywhere.
        let shift = if plan.kind == LineKind::Streaks { (plan.wanted(at).share - mean) / SLOPE } else { 0.0 };
        pattern_value(*value, (level + shift).clamp(LEVELS[0], LEVELS[1]) as f32)
    };
    let values = labels.values.par_iter().enumerate().map(value).collect();
    Field { values, ..labels.clone() }
}
