//! Which points are near each other, and their mutual repulsion.

use rayon::prelude::*;

use crate::grid::{Bounds, Edges};
use crate::rd::nucleus::Nucleus;

/// Points that are not worth handing to another thread.
const FEW: usize = 128;

/// One round of repulsion: points nearer than `reach` pitches push each other away. `nucleus` makes point i at its new place.
pub fn relax(placed: &mut CellList, reach: f64, nucleus: &(dyn Fn(usize, [f64; 2]) -> Nucleus + Sync)) {
    let moved = |(index, point): (usize, &Nucleus)| {
        let mut shift = [0.0, 0.0];
        placed.near(point, reach, |other, delta| {
            let own = point.distance2(delta);
            // Too far by half of the mean already.
            if 0.5 * own >= reach * reach {
                return;
            }
            let d = (0.5 * (own + other.distance2(delta))).sqrt();
            if d > 1e-9 && d < reach {
                // Half of the gap to the reach, shared with the other, damped for six neighbours.
                let push = 0.22 * (reach - d) / d;
                shift[0] -= push * delta[0];
                shift[1] -= push * delta[1];
            }
        });
        nucleus(index, placed.space.folded([point.at[0] + shift[0], point.at[1] + shift[1]]))
    };
    let all: Vec<Nucleus> = placed.all.par_iter().enumerate().with_min_len(FEW).map(moved).collect();
    placed.replace(all);
}

/// Squared distance in pitches, by the mean of both metrics.
pub fn distance2(a: &Nucleus, b: &Nucleus, delta: [f64; 2]) -> f64 {
    0.5 * (a.distance2(delta) + b.distance2(delta))
}

/// Points by place, so that neighbours are found without asking all.
pub struct CellList {
    /// Where the points lie, cells.
    space: Bounds,
    columns: usize,
    rows: usize,
    /// The points.
    pub all: Vec<Nucleus>,
    cells: Vec<Vec<u32>>,
}

impl CellList {
    pub fn new(space: Bounds, reach: f64) -> Self {
        let count = |n: f64| ((n / reach) as usize).max(1);
        let (columns, rows) = (count(space.size[0]), count(space.size[1]));
        Self { space, columns, rows, all: Vec::new(), cells: vec![Vec::new(); columns * rows] }
    }

    /// None of the points, in the same space.
    pub fn emptied(&self) -> Self {
        Self { all: Vec::new(), cells: vec![Vec::new(); self.cells.len()], ..*self }
    }

    fn bucket(&self, at: [f64; 2]) -> [isize; 2] {
        [
            ((at[0] / self.space.size[0] * self.columns as f64) as usize).min(self.columns - 1) as isize,
            ((at[1] / self.space.size[1] * self.rows as f64) as usize).min(self.rows - 1) as isize,
        ]
    }

    /// The same points elsewhere.
    pub fn moved(&mut self, to: impl Fn(usize, &Nucleus) -> [f64; 2]) {
        let all = self.all.iter().enumerate();
        let all = all.map(|(index, point)| Nucleus { at: to(index, point), ..*point }).collect();
        self.replace(all);
    }

    pub fn replace(&mut self, all: Vec<Nucleus>) {
        self.all.clear();
        self.cells.iter_mut().for_each(Vec::clear);
        all.into_iter().for_each(|point| self.insert(point));
    }

    pub fn insert(&mut self, point: Nucleus) {
        let [column, row] = self.bucket(point.at);
        self.cells[row as usize * self.columns + column as usize].push(self.all.len() as u32);
        self.all.push(point);
    }

    /// Calls `each(other, other − point)` for every point, or image of one beyond the border (its own too),
    /// that can lie within `pitches` of `point`; and for some farther ones.
    pub fn near(&self, point: &Nucleus, pitches: f64, mut each: impl FnMut(&Nucleus, [f64; 2])) {
        self.near_by_index(point, pitches, |other, delta| each(&self.all[other], delta));
    }

    /// The same with the index of the other.
    pub fn near_by_index(&self, point: &Nucleus, pitches: f64, mut each: impl FnMut(usize, [f64; 2])) {
        let [column, row] = self.bucket(point.at);
        let reach = pitches * point.reach * 1.5;
        let [w, h] = self.space.size;
        for dy in -1..=1 {
            for dx in -1..=1 {
                let (c, sx) = image(column + dx, self.columns, self.space.edges, w);
                let (r, sy) = image(row + dy, self.rows, self.space.edges, h);
                let beyond = |i: isize, n: usize| i < 0 || i >= n as isize;
                let mirrored = [beyond(column + dx, self.columns), beyond(row + dy, self.rows)];
                for &index in &self.cells[r * self.columns + c] {
                    let other = &self.all[index as usize];
                    let seen = [sx(other.at[0]), sy(other.at[1])];
                    let delta = [seen[0] - point.at[0], seen[1] - point.at[1]];
                    // The image of a point on the wall is that point, and counts once.
                    let twice = |axis: usize| mirrored[axis] && (seen[axis] - other.at[axis]).abs() < 1e-6;
                    let twice = twice(0) || twice(1);
                    let itself = dx == 0 && dy == 0 && delta == [0.0, 0.0];
                    if !itself && !twice && delta[0].abs() <= reach && delta[1].abs() <= reach {
                        each(index as usize, delta);
                    }
                }
            }
        }
    }
}

/// The bucket whose image is bucket `i` of `n`, and the map of its coordinates to those of the image.
fn image(i: isize, n: usize, edges: Edges, size: f64) -> (usize, impl Fn(f64) -> f64) {
    let beyond = if i < 0 {
        -1.0
    } else if i >= n as isize {
        1.0
    } else {
        0.0
    };
    let mirrored = edges == Edges::Closed && beyond != 0.0;
    let index = edges.index(i, n);
    (index, move |v: f64| match (mirrored, beyond) {
        (true, -1.0) => -v,
        (true, _) => 2.0 * size - v,
        (false, b) => v + b * size,
    })
}
