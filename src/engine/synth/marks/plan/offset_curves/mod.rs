//! Curves of lines that run around the marks beneath, or between them.
//!
//! Meinhardt's lines remain where they began, and spread along their direction (`facts.md` M). So they begin along a curve, with
//! its direction:
//!
//! ```text
//!  marks beneath ─▶ distance to the nearest ─▶ rings: where it is the same (offset curves)       ─┐
//!                                           └▶ web: where two marks are equally near (medial axis) ┴─▶ curves, directions
//! ```
//!
//! The reaction determines the final shape and width.

mod copies;
pub mod gaps;
pub mod level_curves;
pub mod medial_axis;
pub mod rings;

use crate::attributes::AttributeMap;
use crate::grid::blur::boxes;
use crate::grid::{Domain, Grid};
use crate::measure::StripeErrors;
use crate::rd::{CurveLaw, GuideCurves, LinesAlongCurves, ParameterField, Parameters};
use crate::synth::error::CurvesError;
use rayon::prelude::*;

/// The curves that lines run along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// A ring around each mark.
    Rings,
    /// One web between all marks.
    Web,
}

impl CurveKind {
    /// The law of lines along these curves.
    #[must_use]
    pub fn law(self, laws: &LinesAlongCurves) -> CurveLaw {
        match self {
            Self::Rings => laws.rings,
            Self::Web => laws.web,
        }
    }

    /// Distance that two marks need for lines between them, in widths of the lines.
    #[must_use]
    pub fn need(self) -> f64 {
        match self {
            Self::Rings => rings::OWN,
            Self::Web => medial_axis::NEED,
        }
    }
}

/// Curves for the lines of a layer, by cell of its grid.
#[derive(Clone, Debug)]
pub struct Curves {
    /// Distance to the nearest curve, cells.
    distance: Vec<f32>,
    /// Directions of the lines.
    directions: Vec<Direction>,
    /// Cells beside the marks beneath where nothing grows: close to them, and in the gaps of open rings.
    blocked: Vec<bool>,
    /// Inhibitor of cells where nothing grows.
    inhibitor: Vec<f32>,
    /// Whether a cell is on the curve, and not in a gap.
    curve: Vec<bool>,
    /// Number of ends of open rings by region, and the length of the remaining arcs, px.
    ends: Vec<(f64, f64)>,
    /// Messages to the user.
    pub remarks: Vec<String>,
}

/// The direction of lines at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Direction {
    /// Degrees from +x towards +y.
    direction: f32,
    /// Minor ÷ major axis of the activator's tensor.
    stretch: f32,
    /// D_b/Dₐ.
    ratio: f32,
}

/// The input of [`Curves::lay`].
#[derive(Clone, Copy, Debug)]
pub struct CurveRequest<'a> {
    /// Rings or a web.
    pub kind: CurveKind,
    /// The laws of lines along curves.
    pub laws: LinesAlongCurves,
    /// For each cell, whether the marks beneath cover it.
    pub obstacles: &'a [bool],
    /// Width of the lines wanted at each cell, px.
    pub width: &'a [f32],
    /// The share of each ring that is open, 0..1.
    pub broken: f64,
    /// Seed of the places of the gaps.
    pub seed: u64,
}

impl Curves {
    /// Lays the curves of `request` on `grid`, which is cut into `regions`, by index.
    ///
    /// # Errors
    /// There is nothing beneath, or no room.
    pub fn lay(
        request: &CurveRequest,
        grid: &Grid,
        regions: usize,
        region_of: &dyn Fn([f64; 2]) -> usize,
    ) -> Result<Self, CurvesError> {
        match request.kind {
            CurveKind::Rings => rings::lay(request, grid, regions, region_of),
            CurveKind::Web => medial_axis::lay(request, grid, regions),
        }
    }

    /// `maps` with lines that run along these curves.
    #[must_use]
    pub fn guide(&self, mut maps: ParameterField) -> ParameterField {
        for (p, direction) in maps.parameters.iter_mut().zip(&self.directions) {
            let Direction { direction, stretch, ratio } = *direction;
            *p = Parameters { direction, stretch, ratio, ..*p };
        }
        for (taken, blocked) in maps.obstacles.iter_mut().zip(&self.blocked) {
            *taken |= blocked;
        }
        let curves = GuideCurves { distance: self.distance.clone(), inhibitor: self.inhibitor.clone() };
        ParameterField { curves: Some(curves), ..maps }
    }

    /// The width of lines in region `index` if 2 × area ÷ contour length is `measured`: the ends of open rings have a contour, too.
    ///
    /// For arcs of total length L with e square ends, W = 2Lw ÷ (2L + ew), so that w = W ÷ (1 − eW/2L).
    #[must_use]
    pub fn width(&self, index: usize, measured: f64) -> f64 {
        let (ends, length) = self.ends[index];
        if length <= 0.0 {
            return measured;
        }
        measured / (1.0 - 0.5 * ends * measured / length).max(0.25)
    }

    /// Corrects the errors of region `index` by [`Self::width`], and removes those of the direction: lines follow the marks
    /// beneath, so that no direction was asked for.
    pub fn correct(&self, index: usize, errors: &mut StripeErrors) {
        if let (Some(got), Some(wanted)) = (&mut errors.got, &errors.wanted) {
            got.width = self.width(index, got.width);
            errors.width = Some(got.width / wanted.width - 1.0);
        }
        errors.angle = None;
        errors.angle_rms = None;
    }
}

/// Directions and ratios, from the vector (columns, rows) of each cell to the curve, or from it: lines run across this vector.
/// Where vectors from all sides meet there is no direction. `ratios` are D_b/Dₐ along a line and at junctions;
/// `stretch_and_meeting` gives the stretch at a cell, and how close to a junction a cell without a direction is, 0..1.
fn directions(
    ways: &[[i32; 2]],
    grid: &Grid,
    radius: usize,
    ratios: [f64; 2],
    stretch_and_meeting: impl Fn(usize) -> (f64, f64) + Sync,
) -> Vec<Direction> {
    let [ratio, at_junctions] = ratios;
    // Cells beside a curve give its direction to 45° only; those farther away are more accurate.
    let far = (2 * radius.max(1)) as f64;
    let weighted = |[x, y]: [i32; 2]| {
        let [x, y] = [f64::from(x) * grid.cell[0], f64::from(y) * grid.cell[1]];
        let length = (x * x + y * y).sqrt();
        let shorter = if length > 0.0 { (far * grid.px_a_cell() / length).min(1.0) } else { 0.0 };
        [shorter * x, shorter * y]
    };
    let part = |of: &(dyn Fn([f64; 2]) -> f64 + Sync)| {
        let values: Vec<f32> = ways.par_iter().map(|way| of(weighted(*way)) as f32).collect();
        boxes(&values, grid.size, grid.edges, radius)
    };
    // (cos 2θ, sin 2θ) of the vector, times its squared length.
    let cos = part(&|[x, y]| x * x - y * y);
    let sin = part(&|[x, y]| 2.0 * x * y);
    let all = part(&|[x, y]| x * x + y * y);
    (0..ways.len())
        .into_par_iter()
        .map(|i| {
            let [c, s, all] = [cos[i], sin[i], all[i]].map(f64::from);
            let agreed = if all > 0.0 { ((c * c + s * s).sqrt() / all).min(1.0) } else { 0.0 };
            let (stretch, meeting) = stretch_and_meeting(i);
            let meets = (1.0 - agreed) * meeting;
            Direction {
                direction: (0.5 * libm::atan2(-s, -c)).to_degrees() as f32,
                stretch: libm::pow(stretch, agreed) as f32,
                ratio: (ratio + (at_junctions - ratio) * (2.0 * meets).min(1.0)) as f32,
            }
        })
        .collect()
}

/// Radius of a blur that suits lines of these widths (px), cells.
fn blur_radius(width: &[f32], grid: &Grid) -> usize {
    let thinnest = width.iter().copied().fold(f32::INFINITY, f32::min);
    ((0.5 * f64::from(thinnest) / grid.px_a_cell()).round() as usize).max(1)
}

/// Width of the lines that `map` wants at each cell of `grid`, px.
#[must_use]
pub fn line_widths(map: &AttributeMap, grid: &Grid) -> Vec<f32> {
    let width = |cell| map.width_at(grid.center_px(cell)).unwrap_or(0.0) as f32;
    (0..grid.cells()).map(width).collect()
}

#[cfg(test)]
mod tests;
