//! Patches, cells and fields of points on a surface. The places of patches and cells are laid as those of spots are; their edges come
//! from scattered points, or lie midway between the places.

mod cells;
mod discs;
mod graph;
mod interpolation;
mod patches;
mod points;

use crate::document::Document;
use crate::surface::SurfacePoint;
use crate::synth::body::area_form::AreaForm;
use crate::synth::body::plan::BodyPlan;
use crate::synth::error::LayerError;
use crate::synth::report::PointsReport;

/// Areas that have grown.
pub struct GrownAreas {
    /// How much of an area each vertex shows, 0..1.
    pub marks: Vec<f32>,
    /// How many patches or cells were laid; 0 of points.
    pub laid: usize,
    /// The report of a field of points; `None` of other areas.
    pub points: Option<PointsReport>,
}

/// Grows the areas of a plan, of this form. Patches and cells begin at the places that are `laid`.
///
/// # Errors
/// Nothing finds room, or all points have the same value.
pub fn grown(
    document: &Document,
    plan: &BodyPlan,
    form: &AreaForm,
    laid: impl FnOnce() -> Vec<SurfacePoint>,
) -> Result<GrownAreas, LayerError> {
    let seed = document.layer_seed(plan.layer);
    let around = |grow: &dyn Fn(&[SurfacePoint]) -> Vec<f32>| {
        let centers = laid();
        if centers.is_empty() {
            return Err(LayerError::NoRoom);
        }
        Ok(GrownAreas { marks: grow(&centers), laid: centers.len(), points: None })
    };
    match form {
        AreaForm::Patches(form) => around(&|centers| patches::grown(plan, form, centers, seed)),
        AreaForm::Cells(gap) => around(&|centers| cells::grown(plan, *gap, centers)),
        AreaForm::Points(form) => {
            let points = document.layers[plan.layer].point_field().unwrap_or_default();
            let body = document.model.as_ref().ok_or(LayerError::NoRoom)?;
            let points::GrownPoints { values, report } = points::grown(plan, form, &points, body, seed)?;
            Ok(GrownAreas { marks: values, laid: 0, points: Some(report) })
        }
    }
}

#[cfg(test)]
mod points_tests;
#[cfg(test)]
mod tests;
