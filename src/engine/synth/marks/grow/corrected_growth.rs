//! A layer of spots or stripes as it is laid out: grown, measured and corrected, again and again while that is worth it.
//!
//! ```text
//!  grow ─▶ refine ─▶ separate ─▶ judge ─▶ the best so far
//!   ▲                   merged spots │
//!   └─ spots begin again, corrected ─┘
//! ```

use crate::grid::Field;
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, Setting};
use crate::synth::marks::GrownMarks;
use crate::synth::marks::grow::engine::Engine;
use crate::synth::marks::grow::half_grown::HalfGrown;
use crate::synth::marks::grow::local_separation::{Separation, remeasured};
use crate::synth::marks::grow::merged_spots::MergedSpots;
use crate::synth::marks::grow::pattern::{Levels, Pattern};
use crate::synth::marks::grow::pinned_correction::{PinnedCorrection, Rounds};
use crate::synth::marks::grow::refine::{Measured, Refinement};
use crate::synth::marks::plan::Plan;
use crate::synth::pattern::EDGE;
use crate::synth::phases::{Phase, during};
use crate::synth::watch::Stage;

/// Rows that are looked at together.
const SEEN_AT_ONCE: usize = 64;

/// A layer that is grown and corrected.
pub struct CorrectedGrowth {
    /// How it is grown; corrections of drawn spots are written into it.
    pub plan: Plan,
    /// The pattern that grows.
    pub engine: Engine,
    rounds: Rounds,
    best: Option<(f64, GrownMarks)>,
    /// Of the last round: what has grown on hardly needs other levels.
    levels: Option<Vec<f64>>,
    settled: bool,
    step: Step,
}

/// What is done next.
enum Step {
    /// The pattern grows.
    Grow,
    /// Its levels are corrected.
    Refine(Box<Grown>, Box<Refinement>),
    /// Merged spots are looked for.
    Separate(Box<Grown>, Measured),
    /// Parts of it grow on, in which spots had merged.
    GrowParts(Box<Grown>, Measured, Separation),
    /// It is compared with the best so far.
    Judge(Box<Grown>, Measured, MergedSpots),
}

/// A pattern that has settled.
struct Grown {
    marks: Field,
    levels: Levels,
}

impl CorrectedGrowth {
    /// The growth of `plan`.
    ///
    /// # Errors
    /// There is no room for any mark.
    pub fn new(plan: Plan, setting: &Setting) -> Result<Self, LayerError> {
        let engine = during(Phase::LayOut, || Engine::new(&plan, setting.seed));
        if !engine.can_start() {
            return Err(LayerError::NoRoom);
        }
        let rounds = Rounds::default();
        Ok(Self { plan, engine, rounds, best: None, levels: None, settled: false, step: Step::Grow })
    }

    /// Whether the pattern grows, and is not being measured.
    #[must_use]
    pub fn grows(&self) -> bool {
        matches!(self.step, Step::Grow) && self.engine.updates() > 0
    }

    /// Cell updates of `time` of normalised time; the least part of the work while the pattern is measured.
    #[must_use]
    pub fn updates_in(&self, time: f64) -> u64 {
        if matches!(self.step, Step::Grow) { self.engine.updates_in(time) } else { 1 }
    }

    /// What is being done, and the share of it that is done.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        match &self.step {
            Step::Grow | Step::GrowParts(..) => (Stage::Grow, self.engine.progress()),
            Step::Refine(_, refinement) => (Stage::Refine, refinement.progress()),
            Step::Separate(..) | Step::Judge(..) => (Stage::Refine, 1.0),
        }
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Nothing grew, or nothing but marks.
    pub fn advance(&mut self, budget: u64, setting: &Setting) -> Result<Advanced, LayerError> {
        let cells = self.engine.cells();
        match std::mem::replace(&mut self.step, Step::Grow) {
            Step::Grow => {
                let before = self.engine.updates();
                if self.engine.advance(budget) {
                    return Ok(Advanced::seen(self.engine.updates() - before));
                }
                self.settled = self.engine.settled();
                self.step = self.measured_first(setting)?;
                // The budget ends with it, so that what grows on afterwards has a whole one: films show the same moments.
                let updates = self.engine.updates() - before + cells as u64;
                Ok(Advanced { updates: updates.max(budget), ..Advanced::default() })
            }
            Step::Refine(mut grown, mut refinement) => {
                let px = refinement.px();
                let mut pattern = Pattern::of_levels(&self.plan.lookup, grown.levels);
                let measured = during(Phase::Measure, || refinement.advance(&self.plan, &mut pattern));
                grown.levels = pattern.into_levels();
                self.step = match measured {
                    None => Step::Refine(grown, refinement),
                    Some(measured) => Step::Separate(grown, measured),
                };
                Ok(Advanced::by(px))
            }
            Step::Separate(grown, measured) => {
                self.step = self.separated(grown, measured, setting);
                Ok(Advanced::by(cells))
            }
            Step::GrowParts(mut grown, measured, mut separation) => {
                if let Some(updates) = separation.advance() {
                    self.step = Step::GrowParts(grown, measured, separation);
                    return Ok(Advanced::by(updates as usize));
                }
                let measured = self.taken_back(&mut grown, measured, separation);
                self.step = Step::Separate(grown, measured);
                Ok(Advanced::by(cells))
            }
            Step::Judge(grown, measured, merged) => {
                let goes_on = self.judge(*grown, measured, &merged, setting)?;
                Ok(if goes_on { Advanced::by(cells) } else { Advanced::done(cells) })
            }
        }
    }

    /// The pattern that has settled, measured once.
    fn measured_first(&mut self, setting: &Setting) -> Result<Step, LayerError> {
        let marks = self.plan.levelled(self.engine.marks());
        if !marks.values.iter().all(|value| value.is_finite()) {
            return Err(LayerError::NoPattern);
        }
        let canvas = self.plan.lookup.map.layout().size.map(|side| side as usize);
        let mut pattern = Pattern::new(&self.plan.lookup, &marks);
        pattern.correction = self.levels.take().unwrap_or(pattern.correction);
        let refinement =
            during(Phase::Measure, || Refinement::new(&self.plan, &pattern, canvas, setting.corrects));
        let levels = pattern.into_levels();
        Ok(Step::Refine(Box::new(Grown { marks, levels }), Box::new(refinement)))
    }

    /// Separates spots that have grown together, where they are few.
    fn separated(&mut self, grown: Box<Grown>, measured: Measured, setting: &Setting) -> Step {
        let merged = during(Phase::Measure, || self.engine.merged(&self.plan, measured.spots()));
        let parts = if setting.corrects { self.engine.parts_about(&merged) } else { None };
        match parts.filter(|_| self.rounds.separate(&merged)) {
            None => Step::Judge(grown, measured, merged),
            Some(parts) => {
                let separation = self.engine.begin_separation(parts, &self.plan, &merged);
                Step::GrowParts(grown, measured, separation)
            }
        }
    }

    /// Takes parts that have grown on back into the pattern, and measures their spots.
    fn taken_back(&mut self, grown: &mut Box<Grown>, measured: Measured, separation: Separation) -> Measured {
        let parts = self.engine.end_separation(separation);
        let Grown { marks, levels } = &mut **grown;
        let pattern = Pattern::of_levels(&self.plan.lookup, levels.clone());
        during(Phase::Measure, || remeasured(&self.plan, &pattern, &parts, &self.engine, marks, measured))
    }

    /// Keeps what has grown if it is the best, and corrects it if that is worth it. Returns whether it then grows on.
    fn judge(
        &mut self,
        grown: Grown,
        measured: Measured,
        merged: &MergedSpots,
        setting: &Setting,
    ) -> Result<bool, LayerError> {
        let Grown { marks, levels } = grown;
        let pattern = Pattern::of_levels(&self.plan.lookup, levels);
        let nothing = during(Phase::Measure, || blank(&self.plan, &pattern));
        let half = during(Phase::Measure, || HalfGrown::new(&self.plan, &pattern, &measured));
        let Levels { correction, own: own_levels, .. } = pattern.into_levels();
        self.levels = Some(correction.clone());
        let found = during(Phase::Measure, || PinnedCorrection::new(&self.plan, measured.spots()));
        let error = match nothing {
            Some(_) => f64::INFINITY,
            None => error_of(&self.plan, &measured, &found, merged, &half),
        };
        if self.best.as_ref().is_none_or(|(least, _)| error < *least) {
            let concentrations =
                if setting.concentrations { self.engine.concentrations() } else { Vec::new() };
            let grown = GrownMarks {
                plan: self.plan.clone(),
                steps: self.engine.steps(),
                settled: self.settled,
                correction,
                own_levels,
                measured,
                half_grown: half.places(),
                marks,
                concentrations,
                ragged: None,
                crossed: None,
            };
            self.best = Some((error, grown));
        }
        if setting.corrects && self.engine.grow_on_corrected(&mut self.plan, &mut self.rounds, &found, merged)
        {
            return Ok(true);
        }
        if setting.corrects && self.rounds.mend(half.len()) && self.engine.grow_on_mended(&self.plan, &half) {
            return Ok(true);
        }
        match (&self.best, nothing) {
            (Some((error, _)), _) if error.is_finite() => Ok(false),
            (_, what) => {
                Err(LayerError::Blank { what: what.unwrap_or("no marks"), advice: LayerError::MARKS })
            }
        }
    }

    /// The best that has grown.
    #[must_use]
    pub fn complete(self) -> Option<GrownMarks> {
        let steps = self.engine.steps();
        self.best.map(|(_, grown)| GrownMarks { steps, ..grown })
    }
}

/// How far what is `measured` is from what was drawn. A mark that is missing is worse than one that differs as much as one can: it
/// counts twice. A lost one is in the error once already. One that has grown by half counts half.
fn error_of(
    plan: &Plan,
    measured: &Measured,
    found: &PinnedCorrection,
    merged: &MergedSpots,
    half: &HalfGrown,
) -> f64 {
    let told = measured.merged_spots(plan).count();
    let merged = told.max(merged.surplus.len() + merged.crowded.len());
    let missing = found.lost.len() + 2 * (plan.left_out().len() + merged);
    found.error + missing as f64 + 0.5 * half.len() as f64
}

/// What a layer is instead of a pattern where it has no marks, or nothing but marks; `None` of a pattern.
fn blank(plan: &Plan, pattern: &Pattern) -> Option<&'static str> {
    let [nx, ny] = plan.lookup.grid.size;
    let (mut marks, mut ground) = (false, false);
    for first in (0..ny).step_by(SEEN_AT_ONCE) {
        let rows = first..ny.min(first + SEEN_AT_ONCE);
        for (cell, value) in (first * nx..).zip(pattern.rows(rows, nx, ny)) {
            let free = !plan.obstacles.get(cell).is_some_and(|taken| *taken);
            marks |= free && value >= EDGE;
            ground |= free && value < EDGE;
        }
        // In most patterns after the first rows.
        if marks && ground {
            return None;
        }
    }
    match (marks, ground) {
        (false, _) => Some("no marks"),
        (true, false) if plan.obstacles.is_empty() => Some("marks without any ground between them"),
        _ => None,
    }
}
