//! Finishes on the surface of a model.
//!
//! ```text
//! colours, labels, flow ─▶ reach ─▶ hairs | seeds of grains and scales ─▶ buckets ─▶ balance ─▶ colour, height, roughness, slope
//!                                   scattered over the surface            what is near as much ink as before
//! ```
//!
//! Everything is a function of the place on the surface, not of a picture: a texture has the same hair on both sides of a seam, and a
//! finer one shows more of the same hairs. Hairs, grains and scales are scattered over the surface instead of a lattice, which a
//! closed surface does not have; finishes that are lattices are for the canvas only ([`Kind::on_models`]).

mod balance;
mod buckets;
mod grains;
mod hairs;
mod paper;
mod plates;
mod reach;
mod scattered;
mod seeds;
mod solid;
mod source;
#[cfg(test)]
mod tests;
mod tone;

pub use source::{Paint, SurfaceSource};

use super::kind::{Finish, Kind};
use super::skin::{LEATHER, SKIN};
use super::surfel::Surfel;
use crate::surface::SurfacePoint;
use crate::surface::vector::{Vector, axis_beside, cross, dot, plus, times, unit};
use balance::Carried;
use grains::Grains;
use hairs::Hairs;
use paper::Paper;
use plates::{Fish, Reptile};
use reach::SurfaceReach;
use source::{OUTSIDE, Place, single};
use tone::Tone;

/// Pictures with fewer px along each px of the document have the mean of four points a px: of hair, which knows how much of a px it
/// covers, and of all others.
const FINE: [f32; 2] = [1.0, 2.0];
/// The coarsest pictures for which it is computed, px along each px of the document: what is coarser shows single points.
const COARSEST: f32 = 0.25;
/// Distance between the two points of a slope, px of the picture; those have at least one px along each px of the document.
const RUN: f32 = 0.6;
/// The steepest slope.
const STEEPEST: f64 = 2.0;

/// A finish on a surface.
pub struct SurfaceFinish<'a> {
    source: SurfaceSource<'a>,
    reach: SurfaceReach,
    parts: Parts,
    /// The length of its parts, px of the document.
    size: f32,
    tone: Tone,
    /// The lowest and the highest of its heights, px.
    heights: [f32; 2],
}

impl Finish {
    /// Bytes that [`SurfaceFinish`] takes for each px² of a surface: of fur the hairs, with the cubes of space that each reaches.
    #[must_use]
    pub fn bytes_of_surface(&self) -> f64 {
        let size = self.size as f32;
        match self.kind {
            Kind::Fur => {
                hairs::BYTES * f64::from(super::hair::LAYERS as f32 / super::hair::area_a_hair(size))
            }
            // Small grains are five for each large one, fish scales two and a half.
            _ => 6.0 * seeds::BYTES / (self.size * self.size),
        }
    }
}

/// What it consists of.
enum Parts {
    Fur(Hairs),
    Hide(Grains),
    Fish(Fish),
    Reptile(Reptile),
    Ink(Paper),
}

/// A place with a finish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finished {
    /// How it looks.
    pub surfel: Surfel,
    /// By how much its height rises along the surface: a tangent vector.
    pub slope: [f64; 3],
}

impl Finished {
    /// The mean of two looks.
    fn halfway(&self, other: &Self) -> Self {
        let slope = times(plus(self.slope, other.slope), 0.5);
        Self { surfel: self.surfel.covered(&other.surfel, 0.5), slope }
    }
}

impl<'a> SurfaceFinish<'a> {
    /// The `finish` of a painted surface; `None` if its kind is not for surfaces, or it was cancelled.
    #[must_use]
    pub fn new(
        finish: Finish,
        source: SurfaceSource<'a>,
        cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Option<Self> {
        finish.kind.on_models().ok()?;
        let size = finish.size as f32;
        let tone = Tone::new(&finish, source.seed);
        let most = 1.55 / super::reach::SHARE * size;
        let reach = SurfaceReach::of(source.surface, &source.labels, most);
        let (parts, heights) = match finish.kind {
            Kind::Fur => (Parts::Fur(Hairs::new(&source, &reach, size, cancelled)?), hairs::heights(size)),
            Kind::Skin => (Parts::Hide(Grains::new(&source, &reach, size, SKIN)), SKIN.heights(size)),
            Kind::Leather => {
                (Parts::Hide(Grains::new(&source, &reach, size, LEATHER)), LEATHER.heights(size))
            }
            Kind::FishScales => (Parts::Fish(Fish::new(&source, &reach, size)), plates::fish_heights(size)),
            Kind::ReptileScales => {
                (Parts::Reptile(Reptile::new(&source, &reach, size)), plates::reptile_heights(size))
            }
            Kind::Ink => (Parts::Ink(Paper::new(&source, size)), paper::HEIGHTS),
            Kind::Cloth | Kind::Twill | Kind::Print => return None,
        };
        let mut finish = Self { source, reach, parts, size, tone, heights };
        balance::balance(&mut finish, cancelled)?;
        (!cancelled()).then_some(finish)
    }

    /// Carries colours this share of their way.
    fn carry(&mut self, carried: Carried) {
        match &mut self.parts {
            Parts::Fur(hairs) => hairs.carry(carried),
            Parts::Hide(grains) => grains.carry(carried),
            Parts::Fish(fish) => fish.seeds.carry(carried),
            Parts::Reptile(reptile) => reptile.seeds.carry(carried),
            Parts::Ink(paper) => paper.carried = carried,
        }
    }

    /// By how much the share of ink at a point is higher than without the finish.
    fn gain(&self, point: SurfacePoint) -> f32 {
        let own = (self.source.paint)(point);
        self.surfel(&self.source.place(point), [0.0; 3], FINE[1], Some(own)).ink - own[3]
    }

    /// The lowest and the highest height that it can have, px of the document.
    #[must_use]
    pub fn heights(&self) -> [f32; 2] {
        self.heights
    }

    /// The finish at a place, in a picture with `scale` px along each px of the document.
    #[must_use]
    pub fn at(&self, point: SurfacePoint, scale: f32) -> Finished {
        let scale = scale.max(COARSEST);
        if scale >= FINE[usize::from(!matches!(self.parts, Parts::Fur(_)))] {
            return self.single(point, scale);
        }
        let step = f64::from(0.25 / scale);
        let at =
            |x: f64, y: f64| self.single(self.source.surface.walk(point, [x * step, y * step]), 2.0 * scale);
        let [left, right] = [-1.0, 1.0].map(|x| at(x, -1.0).halfway(&at(x, 1.0)));
        left.halfway(&right)
    }

    /// The finish at a point.
    fn single(&self, point: SurfacePoint, scale: f32) -> Finished {
        let scale = scale.max(1.0);
        let place = self.source.place(point);
        let own = (self.source.paint)(point);
        let run = RUN / scale;
        let right = unit(cross(place.normal, axis_beside(place.normal))).unwrap_or([1.0, 0.0, 0.0]);
        let axes = [right, cross(place.normal, right)];
        let ahead = axes.map(|axis| times(axis, f64::from(run)));
        let (mut surfel, heights) = match &self.parts {
            Parts::Fur(hairs) => hairs.look(&place, ahead, scale, own),
            _ => {
                let surfel = self.surfel(&place, [0.0; 3], scale, Some(own));
                (surfel, ahead.map(|off| self.surfel(&place, off, scale, None).height))
            }
        };
        surfel.tint *= self.tone.at(single(place.at));
        let rises = heights.map(|height| f64::from((height - surfel.height) / run));
        let slope = plus(times(axes[0], rises[0]), times(axes[1], rises[1]));
        let steep = dot(slope, slope).sqrt();
        Finished { surfel, slope: if steep > STEEPEST { times(slope, STEEPEST / steep) } else { slope } }
    }

    /// The look of what is no hair at a place that is `off` px from another one, whose own colour and share of ink are `own`; without
    /// colours where those are not known.
    fn surfel(&self, place: &Place, off: Vector, scale: f32, own: Option<[f32; 4]>) -> Surfel {
        debug_assert!(dot(off, off) <= OUTSIDE * OUTSIDE, "{off:?}");
        match &self.parts {
            Parts::Fur(hairs) => hairs.look(place, [off; 2], scale, own.unwrap_or_default()).0,
            Parts::Hide(grains) => grains.surfel(&self.source, place, off, own),
            Parts::Fish(fish) => fish.surfel(&self.source, place, off, scale, own),
            Parts::Reptile(reptile) => reptile.surfel(&self.source, place, off, own),
            Parts::Ink(paper) => paper.surfel((&self.source, &self.reach), place, off, own),
        }
    }

    /// The direction from head to tail at a place: a unit vector in its tangent plane.
    #[must_use]
    pub fn flow(&self, point: SurfacePoint) -> [f64; 3] {
        let place = self.source.place(point);
        self.source.flow_at(&place)
    }
}
