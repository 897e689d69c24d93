//! Gradient: pattern value → colour.

use palette::{FromColor, LinSrgb, Oklab, Srgb};
use rayon::prelude::*;
use thiserror::Error;

use super::Bend;

/// A colour at a pattern value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// The pattern value with this colour, 0..1 (0 = ground, 0.5 = the mark's edge, 1 = its centre).
    pub at: f32,
    /// Red, green, blue; 8-bit sRGB.
    pub colour: [u8; 3],
}

/// The colours of one layer: stops in increasing order and the easings between them.
///
/// Below the first stop and above the last the colour is constant. Two stops at the same value are a hard step: the later one
/// holds from there on. Between stops, colours are interpolated in OKLab; colours outside of sRGB are clipped channel by channel.
///
/// B. Ottosson, "A perceptual color space for image processing" (2020).
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient {
    /// At least one, `at` never decreasing. Without stops everything is black.
    pub stops: Vec<Stop>,
    /// `bends[i]` is the easing from stop i to stop i + 1; missing ones are linear.
    pub bends: Vec<Bend>,
}

/// Why a gradient is invalid.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum GradientError {
    /// There are no stops.
    #[error("`stops` is empty; give at least one, such as {{\"at\": 0, \"colour\": \"#f4e3c1\"}}")]
    NoStops,
    /// A stop outside 0..1.
    #[error(
        "`stops[{stop}].at` is {at}; allowed is 0 to 1 (0 = ground, 0.5 = the mark's edge, 1 = its centre)"
    )]
    StopOutside {
        /// Index into `stops`.
        stop: usize,
        /// The given value.
        at: f32,
    },
    /// A stop below the one before it.
    #[error(
        "`stops[{stop}].at` is {at}, less than the {before} of the stop before it; sort the stops by `at`"
    )]
    StopsFall {
        /// Index into `stops`.
        stop: usize,
        /// The given value.
        at: f32,
        /// The value of the stop before it.
        before: f32,
    },
    /// More bends than gaps between stops.
    #[error("{bends} `bends` for {stops} `stops`; allowed is at most one between two stops, {}", stops - 1)]
    TooManyBends {
        /// Number of bends.
        bends: usize,
        /// Number of stops.
        stops: usize,
    },
    /// A bend that is not a function, or not finite.
    #[error(
        "`bends[{bend}]` is {value:?}; allowed are x1, y1, x2, y2 as in CSS: x1 and x2 from 0 to 1, y1 and y2 any number"
    )]
    BadBend {
        /// Index into `bends`.
        bend: usize,
        /// The given value.
        value: [f64; 4],
    },
}

impl Gradient {
    /// Checks stops and bends.
    ///
    /// # Errors
    /// The first problem, with name, value and what is allowed.
    pub fn check(&self) -> Result<(), GradientError> {
        if self.stops.is_empty() {
            return Err(GradientError::NoStops);
        }
        for (stop, &Stop { at, .. }) in self.stops.iter().enumerate() {
            if !(0.0..=1.0).contains(&at) {
                return Err(GradientError::StopOutside { stop, at });
            }
        }
        for (i, pair) in self.stops.windows(2).enumerate() {
            if pair[1].at < pair[0].at {
                return Err(GradientError::StopsFall { stop: i + 1, at: pair[1].at, before: pair[0].at });
            }
        }
        if self.bends.len() >= self.stops.len() {
            return Err(GradientError::TooManyBends { bends: self.bends.len(), stops: self.stops.len() });
        }
        for (bend, &Bend(value)) in self.bends.iter().enumerate() {
            let [x1, y1, x2, y2] = value;
            let x_in_range = [x1, x2].iter().all(|x| (0.0..=1.0).contains(x));
            if !x_in_range || !y1.is_finite() || !y2.is_finite() {
                return Err(GradientError::BadBend { bend, value });
            }
        }
        Ok(())
    }

    /// The colour of the pattern value `v`, which is clamped to 0..1; NaN counts as 0.
    ///
    /// For a whole picture use the [`table`](Self::table).
    #[must_use]
    pub fn colour(&self, v: f32) -> [u8; 3] {
        self.mix(&self.lab(), v)
    }

    /// The colours of several pattern values: faster than one by one.
    #[must_use]
    pub fn colours(&self, values: impl IntoIterator<Item = f32>) -> Vec<[u8; 3]> {
        let lab = self.lab();
        values.into_iter().map(|v| self.mix(&lab, v)).collect()
    }

    /// The position of the colour of stop `stop` on the line from the colour of stop `from` to that of stop `to`, in OKLab, 0..1.
    /// Between stops of the same colour, the position of the stop's value instead.
    #[must_use]
    pub fn share(&self, from: usize, stop: usize, to: usize) -> f64 {
        let lab = self.lab();
        let [a, b, c] = [from, stop, to].map(|i| [lab[i].l, lab[i].a, lab[i].b]);
        let dot = |p: [f64; 3]| (0..3).map(|i| (p[i] - a[i]) * (c[i] - a[i])).sum::<f64>();
        let [p, q, r] = [from, stop, to].map(|i| f64::from(self.stops[i].at));
        let share = if dot(c) > 0.0 { dot(b) / dot(c) } else { (q - p) / (r - p) };
        if share.is_nan() { 0.5 } else { share.clamp(0.0, 1.0) }
    }

    /// The colours of all 65536 values of a 16-bit picture of a pattern.
    pub(super) fn computed_table(&self) -> Vec<[u8; 3]> {
        let lab = self.lab();
        (0..=u16::MAX).into_par_iter().map(|i| self.mix(&lab, f32::from(i) / 65535.0)).collect()
    }

    /// The stops' colours in OKLab.
    fn lab(&self) -> Vec<Oklab<f64>> {
        let lab = |stop: &Stop| Oklab::from_color(Srgb::from(stop.colour).into_linear::<f64>());
        self.stops.iter().map(lab).collect()
    }

    /// The colours of all 65536 values of a 16-bit picture of a pattern: red, green, blue, 0..1 each.
    pub(super) fn exact(&self) -> Vec<[f64; 3]> {
        let lab = self.lab();
        (0..=u16::MAX).into_par_iter().map(|i| self.srgb(&lab, f32::from(i) / 65535.0)).collect()
    }

    fn mix(&self, lab: &[Oklab<f64>], v: f32) -> [u8; 3] {
        self.srgb(lab, v).map(|channel| (channel * 255.0).round() as u8)
    }

    fn srgb(&self, lab: &[Oklab<f64>], v: f32) -> [f64; 3] {
        let v = if v.is_nan() { 0.0 } else { v.clamp(0.0, 1.0) };
        let own = |stop: &Stop| stop.colour.map(|channel| f64::from(channel) / 255.0);
        let behind = self.stops.iter().rposition(|stop| stop.at <= v);
        match behind {
            None => self.stops.first().map_or([0.0; 3], own),
            Some(last) if last + 1 == self.stops.len() => own(&self.stops[last]),
            Some(i) => {
                let [from, to] = [f64::from(self.stops[i].at), f64::from(self.stops[i + 1].at)];
                let share = (f64::from(v) - from) / (to - from);
                let t = self.bends.get(i).map_or(share, |bend| bend.ease(share));
                to_srgb(lab[i] + (lab[i + 1] - lab[i]) * t)
            }
        }
    }
}

/// OKLab → sRGB, each channel clipped to 0..1.
fn to_srgb(lab: Oklab<f64>) -> [f64; 3] {
    let (red, green, blue) = Srgb::from_linear(LinSrgb::from_color(lab)).into_components();
    [red, green, blue].map(|channel: f64| channel.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests;
