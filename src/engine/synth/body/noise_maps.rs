//! Noise in space by which what is wanted varies over a model.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::attributes::modulation::{Change, Modulated, modulated};
use crate::document::{Document, LayerMap, MapKey, MapSource};
use crate::points::solid_noise::SolidNoise;
use crate::surface::Surface;
use crate::synth::drawn::maps::{self, change};

/// The maps of a layer that vary what it asks for.
pub struct NoiseMaps {
    maps: Vec<Varied>,
    /// Whether the spacing of spots follows their area.
    follows: bool,
}

/// An attribute that varies.
struct Varied {
    attribute: Modulated,
    change: Change,
    /// What the lowest and the highest value of the noise mean.
    range: [f64; 2],
    noise: SolidNoise,
}

impl NoiseMaps {
    /// The maps of layer `index`. `follows`: whether spots are as far apart as suits their area, because nothing else says so.
    #[must_use]
    pub fn new(document: &Document, index: usize, follows: bool) -> Self {
        let of = |(key, map): (MapKey, &LayerMap)| {
            let MapSource::Noise { size, octaves } = map.source else { return None };
            let seed = document.layer_seed(index).wrapping_add(maps::seed(key));
            Some(Varied {
                attribute: maps::modulated(key)?,
                change: change(map, key),
                range: map.range,
                noise: SolidNoise::new(size, octaves, seed),
            })
        };
        Self { maps: document.layers[index].maps.iter().filter_map(of).collect(), follows }
    }

    /// What is wanted at each vertex of a surface where `wanted` was.
    #[must_use]
    pub fn varied(&self, surface: &Surface, wanted: Vec<Attributes>) -> Vec<Attributes> {
        if self.maps.is_empty() {
            return wanted;
        }
        let at = |(vertex, wanted): (usize, Attributes)| {
            let place = surface.mesh.positions[vertex];
            self.with(wanted, &|map| map.noise.at(place))
        };
        wanted.into_par_iter().enumerate().map(at).collect()
    }

    /// What is wanted where `wanted` was and all noise is at its lowest, and at its highest.
    #[must_use]
    pub fn extremes(&self, wanted: Attributes) -> [Attributes; 2] {
        [0.0, 1.0].map(|share| self.with(wanted, &|_| share))
    }

    fn with(&self, wanted: Attributes, share: &dyn Fn(&Varied) -> f64) -> Attributes {
        let changed = |attribute: Modulated, value: f64| {
            let map = self.maps.iter().find(|map| map.attribute == attribute)?;
            let [low, high] = map.range;
            Some(map.change.of(value, low + share(map) * (high - low)))
        };
        modulated(wanted, &changed, false, self.follows)
    }
}
