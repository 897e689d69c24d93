//! A threshold that separates the ground and the marks of a picture.

const BINS: usize = 4096;
/// Number of parts of the range between ground and marks whose shares of px are compared.
const PARTS: usize = 16;
/// Parts next to the sparsest one with up to this multiple of its px belong to one step of tones.
const STEP: f64 = 4.0;

/// The threshold between the ground and the marks of a picture, in the middle of the tones that few px have.
///
/// Otsu's threshold separates ground and marks. The range between their medians is cut into equal parts. A sparse part, with the
/// parts around it that have up to four times as many px, is a step of tones: where tones change fast from ground to mark few px
/// have them, so that edges lie there. The threshold is the middle of the longest step. Halfway between the medians, edges would be
/// displaced if colours change over more tones on one side of the edge than on the other. For a picture of two tones the threshold
/// is halfway between them.
///
/// N. Otsu, "A threshold selection method from gray-level histograms", IEEE Trans. SMC 9 (1979): the threshold
/// at which ω₀·ω₁·(μ₁ − μ₀)² is largest.
///
/// ```
/// use dapple_engine::measure::otsu_threshold;
///
/// let level = otsu_threshold(&[0.1, 0.12, 0.11, 0.9, 0.88]);
/// assert!(0.12 < level && level < 0.88);
/// ```
#[must_use]
pub fn otsu_threshold(values: &[f32]) -> f32 {
    let mut counts = vec![0_u64; BINS];
    for value in values {
        counts[((value * BINS as f32) as usize).min(BINS - 1)] += 1;
    }
    let split = threshold(&counts);
    let lower = counts[..=split].iter().sum::<u64>();
    let upper = values.len() as u64 - lower;
    let bin = |rank: u64| {
        let mut seen = 0;
        let reached = counts.iter().position(|count| {
            seen += count;
            seen > rank
        });
        reached.unwrap_or(BINS - 1) as f64
    };
    // For an even number of px the median is halfway between the two in the middle.
    let median = |from: u64, px: u64| 0.5 * (bin(from + px.saturating_sub(1) / 2) + bin(from + px / 2));
    ((step(&counts, median(0, lower), median(lower, upper)) + 0.5) / BINS as f64) as f32
}

/// The last bin of the group with the lower values.
fn threshold(counts: &[u64]) -> usize {
    let total = counts.iter().sum::<u64>() as f64;
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
    split
}

/// The middle of the longest step of tones between two bins, in bins.
///
/// A picture of 8 bits has px in only a few of the bins. The px of such a bin count half on either side, evenly distributed up to
/// the next bin that has px.
fn step(counts: &[u64], low: f64, high: f64) -> f64 {
    let filled: Vec<usize> = (0..BINS).filter(|bin| counts[*bin] > 0).collect();
    let mut sums = vec![0.0];
    for pair in filled.windows(2) {
        sums.push(sums[sums.len() - 1] + 0.5 * (counts[pair[0]] + counts[pair[1]]) as f64);
    }
    let below = |at: f64| {
        let next = filled.partition_point(|bin| (*bin as f64) < at).clamp(1, filled.len() - 1);
        let [from, to] = [filled[next - 1], filled[next]].map(|bin| bin as f64);
        sums[next - 1] + (sums[next] - sums[next - 1]) * ((at - from) / (to - from)).clamp(0.0, 1.0)
    };
    if filled.len() < 2 {
        return 0.5 * (low + high);
    }
    let width = (high - low) / PARTS as f64;
    let from = |part: usize| low + part as f64 * width;
    let px: Vec<f64> = (0..PARTS).map(|part| below(from(part + 1)) - below(from(part))).collect();
    let steps = (0..PARTS).filter_map(|least| {
        let few = |part: &usize| px[*part] <= STEP * px[least];
        let first = (0..least).rev().take_while(few).last().unwrap_or(least);
        let last = (least + 1..PARTS).take_while(few).last().unwrap_or(least);
        let sparsest = px[first..=last].iter().all(|near| px[least] <= *near);
        sparsest.then(|| (last - first, 0.5 * (from(first) + from(last + 1))))
    });
    // If several have one length, the first is taken.
    steps.rev().max_by_key(|(length, _)| *length).map_or(0.5 * (low + high), |(_, middle)| middle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_threshold_of_two_tones_is_half_way_whatever_their_counts() {
        for many in [1, 10, 500] {
            let values: Vec<f32> = (0..1000).map(|i| if i < many { 0.2 } else { 0.8 }).collect();
            assert!((otsu_threshold(&values) - 0.5).abs() < 1e-3, "{many}");
        }
    }

    #[test]
    fn between_soft_tones_it_is_where_they_change_fastest() {
        // Two broad groups of tones, 0.1–0.4 and 0.6–0.7, and a steep step between them.
        let value = |i: u32| {
            let t = f64::from(i) / 10_000.0;
            let tone = if t < 0.7 {
                0.1 + 0.3 * t / 0.7
            } else if t < 0.72 {
                0.4 + 10.0 * (t - 0.7)
            } else {
                0.6 + 0.1 * (t - 0.72) / 0.28
            };
            // As in a picture of 8 bits.
            ((tone * 255.0).round() / 255.0) as f32
        };
        let values: Vec<f32> = (0..10_000).map(value).collect();
        let level = otsu_threshold(&values);
        assert!((level - 0.5).abs() < 0.01, "{level}");
    }

    #[test]
    fn for_a_single_tone_it_is_that_tone() {
        assert!((otsu_threshold(&[0.3; 50]) - 0.3).abs() < 1e-3);
    }

    #[test]
    fn between_three_tones_it_is_in_one_gap() {
        let tones = [(0.3, 600), (0.64, 150), (0.85, 400)];
        let values: Vec<f32> = tones.iter().flat_map(|(tone, count)| vec![*tone; *count]).collect();
        let level = otsu_threshold(&values);
        assert!([0.3, 0.64, 0.85].iter().all(|tone| (level - tone).abs() > 0.05), "{level}");
    }
}
