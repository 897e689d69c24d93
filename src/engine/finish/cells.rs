//! Irregular cells: the regions nearest to scattered points, one point in each cell of a lattice that repeats with the canvas.
//!
//! S. Worley, "A cellular texture basis function", SIGGRAPH 1996.

use super::noise::{Random, floor, whole_cells, wrapped};

/// Scattered points, one a cell of a lattice.
#[derive(Clone, Debug)]
pub struct Cells {
    cells: [usize; 2],
    /// Width and height of a cell of the lattice, px.
    cell: [f32; 2],
    /// Place of each point in its cell, 0..1, and a random number of it.
    points: Vec<[f32; 3]>,
}

/// The cell that holds a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// From the place to its point, px.
    pub to_point: [f32; 2],
    /// Distance of the nearest edge of the cell, px.
    pub edge: f32,
    /// A random number of the cell, 0..1.
    pub random: f32,
}

impl Cells {
    /// Cells about `size` px wide; a `jitter` of 0 makes them square, of 1 irregular.
    #[must_use]
    pub fn new(canvas: [f32; 2], size: f32, jitter: f32, seed: u32) -> Self {
        let cells = whole_cells(canvas, size);
        let point = |index: usize| {
            let place = [index % cells[0], index / cells[0]];
            let mut random = Random::of(seed, place.map(|place| place as u32));
            // Rows are offset by half a cell, so that regular cells are hexagons.
            let offset = if cells[1].is_multiple_of(2) && place[1] % 2 == 1 { 0.5 } else { 0.0 };
            [
                offset + 0.25 + 0.5 * jitter * random.signed(),
                0.5 + 0.5 * jitter * random.signed(),
                random.number(),
            ]
        };
        Self {
            cells,
            cell: [0, 1].map(|axis| canvas[axis] / cells[axis] as f32),
            points: (0..cells[0] * cells[1]).map(point).collect(),
        }
    }

    /// The cell at a point of the canvas, px.
    #[inline]
    #[must_use]
    pub fn at(&self, point: [f32; 2]) -> Cell {
        let place = [0, 1].map(|axis| point[axis] / self.cell[axis]);
        let base = place.map(floor);
        let mut first = (f32::INFINITY, [0.0; 2], 0.0);
        let mut second = (f32::INFINITY, [0.0; 2]);
        for j in -1..=1 {
            let row = wrapped(base[1] + j, self.cells[1]) * self.cells[0];
            for i in -2..=1 {
                let [x, y, random] = self.points[row + wrapped(base[0] + i, self.cells[0])];
                let to_point = [
                    ((base[0] + i) as f32 + x - place[0]) * self.cell[0],
                    ((base[1] + j) as f32 + y - place[1]) * self.cell[1],
                ];
                let squared = to_point[0] * to_point[0] + to_point[1] * to_point[1];
                if squared < first.0 {
                    second = (first.0, first.1);
                    first = (squared, to_point, random);
                } else if squared < second.0 {
                    second = (squared, to_point);
                }
            }
        }
        let apart = [second.1[0] - first.1[0], second.1[1] - first.1[1]];
        let length = (apart[0] * apart[0] + apart[1] * apart[1]).sqrt().max(1e-6);
        Cell { to_point: first.1, edge: 0.5 * (second.0 - first.0) / length, random: first.2 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_place_is_in_the_cell_of_the_nearest_point_also_across_the_border() {
        let canvas = [60.0, 40.0];
        let cells = Cells::new(canvas, 5.0, 0.9, 4);
        let all: Vec<[f32; 2]> = (0..cells.points.len())
            .map(|index| {
                let [x, y, _] = cells.points[index];
                let place = [index % cells.cells[0], index / cells.cells[0]];
                [(place[0] as f32 + x) * cells.cell[0], (place[1] as f32 + y) * cells.cell[1]]
            })
            .collect();
        for k in 0..400 {
            let point = [(k * 7 % 60) as f32 + 0.3, (k * 11 % 40) as f32 + 0.8];
            let distance = |other: &[f32; 2]| {
                let along = |axis: usize| {
                    let apart = (other[axis] - point[axis]).rem_euclid(canvas[axis]);
                    apart.min(canvas[axis] - apart)
                };
                (along(0) * along(0) + along(1) * along(1)).sqrt()
            };
            let nearest = all.iter().map(distance).fold(f32::INFINITY, f32::min);
            let [x, y] = cells.at(point).to_point;
            assert!(((x * x + y * y).sqrt() - nearest).abs() < 1e-3, "{point:?}");
        }
    }
}
