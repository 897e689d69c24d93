//! Converts a grown pattern to a relief of even height, which can be cut at any threshold so that lines of all widths stay whole.

use rayon::prelude::*;

use crate::grid::Field;
use crate::grid::blur::gaussian;
use crate::synth::tone::plan::ToneSystem;

/// Standard deviation of the blurs that find the local mean and height of waves, wavelengths.
const AROUND: f64 = 0.6;
/// Waves lower than this share of the usual height are not raised: where lines end, they should end.
const LOWEST: f32 = 0.05;
/// Range of heights except outliers; thresholds may lie outside of it.
pub const HEIGHTS: [f32; 2] = [0.15, 0.85];
/// Offset added to a spot's concentration (its peak = 1) before its logarithm is taken: the ground between spots has a hundredth.
const GROUND: f32 = 1e-3;
/// The shares of all cells that lie below the two [`HEIGHTS`].
const QUANTILES: [f64; 2] = [0.01, 0.99];

/// The relief of `marks` that `system` has grown, `wavelength` px apart.
#[must_use]
pub fn relief(marks: &Field, system: ToneSystem, wavelength: f64) -> Field {
    let values = if system.usual_g().is_some() {
        // The shown value is b ÷ (b + 3), which has slopes up to its peaks.
        marks.values.clone()
    } else if system.is_striped() {
        waves(marks, wavelength)
    } else {
        logarithms(marks)
    };
    Field { values, ..*marks }
}

/// (u − mean) ÷ amplitude, with the local mean and amplitude.
fn waves(marks: &Field, wavelength: f64) -> Vec<f32> {
    let size = [marks.width, marks.height];
    let sigma = AROUND * wavelength / (marks.cell[0] * marks.cell[1]).sqrt();
    let means = gaussian(&marks.values, size, sigma, marks.edges);
    let squares: Vec<f32> =
        marks.values.par_iter().zip(&means).map(|(value, mean)| (value - mean) * (value - mean)).collect();
    let variances = gaussian(&squares, size, sigma, marks.edges);
    let [low, high] = HEIGHTS;
    let height = |((value, mean), variance): ((&f32, &f32), &f32)| {
        let amplitude = (2.0 * variance.max(0.0)).sqrt().max(LOWEST);
        0.5 + 0.5 * (high - low) * (value - mean) / amplitude
    };
    marks.values.par_iter().zip(&means).zip(&variances).map(height).collect()
}

/// Logarithms of the concentrations: then the ground between spots has slopes, too, and spots can be enlarged until they touch.
fn logarithms(marks: &Field) -> Vec<f32> {
    let logarithm = |value: &f32| libm::logf(value.max(0.0) + GROUND);
    let mut values: Vec<f32> = marks.values.par_iter().map(logarithm).collect();
    let mut sorted = values.clone();
    sorted.sort_unstable_by(f32::total_cmp);
    let last = sorted.len().saturating_sub(1) as f64;
    let [from, to] = QUANTILES.map(|share| sorted.get((share * last) as usize).copied().unwrap_or(0.0));
    let [low, high] = HEIGHTS;
    let scale = (high - low) / (to - from).max(f32::MIN_POSITIVE);
    values.par_iter_mut().for_each(|value| *value = low + scale * (*value - from));
    values
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::rd::System;
    use std::f64::consts::TAU;

    #[test]
    fn low_waves_become_as_high_as_high_ones() {
        let (width, height) = (200, 40);
        let wave = |cell: usize| {
            let x = (cell % width) as f64;
            (0.5 + (0.1 + 0.3 * x / 200.0) * libm::sin(TAU * x / 10.0)) as f32
        };
        let values = (0..width * height).map(wave).collect();
        let marks = Field { width, height, cell: [2.0; 2], edges: Edges::Closed, values };
        let relief = relief(&marks, ToneSystem::Of(System::MEINHARDT_STRIPES), 20.0);
        let highest = |columns: std::ops::Range<usize>| columns.map(|x| relief.values[x]).fold(0.0, f32::max);
        let (left, right) = (highest(20..40), highest(160..180));
        assert!((left - HEIGHTS[1]).abs() < 0.06 && (right - HEIGHTS[1]).abs() < 0.06, "{left} {right}");
    }
}
