//! The description of patches.

use crate::attributes::system::{Description, Family, Keys, LookupBy, picture};

/// Patches as a system of spots. Their rules follow from [`laws`](super::laws), so there are no training rows.
pub static PATCHES: Description = Description {
    name: "patches",
    title: "Patches",
    noun: "patches",
    help: "Blotches as on cows and giraffes, smooth or ragged, as drawn",
    picture: picture!("patches"),
    kind: Family::Areas,
    free_spacing: true,
    option_keys: &["keep", "ragged", "detail", "spread", "rosette"],
    own_keys: &[
        Keys {
            keys: &["options.detail"],
            reason: "Only patches and streaks are made from a number of points: set \"system\" to one of these",
        },
        Keys {
            keys: &["options.rosette"],
            reason: "Only patches become rosettes: set \"system\" to \"patches\"",
        },
    ],
    lookup: LookupBy::Law,
    ..Description::PLAIN
};
