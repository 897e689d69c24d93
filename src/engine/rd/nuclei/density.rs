//! Number and density of spots.

use multiversion::multiversion;
use rayon::prelude::*;

use crate::grid::{Domain, Space};
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::{ParameterField, Parameters};

/// The density of spots over a domain.
pub struct SpotDensity {
    /// Points per mean cell area, by cell.
    pub densities: Vec<f64>,
    pub densest: f64,
    /// The longest reach of a pitch, cells.
    pub largest: f64,
}

/// Cells that are computed side by side. Not tuned.
const TOGETHER: usize = 64;
/// Maxima that are kept side by side.
const MAXIMA: usize = 8;

/// Writes the densities of cells with these pitches. Returns the largest density, and the largest squared reach of a pitch ÷ 1.05.
#[multiversion(targets("x86_64+avx2"))]
fn side_by_side(pitches: &[f64], stretches: &[f64], densities: &mut [f64]) -> [f64; 2] {
    let [mut densest, mut largest] = [[0.0f64; MAXIMA]; 2];
    let some = densities.chunks_mut(MAXIMA).zip(pitches.chunks(MAXIMA)).zip(stretches.chunks(MAXIMA));
    for ((densities, pitches), stretches) in some {
        let maxima = densest.iter_mut().zip(&mut largest);
        for (((density, pitch), stretch), (densest, largest)) in
            densities.iter_mut().zip(pitches).zip(stretches).zip(maxima)
        {
            let square = pitch * pitch;
            *density = density_of(*pitch);
            *densest = densest.max(*density);
            *largest = largest.max(square / stretch);
        }
    }
    [densest, largest].map(|maxima| maxima.into_iter().fold(0.0, f64::max))
}

/// Points per mean cell area if neighbours are this far apart, cells: a hexagonal lattice of pitch 1 has 2/√3 points per unit area.
#[inline(always)]
pub fn density_of(pitch: f64) -> f64 {
    2.0 / (3.0f64.sqrt() * (pitch * pitch))
}

impl SpotDensity {
    pub fn new<D: Domain>(maps: &ParameterField<D>, pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        let part = maps.domain.part();
        let mut densities = vec![0.0; maps.parameters.len()];
        let parts = densities.par_chunks_mut(part).zip(maps.parameters.par_chunks(part));
        let extremes: Vec<[f64; 2]> = parts
            .map(|(densities, parameters)| {
                let mut extremes = [0.0; 2];
                let (mut before, mut here) = (None, 0.0);
                let some = densities.chunks_mut(TOGETHER).zip(parameters.chunks(TOGETHER));
                for (densities, parameters) in some {
                    let [mut pitches, mut stretches] = [[1.0; TOGETHER]; 2];
                    for (k, p) in parameters.iter().enumerate() {
                        // Neighbours mostly have equal parameters.
                        if before != Some(p) {
                            (before, here) = (Some(p), pitch(p));
                        }
                        (pitches[k], stretches[k]) = (here, f64::from(p.stretch));
                    }
                    let found = side_by_side(&pitches[..parameters.len()], &stretches, densities);
                    extremes = [0, 1].map(|k| f64::max(extremes[k], found[k]));
                }
                extremes
            })
            .collect();
        let [densest, largest] =
            extremes.iter().fold([0.0; 2], |sum: [f64; 2], one| [0, 1].map(|k| sum[k].max(one[k])));
        Self { densities, densest, largest: 1.05 * largest.sqrt() }
    }

    /// Number of points, including those over the margin of `space`, which is as dense as the border beside it.
    pub fn wanted(&self, space: &impl Space) -> usize {
        space.integral(|cell| self.densities[cell]).round().max(1.0) as usize
    }

    /// Number of points that the `pinned` ones displace: one for each, if it is like the points around it.
    pub fn displaced_by<D: Domain>(&self, pinned: &[Nucleus<D::Place>], maps: &ParameterField<D>) -> usize {
        let rooms = pinned.iter().map(|pinned| {
            let [xx, xy, yy] = pinned.metric;
            0.75f64.sqrt() / (xx * yy - xy * xy).sqrt() * self.densities[maps.domain.cell_at(pinned.at)]
        });
        rooms.sum::<f64>().round() as usize
    }
}
