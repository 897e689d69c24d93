//! What was asked of the threads of each direction of a weave, and what grew.

use serde::Serialize;

use crate::attributes::Stripes;
use crate::grid::resample::Spline;
use crate::measure::StripeErrors;
use crate::synth::grow::pairs::GrownPairs;
use crate::synth::plan::pairs::thread_map::ThreadMap;
use crate::synth::report::covered::covered;
use crate::synth::report::drawn::{DrawnMark, drawn_line};
use crate::synth::report::stripe_along::stripe_along;

/// The threads of one direction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ThreadReport {
    /// The lines that were drawn in this direction.
    pub lines: usize,
    /// Width, distance (px) and direction that were asked for, their means.
    pub asked: Stripes,
    /// What grew; `None` where none did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub got: Option<Stripes>,
    /// By how much it differs: shares of width and wavelength, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub error: Option<ThreadErrors>,
}

/// By how much grown threads differ from what was asked for at their places.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ThreadErrors {
    /// Share of the width.
    pub width: f64,
    /// Share of the distance from one to the next.
    pub wavelength: f64,
    /// The mean, degrees.
    pub angle: f64,
    /// The root mean square, degrees.
    pub angle_rms: f64,
}

/// The threads of each direction of what pairs have grown.
#[must_use]
pub fn threads(layer: &GrownPairs) -> Vec<ThreadReport> {
    let direction = |(threads, found): (&ThreadMap, &StripeErrors)| {
        let errors = found.width.zip(found.wavelength).zip(found.angle.zip(found.angle_rms));
        ThreadReport {
            lines: threads.lines.len(),
            asked: found.wanted.unwrap_or_else(|| threads.mean()),
            got: found.got,
            error: errors.map(|((width, wavelength), (angle, angle_rms))| ThreadErrors {
                width,
                wavelength,
                angle,
                angle_rms,
            }),
        }
    };
    layer.plan.threads.iter().zip(&layer.measured).map(direction).collect()
}

/// The notes on what pairs have grown.
#[must_use]
pub fn notes(layer: &GrownPairs) -> Vec<String> {
    let dead = layer.plan.threads.iter().zip(&layer.measured).filter(|(_, found)| found.got.is_none());
    let dead = dead.map(|(threads, _)| {
        let Stripes { width, angle, .. } = threads.mean();
        format!("no threads grew at {angle:.0}°, {width:.1} px wide: draw them wider or nearer to each other")
    });
    layer.plan.notes.iter().cloned().chain(dead).collect()
}

/// What became of each drawn line, in the order in which they were drawn.
#[must_use]
pub fn drawn_lines(layer: &GrownPairs) -> Vec<DrawnMark> {
    let canvas = layer.plan.canvas();
    let [nx, ny] = layer.plan.grid.size;
    let mut marks = Vec::new();
    for (direction, threads) in layer.plan.threads.iter().enumerate() {
        let surface = Spline::new(&layer.pattern_of(direction).field(nx, ny));
        for (mark, line) in &threads.lines {
            let covered = covered(line, threads.map().layout(), &surface, |point| layer.plan.is_taken(point));
            let asked = Stripes { width: line.width, ..threads.at(line.center()) };
            let got = stripe_along(line, &surface, canvas);
            let oblique = "closer to others than the period of the threads, or oblique to them";
            marks.push(drawn_line((*mark, line), covered, asked, got, oblique));
        }
    }
    marks.sort_by_key(|mark| mark.mark);
    marks
}
