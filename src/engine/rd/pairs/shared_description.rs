//! What the descriptions of systems of pairs share.

use crate::attributes::system::{Description, Family, MarkKind};

/// Duties of random targets, whatever their directions.
pub(super) const USUAL_DUTY: [[f64; 2]; 2] = [[0.2, 0.7]; 2];

/// What the descriptions of all kinds share. Threads follow from laws, see [`Threads`](super::Threads); training rows say
/// how far these are off.
pub(super) const THREADS: Description = Description {
    kind: Family::Pairs,
    marks: MarkKind::Stripes,
    free_spacing: true,
    option_keys: &["duty"],
    ..Description::PLAIN
};
