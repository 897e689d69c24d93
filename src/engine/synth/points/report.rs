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
    if let Some(asked) = layer.plan.share.filter(|asked| (asked - layer.share).abs() > OFF) {
        notes.push(format!(
            "{:.1} % of the canvas are above the edge, not {:.1} %: its values leave no level between; take smaller distances or another share",
            100.0 * layer.share,
            100.0 * asked
        ));
    }
    notes
}
