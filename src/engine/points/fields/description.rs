//! What the rest of the program has to know of fields of points.

use crate::attributes::system::{Description, Family, Keys, picture};

/// Fields of points as a system. Nothing is looked up for them, so that there are no training rows; the marks that may be drawn are
/// ellipses.
pub static POINTS: Description = Description {
    name: "points",
    title: "Points",
    noun: "a field of points",
    help: "Noise, cells and clusters of scattered points: a cow, stone, a giraffe, with nothing drawn",
    picture: picture!("points"),
    kind: Family::Points,
    directed: false,
    grows_blank: true,
    free_spacing: true,
    own_keys: &[Keys {
        keys: &["points"],
        reason: "Only fields of points have this: set \"system\" to \"points\"",
    }],
    refused_keys: &[Keys {
        keys: &["maps.direction", "maps.aspect", "maps.duty"],
        reason: "Of a field of points the spacing of the points can have a map, and the area of what is dark",
    }],
    ..Description::PLAIN
};
