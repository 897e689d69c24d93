//! Noise in space, and pictures on the texture coordinates of a model, by which what is wanted and colours vary over it.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::attributes::modulation::{Change, Modulated, modulated};
use crate::document::{Document, LayerMap, MapChange, MapKey, MapSource, ToneImage};
use crate::points::solid_noise::SolidNoise;
use crate::surface::Surface;
use crate::synth::body::texture_coordinates::TextureCoordinates;
use crate::synth::drawn::maps::{self, change};

/// The maps of a layer that vary what it asks for.
pub struct BodyMaps<'a> {
    maps: Vec<Varied<'a>>,
    /// Whether the spacing of spots follows their area.
    follows: bool,
}

/// An attribute that varies.
struct Varied<'a> {
    attribute: Modulated,
    change: Change,
    shares: Shares<'a>,
}

/// The numbers of a map on a surface.
struct Shares<'a> {
    /// What the lowest and the highest value mean.
    range: [f64; 2],
    source: Source<'a>,
}

enum Source<'a> {
    Noise(SolidNoise),
    Picture(&'a ToneImage),
}

impl<'a> Shares<'a> {
    fn new(document: &'a Document, index: usize, key: MapKey, map: &'a LayerMap) -> Self {
        let source = match &map.source {
            MapSource::Noise { size, octaves } => {
                let seed = document.layer_seed(index).wrapping_add(maps::seed(key));
                Source::Noise(SolidNoise::new(*size, *octaves, seed))
            }
            MapSource::Image { image, .. } => Source::Picture(image),
        };
        Self { range: map.range, source }
    }

    /// The number at a vertex. Without texture coordinates pictures are black.
    fn at(&self, surface: &Surface, vertex: usize, coordinates: Option<&TextureCoordinates>) -> f64 {
        let place = surface.mesh.positions[vertex];
        self.of(match &self.source {
            Source::Noise(noise) => noise.at(place),
            Source::Picture(image) => {
                let uv = coordinates.map(|coordinates| coordinates.at(place, surface.normal(vertex)));
                uv.map_or(0.0, |uv| brightness(image, uv))
            }
        })
    }

    /// The number of a share, 0..1, of the way from the lowest to the highest.
    fn of(&self, share: f64) -> f64 {
        self.range[0] + share * (self.range[1] - self.range[0])
    }
}

/// The brightness of a picture at texture coordinates, 0 = black, 1 = white; linear between the centres of px. Beyond its sides the picture is
/// repeated, as textures are; px of opposite sides are not mixed.
fn brightness(image: &ToneImage, [u, v]: [f64; 2]) -> f64 {
    let size = image.size();
    let whole = |part: f64| if (0.0..=1.0).contains(&part) { part } else { part.rem_euclid(1.0) };
    let place = [whole(u) * size[0] as f64 - 0.5, (1.0 - whole(v)) * size[1] as f64 - 0.5];
    let first = place.map(f64::floor);
    let value = |x: f64, y: f64| {
        let [x, y] = [x, y].map(|part| part.max(0.0) as usize);
        f64::from(image.values()[y.min(size[1] - 1) * size[0] + x.min(size[0] - 1)]) / 255.0
    };
    let [right, down] = [0, 1].map(|axis| place[axis] - first[axis]);
    let row = |y: f64| value(first[0], y) * (1.0 - right) + value(first[0] + 1.0, y) * right;
    row(first[1]) * (1.0 - down) + row(first[1] + 1.0) * down
}

impl<'a> BodyMaps<'a> {
    /// The maps of layer `index`. `follows`: whether spots are as far apart as suits their area, because nothing else says so.
    #[must_use]
    pub fn new(document: &'a Document, index: usize, follows: bool) -> Self {
        let of = |(key, map): (MapKey, &'a LayerMap)| {
            Some(Varied {
                attribute: maps::modulated(key)?,
                change: change(map, key),
                shares: Shares::new(document, index, key, map),
            })
        };
        Self { maps: document.layers[index].maps.iter().filter_map(of).collect(), follows }
    }

    /// What is wanted at each vertex of a surface where `wanted` was.
    #[must_use]
    pub fn varied(
        &self,
        surface: &Surface,
        wanted: Vec<Attributes>,
        coordinates: Option<&TextureCoordinates>,
    ) -> Vec<Attributes> {
        if self.maps.is_empty() {
            return wanted;
        }
        let at = |(vertex, wanted): (usize, Attributes)| {
            self.with(wanted, &|map| map.shares.at(surface, vertex, coordinates))
        };
        wanted.into_par_iter().enumerate().map(at).collect()
    }

    /// What is wanted where `wanted` was and all maps are at their lowest, and at their highest.
    #[must_use]
    pub fn extremes(&self, wanted: Attributes) -> [Attributes; 2] {
        [0.0, 1.0].map(|share| self.with(wanted, &|map| map.shares.of(share)))
    }

    fn with(&self, wanted: Attributes, number: &dyn Fn(&Varied) -> f64) -> Attributes {
        let changed = |attribute: Modulated, value: f64| {
            let map = self.maps.iter().find(|map| map.attribute == attribute)?;
            Some(map.change.of(value, number(map)))
        };
        modulated(wanted, &changed, false, self.follows)
    }
}

/// The numbers of a layer's map of `key`, which changes colours only, at each vertex of a surface; `None` without such a map.
#[must_use]
pub fn colours(
    document: &Document,
    (index, key): (usize, MapKey),
    surface: &Surface,
    coordinates: Option<&TextureCoordinates>,
) -> Option<Vec<f32>> {
    let map = document.layers[index].maps.get(key)?;
    let shares = Shares::new(document, index, key, map);
    let at = |vertex: usize| shares.at(surface, vertex, coordinates) as f32;
    Some((0..surface.mesh.positions.len()).into_par_iter().map(at).collect())
}

/// Whether the colours of a layer are multiplied, not shifted; `None` without a map of colours.
#[must_use]
pub fn multiplies(document: &Document, index: usize) -> Option<bool> {
    let map = document.layers[index].maps.get(MapKey::Colour)?;
    Some(map.change(MapKey::Colour) == MapChange::Multiply)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_looked_up_from_its_lower_left_corner_and_repeated() {
        let image = ToneImage::new([2, 2], vec![0, 255, 51, 102]).expect("four px");
        // The centres of the four px.
        let at = |u: f64, v: f64| (255.0 * brightness(&image, [u, v])).round();
        assert_eq!(
            [at(0.25, 0.75), at(0.75, 0.75), at(0.25, 0.25), at(0.75, 0.25)],
            [0.0, 255.0, 51.0, 102.0]
        );
        assert_eq!([at(1.25, 0.75), at(-0.25, 1.75), at(0.5, 0.75)], [0.0, 255.0, 128.0]);
        assert_eq!([at(0.0, 1.0), at(1.0, 1.0), at(1.0, 0.0)], [0.0, 255.0, 102.0]);
    }
}
