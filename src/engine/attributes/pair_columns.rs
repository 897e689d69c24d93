//! The columns of the training files of systems of pairs. Lengths are cells of the grid, which has 1.75 in the smallest size s.

use super::columns::{Column, ColumnKind, column};

/// A quantity that is known by its name.
const fn named(
    name: &'static str,
    [unit, meaning]: [&'static str; 2],
    range: [f64; 2],
    allowed: &'static str,
) -> Column {
    column(ColumnKind::Named, name, [unit, meaning], range, allowed)
}

const PERIODS: Column =
    named("periods", ["", "periods along a side of the patch"], [0.1, 1e6], "a count from 0.1 to 1e6");
const WIDTH: Column =
    named("width", ["cells", "mean width of the lines"], [0.1, 1e5], "a length from 0.1 to 1e5 cells");
const PERIOD: Column = named(
    "period",
    ["cells", "from the middle of a line to that of the next"],
    [0.1, 1e5],
    "a length from 0.1 to 1e5 cells",
);
const DUTY: Column = named("duty", ["", "width ÷ period"], [0.01, 0.99], "a share from 0.01 to 0.99");
const DIRECTIONS: Column =
    named("directions", ["", "how many directions the lines have"], [2.0, 5.0], "a number from 2 to 5");
const BETWEEN: Column = named(
    "between",
    ["degrees", "the smallest angle between two directions"],
    [1.0, 90.0],
    "an angle from 1 to 90 degrees",
);
const SIZE: Column = named("size", ["cells", "s of the pair"], [0.01, 1e4], "a size from 0.01 to 1e4 cells");
const FACTOR: Column = named(
    "factor",
    ["", "size ÷ the size that the law gives for what was measured"],
    [0.1, 10.0],
    "a factor from 0.1 to 10",
);
const ANGLE: Column = named(
    "angle",
    ["degrees", "axial mean of the directions along the lines"],
    [-360.0, 360.0],
    "an angle in degrees from -360 to 360",
);
const LEVEL: Column = named(
    "level",
    ["", "level of the edges ÷ the level where the reaction is half"],
    [0.0, 10.0],
    "a level from 0 to 10",
);

/// The columns of weaves: one direction of a run, and what it crosses.
pub const WEAVE: [Column; 11] = [
    PERIODS,
    DIRECTIONS,
    BETWEEN,
    named(
        "others",
        ["", "share of its threads that the others cover"],
        [0.0, 0.99],
        "a share from 0 to 0.99",
    ),
    named(
        "unequal",
        ["", "geometric mean of the periods of the others ÷ its own"],
        [0.01, 100.0],
        "a ratio from 0.01 to 100",
    ),
    WIDTH,
    PERIOD,
    DUTY,
    SIZE,
    named("threshold", ["K₀", "θ of the direction"], [0.001, 1.0], "a threshold from 0.001 to 1"),
    FACTOR,
];

/// The columns of mazes.
pub const MAZE: [Column; 10] = [
    PERIODS,
    DIRECTIONS,
    BETWEEN,
    named("long", ["", "size of the pieces ÷ period, as drawn"], [0.1, 1e3], "a ratio from 0.1 to 1e3"),
    WIDTH,
    PERIOD,
    DUTY,
    SIZE,
    LEVEL,
    FACTOR,
];

/// The columns of pair stripes.
pub const PAIR_STRIPES: [Column; 7] = [PERIODS, WIDTH, PERIOD, DUTY, ANGLE, SIZE, FACTOR];

/// The columns of stucco.
pub const STUCCO: [Column; 5] = [
    PERIODS,
    named("width", ["cells", "mean width of the blotches"], [0.1, 1e5], "a length from 0.1 to 1e5 cells"),
    named("decay", ["", "1 − the last gain ÷ the first"], [0.0, 0.99], "a share from 0 to 0.99"),
    SIZE,
    FACTOR,
];

/// The columns of cells.
pub const CELLS: [Column; 9] = [
    named("cells", ["", "cells that were laid"], [1.0, 1e9], "a count from 1 to 1e9"),
    named("area", ["cells", "mean area of whole cells"], [0.1, 1e8], "an area from 0.1 to 1e8 cells"),
    named("aspect", ["", "mean minor ÷ major axis of whole cells"], [0.01, 1.0], "an aspect from 0.01 to 1"),
    named(
        "gap",
        ["cells", "mean width of the lines between cells"],
        [0.1, 1e5],
        "a length from 0.1 to 1e5 cells",
    ),
    named("sparse", ["", "√area ÷ gap"], [0.1, 1e4], "a ratio from 0.1 to 1e4"),
    SIZE,
    named("distance", ["cells", "√(patch ÷ cells)"], [0.1, 1e5], "a length from 0.1 to 1e5 cells"),
    FACTOR,
    named(
        "apart",
        ["", "distance ÷ the distance that the law gives for what was measured"],
        [0.1, 10.0],
        "a factor from 0.1 to 10",
    ),
];
