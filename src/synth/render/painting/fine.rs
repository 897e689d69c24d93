//! Colours with more than 8 bits, and with opacity.

use rayon::prelude::*;

use crate::colour::{FineTable, painter};
use crate::export::png::Samples;
use crate::synth::render::painting::{Band, Painting};

/// The colours of each layer, and that of the ground.
pub(super) struct Colours {
    layers: Vec<FineTable>,
    /// Where no layer is visible.
    ground: [f32; 4],
}

impl Colours {
    /// The colours of `painting`; the ground has none where it is `transparent`.
    pub fn new(painting: &Painting, transparent: bool) -> Self {
        let shown = painting.visible.iter().rposition(|visible| *visible);
        let shown = shown.or(painting.gradients.len().checked_sub(1));
        let ground = shown.map_or([1.0; 3], |layer| {
            painting.gradients[layer].colour(0.0).map(|channel| f64::from(channel) / 255.0)
        });
        let layer = |gradient| {
            if transparent { FineTable::over(gradient, ground) } else { FineTable::opaque(gradient) }
        };
        let [red, green, blue] = ground.map(|channel| channel as f32);
        let opacity = if transparent { 0.0 } else { 1.0 };
        Self { layers: painting.gradients.iter().map(layer).collect(), ground: [red, green, blue, opacity] }
    }
}

impl Band<'_> {
    /// The colours, in the format of `samples`.
    pub(super) fn paint_fine(&self, colours: &Colours, samples: Samples, bytes: &mut [u8]) {
        let painted = self.painted();
        let deep = matches!(samples, Samples::Rgb16 | Samples::Rgba16);
        let channels = if matches!(samples, Samples::Rgba8 | Samples::Rgba16) { 4 } else { 3 };
        let row = self.painting.size[0] * samples.bytes();
        bytes.par_chunks_mut(row.max(1)).enumerate().for_each(|(y, row)| {
            for (x, out) in row.chunks_exact_mut(samples.bytes()).enumerate() {
                let px = y * self.painting.size[0] + x;
                let colour = painter(&painted, px).map_or(colours.ground, |layer| {
                    colours.layers[layer].colour(self.patterns[layer].values[px])
                });
                for (channel, value) in colour[..channels].iter().enumerate() {
                    if deep {
                        out[2 * channel..2 * channel + 2]
                            .copy_from_slice(&crate::grid::to_u16(*value).to_be_bytes());
                    } else {
                        out[channel] = to_u8(*value);
                    }
                }
            }
        });
    }

    /// The opacity of each px.
    pub(super) fn opacity(&self, colours: &Colours, gray: &mut [u8]) {
        let painted = self.painted();
        for (px, out) in gray.iter_mut().enumerate() {
            let colour = painter(&painted, px).map_or(colours.ground, |layer| {
                colours.layers[layer].colour(self.patterns[layer].values[px])
            });
            *out = to_u8(colour[3]);
        }
    }
}

/// Rounds to 8 bits.
pub(super) fn to_u8(value: f32) -> u8 {
    (255.0 * value.clamp(0.0, 1.0)).round() as u8
}
