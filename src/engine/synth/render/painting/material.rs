//! Grown layers → the maps of a material.

use std::io::Write;
use std::ops::Range;

use crate::document::Document;
use crate::export::Stopped;
use crate::export::gltf::Plane;
use crate::export::maps::{Green, Surface, encoded, share_of};
use crate::export::material::{Failed, Map, Set, id_colour, write};
use crate::grid::{Edges, to_u16};
use crate::synth::render::painting::Painting;
use crate::synth::render::painting::fine::{Colours, to_u8};
use crate::synth::render::painting::finished::encode;
use crate::synth::render::painting::relief::radius;
use crate::synth::watch::{Stage, Watch};

/// px of a band: few compared to the picture, enough for all threads.
const BAND_PX: usize = 1 << 20;

/// The usual relief of a document, px: that of its finish.
#[must_use]
pub fn usual_relief(document: &Document) -> Vec<f64> {
    document
        .finish
        .as_ref()
        .map_or(Surface::default().relief, |finishing| vec![finishing.finish.kind.relief()])
}

/// Settings of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Making {
    /// Heights, in px of the canvas, and roughness.
    pub surface: Surface,
    /// px of the pictures along each px of the canvas.
    pub scale: usize,
    /// Continuation beyond the border.
    pub edges: Edges,
    /// Whether the ground is transparent.
    pub transparent_ground: bool,
}

/// Rows of a band of pictures of this width.
fn rows_a_band(width: usize) -> usize {
    (BAND_PX / width.max(1)).max(16)
}

impl Making {
    /// Heights in px of the pictures.
    fn scaled(&self) -> Surface {
        let relief = self.surface.relief.iter().map(|relief| self.scale as f64 * relief).collect();
        Surface { relief, ..self.surface.clone() }
    }

    /// Bytes held while pictures `width` px wide of `layers` layers are written: two patterns a layer and three values a px with
    /// the rim; values and bytes (16 bits at most) of the maps without it; and the buffers of the nine writers. Measured 0.12 GB at
    /// 4096², 0.13 at 8192², of which the program takes 0.03.
    #[must_use]
    pub fn held(&self, width: usize, layers: usize) -> f64 {
        let rows = rows_a_band(width);
        let rimmed = (rows + 2 * radius(&self.scaled(), layers)) as f64 * (8.0 * layers as f64 + 12.0);
        let inner = rows as f64 * (5.0 * layers as f64 + 60.0);
        width as f64 * (rimmed + inner) + 20e6
    }
}

impl Painting<'_> {
    /// Writes all maps of `set` into `outputs`, in the order of [`Set::maps`].
    ///
    /// # Errors
    /// An output cannot be written to; or it was cancelled.
    pub fn material(
        &self,
        outputs: &mut [impl Write + Send],
        set: &Set,
        making: &Making,
        watch: &Watch,
    ) -> Result<(), Failed> {
        let surface = making.scaled();
        let maps = set.maps();
        let colours = Colours::new(self, making.transparent_ground);
        write(outputs, set, rows_a_band(self.size[0]), |rows, bands| {
            let done = rows.start as f64 / self.size[1] as f64;
            watch.step(Stage::Write, done).map_err(|_| Stopped::Cancelled)?;
            let edges = making.edges;
            let work = Work { painting: self, set, surface: &surface, colours: &colours, edges };
            work.band(rows, &maps, bands, watch);
            watch.step(Stage::Write, done).map_err(|_| Stopped::Cancelled)
        })
    }
}

/// A plane with the maps of `set` in glTF: the names and the bytes of its two files, which belong into the folder of the maps.
#[must_use]
pub fn plane(set: &Set, making: &Making) -> [(String, Vec<u8>); 2] {
    let file = |map: Map| map.file(set.name);
    let (base_colour, normal, orm) = (file(Map::BaseColour), file(Map::NormalGl), file(Map::Orm));
    let buffer = format!("{}.bin", set.name);
    let anisotropy = set.anisotropic.then(|| file(Map::Anisotropy));
    let plane = Plane {
        name: set.name,
        size: set.size,
        wraps: making.edges == Edges::Wrap,
        transparent: set.transparent,
        base_colour: &base_colour,
        normal: &normal,
        orm: &orm,
        anisotropy: anisotropy.as_deref(),
        buffer: &buffer,
    };
    let (bytes, text) = (plane.buffer(), plane.text().into_bytes());
    [(buffer, bytes), (format!("{}.gltf", set.name), text)]
}

struct Work<'a> {
    painting: &'a Painting<'a>,
    set: &'a Set<'a>,
    surface: &'a Surface,
    colours: &'a Colours,
    edges: Edges,
}

impl Work<'_> {
    /// Computes `rows` of all `maps`. The result has no meaning once `watch` is cancelled.
    fn band(&self, rows: Range<usize>, maps: &[Map], bands: &mut [Vec<u8>], watch: &Watch) {
        let relief = self.painting.relief(rows.clone(), self.surface, self.edges, watch);
        let first = rows.start * self.painting.size[0];
        let painted = self.painting.band(rows.clone());
        for (map, bytes) in maps.iter().zip(bands) {
            match map {
                Map::BaseColour => {
                    let samples = map.samples(self.set.deep, self.set.transparent);
                    if let Some(finished) = self.painting.finished() {
                        encode(finished, first, false, samples, bytes);
                        continue;
                    }
                    painted.paint_fine(self.colours, samples, bytes);
                }
                Map::Opacity => painted.opacity(self.colours, bytes),
                Map::Height => {
                    for (two, height) in bytes.chunks_exact_mut(2).zip(&relief.heights) {
                        two.copy_from_slice(&to_u16(share_of(*height, relief.range)).to_be_bytes());
                    }
                }
                Map::NormalGl => self.encode(&relief.normals, Green::Up, bytes),
                Map::NormalDx => self.encode(&relief.normals, Green::Down, bytes),
                Map::Roughness => {
                    bytes.iter_mut().zip(&relief.roughness).for_each(|(out, rough)| *out = to_u8(*rough));
                }
                Map::Occlusion => {
                    bytes.iter_mut().zip(&relief.open).for_each(|(out, open)| *out = to_u8(*open));
                }
                Map::Orm => {
                    for ((out, open), rough) in
                        bytes.chunks_exact_mut(3).zip(&relief.open).zip(&relief.roughness)
                    {
                        out.copy_from_slice(&[to_u8(*open), to_u8(*rough), 0]);
                    }
                }
                Map::MaskMap => {
                    for ((out, open), rough) in
                        bytes.chunks_exact_mut(4).zip(&relief.open).zip(&relief.roughness)
                    {
                        out.copy_from_slice(&[0, to_u8(*open), 0, to_u8(1.0 - *rough)]);
                    }
                }
                Map::Anisotropy => self.painting.anisotropy(rows.clone(), bytes),
                Map::Id => {
                    let mut labels = vec![0; relief.open.len()];
                    painted.labels(&mut labels);
                    for (out, label) in bytes.chunks_exact_mut(3).zip(labels) {
                        out.copy_from_slice(&id_colour(label));
                    }
                }
            }
        }
    }

    fn encode(&self, normals: &[[f32; 3]], green: Green, bytes: &mut [u8]) {
        let encoded = normals.iter().flat_map(|normal| encoded(*normal, green));
        if self.set.deep {
            for (two, value) in bytes.chunks_exact_mut(2).zip(encoded) {
                two.copy_from_slice(&to_u16(value).to_be_bytes());
            }
        } else {
            bytes.iter_mut().zip(encoded).for_each(|(out, value)| *out = to_u8(value));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_material_of_any_height_is_held_in_bands() {
        let making =
            Making { surface: Surface::default(), scale: 8, edges: Edges::Wrap, transparent_ground: false };
        // Measured 0.09 and 0.10 GB besides the program.
        let held = [4096, 8192, 16_384].map(|width| making.held(width, 1));
        assert!((0.09e9..0.18e9).contains(&held[0]) && (0.10e9..0.2e9).contains(&held[1]), "{held:?}");
        // One byte per px of 16,384², as stated.
        assert!(held[2] < 16_384.0 * 16_384.0, "{held:?}");
    }
}
