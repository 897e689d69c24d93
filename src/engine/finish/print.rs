//! Halftone print: dots of cyan, magenta, yellow and black ink on white paper, each on a screen at its own angle.
//!
//! The screens stand at 15°, 75°, 0° and 45°, as usual in offset print. Their periods are fitted so that whole periods cover the
//! canvas, which turns them by a fraction of a degree.

use super::noise::{Noise, floor, part_seed};
use super::surfel::{Source, Surfel};
use crate::grid::sin_cos_degrees;

/// Angles of the screens of cyan, magenta, yellow and black, degrees.
const ANGLES: [f64; 4] = [15.0, 75.0, 0.0, 45.0];
/// What each ink lets through of red, green and blue.
const INKS: [[f32; 3]; 4] = [[0.05, 0.66, 0.9], [0.9, 0.12, 0.5], [1.0, 0.94, 0.1], [0.1, 0.1, 0.1]];
/// The largest share of the common part of the colours that is printed in black.
const BLACK: f32 = 0.85;
/// The paper.
const PAPER: [f32; 3] = [0.985, 0.98, 0.96];

/// Steps of the coverage of a screen.
const STEPS: usize = 256;

/// A screen of dots: waves along two directions.
#[derive(Clone, Copy, Debug)]
struct Screen([[f32; 2]; 2]);

/// A parabola through the zeros and the extremes of the cosine of `turns` whole turns.
#[inline]
fn wave(turns: f32) -> f32 {
    let from_half = (2.0 * (turns - floor(turns) as f32) - 1.0).abs();
    if from_half > 0.5 {
        1.0 - 4.0 * (1.0 - from_half) * (1.0 - from_half)
    } else {
        4.0 * from_half * from_half - 1.0
    }
}

/// For each share of a screen that ink covers, in equal steps from 0 to 1, the height of the waves above which it lies.
fn levels() -> Vec<f32> {
    const SIDE: usize = 64;
    let phase = |i: usize| (i as f32 + 0.5) / SIDE as f32;
    let height = |i: usize| wave(phase(i % SIDE)) + wave(phase(i / SIDE));
    let mut heights: Vec<f32> = (0..SIDE * SIDE).map(height).collect();
    heights.sort_by(|a, b| b.total_cmp(a));
    (0..=STEPS).map(|step| heights[(step * SIDE * SIDE / STEPS).min(SIDE * SIDE - 1)]).collect()
}

impl Screen {
    fn new(canvas: [f32; 2], period: f32, degrees: f64) -> Self {
        let (sin, cos) = sin_cos_degrees(degrees);
        let waves = |part: f64, axis: usize| (canvas[axis] * part as f32 / period).round() / canvas[axis];
        Self([[waves(cos, 0), waves(sin, 1)], [waves(-sin, 0), waves(cos, 1)]])
    }

    /// The height of the waves at a point, −2..2: dots grow from the crests, and gaps close at the troughs.
    #[inline]
    fn height(&self, point: [f32; 2]) -> f32 {
        self.0.iter().map(|along| wave(along[0] * point[0] + along[1] * point[1])).sum()
    }
}

/// A halftone print with screens of this `period`, px.
#[must_use]
pub fn halftone(source: &Source, period: f32) -> Vec<Surfel> {
    source.shaded(surfel(source, period))
}

pub(super) fn surfel<'a>(source: &'a Source, period: f32) -> impl Fn([f32; 2]) -> Surfel + Sync + 'a {
    let screens = ANGLES.map(|degrees| Screen::new(source.canvas, period, degrees));
    let grain = Noise::new(source.canvas, 0.35 * period, part_seed(source.seed, 80));
    // From no ink to full ink over one sample of the picture.
    let sharp = 0.12 * period * source.scale()[0] * if source.scale()[0] < 2.0 { 2.0 } else { 1.0 };
    let levels = levels();
    move |point| {
        let [red, green, blue, ink] = source.at(point);
        let missing = [1.0 - red, 1.0 - green, 1.0 - blue];
        // Light colours are printed without black, whose dots would show.
        let common = missing[0].min(missing[1]).min(missing[2]);
        let black = BLACK * common * (2.5 * common - 0.25).clamp(0.0, 1.0);
        let rest = missing.map(|missing| (missing - black) / (1.0 - black));
        let paper = grain.at(point);
        let mut colour = PAPER.map(|channel| channel * (1.0 + 0.012 * paper));
        let mut wet = 0.0_f32;
        for (index, amount) in [rest[0], rest[1], rest[2], black].into_iter().enumerate() {
            let level = levels[(amount.clamp(0.0, 1.0) * STEPS as f32) as usize];
            let dot = ((screens[index].height(point) - level + 0.1 * paper) * sharp + 0.5).clamp(0.0, 1.0);
            let covered = if amount <= 0.01 { 0.0 } else { dot };
            wet = wet.max(covered);
            for (channel, passed) in colour.iter_mut().zip(INKS[index]) {
                *channel *= 1.0 - covered * (1.0 - passed);
            }
        }
        Surfel {
            colour,
            tint: 1.0,
            light: 1.0,
            height: 0.01 * wet * period + 0.02 * paper,
            roughness: 0.9 - 0.35 * wet,
            ink,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dots_cover_the_share_that_is_asked_for() {
        let (screen, levels) = (Screen::new([64.0, 64.0], 6.0, 15.0), levels());
        for share in [0.1_f32, 0.3, 0.5, 0.8] {
            let covered = (0..256 * 256).filter(|i| {
                let point = [(i % 256) as f32 * 0.25, (i / 256) as f32 * 0.25];
                screen.height(point) > levels[(share * STEPS as f32) as usize]
            });
            let found = covered.count() as f32 / 65_536.0;
            assert!((found - share).abs() < 0.02, "{share}: {found}");
        }
    }
}
