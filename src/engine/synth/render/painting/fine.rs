//! Colours with more than 8 bits, and with opacity.

use rayon::prelude::*;

use crate::colour::{FineTable, Painted, over, painter};
use crate::export::png::Samples;
use crate::synth::render::painting::{Band, Painting};

/// The background of transparent colours in a picture without opacity.
const WHITE: [f32; 4] = [1.0; 4];

/// The colours of each layer, and that of the ground.
pub(super) struct Colours {
    layers: Vec<FineTable>,
    /// The colour where no layer is visible.
    ground: [f32; 4],
}

impl Colours {
    /// The colours of `painting`; the ground is transparent if `transparent`.
    pub fn new(painting: &Painting, transparent: bool) -> Self {
        let shown = painting.visible.iter().rposition(|visible| *visible);
        let shown = shown.or(painting.gradients.len().checked_sub(1));
        let ground = shown.map_or([1.0; 4], |layer| {
            painting.gradients[layer].rgba(0.0).map(|channel| f64::from(channel) / 255.0)
        });
        let [red, green, blue, _] = ground;
        let layer = |gradient| {
            if transparent { FineTable::over(gradient, [red, green, blue]) } else { FineTable::new(gradient) }
        };
        let mut ground = ground.map(|channel| channel as f32);
        if transparent {
            ground[3] = 0.0;
        }
        Self { layers: painting.gradients.iter().map(layer).collect(), ground }
    }

    /// The colour of a px: that of its topmost layer. If it is transparent, it is painted over the layers beneath that were free to
    /// grow there.
    fn at(&self, painted: &[Painted], px: usize) -> [f32; 4] {
        let mut seen: Option<[f32; 4]> = None;
        let mut beneath = painted;
        while let Some(layer) = painter(beneath, px) {
            let value = painted[layer].pattern.values[px];
            let own = self.layers[layer].colour(value);
            let own = match painted[layer].ground {
                Some((ground, shares)) => ground.tinted_finely(own, value, shares.values[px]),
                None => own,
            };
            let colour = seen.map_or(own, |top| over(top, own));
            if !self.layers[layer].is_see_through {
                return colour;
            }
            seen = Some(colour);
            beneath = &painted[..layer];
        }
        seen.unwrap_or(self.ground)
    }
}

impl Band<'_> {
    /// The colours, in the format of `samples`.
    pub(super) fn paint_fine(&self, colours: &Colours, samples: Samples, bytes: &mut [u8]) {
        let painted = self.painted();
        let deep = matches!(samples, Samples::Rgb16 | Samples::Rgba16);
        let channels = if matches!(samples, Samples::Rgba8 | Samples::Rgba16) { 4 } else { 3 };
        let row = self.width * samples.bytes();
        bytes.par_chunks_mut(row.max(1)).enumerate().for_each(|(y, row)| {
            for (x, out) in row.chunks_exact_mut(samples.bytes()).enumerate() {
                let px = y * self.width + x;
                let mut colour = colours.at(&painted, px);
                if channels == 3 {
                    colour = over(colour, WHITE);
                }
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
            *out = to_u8(colours.at(&painted, px)[3]);
        }
    }
}

/// Rounds to 8 bits.
pub(super) fn to_u8(value: f32) -> u8 {
    (255.0 * value.clamp(0.0, 1.0)).round() as u8
}
