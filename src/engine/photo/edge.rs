//! The threshold of the marks' edges.
//!
//! A blurred edge is steepest where the sharp one was. In a photograph of shaded marks the edge is there, too, not halfway between
//! the middle of the mark and the ground. But the steepest value is found with an error, so the threshold is set between ½ and it.

/// Number of thresholds at which the gradient is compared.
const BINS: usize = 48;
/// The lowest and the highest of them: beyond, gradients are those of noise on ground and marks.
const RANGE: [f64; 2] = [0.2, 0.8];
/// Bins on either side that are averaged: single ones hold the px of a few edges only.
const AROUND: usize = 4;

/// The threshold of the edges in `share` on `size` cells, between 0 (ground) and 1 (marks): from ½ towards the steepest value by
/// the factor `trust`.
#[must_use]
pub fn level(share: &[f32], size: [usize; 2], trust: f64) -> f32 {
    let steepest = steepest(share, size).unwrap_or(0.5);
    (0.5 + trust * (steepest - 0.5)) as f32
}

/// The threshold at which the mean gradient is largest; `None` if no value lies between the limits.
fn steepest(share: &[f32], [width, height]: [usize; 2]) -> Option<f64> {
    let (mut sums, mut counts) = ([0.0_f64; BINS], [0.0_f64; BINS]);
    let scale = BINS as f64 / (RANGE[1] - RANGE[0]);
    for y in 1..height.saturating_sub(1) {
        for x in 1..width.saturating_sub(1) {
            let at = y * width + x;
            let place = (f64::from(share[at]) - RANGE[0]) * scale;
            if place >= 0.0 && place < BINS as f64 {
                let across = f64::from(share[at + 1] - share[at - 1]);
                let down = f64::from(share[at + width] - share[at - width]);
                sums[place as usize] += (across * across + down * down).sqrt();
                counts[place as usize] += 1.0;
            }
        }
    }
    let near = |k: usize| k.saturating_sub(AROUND)..(k + AROUND + 1).min(BINS);
    let mean = |k: usize| {
        let (sum, count) = (near(k).map(|k| sums[k]).sum::<f64>(), near(k).map(|k| counts[k]).sum::<f64>());
        if count > 0.0 { sum / count } else { 0.0 }
    };
    let means: Vec<f64> = (0..BINS).map(mean).collect();
    let top = means.iter().copied().fold(0.0, f64::max);
    if top <= 0.0 {
        return None;
    }
    // Straight edges have equal gradients at all thresholds: the middle of those that are nearly steepest is taken.
    let steep = |mean: &f64| (mean / top - NEARLY).max(0.0);
    let total: f64 = means.iter().map(steep).sum();
    let middle =
        means.iter().enumerate().map(|(k, mean)| (k as f64 + 0.5) * steep(mean)).sum::<f64>() / total;
    Some(RANGE[0] + middle / scale)
}

/// Gradients above this share of the largest count as nearly steepest; the weight increases with the gradient.
const NEARLY: f64 = 0.9;

#[cfg(test)]
mod tests {
    use super::*;

    /// Stripes across x; `profile` is a function of the distance to the middle of the nearest stripe, in half periods.
    fn stripes(profile: impl Fn(f64) -> f64) -> (Vec<f32>, [usize; 2]) {
        let size = [400, 20];
        let out = |x: usize| ((x as f64 + 0.5).rem_euclid(40.0) - 20.0).abs() / 20.0;
        ((0..size[0] * size[1]).map(|k| profile(out(k % size[0])) as f32).collect(), size)
    }

    #[test]
    fn even_edges_have_their_threshold_half_way() {
        let (share, size) = stripes(|out| (0.5 + 5.0 * (0.4 - out)).clamp(0.0, 1.0));
        assert!((level(&share, size, 0.7) - 0.5).abs() < 0.01);
    }

    #[test]
    fn shaded_marks_have_their_edge_where_it_is_steep() {
        // From 0.1 to 0.5 the edge, from there on a slow shade to 1.
        let (share, size) = stripes(|out| {
            if out > 0.5 {
                0.0
            } else if out > 0.4 {
                5.0 * (0.5 - out)
            } else {
                0.5 + 1.25 * (0.4 - out)
            }
        });
        let level = level(&share, size, 0.7);
        assert!((0.3..0.42).contains(&level), "{level}");
    }
}
