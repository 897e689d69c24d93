//! A second colour of the ground, which replaces the first one to some share at each place: a pale belly under a dark back.
//!
//! The gradient's colour C(v) is read as a mixture of the ground C(0) and of something else, with the share of the ground
//!
//! ```text
//! w(v) = 1 − max over u ≤ v of |C(u) − C(0)| / max over all u of |C(u) − C(0)|
//! ```
//!
//! so that where the second colour G has the share s, the px is C(v) + w(v)·(G(s) − C(0)); G(s) lies between C(0) and G in OKLab. Marks
//! keep their colours, and the edge passes from the new ground to the mark without a rim of the old ground.

use super::gradient::{Gradient, Stop};
use crate::grid::to_u16;

/// Steps of the tables; between them colours and shares are linear.
const STEPS: usize = 1_024;
/// Colours that differ by less are one.
const SAME: f64 = 0.5 / 255.0;

/// The second colour of the ground of a layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Ground {
    /// G(s) − C(0) at even shares s: red, green, blue in the coding of sRGB.
    offsets: Vec<[f32; 3]>,
    /// w(v) at even pattern values v.
    shares: Vec<f32>,
}

impl Ground {
    /// The second colour `second` (red, green, blue; 8-bit sRGB) of the ground of `gradient`.
    #[must_use]
    pub fn new(gradient: &Gradient, second: [u8; 3]) -> Self {
        let colours = gradient.sampled(STEPS);
        let first = colours[0];
        let between = Gradient {
            stops: vec![Stop::opaque(0.0, gradient.colour(0.0)), Stop::opaque(1.0, second)],
            bends: Vec::new(),
        };
        let between = between.sampled(STEPS);
        let off =
            |colour: &[f64; 4], from: &[f64; 4]| [0, 1, 2].map(|channel| colour[channel] - from[channel]);
        let far = |colour: &[f64; 4]| off(colour, &first).map(|part| part * part).iter().sum::<f64>().sqrt();
        let farthest = colours.iter().map(far).fold(0.0, f64::max);
        let mut most = 0.0_f64;
        let share = |(step, colour): (usize, &[f64; 4])| {
            // Of a layer in one colour, the pattern itself.
            let away = if farthest < SAME { step as f64 / STEPS as f64 } else { far(colour) / farthest };
            most = most.max(away);
            (1.0 - most) as f32
        };
        Self {
            offsets: between.iter().map(|colour| off(colour, &between[0]).map(|part| part as f32)).collect(),
            shares: colours.iter().enumerate().map(share).collect(),
        }
    }

    /// By how much the colour of the pattern value `v` changes where the second colour has this `share`: red, green, blue in the coding
    /// of sRGB.
    #[inline]
    #[must_use]
    pub fn offset(&self, v: f32, share: f32) -> [f32; 3] {
        let held = between(v, |step| self.shares[step]);
        [0, 1, 2].map(|channel| held * between(share, |step| self.offsets[step][channel]))
    }

    /// `colour`, that of the pattern value `v`, where the second colour has this `share`.
    #[inline]
    #[must_use]
    pub fn tinted(&self, colour: [u8; 3], v: f32, share: f32) -> [u8; 3] {
        let offset = self.offset(v, share);
        [0, 1, 2].map(|channel| {
            (f32::from(colour[channel]) + 255.0 * offset[channel]).round().clamp(0.0, 255.0) as u8
        })
    }

    /// `colour` with its opacity, that of the pattern value `v`, 0..1 each, where the second colour has this `share`.
    #[inline]
    #[must_use]
    pub fn tinted_finely(&self, colour: [f32; 4], v: f32, share: f32) -> [f32; 4] {
        let offset = self.offset(v, share);
        let channel = |channel: usize| (colour[channel] + offset[channel]).clamp(0.0, 1.0);
        [channel(0), channel(1), channel(2), colour[3]]
    }
}

/// The value of a table of [`STEPS`] steps at `at`, 0..1.
#[inline]
fn between(at: f32, value: impl Fn(usize) -> f32) -> f32 {
    // Rounded to 16 bits, as tables of gradients are.
    let place = f32::from(to_u16(at)) / f32::from(u16::MAX) * STEPS as f32;
    let step = (place as usize).min(STEPS - 1);
    let (low, high) = (value(step), value(step + 1));
    low + (place - step as f32) * (high - low)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two(ground: [u8; 3], mark: [u8; 3]) -> Gradient {
        Gradient { stops: vec![Stop::opaque(0.4, ground), Stop::opaque(0.6, mark)], bends: Vec::new() }
    }

    #[test]
    fn the_ground_gets_the_second_colour_and_marks_keep_theirs() {
        let gradient = two([200, 120, 40], [30, 20, 10]);
        let ground = Ground::new(&gradient, [250, 240, 230]);
        let at = |v: f32, share| ground.tinted(gradient.colour(v), v, share);
        assert_eq!([at(0.0, 1.0), at(0.3, 1.0)], [[250, 240, 230]; 2]);
        assert_eq!([at(0.7, 1.0), at(1.0, 1.0)], [[30, 20, 10]; 2]);
        assert_eq!(at(0.2, 0.0), [200, 120, 40]);
        let fine = ground.tinted_finely([200.0, 120.0, 40.0, 255.0].map(|part| part / 255.0), 0.0, 1.0);
        assert!((fine[1] - 240.0 / 255.0).abs() < 1e-3 && fine[3] == 1.0, "{fine:?}");
    }

    #[test]
    fn no_rim_of_the_first_ground_is_seen_at_the_edge() {
        // Orange ground, white belly, black marks: between white and black everything is gray.
        let gradient = two([230, 120, 20], [0; 3]);
        let ground = Ground::new(&gradient, [255; 3]);
        for step in 0..=100 {
            let v = step as f32 / 100.0;
            let [red, green, blue] = ground.tinted(gradient.colour(v), v, 1.0).map(i32::from);
            assert!((red - green).abs() <= 40 && (green - blue).abs() <= 40, "{v}: {red} {green} {blue}");
        }
    }

    #[test]
    fn a_ground_colour_that_comes_back_within_a_mark_stays() {
        // Rings: the middle of a mark has the colour of the ground.
        let stops =
            [(0.0, [90; 3]), (0.5, [0; 3]), (1.0, [90; 3])].map(|(at, colour)| Stop::opaque(at, colour));
        let gradient = Gradient { stops: stops.to_vec(), bends: Vec::new() };
        let ground = Ground::new(&gradient, [255; 3]);
        assert_eq!(ground.tinted(gradient.colour(1.0), 1.0, 1.0), [90; 3]);
    }

    #[test]
    fn a_layer_in_one_colour_has_the_second_one_up_to_its_marks() {
        let gradient = two([90; 3], [90; 3]);
        let ground = Ground::new(&gradient, [200; 3]);
        let at = |v: f32| ground.tinted([90; 3], v, 1.0)[0];
        assert_eq!([at(0.0), at(1.0)], [200, 90]);
    }
}
