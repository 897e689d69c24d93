//! The description of mazes.

use super::shared_description::THREADS;
use crate::attributes::Attribute;
use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::pair_columns;
use crate::attributes::system::{Description, LookupBy, picture};
use crate::rd::systems::embedded;

/// Pieces that meet and do not cross.
pub static MAZE: Description = Description {
    name: "maze",
    title: "Maze",
    noun: "a maze",
    help: "Straight pieces of the drawn directions that meet and never cross, two to five directions",
    picture: picture!("maze"),
    lookup: LookupBy::Pairs(&Coordinates {
        by_directions: true,
        asked: &[("duty", Scale::Plain), ("long", Scale::Log), ("between", Scale::Plain)],
        answered: &[Coordinates::FACTOR, ("level", Scale::Plain)],
        duty: [[0.4, 0.6]; 2],
    }),
    grown_errors: &[(Attribute::Width, [4.0, 10.0])],
    columns: &pair_columns::MAZE,
    training: embedded!["maze"],
    ..THREADS
};
