//! Curves of lines that run around the marks beneath, or between them, on a surface: as
//! [`offset_curves`](crate::synth::marks::plan::offset_curves) lays them on canvases, by the same laws.

mod gaps;
mod nearest;
mod peaks;
mod rings;
mod web;

use crate::attributes::Attributes;
use crate::measure::{SurfaceDirection, surface_directions};
use crate::rd::{GuideCurves, LinesAlongCurves, ParameterField, Parameters, System};
use crate::surface::Surface;
use crate::synth::error::CurvesError;
use crate::synth::marks::plan::offset_curves::CurveKind;

/// Curves for the lines of a layer, by vertex.
pub struct Curves {
    /// Cells to the nearest curve.
    distance: Vec<f32>,
    /// Parameters of the lines beside their rate.
    run: Vec<Run>,
    /// Where nothing grows beside the marks beneath: close to them, and in the gaps of open rings.
    blocked: Vec<bool>,
    /// Inhibitor of vertices where nothing grows.
    inhibitor: Vec<f32>,
    /// Whether it is a vertex on the curve, and not in a gap.
    curve: Vec<bool>,
    /// Vertices at the ends of open rings.
    ends: Vec<usize>,
    /// Messages to the user.
    pub remarks: Vec<String>,
}

/// How lines run at one vertex.
#[derive(Clone, Copy, Debug)]
struct Run {
    /// Degrees in the frame of the vertex.
    direction: f64,
    /// Minor ÷ major axis of the activator's tensor.
    stretch: f64,
    /// D_b/Dₐ.
    ratio: f64,
}

/// The input of [`Curves::lay`].
pub struct Request<'a> {
    /// The surface, px.
    pub surface: &'a Surface,
    /// Rings or a web.
    pub kind: CurveKind,
    /// The laws of lines along curves.
    pub laws: LinesAlongCurves,
    /// Which vertices are covered by the marks beneath.
    pub obstacles: &'a [bool],
    /// Width of the lines wanted at each vertex, px.
    pub widths: Vec<f64>,
    /// The share of each ring that is open, 0..1.
    pub broken: f64,
    /// Seed of the places of the gaps.
    pub seed: u64,
}

impl Curves {
    /// Lays the curves of `request`.
    ///
    /// # Errors
    /// There is nothing beneath, or no room.
    pub fn lay(request: &Request) -> Result<Self, CurvesError> {
        match request.kind {
            CurveKind::Rings => rings::lay(request),
            CurveKind::Web => web::lay(request),
        }
    }

    /// Makes the lines of `maps` run along these curves.
    pub fn guide(&self, maps: &mut ParameterField<Surface>) {
        for (p, run) in maps.parameters.iter_mut().zip(&self.run) {
            let [direction, stretch, ratio] =
                [run.direction, run.stretch, run.ratio].map(|value| value as f32);
            *p = Parameters { direction, stretch, ratio, ..*p };
        }
        maps.obstacles.resize(self.blocked.len(), false);
        maps.obstacles.iter_mut().zip(&self.blocked).for_each(|(taken, blocked)| *taken |= blocked);
        let (distance, inhibitor) = (self.distance.clone(), self.inhibitor.clone());
        maps.curves = Some(GuideCurves { distance, inhibitor });
    }

    /// The phases with which lines of `system` begin along these curves: the distance to a curve ÷ the distance from line to line.
    #[must_use]
    pub fn phases(&self, system: System, maps: &ParameterField<Surface>) -> Vec<f32> {
        let phase = |(distance, p): (&f32, &Parameters)| {
            (std::f64::consts::TAU * f64::from(*distance) / system.spacing(p)) as f32
        };
        self.distance.iter().zip(&maps.parameters).map(phase).collect()
    }

    /// The width of the lines in a group of vertices, px, where 2 × area ÷ contour length is `measured`: the ends of open rings have a
    /// contour, too.
    ///
    /// Of arcs of length L with e square ends in all, W = 2Lw ÷ (2L + ew), so that w = W ÷ (1 − eW/2L).
    #[must_use]
    pub fn width(&self, surface: &Surface, measured: f64, is_in_group: &dyn Fn(usize) -> bool) -> f64 {
        let ends = self.ends.iter().filter(|vertex| is_in_group(**vertex)).count() as f64;
        let on_curve =
            |vertex: &usize| self.curve[*vertex] && self.distance[*vertex] < 0.5 && is_in_group(*vertex);
        let length = surface.unit() * (0..self.curve.len()).filter(on_curve).count() as f64;
        if ends == 0.0 || length <= 0.0 {
            measured
        } else {
            measured / (1.0 - 0.5 * ends * measured / length).max(0.25)
        }
    }
}

/// The width of the lines that are wanted at each vertex, px.
#[must_use]
pub fn widths(wanted: &[Attributes]) -> Vec<f64> {
    let width = |wanted: &Attributes| match wanted {
        Attributes::Stripes(stripes) => stripes.width,
        Attributes::Spots(spots) => spots.area.sqrt(),
    };
    wanted.iter().map(width).collect()
}

/// How lines run across the slope of `distance`. Where slopes from all sides meet there is no direction. `stretch_and_meeting` gives the
/// stretch at a vertex, and how close to a junction one without a direction is, 0..1.
fn runs(request: &Request, distance: &[f64], stretch_and_meeting: impl Fn(usize) -> (f64, f64)) -> Vec<Run> {
    let LinesAlongCurves { ratio, ratio_at_junctions, .. } = request.laws;
    let thinnest = request.widths.iter().copied().fold(f64::INFINITY, f64::min);
    // Parts that no mark is on have no distance.
    let finite: Vec<f32> =
        distance.iter().map(|away| if away.is_finite() { *away as f32 } else { 0.0 }).collect();
    let found = surface_directions(request.surface, &finite, 0.5 * thinnest);
    let run = |(vertex, found): (usize, SurfaceDirection)| {
        let agreed = found.coherence;
        let (stretch, meeting) = stretch_and_meeting(vertex);
        let meets = (1.0 - agreed) * meeting;
        Run {
            direction: found.degrees,
            stretch: libm::pow(stretch, agreed),
            ratio: ratio + (ratio_at_junctions - ratio) * (2.0 * meets).min(1.0),
        }
    };
    found.into_iter().enumerate().map(run).collect()
}
