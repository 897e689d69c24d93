//! The description of fields of points.

use crate::attributes::system::{Description, Family, Keys, picture};

/// Fields of points as a system. No parameters are looked up for them, so there are no training rows. The marks that may be drawn
/// are ellipses.
pub static POINTS: Description = Description {
    name: "points",
    title: "Points",
    noun: "a field of points",
    help: "Noise, cells and clusters of scattered points, as on stone, a cow or a giraffe, without drawn marks",
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
        reason: "In a field of points only the spacing of the points and the area of the dark parts can have maps",
    }],
    ..Description::PLAIN
};
