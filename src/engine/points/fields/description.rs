//! What the rest of the program has to know of fields of points.

use crate::attributes::system::{Description, MarkKind, Scaling};

/// Fields of points as a system. Nothing is looked up for them, so that there are no training rows; the marks that may be drawn are
/// ellipses.
pub static POINTS: Description = Description {
    name: "points",
    title: "Points",
    help: "Noise, cells and clusters of scattered points: a cow, stone, a giraffe, with nothing drawn",
    alternative: None,
    marks: MarkKind::Spots,
    free_spacing: true,
    irregular: false,
    seeding: false,
    fixed_places: false,
    along_curves: false,
    tone: false,
    option_keys: &[],
    columns: &[],
    training: &[],
    neighbours: &[],
    scaling: Scaling { ratio: 0.0, level: 0.0 },
    isolated: None,
};
