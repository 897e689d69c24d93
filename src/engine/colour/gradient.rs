//! Gradient: pattern value → colour.

use palette::{FromColor, LinSrgb, Oklab, Srgb};
use rayon::prelude::*;

use super::Bend;
use crate::grid::{exp, ln};

/// A colour at a pattern value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// The pattern value with this colour, 0..1 (0 = ground, 0.5 = the mark's edge, 1 = its centre).
    pub at: f32,
    /// Red, green, blue; 8-bit sRGB.
    pub colour: [u8; 3],
    /// Opacity: 0 = transparent, 255 = opaque.
    pub alpha: u8,
}

impl Stop {
    /// An opaque stop.
    #[must_use]
    pub const fn opaque(at: f32, colour: [u8; 3]) -> Self {
        Self { at, colour, alpha: u8::MAX }
    }
}

/// The colours of one layer: stops in increasing order and the easings between them.
///
/// Below the first stop and above the last the colour is constant. Two stops at the same value are a hard step: the later one
/// holds from there on. Between stops, colours are interpolated in OKLab; colours outside of sRGB are clipped channel by channel.
/// Between stops of different opacity they are interpolated multiplied by it, so that the colour of a transparent stop does not
/// shine through.
///
/// B. Ottosson, "A perceptual color space for image processing" (2020). For the opacity: W3C, "CSS Color Module Level 4", 12.3.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    /// At least one, `at` never decreasing. Without stops everything is black.
    pub stops: Vec<Stop>,
    /// `bends[i]` is the easing from stop i to stop i + 1; missing ones are linear.
    pub bends: Vec<Bend>,
}

impl Gradient {
    /// Whether stops rise from 0 to at most 1, and bends are functions between them.
    #[cfg(test)]
    pub(crate) fn is_valid(&self) -> bool {
        let rise = !self.stops.is_empty() && self.stops.is_sorted_by(|a, b| a.at <= b.at);
        let inside = self.stops.iter().all(|stop| (0.0..=1.0).contains(&stop.at));
        let functions = self.bends.iter().all(|Bend([x1, y1, x2, y2])| {
            [x1, x2].iter().all(|x| (0.0..=1.0).contains(*x)) && y1.is_finite() && y2.is_finite()
        });
        rise && inside && functions && self.bends.len() < self.stops.len()
    }

    /// Whether no stop is transparent.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.stops.iter().all(|stop| stop.alpha == u8::MAX)
    }

    /// The colour of the pattern value `v`, which is clamped to 0..1, without its opacity; NaN counts as 0.
    ///
    /// For a whole picture use the [`table`](Self::table).
    ///
    /// ```
    /// use dapple_engine::colour::{Gradient, Stop};
    ///
    /// let gradient = Gradient {
    ///     stops: vec![Stop::opaque(0.0, [255, 255, 255]), Stop::opaque(1.0, [0, 0, 0])],
    ///     bends: Vec::new(),
    /// };
    /// assert_eq!((gradient.colour(0.0), gradient.colour(1.0)), ([255; 3], [0; 3]));
    /// ```
    #[must_use]
    pub fn colour(&self, v: f32) -> [u8; 3] {
        let [red, green, blue, _] = self.rgba(v);
        [red, green, blue]
    }

    /// The colour of the pattern value `v` with its opacity: red, green, blue, alpha, not multiplied.
    #[must_use]
    pub fn rgba(&self, v: f32) -> [u8; 4] {
        self.mix(&self.lab(), v)
    }

    /// The colours of several pattern values, with their opacity: faster than one by one.
    #[must_use]
    pub fn rgbas(&self, values: impl IntoIterator<Item = f32>) -> Vec<[u8; 4]> {
        let lab = self.lab();
        values.into_iter().map(|v| self.mix(&lab, v)).collect()
    }

    /// The colours of several pattern values, without their opacity.
    #[must_use]
    pub fn colours(&self, values: impl IntoIterator<Item = f32>) -> Vec<[u8; 3]> {
        self.rgbas(values).into_iter().map(|[red, green, blue, _]| [red, green, blue]).collect()
    }

    /// The position of the colour of stop `stop` on the line from the colour of stop `from` to that of stop `to`, in OKLab, 0..1.
    /// Between stops of one colour, the position of the stop's value instead.
    #[must_use]
    pub fn share(&self, from: usize, stop: usize, to: usize) -> f64 {
        let lab = self.lab();
        let [a, b, c] = [from, stop, to].map(|i| [lab[i].l, lab[i].a, lab[i].b]);
        let dot = |p: [f64; 3]| (0..3).map(|i| (p[i] - a[i]) * (c[i] - a[i])).sum::<f64>();
        let [p, q, r] = [from, stop, to].map(|i| f64::from(self.stops[i].at));
        let share = if dot(c) > 0.0 { dot(b) / dot(c) } else { (q - p) / (r - p) };
        if share.is_nan() { 0.5 } else { share.clamp(0.0, 1.0) }
    }

    /// The colours of all 65536 values of a 16-bit picture of a pattern, over white where they are transparent.
    pub(super) fn computed_table(&self) -> Vec<[u8; 3]> {
        let lab = self.lab();
        let colour = |i| on_white(self.srgba(&lab, f32::from(i) / 65535.0));
        (0..=u16::MAX).into_par_iter().map(colour).collect()
    }

    /// The stops' colours in OKLab.
    fn lab(&self) -> Vec<Oklab<f64>> {
        let lab = |stop: &Stop| Oklab::from_color(Srgb::from(stop.colour).into_linear::<f64>());
        self.stops.iter().map(lab).collect()
    }

    /// The colours of all 65536 values of a 16-bit picture of a pattern: red, green, blue, alpha, 0..1 each.
    pub(super) fn exact(&self) -> Vec<[f64; 4]> {
        let lab = self.lab();
        (0..=u16::MAX).into_par_iter().map(|i| self.srgba(&lab, f32::from(i) / 65535.0)).collect()
    }

    /// The colours of `steps` + 1 even pattern values from 0 to 1: red, green, blue, alpha, 0..1 each.
    pub(super) fn sampled(&self, steps: usize) -> Vec<[f64; 4]> {
        let lab = self.lab();
        (0..=steps).map(|step| self.srgba(&lab, step as f32 / steps as f32)).collect()
    }

    fn mix(&self, lab: &[Oklab<f64>], v: f32) -> [u8; 4] {
        self.srgba(lab, v).map(|channel| (channel * 255.0).round() as u8)
    }

    fn srgba(&self, lab: &[Oklab<f64>], v: f32) -> [f64; 4] {
        let v = if v.is_nan() { 0.0 } else { v.clamp(0.0, 1.0) };
        let own = |stop: &Stop| {
            let [red, green, blue] = stop.colour;
            [red, green, blue, stop.alpha].map(|channel| f64::from(channel) / 255.0)
        };
        let behind = self.stops.iter().rposition(|stop| stop.at <= v);
        match behind {
            None => self.stops.first().map_or([0.0, 0.0, 0.0, 1.0], own),
            Some(last) if last + 1 == self.stops.len() => own(&self.stops[last]),
            Some(i) => {
                let [from, to] = [f64::from(self.stops[i].at), f64::from(self.stops[i + 1].at)];
                let share = (f64::from(v) - from) / (to - from);
                let t = self.bends.get(i).map_or(share, |bend| bend.ease(share));
                let (share, alpha) = blended([self.stops[i].alpha, self.stops[i + 1].alpha], t);
                let [red, green, blue] = to_srgb(lab[i] + (lab[i + 1] - lab[i]) * share);
                [red, green, blue, alpha]
            }
        }
    }
}

/// The share of the second colour, and the opacity, `t` of the way between two stops of these opacities. If these differ, an easing
/// that overshoots is clipped.
fn blended([first, second]: [u8; 2], t: f64) -> (f64, f64) {
    if first == second {
        return (t, f64::from(first) / 255.0);
    }
    let t = t.clamp(0.0, 1.0);
    let [of_first, of_second] = [(1.0 - t) * f64::from(first), t * f64::from(second)];
    let sum = of_first + of_second;
    // A transparent stop itself is not visible: it has the colour of its surroundings.
    let share = if sum > 0.0 { of_second / sum } else { f64::from(u8::from(first == 0)) };
    (share, sum / 255.0)
}

/// A colour over white, 8 bits a channel.
fn on_white([red, green, blue, alpha]: [f64; 4]) -> [u8; 3] {
    // Opaque colours are not changed by rounding.
    let over = |channel: f64| if alpha < 1.0 { alpha * channel + 1.0 - alpha } else { channel };
    [red, green, blue].map(|channel| (over(channel) * 255.0).round() as u8)
}

/// OKLab → sRGB, each channel clipped to 0..1.
fn to_srgb(lab: Oklab<f64>) -> [f64; 3] {
    let (red, green, blue) = LinSrgb::from_color(lab).into_components();
    [red, green, blue].map(|channel: f64| encoded(channel).clamp(0.0, 1.0))
}

/// A channel of linear sRGB as it is encoded (IEC 61966-2-1), to 10⁻¹⁰: faster than by the general power.
fn encoded(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * exp(ln(linear) / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests;
