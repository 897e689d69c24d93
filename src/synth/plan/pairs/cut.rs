//! A difference from noise → a field whose edges lie at 1.

use crate::grid::Field;

/// The share of a field's lowest values that count as ground, 0 in what is shown.
const GROUND: f64 = 0.02;

/// The values of a field in rising order.
pub(super) struct Sorted(Vec<f32>);

impl Sorted {
    pub(super) fn new(field: &Field) -> Self {
        let mut sorted = field.values.clone();
        sorted.sort_unstable_by(f32::total_cmp);
        Self(sorted)
    }

    /// The value below which this share of all lies.
    pub(super) fn quantile(&self, share: f64) -> f32 {
        self.0[((share * self.0.len() as f64) as usize).min(self.0.len() - 1)]
    }
}

/// The field, so scaled at each cell that its ground is 0, and 1 the value above which the share `duty` of the cell of all values lies.
pub(super) fn cut_by_duty(field: &Field, duty: impl Fn(usize) -> f64) -> Field {
    let sorted = Sorted::new(field);
    cut(field, &sorted, |cell| sorted.quantile(1.0 - duty(cell)))
}

/// The field, so scaled at each cell that its ground is 0 and the value `edge` of the cell 1.
pub(super) fn cut(field: &Field, sorted: &Sorted, edge: impl Fn(usize) -> f32) -> Field {
    let ground = sorted.quantile(GROUND);
    let value = |(cell, value): (usize, &f32)| {
        ((value - ground) / (edge(cell) - ground).max(f32::MIN_POSITIVE)).max(0.0)
    };
    Field { values: field.values.iter().enumerate().map(value).collect(), ..field.clone() }
}
