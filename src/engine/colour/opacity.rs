//! Colours with more than 8 bits, and marks on a transparent ground.
//!
//! A gradient's colour C(v) is split into a colour F(v) and an opacity α(v), such that F over the ground colour G is C again:
//!
//! ```text
//! C = αF + (1 − α)G
//! α(v) = max over u ≤ v of a(C(u)) / max over all u of a(C(u))
//! ```
//!
//! a(C) is the smallest opacity with which a colour over G can give C: the largest over the channels of (C − G)/(1 − G) above G
//! and (G − C)/G below. It is divided by its maximum, so the strongest colour of a mark is opaque. F contains nothing of the
//! ground, so marks have no fringe of it on another ground. α never decreases towards the centre of a mark. It is multiplied by
//! the opacity that the gradient itself has.
//!
//! T. Porter, T. Duff, "Compositing Digital Images", SIGGRAPH 1984, for "over"; F is not multiplied by α.

use super::Gradient;
use crate::grid::to_u16;

/// The lookup table of a gradient with opacity: red, green, blue and opacity, 0..1 each, sRGB.
#[derive(Clone, Debug, PartialEq)]
pub struct FineTable {
    colours: Vec<[f32; 4]>,
    /// Whether the gradient has transparent stops, through which the layers beneath are seen.
    pub is_see_through: bool,
}

/// Opacity that is 0 in 8 bits.
const NONE: f64 = 0.5 / 255.0;

impl FineTable {
    /// The colours, as opaque as the gradient's stops.
    #[must_use]
    pub fn new(gradient: &Gradient) -> Self {
        let colours = gradient.exact().into_iter().map(|colour| with_opacity(colour, 1.0)).collect();
        Self { colours, is_see_through: !gradient.is_opaque() }
    }

    /// Colours that give `gradient` over `ground` (red, green, blue, 0..1 each, sRGB). If the whole gradient has the colour of the
    /// ground, the opacity is the pattern value.
    #[must_use]
    pub fn over(gradient: &Gradient, ground: [f64; 3]) -> Self {
        let exact = gradient.exact();
        let strongest = exact.iter().map(|colour| min_opacity(*colour, ground)).fold(0.0, f64::max);
        let last = (exact.len() - 1) as f64;
        let mut opacity = 0.0_f64;
        let mut colours: Vec<[f32; 4]> = Vec::with_capacity(exact.len());
        for (step, colour) in exact.iter().enumerate() {
            if strongest < NONE {
                colours.push(with_opacity(*colour, step as f64 / last));
                continue;
            }
            opacity = opacity.max(min_opacity(*colour, ground) / strongest);
            let alone = |channel: usize| {
                (ground[channel] + (colour[channel] - ground[channel]) / opacity.max(NONE)).clamp(0.0, 1.0)
            };
            colours.push(with_opacity([alone(0), alone(1), alone(2), colour[3]], opacity));
        }
        // Invisible values get the first visible colour, so that blurring causes no fringe.
        let visible = colours.iter().position(|colour| f64::from(colour[3]) >= NONE).unwrap_or(0);
        let [red, green, blue, _] = colours[visible];
        colours[..visible].iter_mut().for_each(|colour| *colour = [red, green, blue, colour[3]]);
        Self { colours, is_see_through: !gradient.is_opaque() }
    }

    /// The colour of the step nearest to the pattern value `v`.
    #[must_use]
    pub fn colour(&self, v: f32) -> [f32; 4] {
        self.colours[usize::from(to_u16(v))]
    }
}

/// The colour, with `opacity` times its own opacity.
fn with_opacity([red, green, blue, alpha]: [f64; 4], opacity: f64) -> [f32; 4] {
    [red, green, blue, alpha * opacity].map(|channel| channel as f32)
}

/// Colours that differ by less count as equal: half a step of 16 bits. Otherwise rounding errors would give an opacity with an
/// arbitrary colour.
const SAME: f64 = 0.5 / 65_535.0;

/// The smallest opacity with which some colour over `ground` gives `colour`.
fn min_opacity([red, green, blue, _]: [f64; 4], ground: [f64; 3]) -> f64 {
    let channel = |(c, g): (f64, f64)| {
        if (c - g).abs() < SAME {
            0.0
        } else if c > g {
            (c - g) / (1.0 - g)
        } else {
            (g - c) / g
        }
    };
    [red, green, blue].into_iter().zip(ground).map(channel).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::super::{Bend, Stop};
    use super::*;

    fn gradient(stops: &[(f32, [u8; 3])], bends: &[[f64; 4]]) -> Gradient {
        let stops = stops.iter().map(|&(at, colour)| Stop::opaque(at, colour)).collect();
        Gradient { stops, bends: bends.iter().map(|bend| Bend(*bend)).collect() }
    }

    fn examples() -> Vec<Gradient> {
        vec![
            Gradient::default_for_layer(0),
            Gradient::default_for_layer(1),
            gradient(&[(0.0, [244, 227, 193]), (1.0, [59, 35, 20])], &[[0.42, 0.0, 0.58, 1.0]]),
            // Dark, bright, dark like the ground: the centre line of a ring is not transparent.
            gradient(&[(0.0, [20, 20, 20]), (0.5, [250, 200, 10]), (1.0, [20, 20, 20])], &[]),
            gradient(&[(0.0, [255; 3]), (0.48, [255; 3]), (0.52, [0; 3])], &[]),
        ]
    }

    #[test]
    fn over_the_ground_the_gradient_results() {
        for gradient in examples() {
            let ground = gradient.colour(0.0).map(|channel| f64::from(channel) / 255.0);
            let fine = FineTable::over(&gradient, ground);
            for step in 0..=1000_u16 {
                let v = f32::from(step) / 1000.0;
                // As in an 8-bit file.
                let [r, g, b, a] = fine.colour(v).map(|channel| (255.0 * f64::from(channel)).round());
                for (channel, (f, c)) in [r, g, b].into_iter().zip(gradient.colour(v)).enumerate() {
                    let seen = (a * f + (255.0 - a) * 255.0 * ground[channel]) / 255.0;
                    assert!((seen - f64::from(c)).abs() <= 1.5, "{v} {channel}: {seen} {c}");
                }
            }
        }
    }

    #[test]
    fn opacity_increases_from_0_to_1_and_no_colour_contains_the_ground() {
        for gradient in examples() {
            let ground = gradient.colour(0.0).map(|channel| f64::from(channel) / 255.0);
            let fine = FineTable::over(&gradient, ground);
            let opacity: Vec<f32> = (0..=1000).map(|step| fine.colour(step as f32 / 1000.0)[3]).collect();
            assert_eq!([opacity[0], opacity[1000]], [0.0, 1.0]);
            assert!(opacity.windows(2).all(|w| w[0] <= w[1]));
        }
        // White to black: every visible colour is black.
        let fine = FineTable::over(&gradient(&[(0.0, [255; 3]), (1.0, [0; 3])], &[]), [1.0; 3]);
        // The rounding of colours, some 1e-6, divided by the opacity; a quarter of a step of 8 bit is 1e-3.
        assert!((0..=100).all(|step| fine.colour(step as f32 / 100.0)[..3].iter().all(|c| *c < 1e-3)));
    }

    #[test]
    fn a_gradient_of_the_ground_s_colour_is_as_opaque_as_the_pattern() {
        let fine = FineTable::over(&gradient(&[(0.0, [9; 3])], &[]), [9.0 / 255.0; 3]);
        assert!((fine.colour(0.25)[3] - 0.25).abs() < 1e-4);
    }

    #[test]
    fn opaque_colours_round_to_those_of_the_8_bit_table() {
        for gradient in examples() {
            let (fine, table) = (FineTable::new(&gradient), gradient.table());
            for step in 0..=1000_u16 {
                let v = f32::from(step) / 1000.0;
                let [r, g, b, a] = fine.colour(v);
                assert_eq!(a, 1.0);
                for (fine, coarse) in [r, g, b].into_iter().zip(table.colour(v)) {
                    assert!((255.0 * fine - f32::from(coarse)).abs() <= 0.5001);
                }
            }
        }
    }

    #[test]
    fn the_opacity_of_stops_is_multiplied_by_that_over_the_ground() {
        let opaque = gradient(&[(0.0, [255; 3]), (1.0, [0; 3])], &[]);
        let mut faint = opaque.clone();
        faint.stops.iter_mut().for_each(|stop| stop.alpha = 51);
        let [opaque, faint] = [opaque, faint].map(|gradient| FineTable::over(&gradient, [1.0; 3]));
        for v in [0.0, 0.3, 0.7, 1.0] {
            assert!((faint.colour(v)[3] - 0.2 * opaque.colour(v)[3]).abs() < 1e-6, "{v}");
        }
        assert!(faint.is_see_through && !opaque.is_see_through);
    }
}
