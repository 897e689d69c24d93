//! The report of the threads of each direction: what was asked for, and what grew.

use crate::attributes::Stripes;
use crate::document::Over;
use crate::grid::resample::Spline;
use crate::measure::StripeErrors;
use crate::rd::pairs::PairKind;
use crate::synth::pairs::grown::{GrownPairs, OverUnder};
use crate::synth::pairs::plan::thread_map::ThreadMap;
use crate::synth::report::covered::covered;
use crate::synth::report::drawn::{DrawnMark, drawn_line};
use crate::synth::report::stripe_along::stripe_along;
use crate::synth::report::{NOTED, ThreadErrors, ThreadReport, WidthReport};

/// The report on the blotches of stucco; `None` for all other systems.
#[must_use]
pub fn blotches(layer: &GrownPairs) -> Option<WidthReport> {
    let found = layer.measured.first().filter(|_| layer.plan.kind() == PairKind::Stucco)?;
    Some(WidthReport { asked: found.wanted?.width, got: found.got.map(|got| got.width) })
}

/// The report on the threads of each direction of a layer of pairs; none for stucco.
#[must_use]
pub fn threads(layer: &GrownPairs) -> Vec<ThreadReport> {
    if layer.plan.kind() == PairKind::Stucco {
        return Vec::new();
    }
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

/// The notes on a layer of pairs.
#[must_use]
pub fn notes(layer: &GrownPairs) -> Vec<String> {
    let dead = layer.plan.threads.iter().zip(&layer.measured).filter(|(_, found)| found.got.is_none());
    let dead = dead.map(|(threads, _)| {
        let Stripes { width, angle, .. } = threads.mean();
        format!("no threads grew at {angle:.0}°, {width:.1} px wide: draw them wider or nearer to each other")
    });
    let other = layer.plan.threads.iter().zip(&layer.measured);
    let other = other.filter_map(|(threads, found)| other_width(layer, threads, found));
    let over = layer.over.as_ref().and_then(OverUnder::note);
    let none_over = (layer.plan.over != Over::Level && layer.over.is_none()).then(|| {
        "threads of one direction run in circles or as rays, so that they cannot be counted: all are level".to_owned()
    });
    let wide = blotches(layer).and_then(|WidthReport { asked, got }| {
        let got = got.filter(|got| (got / asked - 1.0).abs() > NOTED)?;
        Some(format!("blotches are {got:.1} px wide, not {asked:.1}: choose another decay"))
    });
    layer
        .plan
        .notes
        .iter()
        .cloned()
        .chain(dead)
        .chain(other)
        .chain(over)
        .chain(none_over)
        .chain(wide)
        .collect()
}

/// A note if these threads are clearly wider or narrower than planned; blotches have a note of their own.
fn other_width(layer: &GrownPairs, threads: &ThreadMap, found: &StripeErrors) -> Option<String> {
    if layer.plan.kind() == PairKind::Stucco {
        return None;
    }
    let expected = layer.plan.reached(threads) / threads.mean().width;
    let off = (1.0 + found.width?) / expected - 1.0;
    let (asked, got) = (found.wanted?, found.got?);
    (off.abs() > NOTED).then(|| {
        format!(
            "at {:.0}° lines are {:.1} px wide, not {:.1}",
            asked.angle,
            got.width,
            expected * asked.width
        )
    })
}

/// For each drawn line, in the order of drawing, how it has grown.
#[must_use]
pub fn drawn_lines(layer: &GrownPairs) -> Vec<DrawnMark> {
    if layer.plan.kind() == PairKind::Stucco {
        // Marks give the width of blotches, not their places.
        return Vec::new();
    }
    if !layer.plan.threads.iter().all(ThreadMap::keeps_lines) {
        return Vec::new();
    }
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
