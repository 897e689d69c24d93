//! The growth of fields of points from their plan.

use rayon::prelude::*;

use crate::grid::{Domain, Field};
use crate::points::fields::{FieldGrowth, PointField};
use crate::points::level::{level_of_share_beside, relevel_smoothly};
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, FILM_STAGES, Setting};
use crate::synth::pattern::AreaPattern;
use crate::synth::points::advice::advice;
use crate::synth::points::grown::GrownPoints;
use crate::synth::points::plan::FieldPlan;
use crate::synth::profile::{Section, during};
use crate::synth::watch::Stage;

/// The threshold of the edge.
const EDGE: f32 = 0.5;
/// Range of values below which a field counts as flat.
const FLAT: f32 = 1e-4;

/// Rounds of setting the threshold: each removes the error of the share that is shown.
const ROUNDS: usize = 4;
/// An error of the share below this needs no other round.
const CLOSE: f64 = 2e-4;
/// A grid of fewer cells is sampled between them, too.
const FEW: usize = 300_000;
/// Rows that are tested together.
const ROWS: usize = 32;

/// A layer of a field of points that grows.
pub struct PointsGrowth {
    seed: u64,
    plan: FieldPlan,
    /// Cells in which no point may be dark; empty = none.
    blocked: Vec<bool>,
    /// Number of moments of a film in which the points of an octave appear.
    stages: usize,
    growth: Option<FieldGrowth>,
    /// The number of the current field (1 = the first) and the field itself.
    now: (u64, Option<Field>),
    grown: Option<GrownPoints>,
}

impl PointsGrowth {
    /// Begins to grow `plan`.
    ///
    /// # Errors
    /// There is no room.
    pub fn begin(plan: FieldPlan, setting: &Setting) -> Result<Self, LayerError> {
        let Setting { seed, filmed, .. } = *setting;
        if !plan.obstacles.is_empty() && plan.obstacles.iter().all(|taken| *taken) {
            return Err(LayerError::NoRoom);
        }
        let blocked = during(Section::LayOut, || plan.blocked());
        let stages = if filmed { FILM_STAGES } else { 1 };
        Ok(Self { seed, plan, blocked, stages, growth: None, now: (0, None), grown: None })
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// All points have the same value.
    pub fn advance(&mut self) -> Result<Advanced, LayerError> {
        if self.grown.is_some() {
            return Ok(Advanced::done(0));
        }
        let cells = self.plan.grid.cells();
        let before = self.growth.take();
        let Self { plan, blocked, seed, stages, .. } = &*self;
        let is_blocked = |at: [f64; 2]| {
            let cell = plan.grid.cell_at(plan.grid.to_cells(plan.canvas().inside(at)));
            blocked.get(cell).is_some_and(|taken| *taken)
        };
        let distance = |at: [f64; 2]| plan.distance(at);
        let dark = |at: [f64; 2]| plan.dark(at);
        let points = PointField {
            grid: plan.grid,
            distance: &distance,
            distances: plan.distances,
            labelling: plan.labelling(&dark),
            nearest: plan.is_sharp(),
            axis: plan.points.axis,
            strength: plan.points.shift,
            shift: plan.shift(),
            octaves: plan.points.octaves,
            fold: plan.points.fold,
            blocked: if blocked.is_empty() { None } else { Some(&is_blocked) },
            seed: *seed,
        };
        let mut growth = before.unwrap_or_else(|| FieldGrowth::new(&points));
        if !during(Section::Steps, || growth.advance(&points, *stages)) {
            let field = growth.appearing(&points);
            let seen = field.is_some();
            self.now = (self.now.0 + u64::from(seen), field);
            self.growth = Some(growth);
            return Ok(Advanced { updates: cells as u64, seen, done: false });
        }
        let (field, count) = growth.complete(&points);
        self.grown = Some(self.levelled(field, count)?);
        self.now = (self.now.0 + 1, None);
        Ok(Advanced { updates: cells as u64, seen: true, done: true })
    }

    /// The field, with its threshold moved to the wanted share.
    fn levelled(&self, mut field: Field, points: usize) -> Result<GrownPoints, LayerError> {
        let plan = self.plan.clone();
        let [low, high] =
            field.values.iter().fold([1.0f32, 0.0], |[low, high], value| [low.min(*value), high.max(*value)]);
        if high - low < FLAT {
            return Err(LayerError::Flat { advice: advice(&plan.points.labels) });
        }
        let share = during(Section::Measure, || match plan.share {
            Some(wanted) => levelled(&mut field, wanted, &plan.obstacles),
            None => shown(&field, &plan.obstacles),
        });
        Ok(GrownPoints { plan, field, points, share })
    }

    /// The current stage, and the finished share of it.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match (&self.grown, &self.growth) {
            (Some(_), _) => (Stage::Refine, 0.0),
            (None, growth) => (Stage::Grow, growth.as_ref().map_or(0.0, FieldGrowth::progress)),
        }
    }

    /// The number of the current field (1 = the first) and the field itself; `None` while there is nothing to show.
    #[must_use]
    pub fn now(&self) -> Option<(u64, &Field)> {
        let grown = self.grown.as_ref().map(|grown| &grown.field);
        Some((self.now.0, grown.or(self.now.1.as_ref())?))
    }

    /// The grown points; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownPoints> {
        self.grown
    }
}

/// Moves the threshold of a field until its pattern outside the `taken` cells has the `wanted` share. Returns the share.
fn levelled(field: &mut Field, wanted: f64, taken: &[bool]) -> f64 {
    let mut asked = wanted;
    let mut best: Option<(f64, Field)> = None;
    for _ in 0..ROUNDS {
        let mut with = field.clone();
        relevel_smoothly(&mut with, level_of_share_beside(field, asked.clamp(0.0, 1.0), taken));
        let got = shown(&with, taken);
        if best.as_ref().is_none_or(|(before, _)| (got - wanted).abs() < (before - wanted).abs()) {
            best = Some((got, with));
        }
        if (got - wanted).abs() < CLOSE {
            break;
        }
        asked += wanted - got;
    }
    let Some((share, with)) = best else { return 0.0 };
    *field = with;
    share
}

/// The share of the pattern of a field that is above the edge, outside the `taken` cells. It is sampled between cells, too, by the
/// spline through them, as it is shown.
fn shown(field: &Field, taken: &[bool]) -> f64 {
    let times = if field.values.len() < FEW { 2 } else { 1 };
    let [width, height] = [times * field.width, times * field.height];
    let pattern = AreaPattern::new(field);
    let count = |band: usize| {
        let rows = band * ROWS..height.min((band + 1) * ROWS);
        let values = pattern.rows(rows.clone(), width, height);
        values.iter().enumerate().fold([0, 0], |[above, free], (index, value)| {
            let (x, y) = (index % width / times, (rows.start + index / width) / times);
            let is_free = !taken.get(y * field.width + x).is_some_and(|taken| *taken);
            [above + usize::from(is_free && *value >= EDGE), free + usize::from(is_free)]
        })
    };
    let bands = (0..height.div_ceil(ROWS)).into_par_iter().map(count);
    let [above, free] = bands.reduce(|| [0, 0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    above as f64 / free.max(1) as f64
}
