//! The report of streaks and cracks: what was asked for, and what grew.

use crate::attributes::{Attribute, Attributes, Polarity};
use crate::document::LineKind;
use crate::measure::StripeErrors;
use crate::points::lines::radius;
use crate::synth::lines::grown::GrownLines;
use crate::synth::lines::grown::LineShare;
use crate::synth::lines::plan::LinePlan;
use crate::synth::report::{NOTED, RegionReport, ShareReport};

/// The report of each region of grown lines, row by row.
#[must_use]
pub fn line_regions(layer: &GrownLines) -> Vec<RegionReport> {
    let plan = &layer.plan;
    let layout = plan.map.layout();
    let region = |index: usize| {
        let (place, errors) = (layout.place(index), &layer.errors[index]);
        let wanted = plan.wanted_of_region(place);
        let directed = plan.kind == LineKind::Streaks;
        let named = [
            (Attribute::Width, errors.width),
            (Attribute::Wavelength, errors.wavelength),
            (Attribute::Angle, errors.angle.filter(|_| directed)),
            (Attribute::AngleScatter, errors.angle_rms.filter(|_| directed)),
        ];
        let mut notes = if index == 0 { plan.notes.clone() } else { Vec::new() };
        notes.extend(other_width(errors));
        if index == 0 {
            notes.extend(other_share(plan, share(layer)));
        }
        if errors.got.is_none() {
            notes.push("nothing grew in this region: nothing was measured".to_owned());
        }
        RegionReport {
            place,
            marks: None,
            merged: None,
            asked: errors.wanted.map_or_else(|| plan.asked_of_region(place), Attributes::Stripes),
            polarity: Polarity::Positive,
            directed,
            parameters: vec![
                ("share", wanted.share),
                ("radius", radius(plan.course(), &wanted)),
                ("cell", plan.px_a_cell()),
            ],
            predicted: None,
            got: errors.got.map(Attributes::Stripes),
            raggedness: None,
            error: named.into_iter().filter_map(|(attribute, value)| Some((attribute, value?))).collect(),
            spread: None,
            kept: None,
            beyond: Vec::new(),
            notes,
        }
    };
    (0..layout.len()).map(region).collect()
}

/// A note if lines are clearly wider or narrower than asked for.
fn other_width(errors: &StripeErrors) -> Option<String> {
    let off = errors.width?.abs();
    let (asked, got) = (errors.wanted?.width, errors.got?.width);
    (off > NOTED).then(|| format!("lines are {got:.1} px wide, not {asked:.1}"))
}

/// A note if lines cover clearly more or less than asked for.
fn other_share(plan: &LinePlan, ShareReport { asked, got }: ShareReport) -> Option<String> {
    ((got / asked - 1.0).abs() > NOTED).then(|| {
        let name = plan.kind.description().name;
        format!("{name} cover {:.0} % of the canvas, not {:.0} %", 100.0 * got, 100.0 * asked)
    })
}

/// The share that the lines of all regions cover.
#[must_use]
pub fn share(layer: &GrownLines) -> ShareReport {
    // All regions are equally large; regions with obstacles have full weight, too.
    let mean = |of: fn(&LineShare) -> f64| {
        layer.shares.iter().map(of).sum::<f64>() / layer.shares.len().max(1) as f64
    };
    ShareReport { asked: mean(|share| share.asked), got: mean(|share| share.got) }
}
