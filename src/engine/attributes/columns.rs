//! The columns of training files: names, units, allowed values. Systems of one kind share theirs.

/// The quantity that a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColumnKind {
    /// The seed of the run.
    Seed,
    /// How much was measured: whole spots, or wavelengths along a side.
    Extent,
    /// How even it is: coefficient of variation of the area, or coherence.
    Evenness,
    /// Area of a spot.
    Area,
    /// Minor ÷ major axis of a spot.
    Aspect,
    /// Direction of the marks.
    Angle,
    /// Distance of neighbouring spots.
    Spacing,
    /// Width of a stripe.
    Width,
    /// Distance of neighbouring stripes.
    Wavelength,
    /// Reaction rate ÷ diffusion.
    Rate,
    /// Diffusion rate of one chemical ÷ the other's.
    Ratio,
    /// Minor ÷ major axis of the diffusion tensor.
    Stretch,
    /// Long axis of the diffusion tensor.
    Direction,
    /// Share of the peak that is the mark's edge.
    Level,
    /// A quantity of systems of pairs, which is known by its name.
    Named,
}

/// A column of a training file.
#[derive(Debug)]
pub struct Column {
    /// What it holds.
    pub kind: ColumnKind,
    /// Its name in the header.
    pub name: &'static str,
    /// Its unit; empty for a plain number.
    pub unit: &'static str,
    /// What it holds, in words.
    pub meaning: &'static str,
    /// Lowest and highest value.
    pub range: [f64; 2],
    /// The allowed values in words.
    pub allowed: &'static str,
}

pub(super) const fn column(
    kind: ColumnKind,
    name: &'static str,
    [unit, meaning]: [&'static str; 2],
    range: [f64; 2],
    allowed: &'static str,
) -> Column {
    Column { kind, name, unit, meaning, range, allowed }
}

/// The first column of any set.
pub const SEED: Column = column(
    ColumnKind::Seed,
    "seed",
    ["", "of the run: where its marks begin"],
    [0.0, 0.0],
    "a whole number from 0 to 18446744073709551615",
);
const ANGLE: [f64; 2] = [-360.0, 360.0];
const DEGREES: &str = "an angle in degrees from -360 to 360";

/// The columns of a spot set, after `seed`.
pub const SPOTS: [Column; 11] = [
    column(
        ColumnKind::Extent,
        "marks",
        ["", "whole spots measured"],
        [1.0, 1e9],
        "a count of spots from 1 to 1e9",
    ),
    column(
        ColumnKind::Area,
        "area",
        ["cells", "mean area at the level"],
        [0.1, 1e6],
        "an area from 0.1 to 1e6 cells",
    ),
    column(
        ColumnKind::Aspect,
        "aspect",
        ["", "mean minor ÷ major axis, 1 = round"],
        [0.01, 1.0],
        "an aspect from 0.01 to 1",
    ),
    column(ColumnKind::Angle, "angle", ["degrees", "axial mean of the major axes"], ANGLE, DEGREES),
    column(
        ColumnKind::Spacing,
        "spacing",
        ["cells", "weighted mean of the Delaunay edges"],
        [0.1, 1e5],
        "a length from 0.1 to 1e5 cells",
    ),
    column(
        ColumnKind::Evenness,
        "area_cv",
        ["", "coefficient of variation of the area"],
        [0.0, 10.0],
        "a coefficient of variation from 0 to 10",
    ),
    column(
        ColumnKind::Rate,
        "rate",
        ["1/cell²", "reaction rate ÷ √(Da·Db)"],
        [1e-9, 1e3],
        "a rate from 1e-9 to 1e3 per cell²",
    ),
    column(
        ColumnKind::Ratio,
        "ratio",
        ["", "diffusion rate of the second chemical ÷ first (Turing: first ÷ second)"],
        [1e-4, 1e4],
        "a ratio Db/Da from 1e-4 to 1e4",
    ),
    column(
        ColumnKind::Stretch,
        "stretch",
        ["", "minor ÷ major axis of the diffusion tensor"],
        [0.01, 1.0],
        "a stretch from 0.01 to 1",
    ),
    column(
        ColumnKind::Direction,
        "direction",
        ["degrees", "long axis of the diffusion tensor"],
        ANGLE,
        DEGREES,
    ),
    column(
        ColumnKind::Level,
        "level",
        ["", "share of the peak that is the mark's edge"],
        [0.001, 0.999],
        "a share of the peak from 0.001 to 0.999",
    ),
];

/// Wavelengths across the patch: a column of stripes and lines.
const WAVELENGTHS: Column = column(
    ColumnKind::Extent,
    "wavelengths",
    ["", "wavelengths along a side of the patch"],
    [0.1, 1e6],
    "a count of wavelengths from 0.1 to 1e6",
);
/// Width: a column of stripes and lines.
const WIDTH: Column = column(
    ColumnKind::Width,
    "width",
    ["cells", "2 × area ÷ contour length"],
    [0.1, 1e5],
    "a length from 0.1 to 1e5 cells",
);
/// Coherence: a column of stripes and lines.
const COHERENCE: Column = column(
    ColumnKind::Evenness,
    "coherence",
    ["", "mean coherence of the structure tensor"],
    [0.0, 1.0],
    "a coherence from 0 to 1",
);

/// The columns of a stripe set, after `seed`.
pub const STRIPES: [Column; 7] = [
    WAVELENGTHS,
    WIDTH,
    column(
        ColumnKind::Angle,
        "angle",
        ["degrees", "axial mean of the directions along the stripes"],
        ANGLE,
        DEGREES,
    ),
    COHERENCE,
    column(
        ColumnKind::Rate,
        "rate",
        ["1/cell²", "reaction rate ÷ Da"],
        [1e-9, 1e3],
        "a rate from 1e-9 to 1e3 per cell²",
    ),
    column(
        ColumnKind::Stretch,
        "stretch",
        ["", "minor ÷ major axis of the diffusion tensor of the activators"],
        [0.01, 1.0],
        "a stretch from 0.01 to 1",
    ),
    column(
        ColumnKind::Direction,
        "direction",
        ["degrees", "long axis of the diffusion tensor of the activators"],
        ANGLE,
        DEGREES,
    ),
];

/// The columns of a set of lines, after `seed`.
pub const LINES: [Column; 9] = [
    WAVELENGTHS,
    WIDTH,
    column(
        ColumnKind::Angle,
        "angle",
        ["degrees", "axial mean of the directions along the lines"],
        ANGLE,
        DEGREES,
    ),
    column(
        ColumnKind::Wavelength,
        "wavelength",
        ["cells", "2 × area of the patch ÷ contour length: the distance from line to line"],
        [0.1, 1e5],
        "a length from 0.1 to 1e5 cells",
    ),
    COHERENCE,
    column(
        ColumnKind::Rate,
        "rate",
        ["1/cell²", "reaction rate ÷ √(Da·Db), Da that across the lines"],
        [1e-9, 1e3],
        "a rate from 1e-9 to 1e3 per cell²",
    ),
    column(
        ColumnKind::Ratio,
        "ratio",
        ["", "Db ÷ Da, Da that across the lines"],
        [1e-4, 1e4],
        "a ratio Db/Da from 1e-4 to 1e4",
    ),
    column(
        ColumnKind::Stretch,
        "stretch",
        ["", "minor ÷ major axis of the diffusion tensor of the activator"],
        [0.01, 1.0],
        "a stretch from 0.01 to 1",
    ),
    column(
        ColumnKind::Direction,
        "direction",
        ["degrees", "long axis of the diffusion tensor of the activator"],
        ANGLE,
        DEGREES,
    ),
];
