//! For tests: a grid whose cells have other numbers, and frames of their own.

use std::ops::Range;

use rand::{Rng, SeedableRng, seq::SliceRandom};
use rand_pcg::Pcg64Mcg;

use super::cells::Grid;
use super::domain::{Domain, turned};
use super::framed::{Framed, Rectangles, Side};
use super::space::{Buckets, Space, Wall};

/// A grid that does not show that it is one.
#[derive(Clone, Debug)]
pub struct Relabelled {
    grid: Grid,
    /// The grid's number of each cell.
    pub old: Vec<usize>,
    /// The number of each cell of the grid.
    pub new: Vec<usize>,
    /// Degrees from +x to the first axis of the frame of each cell.
    pub frames: Vec<f64>,
}

/// A point on it, cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point(pub [f64; 2]);

impl Relabelled {
    /// `grid` with shuffled numbers, those of the cells of `mask` in the same order, and the frame of each cell turned
    /// by `frame` of its number.
    pub fn new(grid: Grid, mask: &[bool], frame: impl Fn(usize) -> f64) -> Self {
        let mut old: Vec<usize> = (0..grid.cells()).collect();
        old.shuffle(&mut Pcg64Mcg::seed_from_u64(7));
        let masked = |cell: &usize| mask.get(*cell).copied().unwrap_or(false);
        let mut ordered = (0..grid.cells()).filter(|cell| masked(cell));
        old.iter_mut().filter(|cell| masked(cell)).for_each(|cell| *cell = ordered.next().expect("as many"));
        let mut new = vec![0; old.len()];
        old.iter().enumerate().for_each(|(number, cell)| new[*cell] = number);
        let frames = (0..old.len()).map(frame).collect();
        Self { grid, old, new, frames }
    }

    /// Values by cell of the grid, by cell of this.
    pub fn renumbered<T: Copy>(&self, values: &[T]) -> Vec<T> {
        self.old.iter().filter_map(|cell| values.get(*cell).copied()).collect()
    }

    fn frame(&self, place: Point) -> f64 {
        self.frames[self.cell_at(place)]
    }
}

impl Domain for Relabelled {
    type Place = Point;

    fn cells(&self) -> usize {
        self.grid.cells()
    }

    fn center(&self, cell: usize) -> Point {
        Point(self.grid.center(self.old[cell]))
    }

    fn cell_at(&self, place: Point) -> usize {
        self.new[self.grid.cell_at(place.0)]
    }

    fn area(&self, _: usize) -> f64 {
        1.0
    }

    fn displacement(&self, from: Point, to: Point) -> [f64; 2] {
        turned(self.grid.displacement(from.0, to.0), -self.frame(from))
    }

    fn moved(&self, from: Point, displacement: [f64; 2]) -> Point {
        Point(self.grid.moved(from.0, turned(displacement, self.frame(from))))
    }

    fn transport_angle(&self, from: usize, to: usize) -> f64 {
        self.frames[from] - self.frames[to]
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        self.grid.neighbours(self.old[cell]).map(|cell| self.new[cell])
    }

    fn near(&self, place: Point, reach: f64, among: Range<usize>) -> impl Iterator<Item = (usize, [f64; 2])> {
        let frame = self.frame(place);
        let near = self.grid.near(place.0, reach, 0..self.cells());
        let near = near.map(move |(cell, displacement)| (self.new[cell], turned(displacement, -frame)));
        near.filter(move |(cell, _)| among.contains(cell))
    }

    fn units(&self) -> [f64; 2] {
        self.grid.units()
    }

    /// Parts that no row of the grid ends with.
    fn part(&self) -> usize {
        997
    }

    fn inside(&self, place: Point) -> Point {
        Point(self.grid.inside(place.0))
    }

    fn middle(&self) -> Point {
        Point(self.grid.middle())
    }

    fn space(&self, margin: f64) -> impl Space<Place = Point> {
        Shown { domain: self, framed: Framed::new(self.grid, margin) }
    }

    fn buckets(&self, side: f64) -> impl Buckets<Place = Point> {
        let rectangles = Rectangles::new(self.grid.bounds(), side);
        Sorted { shown: Shown { domain: self, framed: Framed::new(self.grid, 0.0) }, rectangles }
    }
}

/// The grid with its frame.
#[derive(Clone, Copy)]
struct Shown<'a> {
    domain: &'a Relabelled,
    framed: Framed,
}

impl Shown<'_> {
    fn frame(&self, place: Point) -> f64 {
        self.domain.frame(self.to_domain(place))
    }
}

impl<'a> Space for Shown<'a> {
    type Place = Point;
    type Wall = Edge<'a>;

    fn to_space(&self, place: Point) -> Point {
        Point(self.framed.to_space(place.0))
    }

    fn to_domain(&self, place: Point) -> Point {
        Point(self.framed.to_domain(place.0))
    }

    fn is_inside(&self, place: Point) -> bool {
        self.framed.is_inside(place.0)
    }

    fn covers(&self, place: Point) -> bool {
        self.framed.covers(place.0)
    }

    fn moved(&self, from: Point, displacement: [f64; 2]) -> Point {
        Point(self.framed.moved(from.0, turned(displacement, self.frame(from))))
    }

    fn points(&self, density: f64) -> f64 {
        self.framed.points(density)
    }

    fn integral(&self, density: impl Fn(usize) -> f64) -> f64 {
        self.framed.integral(|cell| density(self.domain.new[cell]))
    }

    fn random(&self, rng: &mut impl Rng) -> Point {
        Point(self.framed.random(rng))
    }

    fn cells(&self) -> usize {
        self.framed.cells()
    }

    fn place_in(&self, cell: usize, at: [f64; 2]) -> Point {
        Point(self.framed.place_in(cell, at))
    }

    fn walls(&self) -> Vec<Edge<'a>> {
        self.framed.walls().into_iter().map(|side| Edge { shown: *self, side }).collect()
    }

    fn buckets(&self, side: f64) -> impl Buckets<Place = Point> {
        Sorted { shown: *self, rectangles: self.framed.rectangles(side) }
    }
}

/// One side of the grid.
struct Edge<'a> {
    shown: Shown<'a>,
    side: Side,
}

impl Wall<Point> for Edge<'_> {
    fn depth(&self, place: Point) -> f64 {
        self.side.depth(place.0)
    }

    fn inward(&self, place: Point) -> [f64; 2] {
        turned(self.side.inward(place.0), -self.shown.frame(place))
    }

    fn at_depth(&self, place: Point, depth: f64) -> Point {
        Point(self.side.at_depth(place.0, depth))
    }

    fn faces(&self, other: &Self) -> bool {
        self.side.faces(&other.side)
    }
}

/// Places in rectangles.
#[derive(Clone, Copy)]
struct Sorted<'a> {
    shown: Shown<'a>,
    rectangles: Rectangles,
}

impl Buckets for Sorted<'_> {
    type Place = Point;

    fn count(&self) -> usize {
        self.rectangles.count()
    }

    fn bucket(&self, place: Point) -> usize {
        self.rectangles.bucket(place.0)
    }

    fn near(
        &self,
        place: Point,
        reach: f64,
    ) -> impl Iterator<Item = (Range<usize>, impl Fn(Point) -> Option<[f64; 2]>)> {
        let frame = self.shown.frame(place);
        let near = self.rectangles.near(place.0, reach);
        near.map(move |(buckets, displacement)| {
            (buckets, move |to: Point| Some(turned(displacement(to.0)?, -frame)))
        })
    }

    fn is_to_image(&self, from: Point, to: Point, displacement: [f64; 2]) -> bool {
        self.rectangles.is_to_image(from.0, to.0, turned(displacement, self.shown.frame(from)))
    }

    fn transport_angle(&self, from: usize, to: usize) -> f64 {
        self.shown.domain.transport_angle(from, to)
    }
}
