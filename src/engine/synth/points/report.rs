//! The report of fields of points: what was asked for, and what grew.

use crate::synth::points::grown::GrownPoints;
use crate::synth::report::{PointsReport, PointsShare};

/// Largest error of a share that is not noted.
const OFF: f64 = 0.005;

/// The report of a field of points.
#[must_use]
pub fn points_report(layer: &GrownPoints) -> PointsReport {
    let plan = &layer.plan;
    PointsReport {
        labels: plan.points.labels.name(),
        count: layer.points,
        distance: plan.distances,
        share: PointsShare { asked: plan.share, got: layer.share },
    }
}

/// Notes for the user.
#[must_use]
pub fn notes(layer: &GrownPoints) -> Vec<String> {
    let mut notes = layer.plan.notes.clone();
    notes.extend(other_share(&PointsShare { asked: layer.plan.share, got: layer.share }, "canvas"));
    notes
}

/// A note if the share of a canvas or of a surface, named by `place`, is clearly not the one that was asked for.
#[must_use]
pub fn other_share(share: &PointsShare, place: &str) -> Option<String> {
    let asked = share.asked.filter(|asked| (asked - share.got).abs() > OFF)?;
    Some(format!(
        "{:.1} % of the {place} are above the edge, not {:.1} %: its values leave no level between; take smaller distances or another share",
        100.0 * share.got,
        100.0 * asked
    ))
}
