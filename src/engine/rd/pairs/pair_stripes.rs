//! The description of stripes of one pair.

use super::shared_description::{THREADS, USUAL_DUTY};
use crate::attributes::Attribute;
use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::pair_columns;
use crate::attributes::system::{Description, LookupBy, picture};
use crate::rd::systems::embedded;

/// Stripes of one direction.
pub static PAIR_STRIPES: Description = Description {
    name: "pair-stripes",
    title: "Stripes with tips",
    noun: "pair stripes",
    help: "Stripes of one direction from noise, which end in tips and begin anew",
    picture: picture!("pair-stripes"),
    tone: true,
    option_keys: &["duty", "vary", "double", "ragged"],
    lookup: LookupBy::Pairs(&Coordinates {
        by_directions: false,
        asked: &[("duty", Scale::Log), ("angle", Scale::Quarter)],
        answered: &[Coordinates::FACTOR],
        duty: USUAL_DUTY,
    }),
    grown_errors: &[(Attribute::Width, [3.0, 7.0]), (Attribute::Period, [2.0, 6.0])],
    columns: &pair_columns::PAIR_STRIPES,
    training: embedded!["pair-stripes"],
    ..THREADS
};
