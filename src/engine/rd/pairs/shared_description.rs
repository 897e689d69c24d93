//! The common part of the descriptions of systems of pairs.

use crate::attributes::system::{Description, Family, MarkKind};

/// Duties of random targets, for any number of directions.
pub(super) const USUAL_DUTY: [[f64; 2]; 2] = [[0.2, 0.7]; 2];

/// The common part of the descriptions of all kinds. Threads follow from laws, see [`Threads`](super::Threads); training rows hold
/// the errors of these laws.
pub(super) const THREADS: Description = Description {
    kind: Family::Pairs,
    marks: MarkKind::Stripes,
    free_spacing: true,
    option_keys: &["duty"],
    ..Description::PLAIN
};
