//! Curves of lines that run around the marks beneath, or between them.
//!
//! Meinhardt's lines stand where they began, and spread along their direction (`facts.md` M). So they begin along a curve,
//! with its direction:
//!
//! ```text
//!  marks beneath ─▶ distance to the nearest ─▶ rings: where it is the same (offset curves)       ─┐
//!                                           └▶ web: where two marks are equally near (medial axis) ┴─▶ curves, directions
//! ```
//!
//! The reaction decides what stands there in the end, and how wide it is.

mod blur;
mod copies;
mod error;
mod gaps;
mod level_curves;
mod medial_axis;
mod rings;

pub use error::CurvesError;

use crate::attributes::AttributeMap;
use crate::attributes::{Attributes, Stripes};
use crate::grid::{Domain, Grid};
use crate::measure::StripeErrors;
use crate::rd::{GuideCurves, Maps, Parameters};
use blur::blurred;
use rayon::prelude::*;

/// D_b/Dₐ of such lines. From 20 on they lean towards the marks beneath and break where three meet; at 12 they split in
/// wide gaps, and at 10 fill them.
pub const RATIO: f64 = 15.0;
/// The same where three lines meet, and the inhibitor of all of them comes together: at [`RATIO`] they part there
/// after T = 60.
const MEETING: f64 = 8.0;

/// The curves that lines run along.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CurveKind {
    /// A ring around each mark.
    Rings,
    /// One web between all marks.
    Web,
}

impl CurveKind {
    /// √rate of lines one cell wide, by the ruler at half of the local peak.
    #[must_use]
    pub fn law(self) -> f64 {
        match self {
            Self::Rings => 12.5,
            Self::Web => 15.8,
        }
    }

    /// Distance between two marks ÷ the width of the lines, that lines of their own need between them.
    #[must_use]
    pub fn need(self) -> f64 {
        match self {
            Self::Rings => rings::OWN,
            Self::Web => medial_axis::NEED,
        }
    }

    /// Minor ÷ major axis of the activator's tensor along a line, √(slow ÷ fast). Webs in the open break into spots at
    /// 1 : 1.5, and widen where they bend at 1 : 10. The more of it, the more lines that bend are drawn to the inside:
    /// rings, which have a lane to hold them, are drawn against their marks at 1 : 2.
    #[must_use]
    pub fn stretch(self) -> f64 {
        match self {
            Self::Rings => 0.82,
            Self::Web => 0.5,
        }
    }
}

/// Curves for the lines of a layer, by cell of its grid.
#[derive(Clone, Debug)]
pub struct Curves {
    /// Cells to the nearest curve.
    distance: Vec<f32>,
    /// Directions of the lines.
    directions: Vec<Direction>,
    /// Where nothing grows beside the marks beneath: close to them, and in the gaps of open rings.
    blocked: Vec<bool>,
    /// Inhibitor of cells where nothing grows.
    inhibitor: Vec<f32>,
    /// Whether it is a cell on the curve, and not in a gap.
    curve: Vec<bool>,
    /// Ends of open rings by region, and the length of what is left of them, px.
    ends: Vec<(f64, f64)>,
    /// Messages to the user.
    pub remarks: Vec<String>,
}

/// How lines run at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Direction {
    /// Degrees from +x towards +y.
    direction: f32,
    /// Minor ÷ major axis of the activator's tensor.
    stretch: f32,
    /// D_b/Dₐ.
    ratio: f32,
}

/// What curves are laid for.
#[derive(Clone, Copy, Debug)]
pub struct CurveRequest<'a> {
    /// Rings or a web.
    pub kind: CurveKind,
    /// Which cells the marks beneath have taken.
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
    pub fn guide(&self, mut maps: Maps) -> Maps {
        for (p, direction) in maps.parameters.iter_mut().zip(&self.directions) {
            let Direction { direction, stretch, ratio } = *direction;
            *p = Parameters { direction, stretch, ratio, ..*p };
        }
        for (taken, blocked) in maps.obstacles.iter_mut().zip(&self.blocked) {
            *taken |= blocked;
        }
        let curves = GuideCurves { distance: self.distance.clone(), inhibitor: self.inhibitor.clone() };
        Maps { curves: Some(curves), ..maps }
    }

    /// The width of lines in region `index` where 2 × area ÷ contour length is `measured`: the ends of open rings have a
    /// contour, too.
    ///
    /// Of arcs of length L with e square ends in all, W = 2Lw ÷ (2L + ew), so that w = W ÷ (1 − eW/2L).
    #[must_use]
    pub fn width(&self, index: usize, measured: f64) -> f64 {
        let (ends, length) = self.ends[index];
        if length <= 0.0 {
            return measured;
        }
        measured / (1.0 - 0.5 * ends * measured / length).max(0.25)
    }

    /// Corrects the errors of region `index` for [`Self::width`]. Lines run as the marks beneath let them: no direction was
    /// asked.
    pub fn correct(&self, index: usize, errors: &mut StripeErrors) {
        if let (Some(got), Some(wanted)) = (&mut errors.got, &errors.wanted) {
            got.width = self.width(index, got.width);
            errors.width = Some(got.width / wanted.width - 1.0);
        }
        errors.angle = None;
        errors.angle_rms = None;
    }
}

/// Directions and ratios from the vector (columns, rows) of each cell to the curve, or from it: lines run across it. Where
/// vectors from all sides meet there is no direction. `stretch_and_meeting` gives the stretch at a cell, and how much lines
/// meet there where they have no direction, 0..1.
fn directions(
    ways: &[[i32; 2]],
    grid: &Grid,
    radius: usize,
    stretch_and_meeting: impl Fn(usize) -> (f64, f64) + Sync,
) -> Vec<Direction> {
    // Cells beside a curve know its direction to 45° only, those farther away better.
    let far = (2 * radius.max(1)) as f64;
    let weighted = |[x, y]: [i32; 2]| {
        let [x, y] = [f64::from(x) * grid.cell[0], f64::from(y) * grid.cell[1]];
        let length = (x * x + y * y).sqrt();
        let shorter = if length > 0.0 { (far * grid.px_a_cell() / length).min(1.0) } else { 0.0 };
        [shorter * x, shorter * y]
    };
    let part = |of: &(dyn Fn([f64; 2]) -> f64 + Sync)| {
        let values: Vec<f32> = ways.par_iter().map(|way| of(weighted(*way)) as f32).collect();
        blurred(&values, grid.size, grid.edges, radius)
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
                ratio: (RATIO + (MEETING - RATIO) * (2.0 * meets).min(1.0)) as f32,
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
    let width = |cell| match map.at(grid.center_px(cell)) {
        Attributes::Stripes(Stripes { width, .. }) => width as f32,
        Attributes::Spots(_) => 0.0,
    };
    (0..grid.cells()).map(width).collect()
}

#[cfg(test)]
mod tests;
