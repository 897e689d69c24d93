//! For tests: a sphere, whose cells differ in area and whose frames turn from cell to cell.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use super::borderless::{Borderless, CellBuckets};
use super::domain::Domain;
use super::space::{Buckets, Space};

/// A sphere cut along meridians and parallels. Places are unit vectors; the axes of a frame run east and north.
#[derive(Clone, Debug)]
pub struct Sphere {
    /// Cells along each parallel, and parallels.
    pub size: [usize; 2],
}

type Vector = [f64; 3];

fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

impl Sphere {
    /// The radius, so that the mean cell has an area of 1.
    pub fn radius(&self) -> f64 {
        (self.cells() as f64 / (4.0 * PI)).sqrt()
    }

    /// Geodesic distance of two places.
    pub fn distance(&self, a: Vector, b: Vector) -> f64 {
        self.radius() * dot(a, b).clamp(-1.0, 1.0).acos()
    }

    /// East and north at a place.
    fn axes([x, y, z]: Vector) -> [Vector; 2] {
        let across = (x * x + y * y).sqrt();
        let [cos, sin] = [x / across, y / across];
        [[-sin, cos, 0.0], [-z * cos, -z * sin, across]]
    }
}

impl Domain for Sphere {
    type Place = Vector;

    fn cells(&self) -> usize {
        self.size[0] * self.size[1]
    }

    fn center(&self, cell: usize) -> Vector {
        let [nx, ny] = self.size.map(|n| n as f64);
        let longitude = ((cell % self.size[0]) as f64 + 0.5) / nx * TAU;
        let latitude = ((cell / self.size[0]) as f64 + 0.5) / ny * PI - 0.5 * PI;
        let (sin, cos) = latitude.sin_cos();
        [cos * longitude.cos(), cos * longitude.sin(), sin]
    }

    fn cell_at(&self, [x, y, z]: Vector) -> usize {
        let [nx, ny] = self.size;
        let column = (y.atan2(x).rem_euclid(TAU) / TAU * nx as f64) as usize;
        let row = ((z.clamp(-1.0, 1.0).asin() / PI + 0.5) * ny as f64) as usize;
        row.min(ny - 1) * nx + column.min(nx - 1)
    }

    fn area(&self, cell: usize) -> f64 {
        let ny = self.size[1] as f64;
        let parallel = |row: usize| (row as f64 / ny * PI - 0.5 * PI).sin();
        let row = cell / self.size[0];
        0.5 * ny * (parallel(row + 1) - parallel(row))
    }

    fn displacement(&self, from: Vector, to: Vector) -> [f64; 2] {
        let along = Self::axes(from).map(|axis| dot(axis, to));
        let length = (along[0] * along[0] + along[1] * along[1]).sqrt();
        let angle = length.atan2(dot(from, to));
        along.map(|part| if length > 0.0 { self.radius() * angle * part / length } else { 0.0 })
    }

    fn moved(&self, from: Vector, displacement: [f64; 2]) -> Vector {
        let length = (displacement[0] * displacement[0] + displacement[1] * displacement[1]).sqrt();
        if length == 0.0 {
            return from;
        }
        let (sin, cos) = (length / self.radius()).sin_cos();
        let [east, north] = Self::axes(from);
        [0, 1, 2]
            .map(|i| cos * from[i] + sin * (displacement[0] * east[i] + displacement[1] * north[i]) / length)
    }

    fn transport_angle(&self, from: usize, to: usize) -> f64 {
        if from == to {
            return 0.0;
        }
        let [from, to] = [from, to].map(|cell| self.center(cell));
        let ([x, y], [back_x, back_y]) = (self.displacement(from, to), self.displacement(to, from));
        ((-back_y).atan2(-back_x) - y.atan2(x)).to_degrees()
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        let [nx, ny] = self.size;
        let (column, row) = (cell % nx, cell / nx);
        let rows = row.saturating_sub(1)..(row + 2).min(ny);
        let around = rows.flat_map(move |y| [nx - 1, 0, 1].map(|x| y * nx + (column + x) % nx));
        around.filter(move |other| *other != cell)
    }

    fn near(
        &self,
        place: Vector,
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])> {
        let ways = among.map(move |cell| (cell, self.displacement(place, self.center(cell))));
        ways.filter(move |(_, [x, y])| x * x + y * y <= reach * reach)
    }

    fn space(&self, _: f64) -> impl Space<Place = Vector> {
        Borderless::new(self)
    }

    fn buckets(&self, _: f64) -> impl Buckets<Place = Vector> {
        CellBuckets::new(self)
    }
}
