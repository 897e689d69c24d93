//! A flat grid as a domain.

use std::ops::Range;

use rayon::prelude::*;

use super::cells::Grid;
use super::distance::{length, nearest};
use super::domain::Domain;
use super::edges::Edges;
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

    fn displacement(&self, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        self.bounds().shortest([to[0] - from[0], to[1] - from[1]])
    }

    fn moved(&self, from: [f64; 2], displacement: [f64; 2]) -> [f64; 2] {
        self.bounds().folded([from[0] + displacement[0], from[1] + displacement[1]])
    }

    fn transport_angle(&self, _: usize, _: usize) -> f64 {
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

    fn runs_near(
        &self,
        place: [f64; 2],
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (Range<usize>, [f64; 2])> {
        let low = place.map(|at| at - 0.5 - reach);
        let high = place.map(|at| at - 0.5 + reach);
        self.window_runs(low, high, among)
            .map(move |(cells, at)| (cells, [at[0] - place[0], at[1] - place[1]]))
    }

    fn may_reach(&self, place: [f64; 2], reach: f64, among: &Range<usize>) -> bool {
        let (nx, height) = (self.size[0], self.size[1] as f64);
        let (first, end) = ((among.start / nx) as f64, among.end.div_ceil(nx) as f64);
        let reaches = |y: f64| y + reach >= first && y - reach <= end;
        let beyond = [-height, height].into_iter().any(|shift| reaches(place[1] + shift));
        reaches(place[1]) || self.edges == Edges::Wrap && (beyond || reach > height)
    }

    fn distances(&self, set: &[bool]) -> Option<Vec<f64>> {
        let unit = Self { cell: [1.0; 2], ..*self };
        let away = |ways: Vec<[i32; 2]>| {
            ways.into_par_iter().map(|displacement| length(displacement, &unit)).collect()
        };
        Some(nearest(set, &unit).map_or_else(|| vec![f64::INFINITY; set.len()], away))
    }

    fn units(&self) -> [f64; 2] {
        self.cell
    }

    /// Whole rows.
    fn part(&self) -> usize {
        16 * self.size[0]
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

    fn buckets(&self, side: f64) -> impl Buckets<Place = [f64; 2]> {
        Rectangles::new(self.bounds(), side)
    }
}
