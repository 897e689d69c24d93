//! Means and standard deviations of values, also under weights.

/// Mean of values under weights; `None` without any weight.
#[must_use]
pub fn weighted_mean(weighted: impl IntoIterator<Item = (f64, f64)>) -> Option<f64> {
    let add = |(sum, total): (f64, f64), (value, weight): (f64, f64)| (sum + weight * value, total + weight);
    let (sum, total) = weighted.into_iter().fold((0.0, 0.0), add);
    (total > 0.0).then(|| sum / total)
}

/// Mean and standard deviation of values under weights; of none 0 and 0.
fn moments(weighted: impl Iterator<Item = (f64, f64)> + Clone) -> (f64, f64) {
    let Some(mean) = weighted_mean(weighted.clone()) else { return (0.0, 0.0) };
    let squares = weighted.map(|(value, weight)| ((value - mean) * (value - mean), weight));
    (mean, weighted_mean(squares).unwrap_or(0.0).sqrt())
}

/// Standard deviation; 0 of none.
#[must_use]
pub fn deviation(values: impl Iterator<Item = f64> + Clone) -> f64 {
    moments(values.map(|value| (value, 1.0))).1
}

/// Coefficient of variation of positive values: standard deviation ÷ mean; 0 of none.
///
/// ```
/// use dapple_engine::attributes::moments::variation;
///
/// assert_eq!(variation([3.0, 3.0, 3.0].into_iter()), 0.0);
/// assert!((variation([1.0, 3.0].into_iter()) - 0.5).abs() < 1e-12);
/// ```
#[must_use]
pub fn variation(values: impl Iterator<Item = f64> + Clone) -> f64 {
    weighted_variation(values.map(|value| (value, 1.0)))
}

/// Coefficient of variation of positive values under weights: standard deviation ÷ mean; 0 of none.
#[must_use]
pub fn weighted_variation(weighted: impl Iterator<Item = (f64, f64)> + Clone) -> f64 {
    let (mean, deviation) = moments(weighted);
    if mean > 0.0 { deviation / mean } else { 0.0 }
}
