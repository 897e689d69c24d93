//! Plans of patches → grown patches.

use crate::attributes::Attributes;
use crate::grid::{Domain, Field};
use crate::measure::{Spot, Target, spot_errors, spot_raggedness_at, spots_of_at_least};
use crate::points::patches::{Outline, Patches};
use crate::synth::grow::layer::GrowError;
use crate::synth::grow::patches::GrownPatches;
use crate::synth::phases::{Phase, during};
use crate::synth::plan::patches::PatchPlan;
use crate::synth::watch::{Stage, Watch};

/// A patch of less than this share of the area wanted at its place is a speck: one in two hundred found no room for more.
const SPECK: f64 = 0.1;
/// The level of the edge.
const EDGE: f32 = 0.5;

/// Grows layer number `layer` (1 = the lowest) as planned.
pub(super) fn grow_patches(
    plan: PatchPlan,
    layer: usize,
    seed: u64,
    watch: &Watch,
    seen: &mut dyn FnMut(&PatchPlan, &Field),
) -> Result<GrownPatches, GrowError> {
    watch.step(Stage::Plan, 1.0)?;
    let blocked = during(Phase::LayOut, || plan.blocked());
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
        detail: plan.detail,
        seed,
    };
    watch.step(Stage::Grow, 0.0)?;
    let grown = during(Phase::Steps, || patches.grow());
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
    seen(&plan, &grown.field);
    watch.step(Stage::Refine, 0.0)?;
    Ok(during(Phase::Measure, || measured(plan, grown.field, grown.cramped)))
}

/// Patches that have grown as `field`, with what is measured on them.
fn measured(plan: PatchPlan, field: Field, cramped: usize) -> GrownPatches {
    let layout = *plan.map.layout();
    let least = plan.map.samples().iter().map(area).fold(f64::INFINITY, f64::min);
    let spots: Vec<Spot> = spots_of_at_least(&field, EDGE, SPECK * least);
    let errors = spot_errors(
        &spots,
        &Target {
            bounds: plan.canvas(),
            regions: layout.len(),
            region_of: &|point| layout.index(layout.region_of(point)),
            covered: &|point| plan.is_taken(point),
            wanted: &|point| plan.map.at(point),
        },
    );
    let mut sums = vec![[0.0; 3]; layout.len()];
    for (center, got) in spot_raggedness_at(&field, EDGE) {
        let [count, asked, found] = &mut sums[layout.index(layout.region_of(center))];
        *count += 1.0;
        *asked += plan.wanted(center).raggedness;
        *found += got;
    }
    let mean = |[count, asked, found]: [f64; 3]| (count > 0.0).then(|| [asked / count, found / count]);
    let raggedness = sums.into_iter().map(mean).collect();
    GrownPatches { plan, field, cramped, spots, errors, raggedness }
}

fn area(wanted: &Attributes) -> f64 {
    if let Attributes::Spots(spots) = wanted { spots.area } else { f64::INFINITY }
}
