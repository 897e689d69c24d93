//! Grown layers → a lit picture of their relief, seen from straight above.

use crate::export::maps::{Green, Surface, encoded};
use crate::export::png::Samples;
use crate::grid::Edges;
use crate::synth::render::lit::{Pictures, from_above};
use crate::synth::render::painting::Painting;
use crate::synth::render::painting::fine::{Colours, to_u8};
use crate::synth::render::painting::finished::encode;
use crate::synth::watch::Watch;

impl Painting<'_> {
    /// The whole texture as a relief that is lit from the upper left: red, green, blue a px, row by row from the top. Transparent
    /// parts are painted over white. Heights of `surface` are in px of the picture. The result has no meaning once `watch` is
    /// cancelled.
    #[must_use]
    pub fn lit(&self, surface: &Surface, edges: Edges, watch: &Watch) -> Vec<u8> {
        let [width, height] = self.size;
        let mut rgba = vec![0; 4 * width * height];
        match self.finished() {
            Some(finished) => encode(finished, 0, false, Samples::Rgba8, &mut rgba),
            None => self.band(0..height).paint_fine(&Colours::new(self, false), Samples::Rgba8, &mut rgba),
        }
        let relief = self.relief(0..height, surface, edges, watch);
        from_above(&Pictures {
            size: self.size,
            colour: &|px| [0, 1, 2, 3].map(|channel| rgba[4 * px + channel]),
            normal: &|px| encoded(relief.normals[px], Green::Up).map(to_u8),
            roughness: &|px| to_u8(relief.roughness[px]),
            occlusion: &|px| to_u8(relief.open[px]),
        })
    }
}
