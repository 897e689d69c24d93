//! Fur on a surface: layers of hairs with scattered roots, each in the tangent plane of its root.

use rayon::prelude::*;

use super::balance::Carried;
use super::buckets::{Buckets, Reached};
use super::reach::SurfaceReach;
use super::scattered::scattered;
use super::solid::SolidNoise;
use super::source::{OUTSIDE, Place, SurfaceSource, is_ink, single};
use crate::finish::flow::turned;
use crate::finish::hair::{self, ANCHOR, Hair, LAYERS, OnHair};
use crate::finish::noise::{Random, part_seed};
use crate::finish::surfel::Surfel;
use crate::surface::SurfacePoint;
use crate::surface::vector::{Vector, cross, plus, times};

/// Bytes of a hair with its colours and its entries in cubes of space, while these are sorted.
pub(super) const BYTES: f64 = 500.0;
/// How far a hair lies across the light, where the light is not known: in the mean its brightness is 1.
const ACROSS: f32 = 0.643;
/// How far the surface may bend away from the plane of a hair that it still covers it: a share of its length, and px.
const BENT_AWAY: [f32; 2] = [0.5, 1.0];
/// The cosine of the angle between a normal and that of a hair's root from which on the hair is seen there: not through a thin sheet.
const FACING: f32 = 0.25;
/// px between two colours along a hair, and the most of these.
const STEP: [f64; 2] = [1.5, 24.0];
/// How far beside a hair a px lies that it covers in the coarsest picture, px.
const MARGIN: f64 = 0.5;

/// The hairs of a surface, the lowest layer first.
#[derive(Clone, Debug)]
pub(super) struct Hairs {
    all: Vec<Rooted>,
    colours: Vec<[f32; 4]>,
    buckets: Buckets,
}

/// A hair on a surface.
#[derive(Clone, Copy, Debug)]
struct Rooted {
    hair: Hair,
    root: [f32; 3],
    /// Its direction, to its side, and outwards.
    axes: [[f32; 3]; 3],
    /// The colours of the surface from its root to its tip: the first of them, and how many; one where all have that of its anchor.
    first: u32,
    count: u32,
    /// How far the colour of its anchor may be carried to its ends ÷ the way to them, and how far it is.
    reach: f32,
    carried: f32,
}

/// The lowest and the highest height of fur of this mean length.
pub(super) fn heights(length: f32) -> [f32; 2] {
    [0.0, hair::RISE[0] * (LAYERS - 1) as f32 + hair::RISE[1] * hair::LENGTHS[1] * length]
}

fn dot([a, b, c]: [f32; 3], [x, y, z]: [f32; 3]) -> f32 {
    a * x + b * y + c * z
}

/// What makes the hairs of one layer.
struct Growing<'a> {
    source: &'a SurfaceSource<'a>,
    reach: &'a SurfaceReach,
    length: f32,
    /// Directions: over a third of the model, of locks, of single strands.
    sway: [SolidNoise; 3],
    /// Brightness: of locks, of the coat.
    shade: [SolidNoise; 2],
}

impl Growing<'_> {
    /// The hair of a root, and its colours.
    fn hair(&self, layer: usize, point: SurfacePoint, mut random: Random) -> (Rooted, Vec<[f32; 4]>) {
        let place = self.source.place(point);
        let root = single(place.at);
        let [cos, sin] =
            turned([1.0, 0.0], hair::turn(self.sway.map(|noise| noise.at(root)), &mut random)).map(f64::from);
        let flow = self.source.flow_at(&place);
        let along = plus(times(flow, cos), times(cross(place.normal, flow), sin));
        let shade = self.shade.map(|noise| noise.at(root));
        let hair = Hair::new(&mut random, layer, self.length, ACROSS, shade);
        let (colours, reach) = self.colours(&place, along, &hair);
        let axes = [along, cross(place.normal, along), place.normal].map(single);
        let count = colours.len() as u32;
        (Rooted { hair, root, axes, first: 0, count, reach, carried: reach }, colours)
    }

    /// The colours of the surface from the root of a hair to its tip, and how far that of its anchor may be carried, as far as marks
    /// allow; that colour alone, where it is carried along the whole hair.
    fn colours(&self, place: &Place, along: Vector, hair: &Hair) -> (Vec<[f32; 4]>, f32) {
        let source = self.source;
        let at = |far: f64| source.displaced(place.point, times(along, far));
        let length = f64::from(hair.length);
        let middle = at(f64::from(hair.anchor()));
        let reach = self.reach.at(source.surface, middle, hair.length) / hair.length;
        if reach >= 1.0 {
            return (vec![(source.paint)(middle)], 1.0);
        }
        let count = (length / STEP[0]).ceil().clamp(1.0, STEP[1]) as usize + 1;
        let colour = |index: usize| (source.paint)(at(length * index as f64 / (count - 1) as f64));
        ((0..count).map(colour).collect(), reach)
    }
}

impl Hairs {
    /// Hairs of a mean `length`, px; `None` if it was cancelled.
    pub fn new(
        source: &SurfaceSource,
        reach: &SurfaceReach,
        length: f32,
        cancelled: &(dyn Fn() -> bool + Sync),
    ) -> Option<Self> {
        let part = |index| part_seed(source.seed, index);
        let noise = |size: f32, index| SolidNoise::new(size, part(index));
        let third = source.surface.mesh.size() as f32 / 3.0;
        let growing = Growing {
            source,
            reach,
            length,
            sway: [noise(third, 1), noise(2.2 * length, 2), noise(0.7 * length, 3)],
            shade: [noise(1.3 * length, 4), noise(6.0 * length, 5)],
        };
        let (mut all, mut colours): (Vec<Rooted>, Vec<[f32; 4]>) = Default::default();
        for layer in 0..LAYERS {
            let seed = part(16 + layer as u32);
            let roots = scattered(source.surface, f64::from(hair::area_a_hair(length)), seed);
            let grow = |(index, point): (usize, &SurfacePoint)| {
                (!cancelled()).then(|| growing.hair(layer, *point, Random::of(seed, [index as u32, 1])))
            };
            let grown: Option<Vec<_>> = roots.par_iter().enumerate().map(grow).collect();
            for (rooted, own) in grown? {
                all.push(Rooted { first: colours.len() as u32, ..rooted });
                colours.extend(own);
            }
        }
        let side = f64::from(0.3 * length).clamp(2.0, 16.0);
        let buckets = Buckets::new(source.surface, side, &|index| all[index].reached(), all.len());
        Some(Self { all, colours, buckets })
    }

    /// Carries colours this share of their way, where edges of marks are near.
    pub fn carry(&mut self, carried: Carried) {
        let Self { all, colours, .. } = self;
        for rooted in all.iter_mut().filter(|rooted| rooted.count > 1) {
            let anchor = rooted.surface_colour(colours, ANCHOR);
            rooted.carried = rooted.reach * carried[usize::from(is_ink(anchor))];
        }
    }

    /// The look at a place of this colour, and the heights at two points beside it.
    pub fn look(&self, place: &Place, beside: [Vector; 2], scale: f32, own: [f32; 4]) -> (Surfel, [f32; 2]) {
        let near = self.buckets.at(place.at).iter().map(|index| &self.all[*index as usize]);
        self.covered(near, place, beside, scale, own)
    }

    /// The look with these hairs, the lowest first.
    fn covered<'a>(
        &self,
        hairs: impl Iterator<Item = &'a Rooted>,
        place: &Place,
        beside: [Vector; 2],
        scale: f32,
        own: [f32; 4],
    ) -> (Surfel, [f32; 2]) {
        let (at, normal, beside) = (single(place.at), single(place.normal), beside.map(single));
        let (mut surfel, mut heights) = (hair::skin(own), [0.0; 2]);
        for rooted in hairs {
            let Some([along, across]) = rooted.near(at, normal) else { continue };
            if let Some(on) = rooted.on([along, across], scale) {
                surfel = surfel.covered(&rooted.hair.surfel(&on, self.colour(rooted, on.t)), on.cover);
            }
            for (height, off) in heights.iter_mut().zip(beside) {
                let there = [along + dot(off, rooted.axes[0]), across + dot(off, rooted.axes[1])];
                if let Some(on) = rooted.on(there, scale) {
                    *height += on.cover * (rooted.hair.height(on.t) - *height);
                }
            }
        }
        (surfel, heights)
    }

    /// The colour of a hair at t.
    fn colour(&self, rooted: &Rooted, t: f32) -> [f32; 4] {
        rooted.surface_colour(&self.colours, t + rooted.carried * (ANCHOR - t))
    }

    /// The look from all hairs of the surface: what [`Self::look`] is compared with.
    #[cfg(test)]
    pub fn look_plainly(
        &self,
        place: &Place,
        beside: [Vector; 2],
        scale: f32,
        own: [f32; 4],
    ) -> (Surfel, [f32; 2]) {
        self.covered(self.all.iter(), place, beside, scale, own)
    }
}

impl Rooted {
    /// The colour of the surface at t along the hair, of the colours of all hairs.
    #[inline(always)]
    fn surface_colour(&self, colours: &[[f32; 4]], t: f32) -> [f32; 4] {
        let colours = &colours[self.first as usize..][..self.count as usize];
        let at = t * (colours.len() - 1) as f32;
        let low = (at as usize).min(colours.len() - 1);
        let (a, b, share) = (colours[low], colours[(low + 1).min(colours.len() - 1)], at - low as f32);
        [0, 1, 2, 3].map(|channel| a[channel] + share * (b[channel] - a[channel]))
    }

    /// Where a point with this normal is along and across the line through the root, if the hair may cover something near it.
    #[inline(always)]
    fn near(&self, point: [f32; 3], normal: [f32; 3]) -> Option<[f32; 2]> {
        const BESIDE: f32 = (MARGIN + OUTSIDE) as f32;
        let off = [0, 1, 2].map(|axis| point[axis] - self.root[axis]);
        let across = dot(off, self.axes[1]);
        if across.abs() > self.hair.half_width + self.hair.bend.abs() + BESIDE {
            return None;
        }
        let [along, up] = [dot(off, self.axes[0]), dot(off, self.axes[2])];
        let is_near = along >= -BESIDE
            && along <= self.hair.length + BESIDE
            && up.abs() <= self.bent_away()
            && dot(normal, self.axes[2]) >= FACING;
        is_near.then_some([along, across])
    }

    /// The place on the hair so far along and across the line through its root, if it covers any of the px there.
    #[inline(always)]
    fn on(&self, local: [f32; 2], scale: f32) -> Option<OnHair> {
        let on = self.hair.at(local, scale)?;
        Some(OnHair { cover: self.hair.opacity(scale) * on.cover, ..on })
    }

    fn bent_away(&self) -> f32 {
        BENT_AWAY[0] * self.hair.length + BENT_AWAY[1]
    }

    /// The box that it may cover.
    fn reached(&self) -> Reached {
        let Hair { length, half_width, bend, .. } = self.hair;
        let axes = self.axes.map(|axis| axis.map(f64::from));
        let [along, across] = [0.5 * length, 0.5 * bend].map(f64::from);
        let middle = plus(self.root.map(f64::from), plus(times(axes[0], along), times(axes[1], across)));
        let sideways = across.abs() + f64::from(half_width) + MARGIN;
        let halves = [along + MARGIN + OUTSIDE, sideways + OUTSIDE, f64::from(self.bent_away())];
        Reached { middle, axes, halves }
    }
}
