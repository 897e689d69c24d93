//! Seeds: the centres of grains and scales on a surface, with their colours.

use super::balance::Carried;
use super::buckets::{Buckets, Reached};
use super::reach::SurfaceReach;
use super::source::{OUTSIDE, Place, SurfaceSource, is_ink};
use crate::finish::noise::Random;
use crate::surface::SurfacePoint;
use crate::surface::vector::{Vector, dot, minus, plus, times};

/// Bytes of a seed with its entries in cubes of space, while these are sorted, and of its candidates.
pub(super) const BYTES: f64 = 1_500.0;
/// The cosine of the angle between two normals from which on one place sees the other: not through a thin sheet.
const FACING: f64 = 0.2;

/// The centre of a grain or a scale.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed {
    pub at: Vector,
    normal: Vector,
    colour: [f32; 4],
    /// How far its colour may be carried ÷ how far it is wanted to be, and how far it is.
    reach: f32,
    carried: f32,
    random: u32,
}

impl Seed {
    /// Its random numbers.
    pub fn random(&self) -> Random {
        Random::of(self.random, [0, 0])
    }
}

/// The centres of the grains or scales of a surface.
#[derive(Clone, Debug)]
pub(super) struct Seeds {
    all: Vec<Seed>,
    buckets: Buckets,
}

/// The way by which distances are measured: in all directions alike, or shorter along one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Metric {
    /// A unit vector, and by what share of itself a way along it is longer.
    along: Option<(Vector, f64)>,
}

impl Metric {
    /// In all directions alike.
    pub const EVEN: Self = Self { along: None };

    /// Ways along a unit vector count `share` of their length.
    pub fn shorter(along: Vector, share: f64) -> Self {
        Self { along: Some((along, share - 1.0)) }
    }

    /// A way in this metric.
    pub fn of(&self, way: Vector) -> Vector {
        match self.along {
            None => way,
            Some((along, more)) => plus(way, times(along, more * dot(way, along))),
        }
    }
}

/// The seed that is nearest to a place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Nearest<'a> {
    pub seed: &'a Seed,
    /// From the place to it, px.
    pub way: Vector,
    /// Distance of the nearest edge of its cell in the metric, px.
    pub edge: f64,
}

impl Seeds {
    /// Seeds at these places, which are looked for up to `radius` px away; their colours are carried `carried` px far, if marks allow.
    pub fn new(
        source: &SurfaceSource,
        reach: &SurfaceReach,
        places: &[SurfacePoint],
        [radius, carried]: [f64; 2],
        seed: u32,
    ) -> Self {
        let of_place = |(index, point): (usize, &SurfacePoint)| {
            let Place { at, normal, .. } = source.place(*point);
            let random = Random::of(seed, [index as u32, 1]).bits();
            let reach = reach.at(source.surface, *point, carried as f32) / carried as f32;
            Seed { at, normal, colour: (source.paint)(*point), reach, carried: reach, random }
        };
        let all: Vec<Seed> = places.iter().enumerate().map(of_place).collect();
        let reached = |index: usize| Reached::ball(all[index].at, radius + OUTSIDE);
        let buckets = Buckets::new(source.surface, 0.6 * radius, &reached, all.len());
        Self { all, buckets }
    }

    /// Carries colours this share of their way, where edges of marks are near.
    pub fn carry(&mut self, carried: Carried) {
        for seed in self.all.iter_mut().filter(|seed| seed.reach < 1.0) {
            seed.carried = seed.reach * carried[usize::from(is_ink(seed.colour))];
        }
    }

    /// The seeds that may be near a place, with the way to each from a point beside it.
    pub fn near(&self, place: &Place, from: Vector) -> impl Iterator<Item = (&Seed, Vector)> {
        let normal = place.normal;
        let seeds = self.buckets.at(place.at).iter().map(|index| &self.all[*index as usize]);
        seeds
            .filter(move |seed| dot(seed.normal, normal) > FACING)
            .map(move |seed| (seed, minus(seed.at, from)))
    }

    /// The nearest seed in a metric; `None` where none is near.
    pub fn nearest(&self, place: &Place, from: Vector, metric: Metric) -> Option<Nearest<'_>> {
        let mut first: Option<(f64, Vector, &Seed)> = None;
        let mut second: Option<(f64, Vector)> = None;
        for (seed, way) in self.near(place, from) {
            let measured = metric.of(way);
            let square = dot(measured, measured);
            if first.is_none_or(|(least, ..)| square < least) {
                second = first.map(|(square, way, _)| (square, way));
                first = Some((square, way, seed));
            } else if second.is_none_or(|(least, _)| square < least) {
                second = Some((square, way));
            }
        }
        let (square, way, seed) = first?;
        let edge = second.map_or(f64::INFINITY, |(other, beyond)| {
            let apart = metric.of(minus(beyond, way));
            0.5 * (other - square) / dot(apart, apart).sqrt().max(1e-6)
        });
        Some(Nearest { seed, way, edge })
    }
}

#[cfg(test)]
impl Seeds {
    /// The nearest of all seeds that face the same way.
    pub fn nearest_plainly(&self, place: &Place) -> &Seed {
        let far = |seed: &&Seed| crate::surface::vector::length(minus(seed.at, place.at));
        let facing = self.all.iter().filter(|seed| dot(seed.normal, place.normal) > FACING);
        facing.min_by(|a, b| far(a).total_cmp(&far(b))).expect("a seed")
    }
}

/// The colour and the share of ink at a place that has those of its own with `share` less, and for this share those of a seed, or of a
/// place towards it as far as marks allow.
pub(super) fn carried(
    source: &SurfaceSource,
    place: &Place,
    own: [f32; 4],
    seed: &Seed,
    share: f32,
) -> [f32; 4] {
    let other = if seed.carried >= 1.0 {
        seed.colour
    } else {
        let way = minus(seed.at, place.at);
        (source.paint)(source.displaced(place.point, times(way, f64::from(seed.carried))))
    };
    [0, 1, 2, 3].map(|channel| own[channel] + share * (other[channel] - own[channel]))
}
