//! The memory that a growth needs, checked before it begins.
//!
//! The caller decides how many bytes may be used: `free`; `None` = no limit.

use crate::points::discs::Laying;
use crate::rd::System;

/// Bytes per px of the canvas: the bands in which pictures are made.
const PX: f64 = 1.0;
/// Bytes per cell for each pair whose direction varies: three pairs on 769² cells took 73 each.
const PAIR: f64 = 110.0;
/// Bytes per cell of a layer that a picture drives, besides its growth: directions, distances, parameters.
const DRIVEN: f64 = 30.0;
/// Bytes per px of a tone, where this exceeds the memory of the growth, which has ended: 12, and four for the slopes. 1178² cells
/// with 1964² px took 253 MB in all without slopes; 296 were reserved.
const TONE: f64 = 16.0;
/// Bytes per point that is laid, with its edges in the graph.
const POINT: f64 = 850.0;
/// Bytes per bucket for finding discs: twelve discs are stored inside it.
const BUCKET: f64 = 100.0;
/// Bytes for any growth: the program, and a band of the picture with its patterns.
pub const BASE: f64 = 60e6;

/// A growth that does not fit into memory.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error(
    "{}×{} px on a grid of {}×{} cells needs about {:.1} GB of memory, {:.1} GB are free; \
     grow a smaller --size, or draw larger marks, or such as differ less in size",
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

/// Bytes for a growth driven by a picture on `grid` cells, with a tone of `fine` px; without the picture it needs `growth`.
#[must_use]
pub fn needed_by_tone(growth: f64, grid: [usize; 2], fine: [usize; 2]) -> f64 {
    let of = |[x, y]: [usize; 2], bytes: f64| x as f64 * y as f64 * bytes;
    growth + of(grid, DRIVEN) + of(fine, TONE)
}

/// Bytes for a growth that needs `a_cell` bytes per cell of the grid, for a canvas of `size` px.
#[must_use]
pub fn of_cells(a_cell: f64, size: [f64; 2], grid: [usize; 2]) -> f64 {
    BASE + grid[0] as f64 * grid[1] as f64 * a_cell + size[0] * size[1] * PX
}

/// Bytes for laid points, with their graph and the buckets for finding them.
#[must_use]
pub fn of_points(laying: &Laying) -> f64 {
    laying.points * POINT + laying.buckets * BUCKET
}

/// Checks that a growth on `grid` cells for a canvas of `size` px, which needs `needed` bytes, fits into the `free` ones.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn fits(needed: f64, size: [f64; 2], grid: [usize; 2], free: Option<f64>) -> Result<(), TooLarge> {
    match free {
        Some(free) if needed > free => Err(TooLarge { size, grid, needed, free }),
        _ => Ok(()),
    }
}

/// Bytes for a growth of this number of pairs on `grid` cells, for a canvas of `size` px.
#[must_use]
pub fn needed_by_pairs(pairs: usize, size: [f64; 2], grid: [usize; 2]) -> f64 {
    of_cells(pairs as f64 * PAIR, size, grid)
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
    /// The name of the exported content.
    pub what: &'static str,
    /// Bytes needed.
    pub needed: f64,
    /// Bytes free.
    pub free: f64,
    /// The remedy.
    pub remedy: &'static str,
}

/// Bytes for a growth of `system` on `grid` cells, for a canvas of `size` px.
#[must_use]
pub fn needed(system: System, size: [f64; 2], grid: [usize; 2]) -> f64 {
    of_cells(system.definition().cost.bytes_a_cell, size, grid)
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
    fn growths_that_do_not_fit_are_refused_with_the_numbers() {
        const FREE: Option<f64> = Some(8e9);
        let (size, grid) = ([1e6; 2], [900_000; 2]);
        let bytes = needed(System::MEINHARDT_STRIPES, size, grid);
        let error = fits(bytes, size, grid, FREE).unwrap_err().to_string();
        assert!(error.contains("900000×900000 cells needs about 122500.1 GB"), "{error}");
        let error = check_export("the hatch", 1e18, "hatch wider", FREE).unwrap_err().to_string();
        assert!(error.starts_with("the hatch needs about 1000000000.0 GB"), "{error}");
        assert!(error.ends_with("8.0 GB are free; hatch wider"), "{error}");
        assert_eq!(check_export("a dot", 1.0, "", FREE), Ok(()));
        assert_eq!(fits(bytes, size, grid, None), Ok(()));
    }
}
