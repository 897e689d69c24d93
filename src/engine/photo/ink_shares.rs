//! Marks and ground, by comparison with the surroundings: local segmentation with two means.
//!
//! ```text
//! cᵢ(x) = Σ w·[c > m]·c ÷ Σ w·[c > m]     c_g(x) = Σ w·[c ≤ m]·c ÷ Σ w·[c ≤ m]     m(x) = (cᵢ + c_g) ÷ 2
//! p(x) = (c − c_g) ÷ max(cᵢ − c_g, floor)
//! ```
//!
//! with Gaussian weights w of one wavelength: the two means and their midpoint m are computed in turn, as in the threshold
//! selection of T. Ridler & S. Calvard ("Picture thresholding using an iterative selection method", IEEE Trans. SMC 8 (1978)), but
//! for each place separately. In the end the means are those of the clear insides alone, so that the px of blurred edges have no
//! effect.

use rayon::prelude::*;

use super::coarse::{Blocks, Coarse, wide};

/// Rounds of means and midpoints: from the fourth on the midpoints of textures move by less than a hundredth of the contrast.
const ROUNDS: usize = 5;
/// Clear insides are this far from the midpoint: p below ½ − CLEAR or above ½ + CLEAR.
const CLEAR: f32 = 0.25;
/// Weight of the mean over the whole picture, as a share of the neighbourhood: a place without ink gets the mean ink of the
/// picture.
const WHOLE: f32 = 0.002;
/// Least difference of ink and ground as a share of their usual difference; with a smaller one there is no ink, only noise. Tried
/// on degraded textures (photographs with vignettes lose up to half of their contrast).
const FLOOR: f32 = 0.35;

/// Ink and ground of each place.
#[derive(Clone, Debug)]
pub struct InkShares {
    /// Ground = 0, ink = 1; one value a cell. Not clipped.
    pub share: Vec<f32>,
    /// The usual difference of ink and ground, in units of the channel: its median over the picture.
    pub contrast: f32,
}

/// The means of ink and ground around each place.
struct Means {
    ink: Coarse,
    ground: Coarse,
}

/// The shares of ink in a channel on `size` cells, whose marks repeat after about `wavelength` cells. Ink is where the channel is
/// high.
#[must_use]
pub fn ink_shares(channel: &[f32], size: [usize; 2], wavelength: f64) -> InkShares {
    let blocks = Blocks::new(size, wavelength);
    let (slow, threshold) = beginning(channel, size, wavelength);
    let mut around = means(
        channel,
        blocks,
        |_| (),
        |(), _, cell| {
            let above = channel[cell] - slow[cell] > threshold;
            [above, !above]
        },
    );
    drop(slow);
    for _ in 1..ROUNDS {
        let midpoint = around.midpoint();
        around = means(
            channel,
            blocks,
            |y| midpoint.row(y),
            |row, x, cell| {
                let above = channel[cell] > midpoint.in_row(row, x);
                [above, !above]
            },
        );
    }
    let [low, high] = [0.5 - CLEAR, 0.5 + CLEAR];
    let around = means(
        channel,
        blocks,
        |y| around.rows(y),
        |rows, x, cell| {
            let share = around.share(rows, x, channel[cell], 0.0);
            [share > high, share < low]
        },
    );
    let contrast = around.contrast();
    let floor = FLOOR * contrast;
    let mut share = vec![0.0; channel.len()];
    share.par_chunks_mut(size[0]).enumerate().for_each(|(y, out)| {
        let rows = around.rows(y);
        let values = &channel[y * size[0]..];
        out.iter_mut().enumerate().for_each(|(x, out)| *out = around.share(&rows, x, values[x], floor));
    });
    InkShares { share, contrast }
}

impl Means {
    fn midpoint(&self) -> Coarse {
        let pairs = self.ink.values.iter().zip(&self.ground.values);
        Coarse { values: pairs.map(|(ink, ground)| 0.5 * (ink + ground)).collect(), ..self.ink.clone() }
    }

    /// The means along a row of cells, ink and ground.
    fn rows(&self, y: usize) -> [Vec<f32>; 2] {
        [self.ink.row(y), self.ground.row(y)]
    }

    /// The position of `value` between ground (0) and ink (1) in a column of such rows.
    fn share(&self, rows: &[Vec<f32>; 2], x: usize, value: f32, floor: f32) -> f32 {
        let (ink, ground) = (self.ink.in_row(&rows[0], x), self.ground.in_row(&rows[1], x));
        (value - ground) / (ink - ground).max(floor).max(f32::MIN_POSITIVE)
    }

    /// The median of the difference of ink and ground.
    fn contrast(&self) -> f32 {
        let pairs = self.ink.values.iter().zip(&self.ground.values);
        let mut apart: Vec<f32> = pairs.map(|(ink, ground)| ink - ground).collect();
        apart.sort_by(f32::total_cmp);
        apart[apart.len() / 2].max(0.0)
    }
}

/// The channel, blurred by two wavelengths, and the height above it at which ink begins: by Otsu's threshold of the difference.
fn beginning(channel: &[f32], size: [usize; 2], wavelength: f64) -> (Vec<f32>, f32) {
    let slow = wide(channel, size, 2.0 * wavelength);
    let apart: Vec<f32> = channel.iter().zip(&slow).map(|(value, slow)| value - slow).collect();
    (slow, split(&apart))
}

/// Bins of the histogram that is split: narrower than the noise of photographs.
const BINS: usize = 512;

/// The threshold between the two groups of values that differ most from each other (N. Otsu, "A threshold selection method from
/// gray-level histograms", IEEE Trans. SMC 9 (1979)).
fn split(values: &[f32]) -> f32 {
    let low = values.iter().copied().fold(f32::INFINITY, f32::min);
    let high = values.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    let width = (high - low) / BINS as f32;
    if width <= 0.0 {
        return low;
    }
    let mut counts = [0_u32; BINS];
    values.iter().for_each(|value| counts[(((value - low) / width) as usize).min(BINS - 1)] += 1);
    let total = values.len() as f64;
    let sum: f64 = counts.iter().enumerate().map(|(bin, count)| bin as f64 * f64::from(*count)).sum();
    let (mut below, mut sum_below, mut best, mut at) = (0.0, 0.0, -1.0, 0);
    for (bin, count) in counts.iter().enumerate() {
        below += f64::from(*count);
        sum_below += bin as f64 * f64::from(*count);
        let above = total - below;
        if below > 0.0 && above > 0.0 {
            let apart = (sum - sum_below) / above - sum_below / below;
            if below * above * apart * apart > best {
                (best, at) = (below * above * apart * apart, bin);
            }
        }
    }
    low + width * (at as f32 + 1.0)
}

/// The means over the cells that `side` classifies as ink and as ground. `row` prepares the data of a row of cells for it.
fn means<R>(
    channel: &[f32],
    blocks: Blocks,
    row: impl Fn(usize) -> R + Sync,
    side: impl Fn(&R, usize, usize) -> [bool; 2] + Sync,
) -> Means {
    let [ink, inks, ground, grounds] = blocks.blurred(row, |row, x, cell| {
        let [ink, ground] = side(row, x, cell).map(|is| f32::from(u8::from(is)));
        [ink * channel[cell], ink, ground * channel[cell], ground]
    });
    let total = |values: &[f32]| values.iter().map(|value| f64::from(*value)).sum::<f64>();
    let mean = |sum: &[f32], count: &[f32]| (total(sum) / total(count).max(f64::MIN_POSITIVE)) as f32;
    let (whole_ink, whole_ground) = (mean(&ink, &inks), mean(&ground, &grounds));
    let weight = WHOLE * (blocks.cells_a_block() as f32);
    let field = |sum: &[f32], count: &[f32], whole: f32| {
        let each = sum.iter().zip(count);
        blocks.field(each.map(|(sum, count)| (sum + weight * whole) / (count + weight)).collect())
    };
    Means { ink: field(&ink, &inks, whole_ink), ground: field(&ground, &grounds, whole_ground) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Discs of radius 5 every 20 cells on `size` cells: 1 inside, 0 outside.
    fn discs(size: [usize; 2]) -> Vec<f32> {
        let near = |x: usize| (x as f64 + 0.5).rem_euclid(20.0) - 10.0;
        let cell = |k: usize| if near(k % size[0]).hypot(near(k / size[0])) < 5.0 { 1.0 } else { 0.0 };
        (0..size[0] * size[1]).map(cell).collect()
    }

    #[test]
    fn light_that_falls_off_leaves_ink_and_ground_as_they_are() {
        let size = [160, 120];
        let discs = discs(size);
        // From corner to corner the light increases by three times the contrast, and the contrast doubles.
        let light =
            |k: usize| ((k % size[0]) as f32 / size[0] as f32 + (k / size[0]) as f32 / size[1] as f32) / 2.0;
        let channel: Vec<f32> = discs
            .iter()
            .enumerate()
            .map(|(k, disc)| 0.9 * light(k) + 0.2 * (1.0 + light(k)) * disc)
            .collect();
        let found = ink_shares(&channel, size, 20.0);
        let wrong =
            found.share.iter().zip(&discs).filter(|(share, disc)| (**share > 0.5) != (**disc > 0.5)).count();
        assert!(wrong <= 3, "{wrong}");
        assert!((found.contrast / 0.3 - 1.0).abs() < 0.1, "{}", found.contrast);
    }

    #[test]
    fn a_place_without_ink_stays_ground() {
        let size = [200, 120];
        let mut channel = discs(size);
        for (k, value) in channel.iter_mut().enumerate() {
            let noise = ((k * 7919) % 1000) as f32 / 1000.0 - 0.5;
            *value = if k % size[0] > 110 { 0.0 } else { *value } + 0.2 * noise;
        }
        let found = ink_shares(&channel, size, 20.0);
        let ink =
            found.share.iter().enumerate().filter(|(k, share)| k % size[0] > 115 && **share > 0.5).count();
        assert_eq!(ink, 0);
    }
}
