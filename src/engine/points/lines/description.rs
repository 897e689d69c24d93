//! What the rest of the program has to know of streaks and cracks.

use crate::attributes::system::{Description, MarkKind, Scaling};

/// Streaks as a system of stripes. Width and share are found for each growth, so that there are no training rows.
pub static STREAKS: Description = Description {
    name: "streaks",
    title: "Streaks",
    help: "Ragged stripes with ends, as on a tiger, along the drawn lines and as wide",
    alternative: None,
    marks: MarkKind::Stripes,
    free_spacing: true,
    irregular: false,
    seeding: false,
    fixed_places: false,
    along_curves: false,
    tone: false,
    option_keys: &["duty", "detail"],
    columns: &[],
    training: &[],
    neighbours: &[],
    scaling: Scaling { ratio: 0.0, level: 0.0 },
    isolated: None,
};

/// Cracks as a system of stripes.
pub static CRACKS: Description = Description {
    name: "cracks",
    title: "Cracks",
    help: "A net as of cracked mud: lines as wide as drawn, meshes as far apart as the drawn lines leave room",
    option_keys: &["duty"],
    ..STREAKS
};
