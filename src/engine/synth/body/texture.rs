//! The texture of a model on which something has grown: the maps of a material on its texture coordinates.

use std::io::Write;
use std::ops::Range;

use rayon::prelude::*;

use crate::export::bake::{Atlas, Baked, Baker, Texels, Unfit, automatic, openness, own};
use crate::export::maps::{Green, Surface, encoded, share_of, shares};
use crate::export::material::{Failed, Map, Set, id_colour, write_some};
use crate::export::{Stopped, srgb_from_linear};
use crate::finish::body::{Finished, SurfaceFinish};
use crate::grid::to_u16;
use crate::synth::body::coat::Coat;
use crate::synth::body::grown::GrownBody;
use crate::synth::drawn::is_replaced;
use crate::synth::pattern::EDGE;
use crate::synth::watch::{Stage, Watch};

/// Texels of a band: enough for all threads.
const BAND: usize = 1 << 18;
/// How many times as long a texel with a finish takes as one without: bands are shorter, so that it can be cancelled.
const SLOWER: usize = 4;
/// Bytes that a texel of a band takes while it is computed, and one of the picture.
const HELD: [f64; 2] = [500.0, 5.0];
/// The width of the gutter, as a share of the side: smaller copies mix it with what is beside it.
const GUTTER: f64 = 1.0 / 64.0;
/// How far, in heights of the relief, a mark still shades its surroundings, as on a canvas.
const REACH: f64 = 4.0;
/// The farthest that it does, cells of the surface.
const FARTHEST: f64 = 12.0;
/// How much of a pattern's value is changed to find how the height follows it.
const SMALL: f32 = 1.0 / 512.0;

/// A model laid out in a texture.
pub struct LaidOut {
    /// Its triangles with texture coordinates.
    pub atlas: Atlas,
    /// Why the coordinates are not those of the model's file; `None` if they are.
    pub unfit: Option<Unfit>,
}

impl LaidOut {
    /// What the user should know of coordinates that are not those of the file.
    #[must_use]
    pub fn note(&self, model: &str) -> Option<String> {
        let charts = self.atlas.charts;
        self.unfit.map(|unfit| {
            format!(
                "{model}: {unfit}; the texture is on automatic coordinates, {charts} pieces: use the model that is written with it"
            )
        })
    }
}

/// A model that cannot be laid out in a texture.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{model}: {unfit}, and {why}")]
pub struct NoTexture {
    /// The name of the model's file.
    pub model: String,
    /// Why not on its own coordinates.
    pub unfit: Unfit,
    /// Why not on automatic ones, and what to do.
    pub why: String,
}

/// A texture that is computed band by band.
pub struct Texture<'a> {
    baker: Baker<'a>,
    surface: Surface,
    coat: Coat,
    /// The layers whose marks have a relief: those that are seen.
    raised: Vec<usize>,
    /// The finish of the document.
    finish: Option<SurfaceFinish<'a>>,
    /// How far reflections are stretched, of 255; `None` if they have no direction.
    stretch: Option<u8>,
}

impl GrownBody {
    /// The atlas of what is grown on, with the texture coordinates of the model's file.
    ///
    /// # Errors
    /// Why no texture can be on them.
    pub fn own_atlas(&self) -> Result<Atlas, Unfit> {
        own(&self.placed.model, &self.is_grown())
    }

    /// The atlas of what is grown on, with automatic coordinates where those of the file are unfit.
    ///
    /// # Errors
    /// There can be none: the reason and the remedy.
    pub fn lay_out(&self) -> Result<LaidOut, NoTexture> {
        match self.own_atlas() {
            Ok(atlas) => Ok(LaidOut { atlas, unfit: None }),
            Err(unfit) => automatic(&self.placed.model, &self.is_grown())
                .map(|atlas| LaidOut { atlas, unfit: Some(unfit) })
                .map_err(|why| NoTexture { model: self.placed.model.name.clone(), unfit, why }),
        }
    }

    /// The layers whose marks are seen.
    pub(super) fn raised(&self) -> Vec<usize> {
        let layers = self.document.layers.iter().enumerate();
        let seen = layers.filter(|(index, layer)| layer.visible && !is_replaced(&self.document, *index));
        seen.map(|(index, _)| index).collect()
    }

    /// Whether something grows on a part of the model.
    fn is_grown(&self) -> impl Fn(usize) -> bool {
        let only = self.document.model.as_ref().map_or(&[][..], |body| &body.only);
        let others = self.placed.model.others(only);
        move |part| !others.contains(&part)
    }

    /// A texture of this size, texels. Heights of the relief are px of the sketch. If it is cancelled, so is writing it.
    #[must_use]
    pub fn texture<'a>(
        &'a self,
        atlas: &'a Atlas,
        size: [usize; 2],
        surface: &Surface,
        watch: &Watch,
    ) -> Texture<'a> {
        let grown = self.finest().plan.surface();
        let patterns = self.painted();
        let raised = self.raised();
        let mut shared = chosen(&patterns, &raised);
        shares(&mut shared);
        let [low, high] = surface.range(shared.len());
        let radius = (REACH * (high - low)).min(FARTHEST * grown.unit());
        let open = match radius > 0.0 {
            true => openness(grown, &surface.height(&shared), radius),
            false => vec![1.0; grown.mesh.positions.len()],
        };
        let gutter = (GUTTER * size[0].max(size[1]) as f64).ceil() as usize;
        let texels = Texels::new(atlas, size, gutter.max(2));
        let scale = self.placed.scale;
        let layers: Vec<&[f32]> = patterns.iter().map(Vec::as_slice).collect();
        let baker = Baker::new(atlas, texels, grown, &move |at| scale.to_px(at), &layers, open);
        let finishing = self.document.finish.as_ref();
        Texture {
            baker,
            surface: surface.clone(),
            coat: Coat::new(&self.document),
            raised,
            finish: self.finish(watch),
            stretch: finishing.and_then(|finishing| finishing.finish.kind.stretch()),
        }
    }
}

/// Some of the layers.
pub(super) fn chosen(patterns: &[Vec<f32>], layers: &[usize]) -> Vec<Vec<f32>> {
    layers.iter().map(|layer| patterns[*layer].clone()).collect()
}

impl Texture<'_> {
    /// Whether reflections of it have a direction: those of hair.
    #[must_use]
    pub fn is_anisotropic(&self) -> bool {
        self.stretch.is_some()
    }

    /// Bytes held while a texture of this size is written.
    #[must_use]
    pub fn held([width, height]: [usize; 2]) -> f64 {
        let band = (BAND.max(width)) as f64;
        HELD[0] * band + HELD[1] * width as f64 * height as f64 + 20e6
    }

    /// Writes some of the `maps` of `set` into `outputs`, in this order.
    ///
    /// # Errors
    /// An output cannot be written to; or it was cancelled.
    pub fn write(
        &self,
        outputs: &mut [impl Write + Send],
        set: &Set,
        maps: &[Map],
        watch: &Watch,
    ) -> Result<(), Failed> {
        let [width, height] = set.size;
        let texels = if self.finish.is_some() { BAND / SLOWER } else { BAND };
        write_some(outputs, set, maps, (texels / width.max(1)).max(1), |rows, bands| {
            watch.step(Stage::Write, rows.start as f64 / height as f64).map_err(|_| Stopped::Cancelled)?;
            self.band(rows, set, maps, bands);
            Ok(())
        })
    }

    /// Computes `rows` of all `maps`.
    fn band(&self, rows: Range<usize>, set: &Set, maps: &[Map], bands: &mut [Vec<u8>]) {
        let baked = self.baker.rows(rows);
        let relief = self.relief(baked);
        for (map, bytes) in maps.iter().zip(bands) {
            relief.encode(*map, self, set, bytes);
        }
    }

    fn relief(&self, baked: Baked) -> Relief {
        let texels = baked.open.len();
        let seen = chosen(&baked.values, &self.raised);
        let mut rises = vec![vec![0.0; texels]; baked.values.len()];
        for (layer, rise) in self.raised.iter().zip(self.rises(&seen)) {
            rises[*layer] = rise;
        }
        let finished = self.finished(&baked);
        let steeper: Vec<[f64; 3]> =
            finished.iter().map(|texel| texel.map_or([0.0; 3], |texel| texel.slope)).collect();
        let normals = baked.normals(&rises, &steeper);
        let mut shared = seen;
        shares(&mut shared);
        let is_flat = shared.is_empty();
        let ground = self.surface.roughness.first().copied().unwrap_or(1.0) as f32;
        let mut relief = Relief {
            heights: if is_flat { vec![0.0; texels] } else { self.surface.height(&shared) },
            roughness: if is_flat { vec![ground; texels] } else { self.surface.roughness(&shared) },
            range: self.surface.range(shared.len()),
            normals,
            finished,
            baked,
        };
        relief.finish(self.finish.as_ref().map_or([0.0; 2], SurfaceFinish::heights));
        relief
    }

    /// The finish of the texels; nothing if the document has none.
    fn finished(&self, baked: &Baked) -> Vec<Option<Finished>> {
        let Some(finish) = &self.finish else { return Vec::new() };
        let scale = self.baker.scale() as f32;
        baked.places.par_iter().map(|place| place.map(|place| finish.at(place, scale))).collect()
    }

    /// By layer and texel: how much the height rises with the value of the layer, a unit of it.
    fn rises(&self, values: &[Vec<f32>]) -> Vec<Vec<f32>> {
        let height = |layer: usize, off: f32| {
            let mut changed = values.to_vec();
            changed[layer].iter_mut().for_each(|value| *value += off);
            shares(&mut changed);
            self.surface.height(&changed)
        };
        let of_layer = |layer: usize| {
            let (above, below) = (height(layer, SMALL), height(layer, -SMALL));
            above.iter().zip(&below).map(|(above, below)| (above - below) / (2.0 * SMALL)).collect()
        };
        (0..values.len()).map(of_layer).collect()
    }
}

/// Some rows of a texture.
struct Relief {
    baked: Baked,
    /// The lowest and the highest height that is possible, px of the sketch.
    range: [f64; 2],
    /// px of the sketch.
    heights: Vec<f32>,
    normals: Vec<[f32; 3]>,
    roughness: Vec<f32>,
    /// Empty without a finish.
    finished: Vec<Option<Finished>>,
}

impl Relief {
    /// Adds the heights of the finish, which lie in this range, and takes its roughness.
    fn finish(&mut self, [low, high]: [f32; 2]) {
        self.range = [self.range[0] + f64::from(low), self.range[1] + f64::from(high)];
        let texels = self.heights.iter_mut().zip(&mut self.roughness).zip(&self.finished);
        for ((height, roughness), finished) in texels {
            if let Some(Finished { surfel, .. }) = finished {
                *height += surfel.height;
                *roughness = surfel.roughness.clamp(0.0, 1.0);
            }
        }
    }

    /// The colour of a texel, red, green, blue in the coding of sRGB.
    fn colour(&self, texel: usize, coat: &Coat) -> [f32; 3] {
        match self.finished.get(texel) {
            Some(Some(finished)) => finished.surfel.albedo(),
            _ => coat.light(&self.of_texel(texel)).map(|light| srgb_from_linear(f64::from(light)) as f32),
        }
    }
}

impl Relief {
    /// The samples of a map.
    fn encode(&self, map: Map, texture: &Texture, set: &Set, bytes: &mut [u8]) {
        let open = &self.baked.open;
        let texels = || open.iter().zip(&self.roughness);
        match map {
            Map::BaseColour => {
                let colours = (0..open.len()).flat_map(|texel| self.colour(texel, &texture.coat));
                fill(bytes, set.deep, colours);
            }
            // Models are opaque.
            Map::Opacity => bytes.fill(u8::MAX),
            Map::Height => {
                fill(bytes, true, self.heights.iter().map(|height| share_of(*height, self.range)));
            }
            Map::NormalGl => fill(bytes, set.deep, self.normals.iter().flat_map(|n| encoded(*n, Green::Up))),
            Map::NormalDx => {
                fill(bytes, set.deep, self.normals.iter().flat_map(|n| encoded(*n, Green::Down)));
            }
            Map::Roughness => fill(bytes, false, self.roughness.iter().copied()),
            Map::Occlusion => fill(bytes, false, open.iter().copied()),
            Map::Orm => fill(bytes, false, texels().flat_map(|(open, rough)| [*open, *rough, 0.0])),
            Map::MaskMap => {
                fill(bytes, false, texels().flat_map(|(open, rough)| [0.0, *open, 0.0, 1.0 - *rough]));
            }
            Map::Anisotropy => self.anisotropy(texture, bytes),
            Map::Id => {
                // Marks beneath keep their place.
                let label = |texel: usize| {
                    let mark = texture.raised.iter().find(|layer| self.baked.values[**layer][texel] >= EDGE);
                    mark.map_or(0, |layer| layer + 1)
                };
                let ids = (0..open.len()).flat_map(|texel| id_colour(label(texel) as u8));
                bytes.iter_mut().zip(ids).for_each(|(out, id)| *out = id);
            }
        }
    }
}

impl Relief {
    /// The values of all layers in a texel.
    fn of_texel(&self, texel: usize) -> Vec<f32> {
        self.baked.values.iter().map(|values| values[texel]).collect()
    }

    /// The direction of reflections: across the hair. Without hair they have none.
    fn anisotropy(&self, texture: &Texture, bytes: &mut [u8]) {
        let stretch = texture.stretch.unwrap_or(0);
        for (texel, out) in bytes.chunks_exact_mut(3).enumerate() {
            let across = |finish: &SurfaceFinish| {
                let [x, y] = self.baked.in_tangent_space(texel, finish.flow(self.baked.places[texel]?));
                Some([-y, x])
            };
            let [x, y] = texture.finish.as_ref().and_then(across).unwrap_or([1.0, 0.0]);
            let code = |part: f32| (255.0 * (0.5 + 0.5 * part)).round() as u8;
            out.copy_from_slice(&[code(x), code(y), stretch]);
        }
    }
}

/// Writes samples from 0 to 1, of 16 bits if `deep`, otherwise 8.
fn fill(bytes: &mut [u8], deep: bool, values: impl Iterator<Item = f32>) {
    if deep {
        for (two, value) in bytes.chunks_exact_mut(2).zip(values) {
            two.copy_from_slice(&to_u16(value).to_be_bytes());
        }
    } else {
        bytes.iter_mut().zip(values).for_each(|(out, value)| {
            *out = (255.0 * value.clamp(0.0, 1.0)).round() as u8;
        });
    }
}
