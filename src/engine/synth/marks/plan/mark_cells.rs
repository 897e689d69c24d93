//! Number of cells of the grid that resolve a mark.

use rayon::prelude::*;

use crate::rd::{ParameterField, Parameters, System};

/// The part of the cells of a mark that resolves it.
#[must_use]
pub fn resolving_cells(system: System, p: &Parameters) -> f64 {
    let cells = system.cells(p);
    if system.definition().resolution.thin_side { cells * f64::from(p.stretch) } else { cells }
}

/// The cells that resolve the largest mark.
#[must_use]
pub fn largest_mark(system: System, maps: &ParameterField) -> f64 {
    maps.parameters.par_iter().map(|p| resolving_cells(system, p)).reduce(|| 0.0, f64::max)
}
