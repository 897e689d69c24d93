//! Points on a domain without a border, for any [`Domain`].

use std::convert::Infallible;
use std::ops::Range;

use rand::{Rng, RngExt};

use super::domain::Domain;
use super::space::{Buckets, Space, Wall};

/// A domain without a border: there is no margin around it.
pub struct Borderless<'a, D: ?Sized> {
    domain: &'a D,
    /// Area of the cells up to and with each.
    areas: Vec<f64>,
}

impl<'a, D: Domain + ?Sized> Borderless<'a, D> {
    /// The whole of `domain`, which has at least one cell.
    pub fn new(domain: &'a D) -> Self {
        let mut sum = 0.0;
        let sums = (0..domain.cells()).map(|cell| {
            sum += domain.area(cell);
            sum
        });
        Self { domain, areas: sums.collect() }
    }

    fn area(&self) -> f64 {
        self.areas.last().copied().unwrap_or(0.0)
    }
}

/// A domain without a border has no walls.
impl<P> Wall<P> for Infallible {
    fn depth(&self, _: P) -> f64 {
        match *self {}
    }

    fn inward(&self, _: P) -> [f64; 2] {
        match *self {}
    }

    fn at_depth(&self, _: P, _: f64) -> P {
        match *self {}
    }

    fn faces(&self, _: &Self) -> bool {
        match *self {}
    }
}

impl<D: Domain + ?Sized> Space for Borderless<'_, D> {
    type Place = D::Place;
    type Wall = Infallible;

    fn to_space(&self, place: D::Place) -> D::Place {
        place
    }

    fn to_domain(&self, place: D::Place) -> D::Place {
        place
    }

    fn is_inside(&self, _: D::Place) -> bool {
        true
    }

    fn covers(&self, _: D::Place) -> bool {
        true
    }

    fn moved(&self, from: D::Place, displacement: [f64; 2]) -> D::Place {
        self.domain.moved(from, displacement)
    }

    fn points(&self, density: f64) -> f64 {
        density * self.area()
    }

    fn integral(&self, density: impl Fn(usize) -> f64) -> f64 {
        (0..self.cells()).map(|cell| density(cell) * self.domain.area(cell)).sum()
    }

    fn random(&self, rng: &mut impl Rng) -> D::Place {
        let area = rng.random::<f64>() * self.area();
        let cell = self.areas.partition_point(|sum| *sum <= area).min(self.areas.len() - 1);
        self.place_in(cell, [rng.random(), rng.random()])
    }

    fn cells(&self) -> usize {
        self.areas.len()
    }

    fn place_in(&self, cell: usize, at: [f64; 2]) -> D::Place {
        self.domain.place_in(cell, at)
    }

    fn walls(&self) -> Vec<Infallible> {
        Vec::new()
    }

    fn buckets(&self, side: f64) -> impl Buckets<Place = D::Place> {
        self.domain.buckets(side)
    }
}

/// Buckets that are the cells of a domain.
pub struct CellBuckets<'a, D: ?Sized> {
    domain: &'a D,
}

impl<'a, D: ?Sized> CellBuckets<'a, D> {
    /// One bucket a cell.
    pub fn new(domain: &'a D) -> Self {
        Self { domain }
    }
}

impl<D: ?Sized> Clone for CellBuckets<'_, D> {
    fn clone(&self) -> Self {
        Self { domain: self.domain }
    }
}

/// How far places of a cell may lie from its centre, in mean sides: .71 in a square of mean area, twice that in one that
/// is larger or longer.
const FARTHEST_IN_CELL: f64 = 1.5;

impl<D: Domain + ?Sized> Buckets for CellBuckets<'_, D> {
    type Place = D::Place;

    fn count(&self) -> usize {
        self.domain.cells()
    }

    fn bucket(&self, place: D::Place) -> usize {
        self.domain.cell_at(place)
    }

    fn near(
        &self,
        place: D::Place,
        reach: f64,
    ) -> impl Iterator<Item = (Range<usize>, impl Fn(D::Place) -> Option<[f64; 2]>)> {
        let cells = self.domain.near(place, reach + FARTHEST_IN_CELL, 0..self.domain.cells());
        let mut cells: Vec<usize> = cells.map(|(cell, _)| cell).collect();
        cells.sort_unstable();
        cells.dedup();
        let displacement = move |other: D::Place| {
            let displacement = self.domain.displacement(place, other);
            let near = displacement != [0.0; 2] && displacement.iter().all(|part| part.abs() <= reach);
            near.then_some(displacement)
        };
        cells.into_iter().map(move |cell| (cell..cell + 1, displacement))
    }

    fn is_to_image(&self, _: D::Place, _: D::Place, _: [f64; 2]) -> bool {
        false
    }

    fn transport_angle(&self, from: usize, to: usize) -> f64 {
        self.domain.transport_angle(from, to)
    }
}
