//! The growth of a field of points as a value that is advanced octave by octave.

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::{OCTAVE_SEED, PointField, Valued};
use crate::grid::{Domain, Field};

/// A field of points that grows.
pub struct FieldGrowth {
    /// The octaves, each with its weight.
    octaves: Vec<(u32, f32)>,
    /// The weighted sum of the finished octaves.
    sum: Vec<f32>,
    /// Number of their points.
    points: usize,
    /// Number of finished octaves.
    done: usize,
    /// The octave whose points appear.
    appearing: Option<Appearing>,
}

/// An octave whose points appear in the order in which they were laid.
struct Appearing {
    valued: Valued,
    directions: Vec<[f64; 2]>,
    /// Index of the next stage.
    stage: usize,
    /// The sum with the previous octaves.
    field: Option<Vec<f32>>,
}

impl FieldGrowth {
    /// The growth of `field`.
    #[must_use]
    pub fn new(field: &PointField) -> Self {
        let octaves = (0..field.octaves.max(1))
            .take_while(|octave| *octave == 0 || field.is_visible(0.5f64.powi(*octave as i32)))
            .map(|octave| (octave, 0.5f32.powi(octave as i32)))
            .collect();
        Self { octaves, sum: vec![0.0; field.grid.cells()], points: 0, done: 0, appearing: None }
    }

    /// Does the next step: lays the points of an octave, shows some of them, or adds them. Returns whether all is done.
    /// Does the next step: lays the points of an octave, shows some of them, or adds them. Returns whether all octaves are
    /// finished.
    ///
    /// The points of each octave appear in `stages` − 1 stages, in the order in which they were laid; points that have not appeared
    /// count as 0.
    pub fn advance(&mut self, field: &PointField, stages: usize) -> bool {
        let Some((octave, share)) = self.octaves.get(self.done).copied() else { return true };
        let Some(mut appearing) = self.appearing.take() else {
            let seed = field.seed.wrapping_add(u64::from(octave).wrapping_mul(OCTAVE_SEED));
            let mut rng = Pcg64Mcg::seed_from_u64(seed);
            let valued = field.valued(f64::from(share), &mut rng);
            let directions = field.directions(&valued.graph, &mut rng);
            self.points += valued.graph.points.len();
            self.appearing = Some(Appearing { valued, directions, stage: 1, field: None });
            return false;
        };
        if appearing.stage < stages {
            let all = &appearing.valued.values;
            let mut values = all.clone();
            values[all.len() * appearing.stage / stages..].fill(0.0);
            appearing.field = Some(self.with(field, &appearing, share, &values));
            appearing.stage += 1;
            self.appearing = Some(appearing);
            return false;
        }
        self.sum = self.with(field, &appearing, share, &appearing.valued.values);
        self.done += 1;
        self.done == self.octaves.len()
    }

    /// The sum including the current octave, whose points have these `values`.
    fn with(&self, field: &PointField, appearing: &Appearing, share: f32, values: &[f32]) -> Vec<f32> {
        let total: f32 = self.octaves.iter().map(|(_, share)| share).sum();
        let spread = field.spread(&appearing.valued.graph, values, &appearing.directions);
        let folded = |value: f32| if field.fold { 2.0 * (value - 0.5).abs() } else { value };
        self.sum.iter().zip(&spread).map(|(sum, value)| sum + share / total * folded(*value)).collect()
    }

    /// The field with the part of the current octave that has appeared.
    #[must_use]
    pub fn appearing(&self, field: &PointField) -> Option<Field> {
        let values = self.appearing.as_ref()?.field.clone()?;
        Some(Field::new(&field.grid, values))
    }

    /// Share of the octaves that are finished, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.done as f64 / self.octaves.len().max(1) as f64
    }

    /// The field, 0..1, and its number of points.
    #[must_use]
    pub fn complete(self, field: &PointField) -> (Field, usize) {
        (Field::new(&field.grid, self.sum), self.points)
    }
}
