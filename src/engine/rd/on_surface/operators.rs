//! The Laplacians that a system spreads by on a surface.

use crate::rd::definition::System;
use crate::rd::kinetics::Spreading;
use crate::rd::parameter_field::Parameters;
use crate::rd::selling::PrincipalAxes;
use crate::rd::sparse::Operators;
use crate::surface::{Laplacian, Mesh, Stretch, laplacian};

impl Operators {
    /// The operators of `mesh` with the parameters of each vertex, whose directions are given in its frame (`frames`, unit
    /// vectors along both axes).
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
            let (stretch, factors): (Vec<Stretch>, Vec<f64>) = axes.map(PrincipalAxes::parted).unzip();
            (laplacian(mesh, frames, &stretch), factors)
        };
        let mut laplacians: Vec<(Laplacian, Vec<f64>)> = definition.tensors.iter().map(of_tensor).collect();
        if definition.spread.iter().any(|spreading| matches!(spreading, Spreading::Isotropic { .. })) {
            let same = vec![Stretch::NONE; parameters.len()];
            laplacians.push((laplacian(mesh, frames, &same), vec![1.0; parameters.len()]));
        }
        Self::of(&laplacians, mesh.area() / mesh.positions.len().max(1) as f64)
    }

    /// Whether there are as many as a system spreads by.
    pub(super) fn fit(&self, system: System) -> bool {
        let definition = system.definition();
        let isotropic =
            definition.spread.iter().any(|spreading| matches!(spreading, Spreading::Isotropic { .. }));
        self.rows.len() == definition.tensors.len() + usize::from(isotropic)
    }
}
