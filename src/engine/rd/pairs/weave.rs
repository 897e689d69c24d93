//! The description of weaves.

use super::shared_description::THREADS;
use crate::attributes::Attribute;
use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::pair_columns;
use crate::attributes::system::{Description, Keys, LookupBy, picture};
use crate::rd::systems::embedded;

/// Threads that cross.
pub static WEAVE: Description = Description {
    name: "weave",
    title: "Weave",
    noun: "a weave",
    help: "Threads along lines that cross, two to five directions in one place",
    picture: picture!("weave"),
    option_keys: &["duty", "over"],
    own_keys: &[Keys {
        keys: &["options.over"],
        reason: "Only threads of a weave lie over others: set \"system\" to \"weave\"",
    }],
    lookup: LookupBy::Pairs(&Coordinates {
        by_directions: true,
        asked: &[
            ("duty", Scale::Log),
            ("others", Scale::Plain),
            ("unequal", Scale::Log),
            ("between", Scale::Plain),
        ],
        answered: &[Coordinates::FACTOR],
        // Three directions leave as much free as two directions with denser threads.
        duty: [[0.15, 0.4], [0.15, 0.24]],
    }),
    grown_errors: &[(Attribute::Width, [3.0, 7.0]), (Attribute::Period, [2.0, 6.0])],
    columns: &pair_columns::WEAVE,
    training: embedded!["weave"],
    ..THREADS
};
