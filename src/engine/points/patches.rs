//! Patches: blotches of a wanted area, aspect, direction, raggedness and spacing, as on cows and giraffes.
//!
//! 1. Centres at the wanted spacing in the metric of aspect and direction (`centers`).
//! 2. Fine Poisson discs, `detail` points a patch: radius √(.7·area ÷ detail).
//! 3. Round robin: each centre claims the point beside its patch with the least metric distance × exp(σ·N(0, 1)), never one beside
//!    another patch, until its area is reached.
//! 4. Labels 0 and 1, interpolated with L = 1.2; the level that gives the wanted area becomes ½.
//!
//! The values of σ and aspect for a wanted raggedness and aspect follow from [`laws`], which were measured (`facts.md` U).
//!
//! A *kept* outline is reproduced: the field is ½ along it and depends on the distance from it (`kept`). No other patch claims
//! points in it or closer to it than patches are to each other.
//!
//! For varying patches, each patch has a wanted area, aspect and direction of its own (`variation`).

mod description;
mod fringe;
mod gap;
mod growing;
mod kept;
pub mod laws;
mod mending;
mod outline;
mod outlines;
mod variation;

use rand_pcg::Pcg64Mcg;

use super::centers::{self, Effort, Pitch};
use super::delaunay::Delaunay;
use super::discs::{Laying, POINTS_A_SQUARE, poisson_discs};
use super::extent::Extent;
use super::graph::PointGraph;
use super::interpolation::{Interpolator, Weights, interpolate};
use super::labels::{Claim, round_robin};
use super::level::{level_of_share, relevel};
use super::metric::Metric;
use super::ways::ways;
use crate::attributes::Spread;
use crate::grid::{Field, Grid};
pub use description::PATCHES;
pub use fringe::fringe;
pub use growing::PatchGrowth;
use kept::is_beside;
pub use kept::slope;
use laws::Shape;
pub use mending::Labelled;
pub use outline::Outline;
pub use outlines::Outlines;
pub use variation::varied;

/// The wanted properties of the patches around a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// Area, px².
    pub area: f64,
    /// Distance of neighbours, px, as `docs/format.md` defines it.
    pub spacing: f64,
    /// Minor ÷ major axis, 0..1.
    pub aspect: f64,
    /// Direction of the major axis, degrees.
    pub angle: f64,
    /// Contour² ÷ contour² of the ellipse of the same moments, at least 1: see `measure`.
    pub raggedness: f64,
    /// Variation of the patches around these values of area, aspect and angle. The spread of the spacing has no effect.
    pub spread: Spread,
}

impl From<Wanted> for Pitch {
    fn from(Wanted { spacing, aspect, angle, .. }: Wanted) -> Self {
        Self { spacing, aspect, angle }
    }
}

/// Reach of ragged patches from their centre, in half major axes of their ellipse: parts farther away would be threads.
const REACH: f64 = 2.3;

/// Reach of patches from their centres, px: patches farther than this beyond a closed border are not visible.
fn reach(extent: &Extent, wanted: &dyn Fn([f64; 2]) -> Wanted) -> f64 {
    centers::largest(extent, wanted, |wanted| {
        REACH * (wanted.area / (std::f64::consts::PI * wanted.aspect.clamp(centers::LONGEST, 1.0))).sqrt()
    })
}

/// Accuracy with which centres are laid: further attempts gain less than the random variation of the patches.
const EFFORT: Effort = Effort { tries: 4, close: 0.008 };

/// Patches over a canvas.
#[derive(Clone, Copy)]
pub struct Patches<'a> {
    /// The canvas and the cells of the field.
    pub grid: Grid,
    /// The wanted patches at a place, px, also beyond a closed border.
    pub wanted: &'a (dyn Fn([f64; 2]) -> Wanted + Sync),
    /// Outlines that are reproduced in place.
    pub kept: &'a [Outline],
    /// Places, px, where no patch may be: the places of the layers beneath.
    pub blocked: Option<&'a (dyn Fn([f64; 2]) -> bool + Sync)>,
    /// Points in each patch, [`Patches::DETAIL`] by default; see [`Patches::LEAST_DETAIL`] and [`Patches::MOST_DETAIL`].
    pub detail: f64,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// The grown patches.
#[derive(Clone, Debug, PartialEq)]
pub struct GrownPatches {
    /// The pattern, 0..1; patches are above ½.
    pub field: Field,
    /// The level of the interpolated labels that became ½; if it is far below ½, patches had no room.
    pub level: f32,
    /// Centres of the laid patches on the canvas, px, without kept ones.
    pub centers: Vec<[f64; 2]>,
    /// Number of these patches without room for 90 % of their area.
    pub cramped: usize,
}

impl Patches<'_> {
    /// The usual number of points in a patch: fewer show the polygons of the graph, more make fine fringes.
    pub const DETAIL: f64 = 24.0;
    /// The least number of points in a patch: fewer make triangles and bars.
    pub const LEAST_DETAIL: f64 = 7.0;
    /// The largest number of points in a patch: with more, the points would be as close as the px of usual patches.
    pub const MOST_DETAIL: f64 = 200.0;
    /// L of the interpolation: at 1 edges show the single points; larger lengths make them smoother.
    const LENGTH: f64 = 1.2;
    /// L if all patches are wanted smooth: with the shorter length their edges show the fine points. With this one ellipses had a
    /// raggedness of 1.01, with the shorter one 1.02.
    const SMOOTH_LENGTH: f64 = 2.2;
    /// Number of points that would show the details of a kept outline: it determines the slope of the field across the outline.
    pub const KEPT_DETAIL: f64 = 220.0;

    /// Grows the patches.
    #[must_use]
    pub fn grow(&self) -> GrownPatches {
        let mut growth = PatchGrowth::default();
        while !growth.advance(self, 1) {}
        growth.complete().expect("it has grown")
    }

    /// Centres of patches on the canvas and within `frame` px of it, at places that are not taken.
    fn laid(&self, kept: &Outlines, frame: f64, rng: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
        let extent = kept.extent();
        let pinned: Vec<[f64; 2]> = self.kept.iter().map(Outline::center).collect();
        let [low, high] = extent.framed(frame);
        let seen = |at: &[f64; 2]| (0..2).all(|axis| (low[axis]..=high[axis]).contains(&at[axis]));
        let pitch = |at: [f64; 2]| Pitch::from((self.wanted)(at));
        let ratio = |points: &[[f64; 2]]| centers::ratio_of_spacings(points, extent, &pitch);
        let mut laid = centers::lay(extent, &pitch, &pinned, &ratio, EFFORT, rng);
        laid.retain(|at| seen(at) && self.is_clear(*at, kept) && !gap::is_gap(*at, &pinned, extent, &pitch));
        laid
    }

    /// The graph of the fine points, and the noise of each. The first points are `laid`, then the centres of kept outlines follow.
    fn scattered(
        &self,
        extent: &Extent,
        frame: f64,
        laid: &[[f64; 2]],
        rng: &mut Pcg64Mcg,
    ) -> (Delaunay, Vec<f64>) {
        let coarse = |at: [f64; 2]| Metric::circle(self.radius(at, |_| self.detail));
        let fine = |at: [f64; 2]| Metric::circle(self.radius(at, |wanted| wanted.points(self.detail)));
        let begun: Vec<[f64; 2]> = laid.iter().copied().chain(self.kept_centers(extent, frame)).collect();
        let detailed = poisson_discs(extent, frame, &coarse, &begun, rng);
        let graph = Delaunay::new(&poisson_discs(extent, frame, &fine, &detailed, rng), *extent);
        let noise = fringe(&graph, detailed.len(), rng);
        (graph, noise)
    }

    /// The centres of kept outlines on the canvas or within its frame.
    fn kept_centers(&self, extent: &Extent, frame: f64) -> Vec<[f64; 2]> {
        let [low, high] = extent.framed(frame);
        let is_there = |at: &[f64; 2]| (0..2).all(|axis| (low[axis]..=high[axis]).contains(&at[axis]));
        self.kept.iter().map(Outline::center).filter(is_there).collect()
    }

    /// Whether each point is taken, so that no patch may claim it: points in or beside kept outlines, and blocked points.
    fn taken(&self, graph: &Delaunay, kept: &Outlines) -> Vec<bool> {
        let clearance = |at: [f64; 2]| self.radius(at, |wanted| wanted.points(self.detail));
        let is_taken = |at: &[f64; 2]| self.is_blocked(*at) || is_beside(*at, kept, clearance(*at));
        graph.points.iter().map(is_taken).collect()
    }

    /// The wanted properties of each patch; the patches begin at the first points. They are the properties at its centre, with the
    /// random variation that is wanted there.
    fn asked(&self, graph: &Delaunay, patches: usize, rng: &mut Pcg64Mcg) -> Vec<Wanted> {
        let wanted: Vec<Wanted> = graph.points[..patches].iter().map(|at| (self.wanted)(*at)).collect();
        if wanted.iter().all(|wanted| wanted.spread.is_zero()) {
            return wanted;
        }
        let kept = self.kept_centers(&graph.extent, reach(&graph.extent, self.wanted)).len();
        let room = room(graph, patches, kept);
        // The patches on the canvas are varied separately: at the end of the frame the room of a patch is not measured correctly.
        let (on_canvas, beyond): (Vec<usize>, Vec<usize>) =
            (0..patches).partition(|patch| graph.extent.contains(graph.points[*patch]));
        let mut asked = wanted.clone();
        for group in [on_canvas, beyond] {
            let own: Vec<Wanted> = group.iter().map(|patch| wanted[*patch]).collect();
            let room: Vec<f64> = group.iter().map(|patch| room[*patch]).collect();
            let varied = varied(&own, &room, self.detail, rng);
            group.into_iter().zip(varied).for_each(|(patch, varied)| asked[patch] = varied);
        }
        asked
    }

    /// Owner and value of each point; the first `patches` points are centres.
    fn labelled(graph: &impl PointGraph, taken: &[bool], patches: usize, rules: &Rules) -> Labelled {
        let centers: Vec<usize> = (0..patches).collect();
        let (mut owner, _) = round_robin(graph, &centers, taken, rules);
        mending::fill(graph, &mut owner, taken, CLEARANCE);
        let values = owner.iter().map(|owner| f32::from(u8::from(owner.is_some()))).collect();
        Labelled { owner, values }
    }

    /// The field of the labels with its level, after separating patches that merged.
    fn interpolated(&self, graph: &Delaunay, labelled: &mut Labelled, share: f64) -> (Field, f32) {
        labelled.part(graph, CLEARANCE);
        let interpolator = Interpolator::new(graph, &self.grid, &self.weights());
        let mut field = interpolator.field(&labelled.values);
        for _ in 0..MENDED {
            let level = level_of_share(&field, share);
            let before = labelled.values.clone();
            if !labelled.mend(graph, CLEARANCE, &field, level) {
                break;
            }
            let both = before.iter().zip(&labelled.values);
            let changed: Vec<bool> = both.map(|(before, now)| before != now).collect();
            interpolator.update(&mut field, &labelled.values, &changed);
        }
        let level = relevel(&mut field, share);
        (clamped(field), level)
    }

    /// The interpolated field of values at the points.
    fn spread(&self, graph: &Delaunay, values: &[f32]) -> Field {
        interpolate(graph, values, &self.grid, &self.weights())
    }

    fn weights(&self) -> Weights<'static> {
        let extent = Extent::from(self.grid.bounds_px());
        let most_ragged = centers::largest(&extent, self.wanted, |wanted| wanted.raggedness);
        Weights { length: axis_length(most_ragged), ..Weights::default() }
    }

    /// The cost of laying the centres and the points.
    #[must_use]
    pub fn laying(&self) -> Laying {
        let extent = Extent::from(self.grid.bounds_px());
        let pitch = |at: [f64; 2]| Pitch::from((self.wanted)(at));
        let fine = |at: [f64; 2]| Metric::circle(self.radius(at, |wanted| wanted.points(self.detail)));
        centers::laying(&extent, &pitch).and(Laying::new(&extent, reach(&extent, self.wanted), &fine))
    }

    /// Upper bound of the number of comparisons of two centres while they are laid.
    #[must_use]
    pub fn compared(&self) -> f64 {
        let pitch = |at: [f64; 2]| Pitch::from((self.wanted)(at));
        centers::compared(&Extent::from(self.grid.bounds_px()), &pitch, EFFORT)
    }

    fn is_blocked(&self, at: [f64; 2]) -> bool {
        self.blocked.is_some_and(|blocked| blocked(at))
    }

    /// Whether a patch may have its centre at a place.
    fn is_clear(&self, at: [f64; 2], kept: &Outlines) -> bool {
        let radius = 0.5 * ((self.wanted)(at).area / std::f64::consts::PI).sqrt();
        !self.is_blocked(at)
            && kept.near(at, radius).all(|outline| outline.depth(at, kept.extent()) < -radius)
    }

    /// Radius of the discs for this number of points in a patch, px.
    fn radius(&self, at: [f64; 2], points: impl Fn(&Wanted) -> f64) -> f64 {
        let wanted = (self.wanted)(at);
        let points = points(&wanted).clamp(Self::LEAST_DETAIL, Self::MOST_DETAIL);
        (POINTS_A_SQUARE * wanted.area / points).sqrt()
    }
}

/// The area around each of the first `patches` points of a graph, px², along which no other of them is nearer, and none of the next
/// `others` points.
#[must_use]
pub fn room(graph: &impl PointGraph, patches: usize, others: usize) -> Vec<f64> {
    let mut room = vec![0.0; patches];
    for (point, from) in ways(graph, 0..patches + others, |_| true).from.into_iter().enumerate() {
        if let Some(room) = room.get_mut(from as usize) {
            *room += graph.area(point);
        }
    }
    room
}

/// The owners and the values of the points of a graph, at the first of which the patches begin that are `asked` for, with `detail`
/// points in each. `noise` holds the [`fringe()`] of each point. `taken` points are not claimed.
#[must_use]
pub fn claimed(
    graph: &impl PointGraph,
    asked: &[Wanted],
    detail: f64,
    noise: Vec<f64>,
    taken: &[bool],
) -> Labelled {
    let rules = Rules::new(asked, &|wanted| wanted.shape(detail), noise);
    let mut labelled = Patches::labelled(graph, taken, asked.len(), &rules);
    labelled.part(graph, CLEARANCE);
    labelled
}

/// The length of the axes, in edges, for patches of this raggedness.
#[must_use]
pub fn axis_length(raggedness: f64) -> f64 {
    if raggedness < SMOOTH { Patches::SMOOTH_LENGTH } else { Patches::LENGTH }
}

/// The field clipped to 0..1: points between patches have negative values.
fn clamped(mut field: Field) -> Field {
    field.values.iter_mut().for_each(|value| *value = value.clamp(0.0, 1.0));
    field
}

/// Patches with less wanted raggedness than this are smooth. Ellipses have 1, and 24 points give 1.137. Not tuned.
const SMOOTH: f64 = 1.1;
/// A patch that claims less than this share of its area is cramped.
const CRAMPED: f64 = 0.9;

/// The rules of the claims: metric, σ and area of each patch, and the noise of each point.
struct Rules {
    metrics: Vec<Metric>,
    sigmas: Vec<f64>,
    areas: Vec<f64>,
    noise: Vec<f64>,
}

impl Rules {
    fn new(asked: &[Wanted], shape: &dyn Fn(&Wanted) -> Shape, noise: Vec<f64>) -> Self {
        let mut rules = Self { metrics: Vec::new(), sigmas: Vec::new(), areas: Vec::new(), noise };
        for wanted in asked {
            let Shape { sigma, aspect } = shape(wanted);
            let radius = (wanted.area / std::f64::consts::PI).sqrt();
            rules.metrics.push(Metric::ellipse(radius, aspect, wanted.angle));
            rules.sigmas.push(sigma);
            rules.areas.push(wanted.area);
        }
        rules
    }
}

impl Claim for Rules {
    fn cost(&self, patch: usize, point: usize, displacement: [f64; 2]) -> Option<f64> {
        Some(
            self.metrics[patch].square(displacement).sqrt()
                * libm::exp(self.sigmas[patch] * self.noise[point]),
        )
    }

    fn wants(&self, patch: usize, area: f64, next: f64) -> bool {
        // The last point is the one that brings the area nearest to the wanted one.
        area + 0.5 * next < self.areas[patch]
    }

    fn clearance(&self) -> Option<f64> {
        Some(CLEARANCE)
    }
}
/// Rounds in which merged patches are separated; of sixty fields none had any left.
const MENDED: usize = 8;
/// Clearance below which an edge is ignored. Without this bound the level left a separate speck at one patch in 36 at σ = .3, and
/// patches merged from a coverage of .45 on; with it there were no specks in as many.
const CLEARANCE: f64 = 0.2;
