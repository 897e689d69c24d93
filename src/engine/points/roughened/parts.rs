//! The connected parts of a pattern: those of the roughened pattern are compared with the marks before, to find fragments.

use rayon::prelude::*;

use crate::grid::{Edges, Field, UnionFind};

/// A part of less than this share of the mark around it is removed, unless it is the largest one of a mark.
const LEAST: f64 = 0.5;
/// Distance from the edge, in pattern values, to which removed places are moved: then the interpolation between cells leaves no
/// speck.
const CLEAR: f32 = 0.1;
/// Least distance from the edge, in pattern values, of cells without a neighbour on the other side of the edge.
const OFF: f32 = 0.04;
/// Number of cells around removed places that are moved towards the edge too.
const AROUND: i32 = 3;

/// The parts of a pattern before it was roughened.
pub(super) struct Parts<'a> {
    pattern: &'a Field,
    marks: Vec<u32>,
    grounds: Vec<u32>,
    radius: &'a (dyn Fn([f64; 2]) -> f64 + Sync),
}

/// The part of each cell, named by its first cell. Connected cells on the same side of the edge are one part.
fn parts(field: &Field) -> Vec<u32> {
    let (nx, ny) = (field.width, field.height);
    let inside = |cell: usize| field.values[cell] >= 0.5;
    let mut sets = UnionFind::new(nx * ny);
    let wraps = field.edges == Edges::Wrap;
    for cell in 0..nx * ny {
        let (x, y) = (cell % nx, cell / nx);
        let right = if x + 1 < nx { Some(cell + 1) } else { wraps.then_some(cell + 1 - nx) };
        let below = if y + 1 < ny { Some(cell + nx) } else { wraps.then_some(x) };
        for beside in [right, below].into_iter().flatten() {
            if inside(cell) == inside(beside) {
                sets.join(cell as u32, beside as u32, [0, 0]);
            }
        }
    }
    (0..nx * ny).map(|cell| sets.find(cell as u32).0).collect()
}

impl<'a> Parts<'a> {
    pub fn new(pattern: &'a Field, radius: &'a (dyn Fn([f64; 2]) -> f64 + Sync)) -> Self {
        let all = parts(pattern);
        let only = |inside: bool| {
            let cells = all.iter().zip(&pattern.values);
            cells.map(|(part, value)| if (*value >= 0.5) == inside { *part } else { NONE }).collect()
        };
        Self { pattern, marks: only(true), grounds: only(false), radius }
    }

    /// The mark of a cell; [`NONE`] for ground.
    pub fn mark_of(&self, cell: usize) -> u32 {
        self.marks[cell]
    }

    /// Moves small parts of a roughened pattern to the other side of the edge.
    pub fn tidy(&self, rough: &mut Field) {
        self.leave_out(true, rough);
        self.leave_out(false, rough);
    }

    /// Moves the small parts `inside` marks, or otherwise those outside, to the other side of the edge.
    fn leave_out(&self, inside: bool, rough: &mut Field) {
        let (all, grid) = (parts(rough), rough.grid());
        let is_inside = |value: f32| (value >= 0.5) == inside;
        let mut sizes = vec![0u32; all.len()];
        for (part, _) in all.iter().zip(&rough.values).filter(|(_, value)| is_inside(**value)) {
            sizes[*part as usize] += 1;
        }
        let before = if inside { &self.marks } else { &self.grounds };
        let mut stays = vec![false; all.len()];
        for part in heirs(before, &all, |cell| is_inside(rough.values[cell])) {
            stays[part as usize] = true;
        }
        let cell = grid.cell[0] * grid.cell[1];
        let mut is_small = vec![false; all.len()];
        for (part, size) in sizes.iter().enumerate().filter(|(part, size)| **size > 0 && !stays[*part]) {
            let radius = (self.radius)(grid.center_px(part));
            is_small[part] = f64::from(*size) * cell < LEAST * std::f64::consts::PI * radius * radius;
        }
        let left_out: Vec<usize> = (0..all.len()).filter(|cell| is_small[all[*cell] as usize]).collect();
        let was = rough.values.clone();
        for cell in left_out {
            let [column, row] = [-AROUND..=AROUND, -AROUND..=AROUND];
            for [x, y] in row.flat_map(|y| column.clone().map(move |x| [x, y])) {
                let away = x.abs().max(y.abs());
                if let Some((beside, _)) = grid.step(cell, [x, y])
                    && (away == 0 || !is_inside(was[beside]))
                {
                    let p = self.pattern.values[beside].clamp(0.0, 1.0);
                    let fade = away as f32 / (AROUND + 1) as f32;
                    // The original value, mirrored at ½ if it was on the same side of the edge. With increasing distance only a
                    // bound near the edge.
                    let [low, high] = [0.5 - CLEAR, 0.5 + CLEAR];
                    let value = &mut rough.values[beside];
                    *value = if inside {
                        let ground = p.min(1.0 - p).min(low);
                        value.min(ground + fade * (low - ground))
                    } else {
                        let mark = p.max(1.0 - p).max(high);
                        value.max(mark + fade * (high - mark))
                    };
                }
            }
        }
    }

    #[cfg(test)]
    pub fn marks(&self) -> usize {
        let first = |(cell, part): (usize, &u32)| cell as u32 == *part;
        self.marks.iter().enumerate().filter(|of| first(*of)).count()
    }
}

/// Moves the cells without a neighbour on the other side of the edge away from it. The interpolation between cells would make
/// specks of cells that nearly reach the edge.
pub(super) fn keep_off(rough: &mut Field) {
    let grid = rough.grid();
    let around = [-1, 0, 1].into_iter().flat_map(|y| [-1, 0, 1].map(|x| [x, y]));
    let at_edge = |cell: usize| {
        let inside = |cell: usize| rough.values[cell] >= 0.5;
        around.clone().any(|displacement| {
            grid.step(cell, displacement).is_some_and(|(beside, _)| inside(beside) != inside(cell))
        })
    };
    let near = |value: f32| (value - 0.5).abs() < OFF;
    let cells = rough.values.par_iter().enumerate();
    let kept = cells.map(|(cell, value)| match *value {
        value if !near(value) || at_edge(cell) => value,
        value if value < 0.5 => 0.5 - OFF,
        _ => 0.5 + OFF,
    });
    rough.values = kept.collect();
}

/// Index that means "no part".
const NONE: u32 = u32::MAX;

/// For each part `before`, the part of `all` that has most of its cells; only cells accepted by `counts` are counted.
fn heirs(before: &[u32], all: &[u32], counts: impl Fn(usize) -> bool) -> Vec<u32> {
    let shared = |cell: usize| (before[cell] != NONE && counts(cell)).then(|| (before[cell], all[cell]));
    let mut pairs: Vec<(u32, u32)> = (0..all.len()).filter_map(shared).collect();
    pairs.sort_unstable();
    let (mut heirs, mut best): (Vec<u32>, Option<(u32, usize)>) = (Vec::new(), None);
    for run in pairs.chunk_by(|a, b| a == b) {
        let (before, part) = run[0];
        match best {
            Some((same, most)) if same == before => {
                if run.len() > most {
                    best = Some((before, run.len()));
                    if let Some(last) = heirs.last_mut() {
                        *last = part;
                    }
                }
            }
            _ => {
                best = Some((before, run.len()));
                heirs.push(part);
            }
        }
    }
    heirs
}
