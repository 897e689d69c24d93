//! What a growth will need, before it is begun.

/// Bytes that a cell of the grid takes: 5 chemicals twice (40), 8 stencil weights (32, and as much again while
/// they are laid out), mobilities and rate (12), parameters (20), the pattern's spline and its copy (12).
const BYTES_A_CELL: f64 = 148.0;
/// Bytes that a px of the canvas takes at scale 1: the pattern, its spline and bands while it is measured.
const BYTES_A_PX: f64 = 16.0;

/// A texture that does not fit.
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

/// Whether a growth on `grid` cells for a canvas of `size` px fits into the memory that is free now.
///
/// # Errors
/// [`TooLarge`] with the numbers.
pub fn check(size: [f64; 2], grid: [usize; 2]) -> Result<(), TooLarge> {
    let needed = grid[0] as f64 * grid[1] as f64 * BYTES_A_CELL + size[0] * size[1] * BYTES_A_PX;
    let free = free();
    if needed > free { Err(TooLarge { size, grid, needed, free }) } else { Ok(()) }
}

/// Bytes of memory that are free; where the system does not say, what most machines have.
fn free() -> f64 {
    const USUAL: f64 = 8e9;
    let Ok(text) = std::fs::read_to_string("/proc/meminfo") else { return USUAL };
    let line = text.lines().find_map(|line| line.strip_prefix("MemAvailable:"));
    let kilobytes = line.and_then(|rest| rest.trim().trim_end_matches("kB").trim().parse::<f64>().ok());
    kilobytes.map_or(USUAL, |kilobytes| 1024.0 * kilobytes)
}
