//! Skin and leather on a surface: irregular grains of two sizes around scattered seeds.

use super::balance::Carried;
use super::reach::SurfaceReach;
use super::scattered::apart;
use super::seeds::{Metric, Nearest, Seeds, carried};
use super::solid::SolidNoise;
use super::source::{Place, SurfaceSource, single};
use crate::finish::noise::part_seed;
use crate::finish::skin::Hide;
use crate::finish::surfel::Surfel;
use crate::surface::vector::{Vector, length, plus};

/// Size of a small grain ÷ that of a large one.
const SMALL: f64 = 0.45;
/// The least distance of two seeds ÷ size, where grains are regular, and by how much it is less where they are irregular. Seeds that are
/// .83 apart fill a surface.
const APART: [f64; 2] = [0.83, 0.2];
/// How far from a place its seed and the next one are looked for ÷ size.
const SEEN: f64 = 1.7;
/// How far colours are carried ÷ size, as on a canvas.
const CARRIED: f64 = 0.8;
/// By how much creases are bent ÷ size.
const BENT: f32 = 0.09;

/// The grains of a surface.
#[derive(Clone, Debug)]
pub(super) struct Grains {
    hide: Hide,
    size: f32,
    large: Seeds,
    small: Seeds,
    pores: SolidNoise,
    folds: SolidNoise,
    bend: [SolidNoise; 3],
}

impl Grains {
    /// Grains of `size` px.
    pub fn new(source: &SurfaceSource, reach: &SurfaceReach, size: f32, hide: Hide) -> Self {
        let part = |index| part_seed(source.seed, index);
        let seeds = |size: f64, seed: u32| {
            let least = (APART[0] - APART[1] * f64::from(hide.jitter)) * size;
            let places = apart(source.surface, size * size, least, seed, |_, way| length(way));
            Seeds::new(source, reach, &places, [SEEN * size, CARRIED * size], seed)
        };
        let bend = [52, 53, 54].map(|index| SolidNoise::new(0.6 * size, part(index)));
        Self {
            hide,
            size,
            large: seeds(f64::from(size), part(48)),
            small: seeds(SMALL * f64::from(size), part(49)),
            pores: SolidNoise::new(0.11 * size, part(50)),
            folds: SolidNoise::new(5.0 * size, part(51)),
            bend,
        }
    }

    /// Carries colours this share of their way.
    pub fn carry(&mut self, carried: Carried) {
        // Small grains have the colour of the large one that they are in.
        self.large.carry(carried);
    }

    /// The look `off` px beside a place of this colour; without colours where that is not known.
    pub fn surfel(
        &self,
        source: &SurfaceSource,
        place: &Place,
        off: Vector,
        own: Option<[f32; 4]>,
    ) -> Surfel {
        let at = plus(place.at, off);
        let point = single(at);
        let bent = self.bend.map(|noise| f64::from(BENT * self.size * noise.at(point)));
        let from = plus(at, bent);
        let edge = |near: Option<Nearest>| near.map_or(self.size, |near| near.edge as f32);
        let grain = self.large.nearest(place, from, Metric::EVEN);
        let small = edge(self.small.nearest(place, from, Metric::EVEN));
        let colour = match (own, grain) {
            (Some(own), Some(near)) => carried(source, place, own, near.seed, self.hide.from_centre),
            (own, _) => own.unwrap_or_default(),
        };
        let random = grain.map_or(0.5, |near| near.seed.random().number());
        let noises = [self.folds.at(point), self.pores.at(point)];
        self.hide.surfel(self.size, [edge(grain), small, random], noises, colour)
    }
}

#[cfg(test)]
impl Grains {
    /// Compares the large grain of a place with that by a search among all seeds.
    pub fn check_plainly(&self, place: &Place) {
        let found = self.large.nearest(place, place.at, Metric::EVEN).expect("a grain");
        let plain = self.large.nearest_plainly(place);
        assert_eq!(found.seed.at, plain.at, "{place:?}");
    }
}
