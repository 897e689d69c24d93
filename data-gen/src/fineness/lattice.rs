//! A plane of nearly regular triangles that is periodic at its borders, as a mesh without a border.

use std::ops::Range;

use dapple_engine::grid::{Borderless, Buckets, CellBuckets, Domain, Space};
use dapple_engine::surface::{Laplacian, Mesh, Triangulation, edges, laplacian_of_lengths};

/// A periodic square whose area equals its number of vertices. Places are [x, y].
#[derive(Clone, Copy, Debug)]
pub struct Lattice {
    /// Vertices along a row, and rows, an even number.
    size: [usize; 2],
    /// The side of the square.
    pub side: f64,
}

impl Lattice {
    /// A lattice whose side is about `side`.
    pub fn new(side: f64) -> Self {
        // The side of a regular triangle whose area is ½, and its height.
        let edge = (2.0 / 3.0f64.sqrt()).sqrt();
        let columns = (side / edge).round().max(3.0) as usize;
        let rows = 2 * (0.5 * side / (0.75f64.sqrt() * edge)).round().max(2.0) as usize;
        Self { size: [columns, rows], side: ((columns * rows) as f64).sqrt() }
    }

    /// Distance of vertices along a row, and of rows.
    fn steps(&self) -> [f64; 2] {
        self.size.map(|n| self.side / n as f64)
    }

    /// The vertex in a column and a row, which may be outside the square.
    fn vertex(&self, column: isize, row: isize) -> usize {
        let [columns, rows] = self.size.map(|n| n as isize);
        (row.rem_euclid(rows) * columns + column.rem_euclid(columns)) as usize
    }

    /// Its triangles.
    pub fn faces(&self) -> Vec<[u32; 3]> {
        let [columns, rows] = self.size.map(|n| n as isize);
        let square = |x: isize, y: isize| {
            let [a, b, c, d] = [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]]
                .map(|[column, row]| self.vertex(column, row) as u32);
            // Odd rows are half a step to the right.
            if y % 2 == 0 { [[a, b, c], [b, d, c]] } else { [[a, b, d], [a, d, c]] }
        };
        (0..columns * rows).flat_map(|i| square(i % columns, i / columns)).collect()
    }

    /// A flat mesh of the lattice with a frame of periodic copies of this width around it, and for each of its vertices
    /// the vertex of the lattice. y runs away from the viewer, so that frames turn as on a canvas.
    pub fn unrolled(&self, frame: f64) -> (Mesh, Vec<usize>) {
        let steps = self.steps();
        // An even number of rows, because every other row is shifted by half a step.
        let more = steps.map(|step| 2 * (0.5 * frame / step).ceil() as isize);
        let [wide, high] = [0, 1].map(|axis| self.size[axis] as isize + 2 * more[axis]);
        let mut mesh = Mesh { positions: Vec::new(), faces: Vec::new() };
        let mut vertices = Vec::new();
        for row in 0..high {
            for column in 0..wide {
                let [x, y] = [column - more[0], row - more[1]];
                let shift = if y.rem_euclid(2) == 1 { 0.5 } else { 0.0 };
                mesh.positions.push([(x as f64 + 0.5 + shift) * steps[0], (y as f64 + 0.5) * steps[1], 0.0]);
                vertices.push(self.vertex(x, y));
            }
        }
        let at = |column: isize, row: isize| (row * wide + column) as u32;
        for row in 0..high - 1 {
            for column in 0..wide - 1 {
                let [a, b, c, d] =
                    [at(column, row), at(column + 1, row), at(column, row + 1), at(column + 1, row + 1)];
                let is_odd = (row - more[1]).rem_euclid(2) == 1;
                mesh.faces.extend(if is_odd { [[a, b, d], [a, d, c]] } else { [[a, b, c], [b, d, c]] });
            }
        }
        (mesh, vertices)
    }

    /// The Laplacian of the lattice with a constant stretch: `ratio` across the direction `degrees`.
    pub fn laplacian(&self, ratio: f64, degrees: f64) -> Laplacian {
        let faces = self.faces();
        let (ends, sides) = edges(&faces);
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let length = |[a, b]: &[u32; 2]| {
            let [x, y] = self.displacement(self.center(*a as usize), self.center(*b as usize));
            let (along, across) = (cos * x + sin * y, cos * y - sin * x);
            (ratio * along * along + across * across / ratio).sqrt()
        };
        let lengths = ends.iter().map(length).collect();
        laplacian_of_lengths(Triangulation::new(faces, sides, lengths), &vec![ratio; self.cells()])
    }
}

impl Domain for Lattice {
    type Place = [f64; 2];

    fn cells(&self) -> usize {
        self.size[0] * self.size[1]
    }

    fn center(&self, cell: usize) -> [f64; 2] {
        let (row, [along, down]) = (cell / self.size[0], self.steps());
        [((cell % self.size[0]) as f64 + 0.5 * (row % 2) as f64) * along, row as f64 * down]
    }

    fn cell_at(&self, place: [f64; 2]) -> usize {
        let squared = |[x, y]: [f64; 2]| x * x + y * y;
        let near = self.near(place, 1.1, 0..self.cells());
        let nearest = near.min_by(|(_, a), (_, b)| squared(*a).total_cmp(&squared(*b)));
        nearest.map_or(0, |(cell, _)| cell)
    }

    fn area(&self, _: usize) -> f64 {
        1.0
    }

    fn displacement(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| {
            let displacement = to[axis] - from[axis];
            displacement - self.side * (displacement / self.side).round()
        })
    }

    fn moved(&self, from: [f64; 2], displacement: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (from[axis] + displacement[axis]).rem_euclid(self.side))
    }

    fn transport_angle(&self, _: usize, _: usize) -> f64 {
        0.0
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        self.near(self.center(cell), 1.3, 0..self.cells())
            .map(|(other, _)| other)
            .filter(move |other| *other != cell)
    }

    fn near(
        &self,
        place: [f64; 2],
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])> {
        let [along, down] = self.steps();
        let rows = ((place[1] - reach) / down).ceil() as isize..=((place[1] + reach) / down).floor() as isize;
        let ways = rows.flat_map(move |row| {
            let shift = 0.5 * row.rem_euclid(2) as f64;
            let y = row as f64 * down - place[1];
            let half = (reach * reach - y * y).max(0.0).sqrt();
            let columns = ((place[0] - half) / along - shift).ceil() as isize
                ..=((place[0] + half) / along - shift).floor() as isize;
            columns.map(move |column| {
                (self.vertex(column, row), [(column as f64 + shift) * along - place[0], y])
            })
        });
        ways.filter(move |(cell, _)| among.contains(cell))
    }

    fn space(&self, _: f64) -> impl Space<Place = [f64; 2]> {
        Borderless::new(self)
    }

    fn buckets(&self, _: f64) -> impl Buckets<Place = [f64; 2]> {
        CellBuckets::new(self)
    }
}
