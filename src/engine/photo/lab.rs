//! The working copy of a photograph: OKLab, with as few px as the marks need.

use rayon::prelude::*;

use super::Raster;
use crate::colour::{linear_light, oklab_of_light};

/// L, a and b of OKLab on a grid of cells of `factor` × `factor` px.
#[derive(Clone, Debug)]
pub struct Lab {
    /// Columns and rows.
    pub size: [usize; 2],
    /// px per cell along each side. px at the right and the lower border that do not fill a cell are left out.
    pub factor: usize,
    /// The three planes.
    pub planes: [Vec<f32>; 3],
}

impl Lab {
    /// The mean light of each cell, as OKLab.
    #[must_use]
    pub fn of(raster: &Raster, factor: usize) -> Self {
        let size = raster.size.map(|side| (side / factor).max(1));
        let block = [0, 1].map(|axis| factor.min(raster.size[axis]));
        let light = linear_light();
        let cells: Vec<[f32; 3]> = (0..size[0] * size[1])
            .into_par_iter()
            .with_min_len(size[0])
            .map(|cell| {
                let (x, y) = (cell % size[0] * factor, cell / size[0] * factor);
                let mut sum = [0.0; 3];
                for row in y..y + block[1] {
                    let start = 3 * (row * raster.size[0] + x);
                    for px in raster.rgb[start..start + 3 * block[0]].chunks_exact(3) {
                        (0..3).for_each(|k| sum[k] += light[usize::from(px[k])]);
                    }
                }
                let count = (block[0] * block[1]) as f32;
                oklab_of_light(sum.map(|sum: f32| sum / count))
            })
            .collect();
        Self { size, factor, planes: [0, 1, 2].map(|k| cells.iter().map(|cell| cell[k]).collect()) }
    }

    /// L, a, b of a cell.
    #[must_use]
    pub fn at(&self, cell: usize) -> [f32; 3] {
        [0, 1, 2].map(|k| self.planes[k][cell])
    }
}
