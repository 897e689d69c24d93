//! Summarises many errors by three numbers.

/// Median, 95th percentile and maximum of |error|.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// The number of errors.
    pub count: usize,
    /// Half of the absolute errors are smaller.
    pub median: f64,
    /// One absolute error in twenty is larger.
    pub p95: f64,
    /// The largest absolute error.
    pub max: f64,
}

impl Summary {
    /// The summary of `errors`; `None` where there are none.
    pub fn from_errors(errors: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut sizes: Vec<f64> = errors.into_iter().map(f64::abs).collect();
        sizes.sort_by(f64::total_cmp);
        let at = |share| percentile(&sizes, share);
        Some(Self { count: sizes.len(), median: at(0.5)?, p95: at(0.95)?, max: at(1.0)? })
    }
}

/// The quantile of `sorted` at a share 0..1: linear between the two nearest, the first at share 0
/// and the last at 1 (R. J. Hyndman & Y. Fan, "Sample quantiles in statistical packages", 1996, type 7).
pub fn percentile(sorted: &[f64], share: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let place = share * last as f64;
    let low = (place as usize).min(last);
    let high = (low + 1).min(last);
    Some(sorted[low] + (place - low as f64) * (sorted[high] - sorted[low]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_lie_between_the_nearest_two() {
        let numbers: Vec<f64> = (0..=20).map(f64::from).collect();
        assert_eq!(percentile(&numbers, 0.95), Some(19.0));
        assert_eq!(percentile(&[1.0, 2.0], 0.5), Some(1.5));
        assert_eq!(percentile(&[1.0, 2.0, 4.0], 0.75), Some(3.0));
        assert_eq!([0.0, 0.5, 1.0].map(|share| percentile(&[7.0], share)), [Some(7.0); 3]);
        assert_eq!(percentile(&[], 0.5), None);
    }

    #[test]
    fn a_summary_takes_absolute_values() {
        let summary = Summary::from_errors([-3.0, 1.0, -2.0]).unwrap();
        assert_eq!((summary.count, summary.median, summary.max), (3, 2.0, 3.0));
        assert_eq!(Summary::from_errors([]), None);
    }
}
