//! Obstacle mask: the cells taken by the marks of the layers beneath. Stripes keep clear of them, and need room between them.

use rayon::prelude::*;

use crate::attributes::{Attributes, Polarity};
use crate::grid::Domain;
use crate::grid::distance::{length, nearest};
use crate::synth::marks::plan::layer_lookup::Lookup;

/// The obstacles and the cells beside them, for stripes, which may end on obstacle cells: they then reach less than a cell onto the
/// marks. Of 224 stripes that end on marks eight touched one; with the rim none.
#[must_use]
pub fn with_rim<D: Domain>(obstacles: &[bool], domain: &D) -> Vec<bool> {
    let near = |cell: usize| obstacles[cell] || domain.neighbours(cell).any(|other| obstacles[other]);
    (0..obstacles.len()).into_par_iter().map(near).collect()
}

/// The ground around the obstacles, by cell, for stripes that are the gaps between lines: the height of a line as a share of its peak,
/// 1 on the obstacles and ½ at a distance of one line width. Empty without obstacles, and if the stripes are the lines themselves,
/// which leave ground there anyway.
#[must_use]
pub fn ground_rim(lookup: &Lookup, obstacles: &[bool]) -> Vec<f32> {
    let grid = lookup.grid;
    let ways = match lookup.polarity {
        Polarity::Positive => None,
        Polarity::Negative => nearest(obstacles, &grid),
    };
    let height = |(cell, way): (usize, [i32; 2])| {
        let Attributes::Stripes(lines) = lookup.polarity.lines(&lookup.map.at(grid.center_px(cell))) else {
            return 0.0;
        };
        let off = length(way, &grid) / lines.width;
        libm::exp2(-off * off) as f32
    };
    ways.map_or_else(Vec::new, |ways| ways.into_par_iter().enumerate().map(height).collect())
}

/// Whether the stripes fit between the obstacles: whether some place is at least half a stripe width away from all of them.
#[must_use]
pub fn has_room(lookup: &Lookup, obstacles: &[bool]) -> bool {
    let grid = lookup.grid;
    let Some(ways) = nearest(obstacles, &grid) else { return true };
    (0..grid.cells()).into_par_iter().any(|cell| {
        let Attributes::Stripes(wanted) = lookup.map.at(grid.center_px(cell)) else { return false };
        // Distance to the near side of the obstacle, not to the centre of its cell.
        2.0 * length(ways[cell], &grid) - lookup.px_a_cell() >= wanted.width
    })
}
