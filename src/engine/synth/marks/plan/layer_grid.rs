//! The grid of a layer: so fine that its smallest marks have the cells that their system needs.

use crate::attributes::{AttributeMap, Attributes, Polarity};
use crate::grid::Grid;
use crate::rd::System;
use crate::synth::marks::plan::cell_size::cell_for;

/// Factor of the cell size if the lines that grow are the gaps between wide stripes: the error of width of a line of three cells is
/// a small share of the width of a stripe. Of 42 sketches the longest growth takes 16 s instead of 66 s, and the widths of stripes
/// are as accurate as before; with a factor of 2 the largest errors grow by a third.
const GAP_CELLS: f64 = 1.5;

/// px a cell that suits the finest marks of `map`; no spacing of `map` may be free.
#[must_use]
pub fn finest_cell((system, polarity): (System, Polarity), map: &AttributeMap) -> f64 {
    let coarser = if polarity == Polarity::Negative { GAP_CELLS } else { 1.0 };
    let cell = |wanted: &Attributes| coarser * cell_for(system, &polarity.lines(wanted));
    map.samples().iter().map(cell).fold(f64::INFINITY, f64::min)
}

/// The grid over the canvas of `map` whose cells are about `cell` px wide.
#[must_use]
pub fn grid_of(map: &AttributeMap, cell: f64) -> Grid {
    let layout = map.layout();
    let size = layout.size.map(|side| ((side / cell).round() as usize).max(8));
    let exact = [0, 1].map(|axis| layout.size[axis] / size[axis] as f64);
    Grid { size, cell: exact, edges: layout.edges }
}
