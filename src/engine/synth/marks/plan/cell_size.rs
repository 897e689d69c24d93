//! The size of a cell.

use crate::attributes::{Attributes, Stripes};
use crate::rd::MarkCells;
use crate::rd::System;

/// Smallest cell, px: finer patterns could not be seen on the canvas.
const FINEST: f64 = 0.35;
/// area ÷ spacing² of spots whose spacing is free: the density of Meinhardt's system at its smallest ratio (0.124–0.126 at aspects
/// from 0.4 to 1), where its spots are evenest.
pub(super) const FREE_DENSITY: f64 = 0.122;

/// px a cell that suits these attributes: on it the smallest mark has the cells that `system` needs.
#[must_use]
pub fn cell_for(system: System, wanted: &Attributes) -> f64 {
    let MarkCells { own_distance: own, asked_distance: asked } = system.definition().resolution.planned;
    let cell = match wanted {
        Attributes::Stripes(Stripes { width, wavelength: None, .. }) => width / own,
        Attributes::Stripes(line) => line.width / asked,
        Attributes::Spots(spots) => {
            // Denser spots are read at a lower threshold, and so are larger than the peak that must be resolved.
            let dense = spots.spacing.map_or(1.0, |s| (spots.area / (s * s) / FREE_DENSITY).clamp(1.0, 2.0));
            (spots.area / dense / asked).sqrt()
        }
    };
    cell.max(FINEST)
}

/// px a cell of the coarsest grid, no finer than `cell`, on which the size of such marks in cells does not matter to `system`.
#[must_use]
pub fn exact_cell(system: System, wanted: &Attributes, cell: f64) -> f64 {
    let MarkCells { own_distance: own, asked_distance: asked } = system.definition().resolution.exact;
    cell.max(match wanted {
        Attributes::Spots(spots) => (spots.area / asked).sqrt(),
        Attributes::Stripes(Stripes { width, wavelength: None, .. }) => width / own,
        Attributes::Stripes(line) => line.width / asked,
    })
}
