//! Advice if a field of points has one value everywhere.

use crate::document::Labels;

/// The reason why all points with these labels can have one value, and what to change.
#[must_use]
pub fn advice(labels: &Labels) -> &'static str {
    match labels {
        Labels::Values { .. } => {
            "all its points have about the same value; take smaller groups or a smaller \"distance\""
        }
        Labels::Random { .. } => {
            "all its points are dark, or all are light; take a probability \"dark\" nearer to 0.5, or a smaller \"distance\""
        }
        Labels::Image { .. } => {
            "all its points are dark, or all are light; take a picture with dark and light places, or a smaller \"distance\""
        }
        Labels::SpaceGiraffe { .. } => "a cell is larger than the canvas; take a smaller \"distance\"",
        Labels::BreadthFirst { .. } | Labels::DepthFirst { .. } => {
            "all its points are in clusters, or none is; take another \"size\" of clusters, or a smaller \"distance\""
        }
        Labels::RoundRobin { .. } => {
            "no point is inside a cluster, or none is at its border; take larger clusters, fewer \"rings\" or a smaller \"distance\""
        }
        Labels::Connected { .. } => {
            "all its points are on the net, or none is; take another \"start\", fewer \"rings\" or a smaller \"distance\""
        }
    }
}
