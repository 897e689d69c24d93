//! What the columns of the training files are: names, units, allowed values.

use super::{TrainingError, training_set::Kind};

/// A column of a training file.
pub struct Column {
    /// What stands in the header.
    pub name: &'static str,
    /// Its unit; empty for what is a number by itself.
    pub unit: &'static str,
    /// What it holds.
    pub meaning: &'static str,
    /// Lowest and highest value.
    pub(super) range: [f64; 2],
    /// The same in words.
    pub(super) allowed: &'static str,
}

const fn column(
    name: &'static str,
    [unit, meaning]: [&'static str; 2],
    range: [f64; 2],
    allowed: &'static str,
) -> Column {
    Column { name, unit, meaning, range, allowed }
}

/// The first column of any set.
pub(super) const SEED: Column = column(
    "seed",
    ["", "of the run: where its marks begin"],
    [0.0, 0.0],
    "a whole number from 0 to 18446744073709551615",
);
const ANGLE: [f64; 2] = [-360.0, 360.0];
const DEGREES: &str = "an angle in degrees from -360 to 360";

/// The columns of a spot set, after `seed`.
const SPOTS: [Column; 11] = [
    column("marks", ["", "whole spots measured"], [1.0, 1e9], "a count of spots from 1 to 1e9"),
    column("area", ["cells", "mean area at the level"], [0.1, 1e6], "an area from 0.1 to 1e6 cells"),
    column("aspect", ["", "mean minor ÷ major axis, 1 = round"], [0.01, 1.0], "an aspect from 0.01 to 1"),
    column("angle", ["degrees", "axial mean of the major axes"], ANGLE, DEGREES),
    column("spacing", ["cells", "mean Delaunay edge"], [0.1, 1e5], "a length from 0.1 to 1e5 cells"),
    column(
        "area_cv",
        ["", "coefficient of variation of the area"],
        [0.0, 10.0],
        "a coefficient of variation from 0 to 10",
    ),
    column("rate", ["1/cell²", "reaction rate ÷ √(Da·Db)"], [1e-9, 1e3], "a rate from 1e-9 to 1e3 per cell²"),
    column(
        "ratio",
        ["", "diffusion rate of the second chemical ÷ first (Turing: first ÷ second)"],
        [1e-4, 1e4],
        "a ratio Db/Da from 1e-4 to 1e4",
    ),
    column(
        "stretch",
        ["", "minor ÷ major axis of the diffusion tensor"],
        [0.01, 1.0],
        "a stretch from 0.01 to 1",
    ),
    column("direction", ["degrees", "long axis of the diffusion tensor"], ANGLE, DEGREES),
    column(
        "level",
        ["", "share of the peak that is the mark's edge"],
        [0.001, 0.999],
        "a share of the peak from 0.001 to 0.999",
    ),
];

/// The columns of a stripe set, after `seed`.
const STRIPES: [Column; 7] = [
    column(
        "wavelengths",
        ["", "wavelengths along a side of the patch"],
        [0.1, 1e6],
        "a count of wavelengths from 0.1 to 1e6",
    ),
    column("width", ["cells", "2 × area ÷ contour length"], [0.1, 1e5], "a length from 0.1 to 1e5 cells"),
    column("angle", ["degrees", "axial mean of the directions along the stripes"], ANGLE, DEGREES),
    column(
        "coherence",
        ["", "mean coherence of the structure tensor"],
        [0.0, 1.0],
        "a coherence from 0 to 1",
    ),
    column("rate", ["1/cell²", "reaction rate ÷ Da"], [1e-9, 1e3], "a rate from 1e-9 to 1e3 per cell²"),
    column(
        "stretch",
        ["", "minor ÷ major axis of the diffusion tensor of the activators"],
        [0.01, 1.0],
        "a stretch from 0.01 to 1",
    ),
    column("direction", ["degrees", "long axis of the diffusion tensor of the activators"], ANGLE, DEGREES),
];

/// The columns of a set of lines, after `seed`.
const LINES: [Column; 9] = [
    column(
        "wavelengths",
        ["", "wavelengths along a side of the patch"],
        [0.1, 1e6],
        "a count of wavelengths from 0.1 to 1e6",
    ),
    column("width", ["cells", "2 × area ÷ contour length"], [0.1, 1e5], "a length from 0.1 to 1e5 cells"),
    column("angle", ["degrees", "axial mean of the directions along the lines"], ANGLE, DEGREES),
    column(
        "wavelength",
        ["cells", "2 × area of the patch ÷ contour length: the distance from line to line"],
        [0.1, 1e5],
        "a length from 0.1 to 1e5 cells",
    ),
    column(
        "coherence",
        ["", "mean coherence of the structure tensor"],
        [0.0, 1.0],
        "a coherence from 0 to 1",
    ),
    column(
        "rate",
        ["1/cell²", "reaction rate ÷ √(Da·Db), Da that across the lines"],
        [1e-9, 1e3],
        "a rate from 1e-9 to 1e3 per cell²",
    ),
    column("ratio", ["", "Db ÷ Da, Da that across the lines"], [1e-4, 1e4], "a ratio Db/Da from 1e-4 to 1e4"),
    column(
        "stretch",
        ["", "minor ÷ major axis of the diffusion tensor of the activator"],
        [0.01, 1.0],
        "a stretch from 0.01 to 1",
    ),
    column("direction", ["degrees", "long axis of the diffusion tensor of the activator"], ANGLE, DEGREES),
];

/// The columns of the training files of `system`, in the order in which [`write_rows`](super::write_rows) writes them.
///
/// # Errors
/// [`TrainingError::UnknownSystem`].
pub fn columns_of(system: &str) -> Result<impl Iterator<Item = &'static Column>, TrainingError> {
    let (_, kind) = super::training_set::find(system)?;
    Ok(std::iter::once(&SEED).chain(columns(kind)))
}

/// The columns of a kind of set, after `seed`.
pub(super) fn columns(kind: Kind) -> &'static [Column] {
    match kind {
        Kind::Spots => &SPOTS,
        Kind::Stripes => &STRIPES,
        Kind::Lines => &LINES,
    }
}
