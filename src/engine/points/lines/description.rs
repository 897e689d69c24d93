//! The descriptions of streaks and cracks.

use crate::attributes::system::{Description, Family, Keys, LookupBy, MarkKind, picture};

/// The common part of the descriptions of streaks and cracks. Width and share are found for each pattern, so there are no training
/// rows.
const LINES: Description = Description {
    kind: Family::Lines,
    marks: MarkKind::Stripes,
    free_spacing: true,
    lookup: LookupBy::Law,
    ..Description::PLAIN
};

/// Streaks as a system of stripes.
pub static STREAKS: Description = Description {
    name: "streaks",
    title: "Streaks",
    noun: "streaks",
    help: "Ragged stripes with ends, as on a tiger, along the drawn lines and with their width",
    picture: picture!("streaks"),
    option_keys: &["duty", "vary", "double", "ragged", "detail"],
    own_keys: &[Keys {
        keys: &["options.detail"],
        reason: "Only patches and streaks are made from a number of points: set \"system\" to one of these",
    }],
    ..LINES
};

/// Cracks as a system of stripes.
pub static CRACKS: Description = Description {
    name: "cracks",
    title: "Cracks",
    noun: "cracks",
    help: "A net like the cracks in dry mud: lines of the drawn width, meshes as wide as the spaces between the drawn lines",
    picture: picture!("cracks"),
    directed: false,
    option_keys: &["duty"],
    refused_keys: &[Keys {
        keys: &["maps.direction"],
        reason: "Cracks run in all directions; their spacing and duty can have maps",
    }],
    ..LINES
};
