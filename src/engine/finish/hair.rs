//! One hair: its size, its brightness along and across it, and what it covers, wherever its root is.
//!
//! At t along a hair of length L, from its root (0) to its tip (1), and v px off its middle line:
//! half width h·min(1, 4(1 − t))·(.55 + .45·min(1, 6t)); middle line bent by b·L·t²; brightness (.72 + .4t)·(1 − .3(v ÷ h)²).

use super::noise::Random;
use super::surfel::Surfel;

/// Layers of hairs, the lowest first.
pub(super) const LAYERS: usize = 4;
/// The mean number of hairs over a place.
pub(super) const COVER: f32 = 4.0;
/// Opacity of a hair.
pub(super) const OPACITY: f32 = 0.92;
/// Along a hair, the place whose colour it has.
pub(super) const ANCHOR: f32 = 0.36;
/// The longest and the shortest hair ÷ their mean length.
pub(super) const LENGTHS: [f32; 2] = [0.55, 1.55];
/// The widest hair ÷ the mean width.
pub(super) const WIDEST: f32 = 1.4;
/// The largest bend ÷ length.
pub(super) const BEND: f32 = 0.16;
/// Brightness of the skin beneath the hairs.
const SKIN: f32 = 0.45;
/// Height of a layer above the one beneath, px, and by how much the tip is higher than the root ÷ length.
pub(super) const RISE: [f32; 2] = [0.7, 0.12];

/// The mean width of hairs of this mean length, px.
pub(super) fn mean_width(length: f32) -> f32 {
    0.75 + 0.02 * length
}

/// The area to which one layer has one hair, px².
pub(super) fn area_a_hair(length: f32) -> f32 {
    0.8 * LAYERS as f32 * length * mean_width(length) / COVER
}

/// The direction of a hair against the flow, radians, from noise over the coat, of locks and of strands.
pub(super) fn turn([slow, lock, strand]: [f32; 3], random: &mut Random) -> f32 {
    0.3 * slow + 0.3 * lock + 0.22 * strand + 0.1 * random.signed()
}

/// The skin beneath all hairs, of this colour and share of ink.
pub(super) fn skin([red, green, blue, ink]: [f32; 4]) -> Surfel {
    Surfel { colour: [red, green, blue], tint: SKIN, light: 1.0, height: 0.0, roughness: 0.8, ink }
}

/// One hair; lengths in px of the document.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hair {
    pub length: f32,
    pub half_width: f32,
    pub bend: f32,
    tint: f32,
    light: f32,
    /// How far light that the surface of the hair mirrors makes it white, which shows on dark hair.
    sheen: f32,
    roughness: f32,
    /// Height of the root, and by how much the tip is higher.
    height: f32,
    rise: f32,
    /// 1 ÷ length, 1 ÷ half width².
    pub per_length: f32,
    per_half_width_squared: f32,
}

/// A place on a hair.
#[derive(Clone, Copy, Debug)]
pub(super) struct OnHair {
    /// From the root, 0, to the tip, 1.
    pub t: f32,
    /// Off its middle line, px of the document.
    pub off: f32,
    /// Along and across the straight line through its root.
    pub local: [f32; 2],
    /// The share of the px that it covers, if the hair is not thinner than a px.
    pub cover: f32,
}

/// The smaller of two numbers; unlike the library's function not for numbers that are undefined, and so faster.
#[inline(always)]
pub(super) fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

impl Hair {
    /// A hair of a layer of fur with this mean `length`; `across` says how far it lies across the light, 0..1, and `shade` is noise: of
    /// locks, and of the coat.
    pub fn new(random: &mut Random, layer: usize, length: f32, across: f32, shade: [f32; 2]) -> Self {
        let width = mean_width(length);
        let [shortest, longest] = LENGTHS;
        let length = length * (shortest + (longest - shortest) * random.number());
        let half_width = 0.5 * width * (0.6 + (WIDEST - 0.6) * random.number());
        let bend = BEND * length * random.signed();
        let hair = 1.0 + 0.3 * random.signed();
        let glossy = random.number();
        let locks = 1.0 + 0.2 * shade[0];
        let coat = 1.0 + 0.1 * shade[1];
        Self {
            length,
            half_width,
            bend,
            tint: hair * locks * coat,
            light: 0.82 + 0.28 * across,
            sheen: 0.16 * glossy * glossy * (0.4 + 0.6 * across),
            roughness: 0.55 + 0.2 * random.number(),
            height: RISE[0] * layer as f32,
            rise: RISE[1] * length,
            per_length: 1.0 / length,
            per_half_width_squared: 1.0 / (half_width * half_width),
        }
    }

    /// The place from its root, px, whose colour it has.
    pub fn anchor(&self) -> f32 {
        ANCHOR * self.length
    }

    /// Its opacity where `scale` px of the picture are one of the document: a hair that is thinner than a px covers a part of it.
    #[inline(always)]
    pub fn opacity(&self, scale: f32) -> f32 {
        OPACITY * (2.0 * self.half_width * scale).min(1.0)
    }

    /// The place on the hair that lies so far along and across the line through its root, if it covers any of the px there.
    #[inline(always)]
    pub fn at(&self, [along, across]: [f32; 2], scale: f32) -> Option<OnHair> {
        let t = along * self.per_length;
        let off = across - self.bend * t * t;
        let half = self.half_width * least(4.0 - 4.0 * t, 1.0) * (0.55 + 0.45 * least(6.0 * t, 1.0));
        let inside = (half - off.abs()) * scale + 0.5;
        if !((0.0..=1.0).contains(&t) && inside > 0.0) {
            return None;
        }
        Some(OnHair { t, off, local: [along, across], cover: least(inside, 1.0) })
    }

    /// Its height there, px.
    #[inline(always)]
    pub fn height(&self, t: f32) -> f32 {
        self.height + self.rise * t
    }

    /// How it looks there with this colour and share of ink.
    #[inline(always)]
    pub fn surfel(&self, on: &OnHair, [red, green, blue, ink]: [f32; 4]) -> Surfel {
        let round = least(on.off * on.off * self.per_half_width_squared, 1.0);
        Surfel {
            colour: [red, green, blue].map(|channel| channel + self.sheen * (1.0 - channel)),
            tint: self.tint * (0.72 + 0.4 * on.t) * (1.0 - 0.3 * round),
            light: self.light,
            height: self.height(on.t),
            roughness: self.roughness,
            ink,
        }
    }
}
