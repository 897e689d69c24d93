//! The course of lines that go round the marks beneath, or between them.
//!
//! Meinhardt's lines stand where they were begun, and spread along their direction (`facts.md` M). So they are begun
//! along a curve, and told to run along it:
//!
//! ```text
//!  marks beneath ─▶ distance to the nearest ─▶ rings: where it is the same        ─┐
//!                                           └▶ web: where two marks are as near ─┴─▶ crests, directions
//! ```
//!
//! What stands there in the end, and how wide it is, the reaction decides.

mod blur;
mod copies;
mod gaps;
mod levels;
mod medial_axis;
mod rings;
mod room;

pub use copies::Grid;
pub use room::CourseError;

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

/// What lines do to the marks beneath.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// They ring each.
    Rings,
    /// They run between them as one web.
    Web,
}

impl Way {
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

/// What a layer of such lines is told, by cell of its grid.
#[derive(Clone, Debug)]
pub struct Course {
    /// What it does.
    pub way: Way,
    /// Cells to the curve that lines begin along.
    pub off: Vec<f32>,
    /// How they are to run.
    pub along: Vec<Along>,
    /// Where nothing grows beside the marks beneath: close to them, and where rings are open.
    pub kept_off: Vec<bool>,
    /// Inhibitor where nothing grows.
    pub held: Vec<f32>,
    /// Whether it is a cell that the curve passes, and rings are not open there.
    curve: Vec<bool>,
    /// Ends of open rings by region, and the length of what is left of them, px.
    ends: Vec<(f64, f64)>,
    /// What there is to say about it.
    pub remarks: Vec<String>,
}

/// How lines run at one place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Along {
    /// Degrees from +x towards +y.
    pub direction: f32,
    /// Minor ÷ major axis of the activator's tensor.
    pub stretch: f32,
    /// D_b/Dₐ.
    pub ratio: f32,
}

/// What is asked of a course.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// What it does.
    pub way: Way,
    /// Which cells the marks beneath have taken.
    pub taken: &'a [bool],
    /// Width of the lines wanted at each cell, px.
    pub width: &'a [f32],
    /// The share of each ring that is open, 0..1.
    pub broken: f64,
    /// Where all chance comes from.
    pub seed: u64,
}

impl Course {
    /// Lays the course of `wanted` on `grid`, which is cut into `regions`, by index.
    ///
    /// # Errors
    /// There is nothing beneath, or no room.
    pub fn lay(
        wanted: &Wanted,
        grid: &Grid,
        regions: usize,
        region_of: &dyn Fn([f64; 2]) -> usize,
    ) -> Result<Self, CourseError> {
        match wanted.way {
            Way::Rings => rings::lay(wanted, grid, regions, region_of),
            Way::Web => medial_axis::lay(wanted, grid, regions),
        }
    }

    /// What the simulation is told: `maps`, whose lines are to run like this.
    #[must_use]
    pub fn told(&self, mut maps: Maps) -> Maps {
        for (p, along) in maps.parameters.iter_mut().zip(&self.along) {
            let Along { direction, stretch, ratio } = *along;
            *p = Parameters { direction, stretch, ratio, ..*p };
        }
        for (taken, kept_off) in maps.obstacles.iter_mut().zip(&self.kept_off) {
            *taken |= kept_off;
        }
        Maps {
            curves: Some(GuideCurves { distance: self.off.clone(), inhibitor: self.held.clone() }),
            ..maps
        }
    }

    /// What 2 × area ÷ contour length in region `index` says about the width there: the ends of open rings have a
    /// contour too.
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

    /// Errors of region `index` by that width. Lines run as the marks beneath let them: no direction was asked.
    pub fn corrected(&self, index: usize, errors: &mut StripeErrors) {
        if let (Some(got), Some(wanted)) = (&mut errors.got, &errors.wanted) {
            got.width = self.width(index, got.width);
            errors.width = Some(got.width / wanted.width - 1.0);
        }
        errors.angle = None;
        errors.angle_rms = None;
    }
}

/// Directions and ratios from the way (columns, rows) to the curve, or from it, that each cell has: lines run across it.
/// Where ways from all sides meet there is no direction. `told` gives the stretch at a cell, and how far lines meet there
/// where they have none, 0..1.
fn along(
    ways: &[[i32; 2]],
    grid: &Grid,
    radius: usize,
    told: impl Fn(usize) -> (f64, f64) + Sync,
) -> Vec<Along> {
    // Cells beside a curve know its direction to 45° only, those farther away better.
    let far = (2 * radius.max(1)) as f64;
    let weighted = |[x, y]: [i32; 2]| {
        let [x, y] = [f64::from(x) * grid.cell[0], f64::from(y) * grid.cell[1]];
        let length = (x * x + y * y).sqrt();
        let shorter = if length > 0.0 { (far * grid.px() / length).min(1.0) } else { 0.0 };
        [shorter * x, shorter * y]
    };
    let part = |of: &(dyn Fn([f64; 2]) -> f64 + Sync)| {
        let values: Vec<f32> = ways.par_iter().map(|way| of(weighted(*way)) as f32).collect();
        blurred(&values, grid.size, grid.edges, radius)
    };
    // (cos 2θ, sin 2θ) of the way, times its squared length.
    let cos = part(&|[x, y]| x * x - y * y);
    let sin = part(&|[x, y]| 2.0 * x * y);
    let all = part(&|[x, y]| x * x + y * y);
    (0..ways.len())
        .into_par_iter()
        .map(|i| {
            let [c, s, all] = [cos[i], sin[i], all[i]].map(f64::from);
            let agreed = if all > 0.0 { ((c * c + s * s).sqrt() / all).min(1.0) } else { 0.0 };
            let (stretch, meeting) = told(i);
            let meets = (1.0 - agreed) * meeting;
            Along {
                direction: (0.5 * libm::atan2(-s, -c)).to_degrees() as f32,
                stretch: libm::pow(stretch, agreed) as f32,
                ratio: (RATIO + (MEETING - RATIO) * (2.0 * meets).min(1.0)) as f32,
            }
        })
        .collect()
}

/// Cells of a blur that suits lines of these widths, px.
fn radius(width: &[f32], grid: &Grid) -> usize {
    let thinnest = width.iter().copied().fold(f32::INFINITY, f32::min);
    ((0.5 * f64::from(thinnest) / grid.px()).round() as usize).max(1)
}

#[cfg(test)]
mod tests;
