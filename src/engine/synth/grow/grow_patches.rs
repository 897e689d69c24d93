//! Plans of patches → grown patches.

use crate::grid::{Domain, Field};
use crate::points::patches::{Outline, Patches};
use crate::synth::grow::areas::GrownAreas;
use crate::synth::grow::layer::GrowError;
use crate::synth::grow::measured_areas::{EDGE, measured};
use crate::synth::grow::snapshot::FILM_STAGES;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::areas::AreaPlan;
use crate::synth::plan::areas::patches::PatchForm;
use crate::synth::watch::{Cancelled, Stage, Watch};

/// Grows layer number `layer` (1 = the lowest) as planned. Where it is `filmed`, `seen` gets the field as the points appear.
pub(super) fn grow_patches(
    plan: AreaPlan,
    form: &PatchForm,
    layer: usize,
    seed: u64,
    watch: &Watch,
    filmed: bool,
    seen: &mut dyn FnMut(&AreaPlan, &Field, u64),
) -> Result<GrownAreas, GrowError> {
    watch.step(Stage::Plan, 1.0)?;
    let blocked = during(Phase::LayOut, || form.blocked(&plan));
    let is_blocked = |at: [f64; 2]| {
        blocked
            .get(plan.grid.cell_at(plan.grid.to_cells(plan.canvas().inside(at))))
            .is_some_and(|taken| *taken)
    };
    let wanted = |at: [f64; 2]| plan.wanted(at);
    let kept: Vec<Outline> = plan.kept.iter().map(|(_, outline)| outline.clone()).collect();
    let patches = Patches {
        grid: plan.grid,
        wanted: &wanted,
        kept: &kept,
        blocked: if blocked.is_empty() { None } else { Some(&is_blocked) },
        detail: form.detail,
        seed,
    };
    watch.step(Stage::Grow, 0.0)?;
    let stages = if filmed { FILM_STAGES } else { 1 };
    let mut stage = 0;
    let mut each = |field: &Field| {
        stage += 1;
        seen(&plan, field, stage);
    };
    let grown = during(Phase::Steps, || patches.grow_seen(watch.cancelled, stages, &mut each));
    let grown = grown.ok_or(Cancelled)?;
    if grown.centers.is_empty() && kept.is_empty() {
        return Err(GrowError::NoRoom { layer });
    }
    let is_patch = |value: &f32| *value >= EDGE;
    let what = match (grown.field.values.iter().any(is_patch), grown.field.values.iter().all(is_patch)) {
        (false, _) => Some("no patches"),
        (_, true) => Some("patches without any ground between them"),
        _ => None,
    };
    if let Some(what) = what {
        return Err(GrowError::Blank { layer, what });
    }
    seen(&plan, &grown.field, stage + 1);
    watch.step(Stage::Refine, 0.0)?;
    Ok(during(Phase::Measure, || GrownAreas { cramped: grown.cramped, ..measured(plan, grown.field) }))
}
