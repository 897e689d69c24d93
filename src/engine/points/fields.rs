//! Fields of points: values or labels at Poisson discs, interpolated, over octaves (the paper's figures 5–24).
//!
//! ```text
//! T = Σᵢ 2⁻ⁱ·Pᵢ ÷ Σᵢ 2⁻ⁱ,  i = 0 … octaves − 1     eq. 5; Pᵢ from discs of 2⁻ⁱ of the radius
//! P′ = 2·|P − ½|                                     folded
//! ```

mod description;
mod growing;

use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use super::delaunay::Delaunay;
use super::discs::{POINTS_A_SQUARE, poisson_discs};
use super::extent::Extent;
use super::graph::PointGraph;
use super::interpolation::{NOBODY, Orientation, Weights, highest_weight, interpolate};
use super::labels::{
    self, Claim, Order, bordered, by_reference, clusters, connected, groups, round_robin, space_giraffe,
};
use super::metric::Metric;
use crate::grid::{Bounds, Field, Grid};

pub use description::POINTS;
pub use growing::FieldGrowth;

/// A number for each place of the canvas, px; it is also evaluated beyond a closed border.
pub type ByPlace<'a> = &'a (dyn Fn([f64; 2]) -> f64 + Sync);

/// The rule that gives points their values. Each except [`Labelling::Values`] makes them dark (1) or light (0).
#[derive(Clone, Copy)]
pub enum Labelling<'a> {
    /// Random values from 0 to 1, one for each group of this number of neighbours.
    Values(usize),
    /// Each point is dark with this probability at its place.
    Random(ByPlace<'a>),
    /// Each point is dark with this probability at its place. Then passes up to this total number: each uses the field of the
    /// previous pass as the probability, and 1 ÷ √2 of its radius.
    Reference(ByPlace<'a>, u32),
    /// Cells round each disc, with a random number of rays from the first number to the second.
    SpaceGiraffe([usize; 2]),
    /// Clusters of this number of points, all their neighbours light.
    BreadthFirst(usize),
    /// Clusters of this number of points, grown as winding chains, all their neighbours light.
    DepthFirst(usize),
    /// Clusters that claim points in turn until every point is taken, one cluster for this number of points. Points at the borders
    /// of clusters are light, and this number of further rings of neighbours.
    RoundRobin(usize, usize),
    /// Points drawn with this probability, the shortest paths between them, and this number of rings of neighbours round both.
    Connected(f64, usize),
}

/// The direction in which the weights of points are shifted (eq. 4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shift {
    /// A random direction, different for each point.
    Random,
    /// Away from the middle of the canvas.
    Outward,
    /// Along this direction, degrees from +x toward +y.
    Along(f64),
}

/// A field of points over a canvas.
pub struct PointField<'a> {
    /// The canvas and the cells of the field.
    pub grid: Grid,
    /// Radius of the discs at a place, px: roughly the distance from a point to its nearest neighbour.
    pub distance: ByPlace<'a>,
    /// The smallest and the largest of these radii, px.
    pub distances: [f64; 2],
    /// The rule that gives points their values.
    pub labelling: Labelling<'a>,
    /// Whether each cell takes the value of the point of the highest weight, instead of the interpolated one.
    pub nearest: bool,
    /// L, the length of the axes: see [`Weights::length`].
    pub axis: f64,
    /// ε of eq. 4, 0–1; 0 = no shift.
    pub strength: f64,
    /// The direction in which weights are shifted.
    pub shift: Shift,
    /// Number of octaves, at least 1.
    pub octaves: u32,
    /// Whether each octave is folded at ½.
    pub fold: bool,
    /// Places, px, where no point is dark: the places of the layers beneath.
    pub blocked: Option<&'a (dyn Fn([f64; 2]) -> bool + Sync)>,
    /// Seed of all random numbers.
    pub seed: u64,
}

/// Points with their values.
struct Valued {
    graph: Delaunay,
    values: Vec<f32>,
}

/// Octaves and passes with smaller discs, in cells, are left out: a cell would show the mean of several.
const FINEST: f64 = 1.0;
/// Difference between the seeds of successive octaves; an odd number, so that none repeats (2⁶⁴ ÷ the golden ratio).
pub const OCTAVE_SEED: u64 = 0x9E37_79B9_7F4A_7C15;
/// Width of the frame of discs beyond a closed border, in radii: it holds the neighbours of those that reach the canvas, 2 for each
/// length of an axis.
const FRAME: f64 = 2.0;

impl PointField<'_> {
    /// The field, 0..1, and its number of points.
    #[must_use]
    pub fn grow(&self) -> (Field, usize) {
        let mut growth = FieldGrowth::new(self);
        while !growth.advance(self, 1) {}
        growth.complete(self)
    }

    /// Whether discs with this `scale` are visible.
    fn is_visible(&self, scale: f64) -> bool {
        scale * self.distances[0] >= FINEST * self.grid.px_a_cell()
    }

    /// The interpolated values of each cell.
    fn spread(&self, graph: &Delaunay, values: &[f32], directions: &[[f64; 2]]) -> Vec<f32> {
        let shifted = Orientation { strength: self.strength, directions };
        let weights = Weights { length: self.axis, orientation: (self.strength > 0.0).then_some(shifted) };
        if !self.nearest {
            return interpolate(graph, values, &self.grid, &weights).values;
        }
        let owners = highest_weight(graph, &self.grid, &weights);
        let value = |owner: u32| if owner == NOBODY { 0.0 } else { values[owner as usize] };
        owners.into_iter().map(value).collect()
    }

    /// The direction in which each point shifts its weight.
    fn directions(&self, graph: &Delaunay, rng: &mut Pcg64Mcg) -> Vec<[f64; 2]> {
        if self.strength <= 0.0 {
            return Vec::new();
        }
        let along = |angle: f64| {
            let (s, c) = libm::sincos(angle);
            [c, s]
        };
        let direction = |at: &[f64; 2]| match self.shift {
            Shift::Random => along(std::f64::consts::TAU * rng.random::<f64>()),
            Shift::Along(angle) => along(angle.to_radians()),
            Shift::Outward => {
                let middle = graph.extent.size.map(|side| 0.5 * side);
                let displacement = [at[0] - middle[0], at[1] - middle[1]];
                let length = libm::hypot(displacement[0], displacement[1]);
                if length > 0.0 { displacement.map(|displacement| displacement / length) } else { [0.0; 2] }
            }
        };
        graph.points.iter().map(direction).collect()
    }

    /// Points whose discs have this `scale`, and their values.
    fn valued(&self, scale: f64, rng: &mut Pcg64Mcg) -> Valued {
        if let Labelling::Reference(first, passes) = self.labelling {
            return self.passed(first, passes, scale, rng);
        }
        let graph = self.scattered(scale, rng);
        let dark = match self.labelling {
            Labelling::Values(size) => {
                let group = if size > 1 {
                    groups(&graph, size, rng)
                } else {
                    (0..graph.points.len() as u32).collect()
                };
                let count = group.iter().max().map_or(0, |last| *last as usize + 1);
                let of_group: Vec<f32> = (0..count).map(|_| rng.random()).collect();
                let values = group.iter().map(|group| of_group[*group as usize]).collect();
                return Valued { graph, values };
            }
            Labelling::Random(dark) => labels::random(&graph.points, dark, rng),
            Labelling::Reference(..) => Vec::new(),
            Labelling::SpaceGiraffe([least, most]) => {
                let (points, dark) = space_giraffe(&graph, &(least..most + 1), rng);
                return self.labelled(Delaunay::new(&points, graph.extent), &dark);
            }
            Labelling::BreadthFirst(size) => self.clustered(&graph, size, Order::BreadthFirst, rng),
            Labelling::DepthFirst(size) => self.clustered(&graph, size, Order::DepthFirst, rng),
            Labelling::RoundRobin(size, rings) => round_robin_labels(&graph, size, rings, rng),
            Labelling::Connected(start, rings) => {
                connected(&graph, |ends| labels::sparse(&graph, ends), start, rings, rng)
            }
        };
        self.labelled(graph, &dark)
    }

    fn clustered(&self, graph: &Delaunay, size: usize, order: Order, rng: &mut Pcg64Mcg) -> Vec<bool> {
        let owner = clusters(graph, size, order, rng);
        owner.into_iter().map(|owner| owner.is_some()).collect()
    }

    /// Points with random labels in several passes, each with the field of the previous one as the probability.
    fn passed(&self, first: ByPlace, passes: u32, scale: f64, rng: &mut Pcg64Mcg) -> Valued {
        let finer = |pass: u32| scale * 0.5f64.powf(0.5 * f64::from(pass));
        let mut graph = self.scattered(scale, rng);
        let dark = labels::random(&graph.points, first, rng);
        let mut valued = self.labelled(graph, &dark);
        for pass in (1..passes).take_while(|pass| self.is_visible(finer(*pass))) {
            let directions = self.directions(&valued.graph, rng);
            let values = self.spread(&valued.graph, &valued.values, &directions);
            graph = self.scattered(finer(pass), rng);
            let dark = by_reference(&graph.points, &Field::new(&self.grid, values), rng);
            valued = self.labelled(graph, &dark);
        }
        valued
    }

    fn scattered(&self, scale: f64, rng: &mut Pcg64Mcg) -> Delaunay {
        let extent = Extent::from(self.grid.bounds_px());
        let frame = scale * frame(self.axis, self.distances[1]);
        let metric = |at: [f64; 2]| Metric::circle(scale * (self.distance)(at));
        Delaunay::new(&poisson_discs(&extent, frame, &metric, &[], rng), extent)
    }

    /// The values of points: 1 where a point is dark and not blocked, otherwise 0.
    fn labelled(&self, graph: Delaunay, dark: &[bool]) -> Valued {
        let is_blocked = |at: [f64; 2]| self.blocked.is_some_and(|blocked| blocked(at));
        let value = |(at, dark): (&[f64; 2], &bool)| f32::from(u8::from(*dark && !is_blocked(*at)));
        let values = graph.points.iter().zip(dark).map(value).collect();
        Valued { graph, values }
    }
}

/// The width of the frame beyond a closed border, px, for axes of this length and discs up to this radius.
#[must_use]
pub fn frame(axis: f64, largest: f64) -> f64 {
    (FRAME + FRAME * axis) * largest
}

/// The claims of clusters that take the nearest free point without any condition, until none is left.
struct Nearest;

impl Claim for Nearest {
    fn cost(&self, _: usize, _: usize, displacement: [f64; 2]) -> Option<f64> {
        Some(libm::hypot(displacement[0], displacement[1]))
    }

    fn wants(&self, _: usize, _: f64, _: f64) -> bool {
        true
    }

    fn clearance(&self) -> Option<f64> {
        None
    }
}

/// Whether each point is dark, for clusters of about `size` points that claim points in turn.
pub fn round_robin_labels(
    graph: &impl PointGraph,
    size: usize,
    rings: usize,
    rng: &mut Pcg64Mcg,
) -> Vec<bool> {
    let count = (graph.count() / size.max(1)).max(1).min(graph.count());
    let mut points: Vec<usize> = (0..graph.count()).collect();
    labels::shuffle(&mut points, rng);
    let (owner, _) = round_robin(graph, &points[..count], &[], &Nearest);
    bordered(graph, &owner, rings)
}

/// Approximate number of points of discs with these radii and number of octaves, for a canvas in px: from the mean of distance⁻²
/// over it.
#[must_use]
pub fn expected_points(canvas: &Bounds, distance: ByPlace, octaves: u32) -> f64 {
    /// Number of sampled places along each side.
    const SAMPLES: usize = 16;
    let place = |k: usize, axis: usize| (k as f64 + 0.5) / SAMPLES as f64 * canvas.size[axis];
    let at = |k: usize| [place(k % SAMPLES, 0), place(k / SAMPLES, 1)];
    let density = (0..SAMPLES * SAMPLES).map(|k| distance(at(k)).powi(-2)).sum::<f64>();
    // 1 + 4 + 16 + …
    let octaves = (4f64.powi(octaves as i32) - 1.0) / 3.0;
    POINTS_A_SQUARE * density / (SAMPLES * SAMPLES) as f64 * canvas.size[0] * canvas.size[1] * octaves
}

#[cfg(test)]
mod tests;
