//! What was asked of fields of points, and what grew.

use serde::Serialize;

use crate::synth::grow::point_fields::GrownPoints;

/// A share may be off by so much before it is said.
const OFF: f64 = 0.005;

/// A grown field of points.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PointsReport {
    /// What gave the points their values.
    pub labels: &'static str,
    /// How many points there are, of all octaves.
    pub count: usize,
    /// The smallest and the largest distance that was asked for, px.
    pub distance: [f64; 2],
    /// The share of the canvas above the edge.
    pub share: PointsShare,
}

/// The share of the canvas above the edge, of what the layers beneath left free, 0..1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PointsShare {
    /// What was asked for, if anything was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub asked: Option<f64>,
    /// What grew.
    pub got: f64,
}

/// What became of a field of points.
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

/// What the user should know of it.
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
