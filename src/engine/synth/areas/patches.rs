//! The growth of a layer of patches.

use crate::grid::{Domain, Field};
use crate::points::patches::{GrownPatches, Outline, PatchGrowth, Patches};
use crate::points::rosettes::{Rosettes, rosettes};
use crate::synth::areas::grown::GrownAreas;
use crate::synth::areas::measured::{EDGE, measured};
use crate::synth::areas::plan::AreaPlan;
use crate::synth::areas::plan::patches::PatchForm;
use crate::synth::error::LayerError;
use crate::synth::kind::{Advanced, FILM_STAGES};
use crate::synth::profile::{Section, during};
use crate::synth::watch::Stage;

/// A layer of patches that grows.
pub struct PatchesGrowth {
    seed: u64,
    plan: AreaPlan,
    detail: f64,
    rosette: Option<Rosettes>,
    kept: Vec<Outline>,
    /// The cells that no patch may cover; empty = none.
    blocked: Vec<bool>,
    /// Number of moments of a film in which points appear.
    stages: usize,
    growth: Option<PatchGrowth>,
    grown: Option<GrownAreas>,
}

impl PatchesGrowth {
    /// Begins to grow `plan`; where it is `filmed`, its points appear one after the other.
    pub(super) fn begin(plan: AreaPlan, form: &PatchForm, seed: u64, filmed: bool) -> Self {
        let blocked = during(Section::LayOut, || form.blocked(&plan));
        let kept = plan.kept.iter().map(|(_, outline)| outline.clone()).collect();
        let stages = if filmed { FILM_STAGES } else { 1 };
        let growth = Some(PatchGrowth::default());
        let PatchForm { detail, rosette, .. } = *form;
        Self { seed, plan, detail, rosette, kept, blocked, stages, growth, grown: None }
    }

    /// Does a part of the work.
    ///
    /// # Errors
    /// Nothing grew, or nothing but patches.
    pub fn advance(&mut self) -> Result<Advanced, LayerError> {
        let cells = self.plan.grid.cells();
        let Some(mut growth) = self.growth.take() else { return Ok(Advanced::done(0)) };
        let Self { plan, blocked, kept, .. } = &*self;
        let is_blocked = |at: [f64; 2]| {
            let cell = plan.grid.cell_at(plan.grid.to_cells(plan.canvas().inside(at)));
            blocked.get(cell).is_some_and(|taken| *taken)
        };
        let wanted = |at: [f64; 2]| plan.wanted(at);
        let patches = Patches {
            grid: plan.grid,
            wanted: &wanted,
            kept,
            blocked: if blocked.is_empty() { None } else { Some(&is_blocked) },
            detail: self.detail,
            seed: self.seed,
        };
        let done = during(Section::Steps, || growth.advance(&patches, self.stages));
        if !done {
            let seen = growth.appearing().is_some();
            self.growth = Some(growth);
            return Ok(Advanced { updates: cells as u64, seen, done: false });
        }
        let grown = growth.complete().ok_or(LayerError::NoRoom)?;
        self.grown = Some(self.checked(grown)?);
        Ok(Advanced { updates: cells as u64, seen: true, done: true })
    }

    /// The grown patches with their measurements.
    fn checked(&self, grown: GrownPatches) -> Result<GrownAreas, LayerError> {
        if grown.centers.is_empty() && self.kept.is_empty() {
            return Err(LayerError::NoRoom);
        }
        let is_patch = |value: &f32| *value >= EDGE;
        let values = &grown.field.values;
        let what = match (values.iter().any(is_patch), values.iter().all(is_patch)) {
            (false, _) => Some("no patches"),
            (_, true) => Some("patches without any ground between them"),
            _ => None,
        };
        if let Some(what) = what {
            return Err(LayerError::Blank { what, advice: LayerError::MARKS });
        }
        let rosettes =
            self.rosette.map(|of| during(Section::Steps, || rosettes(&grown.field, &of, self.seed)));
        let measured = during(Section::Measure, || measured(self.plan.clone(), grown.field));
        Ok(GrownAreas { cramped: grown.cramped, rosettes, ..measured })
    }

    /// The current stage, and the finished share of it.
    #[must_use]
    pub fn progress(&self) -> (Stage, f64) {
        if self.grown.is_some() { (Stage::Refine, 1.0) } else { (Stage::Grow, 0.0) }
    }

    /// The number of the current field (1 = the first) and the field itself; `None` while there is nothing to show.
    #[must_use]
    pub fn now(&self) -> Option<(u64, &Field)> {
        if let Some(grown) = &self.grown {
            return Some((self.stages as u64, grown.shown()));
        }
        let (stage, field) = self.growth.as_ref()?.appearing()?;
        Some((stage as u64, field))
    }

    /// The grown areas; `None` before the end.
    #[must_use]
    pub fn complete(self) -> Option<GrownAreas> {
        self.grown
    }
}
