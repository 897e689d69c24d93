//! What the layers beneath have grown: their marks are frozen, and what grows next keeps out of them.

use rayon::prelude::*;

use super::pattern::Pattern;

/// From this pattern value on a place belongs to a mark.
pub const COVERED: f32 = 0.5;
/// Points that a cell is asked at, each way, at most.
const POINTS: usize = 4;

/// Which cells of a grid of `nx` × `ny` over the canvas the marks of `layers` reach into, row by row.
#[must_use]
pub fn taken(layers: &[Pattern], [nx, ny]: [usize; 2]) -> Vec<bool> {
    let mut taken = vec![false; nx * ny];
    for layer in layers {
        // As many points as show the finest that this layer has grown.
        let finer = |axis: usize, n: usize| layer.grid()[axis].div_ceil(n).clamp(1, POINTS);
        let [fx, fy] = [finer(0, nx), finer(1, ny)];
        let fine = layer.field(fx * nx, fy * ny);
        taken.par_iter_mut().enumerate().for_each(|(cell, taken)| {
            let (x, y) = (cell % nx * fx, cell / nx * fy);
            let covered =
                |row: usize| fine.values[row * fine.width + x..][..fx].iter().any(|v| *v >= COVERED);
            *taken = *taken || (y..y + fy).any(covered);
        });
    }
    taken
}
