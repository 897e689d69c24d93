//! Scales on a surface, around scattered seeds: the overlapping round ones of fish, and the keeled ones of reptiles.

use super::reach::SurfaceReach;
use super::scattered::apart;
use super::seeds::{Metric, Seed, Seeds, carried};
use super::solid::SolidNoise;
use super::source::{Place, SurfaceSource, single};
use crate::finish::noise::part_seed;
use crate::finish::scales::{FROM_CENTRE, Plate, RADIUS, REPTILE_ROW, ROW, keeled, rings};
use crate::finish::surfel::Surfel;
use crate::surface::SurfacePoint;
use crate::surface::vector::{Vector, across, cross, dot, length, plus};

/// The distance of two fish scales from each other ÷ size at which there are as many as on a canvas, and they leave no gap.
const FISH_APART: f64 = 0.54;
/// Ways along a reptile's scale count this share of those across: it is longer than wide.
const SHORTER: f64 = 0.64;
/// The distance of two reptile scales from each other ÷ size, in this metric.
const REPTILE_APART: f64 = 0.6;

/// The lowest and the highest height of fish scales of this size.
pub(super) fn fish_heights(size: f32) -> [f32; 2] {
    [-1.1, 1.9].map(|share| 0.16 * size * share)
}

/// The lowest and the highest height of reptile scales of this size.
pub(super) fn reptile_heights(size: f32) -> [f32; 2] {
    [-0.08, 0.23].map(|share| share * size)
}

/// The scales of a fish.
#[derive(Clone, Debug)]
pub(super) struct Fish {
    size: f32,
    pub seeds: Seeds,
    grain: SolidNoise,
}

impl Fish {
    /// Scales `size` px wide.
    pub fn new(source: &SurfaceSource, reach: &SurfaceReach, size: f32) -> Self {
        let (seed, wide) = (part_seed(source.seed, 32), f64::from(size));
        let area = f64::from(ROW) * wide * wide;
        let places = apart(source.surface, area, FISH_APART * wide, seed, |_, way| length(way));
        let radius = f64::from(RADIUS) * wide;
        let seeds = Seeds::new(source, reach, &places, [radius; 2], seed);
        Self { size, seeds, grain: SolidNoise::new(0.12 * size.max(4.0), part_seed(source.seed, 33)) }
    }

    /// The look `off` px beside a place of this colour; without colours where that is not known.
    pub fn surfel(
        &self,
        source: &SurfaceSource,
        place: &Place,
        off: Vector,
        scale: f32,
        own: Option<[f32; 4]>,
    ) -> Surfel {
        let (at, flow) = (plus(place.at, off), source.flow_at(place));
        let radius = RADIUS * self.size;
        // Of the scales that cover the place that which begins nearest to the head lies over the others.
        let mut found: Option<(&Seed, [f32; 2])> = None;
        for (seed, way) in self.seeds.near(place, at) {
            let (along, far) = (-dot(way, flow) as f32, length(way) as f32);
            if far < radius && found.is_none_or(|(_, [most, _])| along > most) {
                found = Some((seed, [along, far]));
            }
        }
        let plate = Plate { size: self.size, radius, rings: rings(radius, scale) };
        let grain = self.grain.at(single(at));
        match found {
            Some((seed, here)) => {
                let colour = own.map(|own| carried(source, place, own, seed, FROM_CENTRE));
                plate.surfel(here, &mut seed.random(), grain, colour.unwrap_or_default())
            }
            // Between scales, where there was no room for another: the rim of one.
            None => {
                let mut random = crate::finish::noise::Random::of(0, [0, 0]);
                plate.surfel([0.0, radius], &mut random, grain, own.unwrap_or_default())
            }
        }
    }
}

/// The scales of a reptile.
#[derive(Clone, Debug)]
pub(super) struct Reptile {
    size: f32,
    pub seeds: Seeds,
    grain: SolidNoise,
}

impl Reptile {
    /// Scales `size` px wide.
    pub fn new(source: &SurfaceSource, reach: &SurfaceReach, size: f32) -> Self {
        let (seed, wide) = (part_seed(source.seed, 32), f64::from(size));
        let far = |point: SurfacePoint, way: Vector| {
            length(Metric::shorter(source.flow_at(&source.place(point)), SHORTER).of(way))
        };
        let area = f64::from(REPTILE_ROW) * wide * wide;
        let places = apart(source.surface, area, REPTILE_APART * wide, seed, far);
        let seeds = Seeds::new(source, reach, &places, [1.9 * wide, 0.7 * wide], seed);
        Self { size, seeds, grain: SolidNoise::new(0.07 * size.max(6.0), part_seed(source.seed, 33)) }
    }

    /// The look `off` px beside a place of this colour; without colours where that is not known.
    pub fn surfel(
        &self,
        source: &SurfaceSource,
        place: &Place,
        off: Vector,
        own: Option<[f32; 4]>,
    ) -> Surfel {
        let (at, flow) = (plus(place.at, off), source.flow_at(place));
        let grain = self.grain.at(single(at));
        let Some(near) = self.seeds.nearest(place, at, Metric::shorter(flow, SHORTER)) else {
            let mut random = crate::finish::noise::Random::of(0, [0, 0]);
            return keeled(self.size, [1.0, 0.0, 0.0], &mut random, grain, own.unwrap_or_default());
        };
        let colour = own.map(|own| carried(source, place, own, near.seed, FROM_CENTRE));
        let sideways = dot(across(near.way, place.normal), cross(place.normal, flow)) as f32;
        let along = -dot(near.way, flow) as f32 / (REPTILE_ROW * self.size);
        let here = [sideways / self.size, along, near.edge as f32 / self.size];
        keeled(self.size, here, &mut near.seed.random(), grain, colour.unwrap_or_default())
    }
}
