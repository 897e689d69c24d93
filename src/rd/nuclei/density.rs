//! How many spots there will be, and where they are densest.

use rayon::prelude::*;

use crate::grid::Domain;
use crate::rd::maps::{Maps, Parameters};
use crate::rd::nucleus::Nucleus;

/// The density of spots over the grid.
pub struct SpotDensity {
    /// Points a cell, by cell.
    pub densities: Vec<f64>,
    /// Cells in a row.
    pub columns: usize,
    pub densest: f64,
    /// The farthest that a pitch reaches, cells.
    pub largest: f64,
}

impl SpotDensity {
    pub fn new(maps: &Maps, pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        let rows: Vec<(Vec<f64>, f64)> = maps
            .parameters
            .par_chunks(maps.grid.size[0])
            .map(|row| {
                let (mut before, mut here, mut largest) = (None, 0.0, 0.0f64);
                let densities = row
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
        let largest = rows.iter().map(|(_, largest)| *largest).fold(0.0, f64::max);
        let densities: Vec<f64> = rows.into_iter().flat_map(|(row, _)| row).collect();
        let densest = densities.iter().copied().fold(0.0, f64::max);
        Self { densities, columns: maps.grid.size[0], densest, largest }
    }

    /// Points in all, those over a frame of so many cells too: it is as crowded as the border beside it.
    pub fn wanted(&self, frame: f64) -> usize {
        let row = |row: &[f64]| {
            let ends = row.first().zip(row.last()).map_or(0.0, |(first, last)| first + last);
            row.iter().sum::<f64>() + frame * ends
        };
        let mut rows = self.densities.chunks_exact(self.columns);
        let ends = rows.clone().next().zip(rows.clone().next_back());
        let ends = ends.map_or(0.0, |(first, last)| row(first) + row(last));
        (rows.by_ref().map(row).sum::<f64>() + frame * ends).round().max(1.0) as usize
    }

    /// Of these, as many as the `pinned` ones displace: one each, if they are like those around them.
    pub fn displaced_by(&self, pinned: &[Nucleus], maps: &Maps) -> usize {
        let rooms = pinned.iter().map(|pinned| {
            let [xx, xy, yy] = pinned.metric;
            0.75f64.sqrt() / (xx * yy - xy * xy).sqrt() * self.densities[maps.grid.cell_at(pinned.at)]
        });
        rooms.sum::<f64>().round() as usize
    }
}
