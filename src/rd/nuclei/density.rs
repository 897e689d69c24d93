//! How many spots there will be, and where they are densest.

use rayon::prelude::*;

use crate::grid::{Domain, Space};
use crate::rd::maps::{Maps, Parameters};
use crate::rd::nucleus::Nucleus;

/// The density of spots over a domain.
pub struct SpotDensity {
    /// Points a mean cell's area, by cell.
    pub densities: Vec<f64>,
    pub densest: f64,
    /// The farthest that a pitch reaches, cells.
    pub largest: f64,
}

impl SpotDensity {
    pub fn new<D: Domain>(maps: &Maps<D>, pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        let parts: Vec<(Vec<f64>, f64)> = maps
            .parameters
            .par_chunks(maps.domain.part())
            .map(|part| {
                let (mut before, mut here, mut largest) = (None, 0.0, 0.0f64);
                let densities = part
                    .iter()
                    .map(|p| {
                        // Mostly the same as beside it.
                        if before != Some(p) {
                            let pitch = pitch(p);
                            // A hexagonal lattice of pitch 1 has 2/√3 points a unit area.
                            here = 2.0 / (3.0f64.sqrt() * pitch * pitch);
                            largest = largest.max(1.05 * pitch / f64::from(p.stretch).sqrt());
                            before = Some(p);
                        }
                        here
                    })
                    .collect();
                (densities, largest)
            })
            .collect();
        let largest = parts.iter().map(|(_, largest)| *largest).fold(0.0, f64::max);
        let densities: Vec<f64> = parts.into_iter().flat_map(|(part, _)| part).collect();
        let densest = densities.iter().copied().fold(0.0, f64::max);
        Self { densities, densest, largest }
    }

    /// Points in all, those over the margin of `space` too: it is as crowded as the border beside it.
    pub fn wanted(&self, space: &impl Space) -> usize {
        space.integral(|cell| self.densities[cell]).round().max(1.0) as usize
    }

    /// Of these, as many as the `pinned` ones displace: one each, if they are like those around them.
    pub fn displaced_by<D: Domain>(&self, pinned: &[Nucleus<D::Place>], maps: &Maps<D>) -> usize {
        let rooms = pinned.iter().map(|pinned| {
            let [xx, xy, yy] = pinned.metric;
            0.75f64.sqrt() / (xx * yy - xy * xy).sqrt() * self.densities[maps.domain.cell_at(pinned.at)]
        });
        rooms.sum::<f64>().round() as usize
    }
}
