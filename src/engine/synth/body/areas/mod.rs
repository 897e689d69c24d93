//! Patches and cells on a surface. Their places are laid as those of spots are; their edges come from scattered points, or lie midway
//! between the places.

mod cells;
mod discs;
mod graph;
mod interpolation;
mod patches;

use crate::surface::SurfacePoint;
use crate::synth::body::area_form::AreaForm;
use crate::synth::body::plan::BodyPlan;

/// How much of an area of this form each vertex shows, 0..1; the areas begin at these `centers`.
#[must_use]
pub fn grown(plan: &BodyPlan, form: &AreaForm, centers: &[SurfacePoint], seed: u64) -> Vec<f32> {
    match form {
        AreaForm::Patches(form) => patches::grown(plan, form, centers, seed),
        AreaForm::Cells(gap) => cells::grown(plan, *gap, centers),
    }
}

#[cfg(test)]
mod tests;
