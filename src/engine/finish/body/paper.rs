//! Ink on a paper that covers a surface: its fibres lie along the axes of space, where these are near the surface.

use super::balance::Carried;
use super::reach::SurfaceReach;
use super::solid::SolidNoise;
use super::source::{Place, SurfaceSource, is_ink, single};
use crate::finish::ink::{RUN, dried};
use crate::finish::noise::part_seed;
use crate::finish::surfel::Surfel;
use crate::surface::SurfacePoint;
use crate::surface::vector::{Vector, across, length, plus, times};

/// The lowest and the highest height.
pub(super) const HEIGHTS: [f32; 2] = [-0.06, 0.06];
/// Length of a fibre ÷ its width.
const STRETCH: f32 = 5.0;
/// Distance at which other colours are looked for, px.
const BESIDE: f64 = 1.1;

/// Paper with fibres.
#[derive(Clone, Debug)]
pub(super) struct Paper {
    size: f32,
    /// The share of its way that ink of the paper, and of marks, runs.
    pub carried: Carried,
    /// Along each axis.
    run: [SolidNoise; 3],
    fine: [SolidNoise; 3],
    fibres: [SolidNoise; 3],
    cloud: SolidNoise,
}

impl Paper {
    /// Paper with fibres of `size` px.
    pub fn new(source: &SurfaceSource, size: f32) -> Self {
        let noise = |size: f32, index: u32| SolidNoise::new(size, part_seed(source.seed, index));
        Self {
            size,
            carried: [1.0; 2],
            run: [96, 97, 103].map(|index| noise(0.45 * size, index)),
            fine: [98, 99, 104].map(|index| noise(0.16 * size, index)),
            fibres: [100, 101, 105].map(|index| noise(0.2 * size, index)),
            cloud: noise(2.4 * size, 102),
        }
    }

    /// The look `off` px beside a place of this colour; without colours where that is not known.
    pub fn surfel(
        &self,
        (source, reach): (&SurfaceSource, &SurfaceReach),
        place: &Place,
        off: Vector,
        own: Option<[f32; 4]>,
    ) -> Surfel {
        let point = single(plus(place.at, off));
        let fibre = [0, 1, 2].map(|axis| {
            let mut along = point;
            along[axis] /= STRETCH;
            // Those that stick out of the surface are not seen.
            let flat = 1.0 - place.normal[axis] * place.normal[axis];
            flat as f32 * self.fibres[axis].at(along)
        });
        let (slow, grain) = (self.cloud.at(point), 0.5 * fibre.iter().sum::<f32>());
        let Some(own) = own else { return dried([1.0, 1.0, 1.0, 0.0], 0.0, slow, grain) };
        let by = [0, 1, 2].map(|axis| {
            let noise =
                0.75 * self.run[axis].at(point) + 0.45 * self.fine[axis].at(point) + 0.6 * fibre[axis];
            f64::from(RUN * self.size * noise)
        });
        let by = across(by, place.normal);
        let far = length(by).max(1e-6);
        let most = f64::from(reach.at(source.surface, place.point, self.size));
        let by = times(by, most.min(far) / far);
        let looked = |share: f32| {
            let from = source.displaced(place.point, plus(times(by, f64::from(share)), off));
            (from, if from == place.point { own } else { (source.paint)(from) })
        };
        let (mut from, mut seen) = looked(1.0);
        let carried = self.carried[usize::from(is_ink(seen))];
        if is_ink(seen) != is_ink(own) && carried < 1.0 {
            (from, seen) = looked(carried);
        }
        // Where the places around have other colours, an edge is near: there the ink dries last.
        let rim = self.rim(source, from, seen);
        dried(seen, rim, slow, grain)
    }

    /// How far a place of this colour is at an edge, 0..1.
    fn rim(&self, source: &SurfaceSource, from: SurfacePoint, seen: [f32; 4]) -> f32 {
        let around = [[BESIDE, 0.0], [-BESIDE, 0.0], [0.0, BESIDE], [0.0, -BESIDE]].map(|by| {
            let there = (source.paint)(source.surface.walk(from, by));
            (0..3).map(|channel| (there[channel] - seen[channel]).max(0.0)).sum::<f32>()
        });
        (around.iter().sum::<f32>() * 0.5).min(1.0)
    }
}
