//! The Laplacians that a system spreads by on a surface.

use super::slices::{Slices, order};
use super::sparse_rows::SparseRows;
use crate::rd::definition::System;
use crate::rd::kinetics::Spreading;
use crate::rd::maps::Parameters;
use crate::surface::{Laplacian, Mesh, Stretch, laplacian};

/// The Laplacians of one system on one surface, for given stretches and directions. Growths with other rates and ratios can use the
/// same.
#[derive(Clone, Debug)]
pub struct Operators {
    /// Where each row comes from (`order[row] = vertex`).
    pub(super) order: Vec<u32>,
    /// One a tensor, then that of isotropic diffusion if the system needs it.
    pub(super) rows: Vec<SparseRows>,
    /// The same in slices.
    pub(super) slices: Vec<Slices>,
}

impl Operators {
    /// Those of `mesh` with the parameters of each vertex, whose directions are given in its frame (`frames`, unit vectors along both axes).
    ///
    /// # Panics
    /// Where there is not one frame and one set of parameters for each vertex.
    #[must_use]
    pub fn new(system: System, mesh: &Mesh, frames: &[[[f64; 3]; 2]], parameters: &[Parameters]) -> Self {
        assert!(
            [frames.len(), parameters.len()] == [mesh.positions.len(); 2],
            "one frame and one set a vertex"
        );
        let definition = system.definition();
        let of_tensor = |axes: &fn(&Parameters) -> _| {
            let axes = parameters.iter().map(axes);
            // What is more than determinant 1 is a factor of the whole row, as on a grid.
            let (stretch, factors): (Vec<Stretch>, Vec<f64>) =
                axes.map(crate::rd::selling::PrincipalAxes::parted).unzip();
            (laplacian(mesh, frames, &stretch), factors)
        };
        let mut laplacians: Vec<(Laplacian, Vec<f64>)> = definition.tensors.iter().map(of_tensor).collect();
        if definition.spread.iter().any(|spreading| matches!(spreading, Spreading::Isotropic { .. })) {
            let same = vec![Stretch::NONE; parameters.len()];
            laplacians.push((laplacian(mesh, frames, &same), vec![1.0; parameters.len()]));
        }
        Self::of(&laplacians, mesh.area() / mesh.positions.len().max(1) as f64)
    }

    /// Those of given Laplacians, each with a factor for each row, and the area of a mean cell.
    #[must_use]
    pub fn of(laplacians: &[(Laplacian, Vec<f64>)], cell: f64) -> Self {
        let order = laplacians.first().map_or_else(Vec::new, |(laplacian, _)| order(laplacian));
        let rows: Vec<SparseRows> = laplacians
            .iter()
            .map(|(laplacian, factors)| SparseRows::new(laplacian, &order, cell, |row| factors[row]))
            .collect();
        Self { slices: rows.iter().map(Slices::new).collect(), rows, order }
    }

    /// Number of vertices.
    #[must_use]
    pub fn vertices(&self) -> usize {
        self.order.len()
    }
}
