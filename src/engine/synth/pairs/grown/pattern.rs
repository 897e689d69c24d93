//! The pattern of grown pairs: 0 = ground, ½ = an edge, 1 = the middle of a thread.

use std::ops::Range;

use rayon::prelude::*;

use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::synth::pairs::grown::over::OverUnder;
use crate::synth::pattern::{PatternRows, share};

/// The pattern of some pairs, at any size: the largest of them at each place.
pub struct PairPattern {
    grid: [usize; 2],
    extent: [f64; 2],
    pairs: Vec<Pair>,
    edges: crate::grid::Edges,
    over: Option<OverUnder>,
}

/// The difference of one pair.
struct Pair {
    surface: Spline,
    /// The value that counts as the middle of a thread.
    peak: f32,
    /// The threshold of the edge ÷ the peak.
    level: f32,
}

/// The share of the values above the threshold that lies below the middle of a thread.
const MIDDLE: f64 = 0.9;
/// The highest threshold ÷ peak, for fields with hardly any value above the threshold.
const HIGHEST: f32 = 0.9;

impl PairPattern {
    /// The pattern of at least one pair; its edges are at the threshold of its difference in `levels`.
    #[must_use]
    pub fn new(differences: &[Field], levels: &[f32]) -> Self {
        let first = &differences[0];
        let pair = |(field, &level): (&Field, &f32)| {
            let peak = middle_of_threads(&field.values, level);
            Pair { surface: Spline::new(field), peak, level: level / peak }
        };
        Self {
            grid: [first.width, first.height],
            extent: first.extent(),
            pairs: differences.iter().zip(levels).map(pair).collect(),
            edges: first.edges,
            over: None,
        }
    }

    /// This pattern with threads that lie over others.
    #[must_use]
    pub fn with(self, over: Option<OverUnder>) -> Self {
        Self { over, ..self }
    }

    /// Cells along x and y of the grid that it grew on.
    #[must_use]
    pub fn grid(&self) -> [usize; 2] {
        self.grid
    }

    /// Rows `rows` at `width` × `height` px over the whole canvas.
    #[must_use]
    pub fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        let alone = |pair: &Pair| {
            let mut values = pair.surface.rows(rows.clone(), width, height);
            values.par_iter_mut().for_each(|value| *value = share(*value / pair.peak, pair.level));
            values
        };
        if let Some(over) = &self.over {
            let alone: Vec<Vec<f32>> = self.pairs.iter().map(alone).collect();
            return over.rows(&alone, rows, width, height);
        }
        let highest = |mut all: Vec<f32>, pair: &Pair| {
            all.par_iter_mut().zip(alone(pair)).for_each(|(all, value)| *all = all.max(value));
            all
        };
        self.pairs.iter().fold(vec![0.0f32; rows.len() * width], highest)
    }

    /// The whole pattern at `width` × `height` px.
    #[must_use]
    pub fn field(&self, width: usize, height: usize) -> Field {
        let cell = [self.extent[0] / width as f64, self.extent[1] / height as f64];
        Field { width, height, cell, edges: self.edges, values: self.rows(0..height, width, height) }
    }
}

/// The difference that counts as the middle of a thread, of differences whose edges are at `level`.
#[must_use]
pub fn middle_of_threads(differences: &[f32], level: f32) -> f32 {
    let mut above: Vec<f32> = differences.iter().copied().filter(|value| *value > level).collect();
    let middle = (MIDDLE * above.len() as f64) as usize;
    let peak = if above.is_empty() {
        level
    } else {
        let middle = middle.min(above.len() - 1);
        *above.select_nth_unstable_by(middle, f32::total_cmp).1
    };
    peak.max(level / HIGHEST).max(f32::MIN_POSITIVE)
}

impl PatternRows for PairPattern {
    fn grid(&self) -> [usize; 2] {
        self.grid()
    }

    fn rows(&self, rows: Range<usize>, width: usize, height: usize) -> Vec<f32> {
        self.rows(rows, width, height)
    }

    fn field(&self, width: usize, height: usize) -> Field {
        self.field(width, height)
    }
}
