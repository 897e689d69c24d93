//! The data from which a system builds its initial concentrations.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::line_noise::GuideLine;
use super::parameter_field::{GuideCurves, ParameterField, Parameters};
use super::seeding::Seeding;
use crate::attributes::Polarity;
use crate::grid::Domain;

/// Initial marks of stripes and lines.
pub struct Start<'a> {
    /// The seed of its random numbers.
    pub seed: u64,
    /// Lines along which stripes run.
    pub lines: &'a [GuideLine],
    /// Curves along which lines begin; `None` = everywhere.
    pub curves: Option<&'a GuideCurves>,
    /// Initial state of stripes: noise, segments or lines.
    pub seeding: Seeding,
    /// Whether the marks run along `lines`, or between them.
    pub polarity: Polarity,
}

impl Start<'_> {
    /// Random numbers from its seed.
    #[must_use]
    pub fn random(&self) -> Pcg64Mcg {
        Pcg64Mcg::seed_from_u64(self.seed)
    }
}

/// The concentrations of `chemicals` chemicals over the cells of `maps`. `fill` writes the concentrations of some consecutive
/// cells, one slice a chemical, from their `values`, one a cell, and their parameters.
pub fn by_cell<D: Domain>(
    maps: &ParameterField<D>,
    chemicals: usize,
    values: &[f32],
    fill: impl Fn(&mut [&mut [f32]], &[f32], &[Parameters]) + Sync,
) -> Vec<Vec<f32>> {
    let part = maps.domain.part();
    let mut cells = vec![vec![0.0; values.len()]; chemicals];
    let mut parts: Vec<_> = cells.iter_mut().map(|cells| cells.chunks_mut(part)).collect();
    let tasks: Vec<Vec<&mut [f32]>> = (0..values.len().div_ceil(part))
        .map(|_| parts.iter_mut().filter_map(Iterator::next).collect())
        .collect();
    let known = values.par_chunks(part).zip(maps.parameters.par_chunks(part));
    tasks.into_par_iter().zip(known).for_each(|(mut part, (values, parameters))| {
        fill(&mut part, values, parameters);
    });
    cells
}
