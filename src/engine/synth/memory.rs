//! The memory that a growth needs, checked before it begins.
//!
//! What may be used is the caller's to say: `free` is the bytes of it, `None` = without a limit.

use crate::document::AreaKind;
use crate::rd::System;

/// Bytes a px of the canvas: the bands in which pictures are made.
const PX: f64 = 1.0;
/// Bytes a cell of each pair whose direction varies: three pairs on 769² cells took 73.
const PAIR: f64 = 110.0;
/// Bytes a cell of patches: field and spline, and what its share of the points takes. A Holstein on 1663² cells took 46.
const PATCH: f64 = 60.0;
/// Bytes a cell of the grid of cells: the pair, whose size may vary, its fields, and the distances from borders.
const CELL: f64 = 150.0;
/// Bytes a cell of streaks and cracks: labels, pattern, spline and the best so far, distances from obstacles, and what its share of the
/// points takes, as of patches.
const LINE: f64 = 80.0;
/// Bytes a cell of a field of points, and of each point: 4000² cells with 311,000 points took 388 MB in all, 2000² with 700,000 points 657,
/// for which 532 and 707 are allowed.
const FIELD: f64 = 12.0;
/// See [`FIELD`].
const POINT: f64 = 850.0;
/// Bytes a cell that a picture drives, beside its growth: directions, distances, parameters.
const DRIVEN: f64 = 30.0;
/// Bytes a px of a tone, where they are not those of the growth, which has ended: 12 and four for the slopes. 1178² cells with 1964² px took
/// 253 MB in all without slopes, for which 296 were allowed.
const TONE: f64 = 16.0;
/// Bytes of any growth: the program, and a band of the picture with its patterns.
const BASE: f64 = 60e6;

/// A growth that does not fit into memory.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "{}×{} px on a grid of {}×{} cells needs about {:.1} GB of memory, {:.1} GB are free; \
     grow a smaller --size, or draw larger marks",
    size[0], size[1], grid[0], grid[1], needed / 1e9, free / 1e9
)]
pub struct TooLarge {
    /// Canvas, px.
    pub size: [f64; 2],
    /// Cells along x and y.
    pub grid: [usize; 2],
    /// Bytes needed.
    pub needed: f64,
    /// Bytes free.
    pub free: f64,
}

/// Checks that a growth of `system` on `grid` cells for a canvas of `size` px fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check(system: System, size: [f64; 2], grid: [usize; 2], free: Option<f64>) -> Result<(), TooLarge> {
    fits(needed(system, size, grid), size, grid, free)
}

/// Checks that a growth of so many pairs on `grid` cells for a canvas of `size` px fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check_pairs(
    pairs: usize,
    size: [f64; 2],
    grid: [usize; 2],
    free: Option<f64>,
) -> Result<(), TooLarge> {
    fits(needed_by_pairs(pairs, size, grid), size, grid, free)
}

/// Checks that a growth of these areas on `grid` cells for a canvas of `size` px fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check_areas(
    kind: AreaKind,
    size: [f64; 2],
    grid: [usize; 2],
    free: Option<f64>,
) -> Result<(), TooLarge> {
    fits(needed_by_areas(kind, size, grid), size, grid, free)
}

/// Checks that a growth on `grid` cells that a picture drives, with a tone of `fine` px, for a canvas of `size` px fits into `free` bytes
/// of memory; without the picture it needs `growth` bytes.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check_tone(
    growth: f64,
    size: [f64; 2],
    grid: [usize; 2],
    fine: [usize; 2],
    free: Option<f64>,
) -> Result<(), TooLarge> {
    fits(needed_by_tone(growth, grid, fine), size, grid, free)
}

/// Bytes that a growth on `grid` cells that a picture drives, with a tone of `fine` px, needs; without the picture it needs `growth`.
#[must_use]
pub fn needed_by_tone(growth: f64, grid: [usize; 2], fine: [usize; 2]) -> f64 {
    let of = |[x, y]: [usize; 2], bytes: f64| x as f64 * y as f64 * bytes;
    growth + of(grid, DRIVEN) + of(fine, TONE)
}

/// Whether `needed` bytes are free for a growth on `grid` cells for a canvas of `size` px.
fn fits(needed: f64, size: [f64; 2], grid: [usize; 2], free: Option<f64>) -> Result<(), TooLarge> {
    match free {
        Some(free) if needed > free => Err(TooLarge { size, grid, needed, free }),
        _ => Ok(()),
    }
}

/// Bytes that a growth of these areas on `grid` cells for a canvas of `size` px needs.
#[must_use]
pub fn needed_by_areas(kind: AreaKind, size: [f64; 2], grid: [usize; 2]) -> f64 {
    let of_cell = match kind {
        AreaKind::Patches => PATCH,
        AreaKind::Cells => CELL,
    };
    BASE + grid[0] as f64 * grid[1] as f64 * of_cell + size[0] * size[1] * PX
}

/// Checks that a growth of streaks or cracks on `grid` cells for a canvas of `size` px fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check_lines(size: [f64; 2], grid: [usize; 2], free: Option<f64>) -> Result<(), TooLarge> {
    fits(needed_by_lines(size, grid), size, grid, free)
}

/// Bytes that a growth of streaks or cracks on `grid` cells for a canvas of `size` px needs.
#[must_use]
pub fn needed_by_lines(size: [f64; 2], grid: [usize; 2]) -> f64 {
    BASE + grid[0] as f64 * grid[1] as f64 * LINE + size[0] * size[1] * PX
}

/// Checks that a field of so many `points` on `grid` cells for a canvas of `size` px fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check_points(
    points: f64,
    size: [f64; 2],
    grid: [usize; 2],
    free: Option<f64>,
) -> Result<(), TooLarge> {
    fits(needed_by_points(points, size, grid), size, grid, free)
}

/// Bytes that a field of so many `points` on `grid` cells for a canvas of `size` px needs.
#[must_use]
pub fn needed_by_points(points: f64, size: [f64; 2], grid: [usize; 2]) -> f64 {
    BASE + grid[0] as f64 * grid[1] as f64 * FIELD + points * POINT + size[0] * size[1] * PX
}

/// Bytes that a growth of so many pairs on `grid` cells for a canvas of `size` px needs.
#[must_use]
pub fn needed_by_pairs(pairs: usize, size: [f64; 2], grid: [usize; 2]) -> f64 {
    BASE + grid[0] as f64 * grid[1] as f64 * pairs as f64 * PAIR + size[0] * size[1] * PX
}

/// Checks that a picture of `size` px whose writer holds `held` bytes a px fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLargePicture`] with the numbers.
pub fn check_picture(size: [usize; 2], held: f64, free: Option<f64>) -> Result<(), TooLargePicture> {
    let needed = held * size[0] as f64 * size[1] as f64;
    match free {
        Some(free) if needed > free => Err(TooLargePicture { size, needed, free }),
        _ => Ok(()),
    }
}

/// A picture whose writer needs more memory than is free.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "a picture of {}×{} px in this format needs about {:.1} GB of memory, {:.1} GB are free; write a .png, or a smaller one",
    size[0], size[1], needed / 1e9, free / 1e9
)]
pub struct TooLargePicture {
    /// Width and height, px.
    pub size: [usize; 2],
    /// Bytes needed.
    pub needed: f64,
    /// Bytes free.
    pub free: f64,
}

/// Checks that another export, whose writer holds `needed` bytes, fits into `free` bytes of memory.
///
/// # Errors
/// [`TooLargeExport`] with the numbers.
pub fn check_export(
    what: &'static str,
    needed: f64,
    remedy: &'static str,
    free: Option<f64>,
) -> Result<(), TooLargeExport> {
    match free {
        Some(free) if needed > free => Err(TooLargeExport { what, needed, free, remedy }),
        _ => Ok(()),
    }
}

/// An export that needs more memory than is free.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("{what} needs about {:.1} GB of memory, {:.1} GB are free; {remedy}", needed / 1e9, free / 1e9)]
pub struct TooLargeExport {
    /// What is exported.
    pub what: &'static str,
    /// Bytes needed.
    pub needed: f64,
    /// Bytes free.
    pub free: f64,
    /// The remedy.
    pub remedy: &'static str,
}

/// Bytes that a growth of `system` on `grid` cells for a canvas of `size` px needs.
#[must_use]
pub fn needed(system: System, size: [f64; 2], grid: [usize; 2]) -> f64 {
    BASE + grid[0] as f64 * grid[1] as f64 * system.definition().cost.bytes_a_cell + size[0] * size[1] * PX
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_print_of_16384_px_with_spots_of_300_takes_24_bytes_a_px() {
        // 48 cells a spot: 2.5 px a cell.
        let needed = needed(System::MEINHARDT_SPOTS, [16_384.0; 2], [6_554; 2]);
        assert!((23.0..24.5).contains(&(needed / (16_384.0 * 16_384.0))), "{needed}");
    }

    #[test]
    fn what_cannot_fit_is_refused_with_the_numbers() {
        const FREE: Option<f64> = Some(8e9);
        let error = check(System::MEINHARDT_STRIPES, [1e6; 2], [900_000; 2], FREE).unwrap_err().to_string();
        assert!(error.contains("900000×900000 cells needs about 122500.1 GB"), "{error}");
        let error = check_export("the hatch", 1e18, "hatch wider", FREE).unwrap_err().to_string();
        assert!(error.starts_with("the hatch needs about 1000000000.0 GB"), "{error}");
        assert!(error.ends_with("8.0 GB are free; hatch wider"), "{error}");
        assert_eq!(check_export("a dot", 1.0, "", FREE), Ok(()));
        assert_eq!(check(System::MEINHARDT_STRIPES, [1e6; 2], [900_000; 2], None), Ok(()));
    }
}
