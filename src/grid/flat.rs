//! A flat grid as a domain.

use std::ops::Range;

use super::cells::Grid;
use super::domain::Domain;
use super::framed::{Framed, Rectangles};
use super::space::{Buckets, Space};

impl Domain for Grid {
    type Place = [f64; 2];

    fn cells(&self) -> usize {
        self.size[0] * self.size[1]
    }

    fn center(&self, cell: usize) -> [f64; 2] {
        self.position(cell).map(|at| at as f64 + 0.5)
    }

    fn cell_at(&self, place: [f64; 2]) -> usize {
        // The cast takes negative numbers to 0.
        self.index([0, 1].map(|axis| (place[axis].max(0.0) as usize).min(self.size[axis] - 1)))
    }

    fn area(&self, _: usize) -> f64 {
        1.0
    }

    fn way(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        self.bounds().shortest([to[0] - from[0], to[1] - from[1]])
    }

    fn moved(&self, from: [f64; 2], way: [f64; 2]) -> [f64; 2] {
        self.bounds().folded([from[0] + way[0], from[1] + way[1]])
    }

    fn turn(&self, _: usize, _: usize) -> f64 {
        0.0
    }

    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize> {
        const STEPS: [[i32; 2]; 8] = [[-1, -1], [0, -1], [1, -1], [-1, 0], [1, 0], [-1, 1], [0, 1], [1, 1]];
        STEPS.into_iter().filter_map(move |step| Some(self.step(cell, step)?.0))
    }

    fn near(
        &self,
        place: [f64; 2],
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])> {
        let low = place.map(|at| at - 0.5 - reach);
        let high = place.map(|at| at - 0.5 + reach);
        self.window(low, high, among).map(move |(cell, at)| (cell, [at[0] - place[0], at[1] - place[1]]))
    }

    fn units(&self) -> [f64; 2] {
        self.cell
    }

    /// Whole rows.
    fn part(&self) -> usize {
        16 * self.size[0]
    }

    fn place_in(&self, cell: usize, at: [f64; 2]) -> [f64; 2] {
        let [column, row] = self.position(cell);
        [column as f64 + at[0], row as f64 + at[1]]
    }

    fn inside(&self, place: [f64; 2]) -> [f64; 2] {
        let size = self.bounds().size;
        [0, 1].map(|axis| place[axis].clamp(0.0, size[axis] * (1.0 - 1e-12)))
    }

    fn middle(&self) -> [f64; 2] {
        self.bounds().size.map(|side| 0.5 * side)
    }

    fn space(&self, margin: f64) -> impl Space<Place = [f64; 2]> {
        Framed::new(*self, margin)
    }

    fn buckets(&self, reach: f64) -> impl Buckets<Place = [f64; 2]> {
        Rectangles::new(self.bounds(), reach)
    }
}
