//! A level that tells the two phases of a picture apart.

/// The level half way between the medians of the two phases, which Otsu's threshold tells apart: on a picture
/// of two tones exactly half of the contrast, wherever between them the threshold fell.
///
/// N. Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9 (1979): the threshold
/// at which ω₀·ω₁·(μ₁ − μ₀)² is largest.
#[must_use]
pub fn level_between_phases(values: &[f32]) -> f32 {
    const BINS: usize = 4096;
    let mut counts = vec![0_u64; BINS];
    for value in values {
        counts[((value * BINS as f32) as usize).min(BINS - 1)] += 1;
    }
    let total = values.len() as f64;
    let sum: f64 = counts.iter().enumerate().map(|(bin, count)| bin as f64 * *count as f64).sum();
    let (mut below, mut sum_below, mut best, mut split) = (0.0, 0.0, -1.0, 0);
    for (bin, count) in counts.iter().enumerate() {
        below += *count as f64;
        sum_below += bin as f64 * *count as f64;
        let above = total - below;
        if below > 0.0 && above > 0.0 {
            let apart = (sum - sum_below) / above - sum_below / below;
            if below * above * apart * apart > best {
                (best, split) = (below * above * apart * apart, bin);
            }
        }
    }
    let lower = counts[..=split].iter().sum::<u64>();
    let upper = values.len() as u64 - lower;
    let rank = |wanted: u64| {
        let mut seen = 0;
        let reached = counts.iter().position(|count| {
            seen += count;
            seen > wanted
        });
        (reached.unwrap_or(BINS - 1) as f32 + 0.5) / BINS as f32
    };
    0.5 * (rank(lower / 2) + rank(lower + upper / 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_threshold_of_two_tones_is_half_way_whatever_their_counts() {
        for many in [1, 10, 500] {
            let values: Vec<f32> = (0..1000).map(|i| if i < many { 0.2 } else { 0.8 }).collect();
            assert!((level_between_phases(&values) - 0.5).abs() < 1e-3, "{many}");
        }
    }
}
