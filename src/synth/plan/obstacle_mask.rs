//! Cells taken by the marks of the layers beneath: stripes keep clear of them, and need room between them.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::grid::Edges;
use crate::grid::distance::{length, nearest};
use crate::synth::plan::layer_lookup::Lookup;

/// The obstacles with the cells beside them, for stripes: these end on the obstacle cells, and by less than a cell on the
/// marks. Of 224 that end on marks eight touched one; so none.
#[must_use]
pub fn with_rim(obstacles: &[bool], [nx, ny]: [usize; 2], edges: Edges) -> Vec<bool> {
    let near = |cell: usize| {
        let (x, y) = ((cell % nx) as isize, (cell / nx) as isize);
        let mut around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy)));
        around.any(|(x, y)| obstacles[edges.index(y, ny) * nx + edges.index(x, nx)])
    };
    (0..obstacles.len()).into_par_iter().map(near).collect()
}

/// Do the stripes fit anywhere between the obstacles: is a place as far from these as half a stripe is wide?
#[must_use]
pub fn has_room(lookup: &Lookup, obstacles: &[bool]) -> bool {
    let Lookup { grid: [nx, ny], cell: px, .. } = *lookup;
    let Some(ways) = nearest(obstacles, [nx, ny], px, lookup.map.layout().edges) else { return true };
    (0..nx * ny).into_par_iter().any(|cell| {
        let at = lookup.to_px([(cell % nx) as f64 + 0.5, (cell / nx) as f64 + 0.5]);
        let Attributes::Stripes(wanted) = lookup.map.at(at) else { return false };
        // To the near side of the obstacle, not to the middle of its cell.
        2.0 * length(ways[cell], px) - lookup.px_a_cell() >= wanted.width
    })
}
