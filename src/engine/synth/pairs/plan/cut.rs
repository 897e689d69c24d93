//! Scales a difference field that grew from noise so that its edges lie at 1.

use rayon::prelude::*;

use crate::grid::Field;

/// The share of a field's lowest values that counts as ground, 0 in the shown field.
pub const GROUND: f64 = 0.02;

/// The values of a field in ascending order.
pub(super) struct Sorted(Vec<f32>);

impl Sorted {
    pub(super) fn new(field: &Field) -> Self {
        let mut sorted = field.values.clone();
        sorted.par_sort_unstable_by(f32::total_cmp);
        Self(sorted)
    }

    /// The value below which this share of all values lies.
    pub(super) fn quantile(&self, share: f64) -> f32 {
        self.0[((share * self.0.len() as f64) as usize).min(self.0.len() - 1)]
    }
}

/// The share of a field's highest values that counts as the middles of lines.
const MIDDLE: f64 = 0.02;

/// The field, scaled at each cell so that its ground is 0, and 1 is the value that the share `duty` (at that cell) of all values
/// exceeds.
///
/// With a `usual` duty the middles of all lines have the height of lines of this duty: otherwise thin lines would be paler.
pub(super) fn cut_by_duty(field: &Field, duty: impl Fn(usize) -> f64 + Sync, usual: Option<f64>) -> Field {
    let sorted = Sorted::new(field);
    let edge = |duty: f64| sorted.quantile(1.0 - duty);
    let mut shown = cut(field, &sorted, |cell| edge(duty(cell)));
    if let Some(usual) = usual {
        let (ground, middle) = (sorted.quantile(GROUND), sorted.quantile(1.0 - MIDDLE));
        let height = |edge: f32| (middle - edge) / (edge - ground).max(f32::MIN_POSITIVE);
        let usual = height(edge(usual));
        shown.values.par_iter_mut().enumerate().filter(|(_, value)| **value > 1.0).for_each(
            |(cell, value)| {
                let own = height(edge(duty(cell))).max(f32::MIN_POSITIVE);
                *value = 1.0 + (*value - 1.0) * usual / own;
            },
        );
    }
    shown
}

/// The field, scaled at each cell so that its ground is 0 and the value `edge` of the cell becomes 1.
pub(super) fn cut(field: &Field, sorted: &Sorted, edge: impl Fn(usize) -> f32 + Sync) -> Field {
    let ground = sorted.quantile(GROUND);
    let value = |(cell, value): (usize, &f32)| {
        ((value - ground) / (edge(cell) - ground).max(f32::MIN_POSITIVE)).max(0.0)
    };
    Field { values: field.values.par_iter().enumerate().map(value).collect(), ..field.clone() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn lines_are_as_wide_as_their_duty_and_as_high_as_the_usual_ones() {
        let wave = |[x, _]: [f64; 2]| libm::cos(std::f64::consts::TAU * x / 23.7) as f32;
        let field = Field::from_fn([200, 4], [1.0, 1.0], Edges::Closed, wave);
        // A quarter on the left, and a half on the right.
        let duty = |cell: usize| if cell % 200 < 100 { 0.25 } else { 0.5 };
        let shown = cut_by_duty(&field, duty, Some(0.5));
        let part = |from: usize| &shown.values[from..from + 100];
        let [left, right] = [0, 100].map(|from| part(from).iter().filter(|value| **value > 1.0).count());
        assert!(left.abs_diff(25) <= 5 && right.abs_diff(50) <= 5, "{left}, {right}");
        let [left, right] = [0, 100].map(|from| part(from).iter().copied().fold(0.0, f32::max));
        assert!((left / right - 1.0).abs() < 0.02 && right > 1.5, "{left}, {right}");
        let paler = cut_by_duty(&field, duty, None);
        assert!(paler.values[..100].iter().copied().fold(0.0, f32::max) < 0.8 * left);
    }
}
