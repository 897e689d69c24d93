//! What the rest of the program has to know of patches.

use crate::attributes::system::{Description, MarkKind, Scaling};

/// Patches as a system of spots. They follow from [`laws`](super::laws), so that there are no training rows.
pub static PATCHES: Description = Description {
    name: "patches",
    title: "Patches",
    help: "Blotches as on cows and giraffes, smooth or ragged, as drawn",
    alternative: None,
    marks: MarkKind::Spots,
    free_spacing: true,
    irregular: false,
    seeding: false,
    fixed_places: false,
    along_curves: false,
    tone: false,
    option_keys: &["keep", "ragged", "detail"],
    columns: &[],
    training: &[],
    neighbours: &[],
    scaling: Scaling { ratio: 0.0, level: 0.0 },
    isolated: None,
};
