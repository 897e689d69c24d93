//! The data from which a system builds its initial concentrations.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::line_noise::GuideLine;
use super::maps::{GuideCurves, Maps, Parameters};
use super::nucleus::Nucleus;
use super::seeding::Seeding;

/// Initial marks of a growth.
pub struct Start<'a> {
    /// The seed of its random numbers.
    pub seed: u64,
    /// Where spots begin.
    pub nuclei: &'a [Nucleus],
    /// Lines along which stripes run.
    pub lines: &'a [GuideLine],
    /// Curves along which lines begin; `None` = everywhere.
    pub curves: Option<&'a GuideCurves>,
    /// What stripes begin from: noise, segments or lines.
    pub seeding: Seeding,
}

impl Start<'_> {
    /// Random numbers from its seed.
    #[must_use]
    pub fn random(&self) -> Pcg64Mcg {
        Pcg64Mcg::seed_from_u64(self.seed)
    }
}

/// The concentrations of `N` chemicals over the grid of `maps`: `fill` writes those of one row from its `values`, one for
/// each cell, and the parameters of its cells.
pub fn by_row<const N: usize>(
    maps: &Maps,
    values: &[f32],
    fill: impl Fn(&mut [&mut [f32]; N], &[f32], &[Parameters]) + Sync,
) -> Vec<Vec<f32>> {
    let mut cells = [(); N].map(|()| vec![0.0; values.len()]);
    let mut rows = cells.each_mut().map(|cells| cells.chunks_mut(maps.grid.size[0]));
    let tasks: Vec<[&mut [f32]; N]> =
        (0..maps.grid.size[1]).map(|_| rows.each_mut().map(|rows| rows.next().unwrap_or_default())).collect();
    let known = values.par_chunks(maps.grid.size[0]).zip(maps.parameters.par_chunks(maps.grid.size[0]));
    tasks.into_par_iter().zip(known).for_each(|(mut row, (values, parameters))| {
        fill(&mut row, values, parameters);
    });
    cells.into()
}
