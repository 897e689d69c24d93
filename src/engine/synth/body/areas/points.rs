//! Fields of points on a surface: values or labels at Poisson discs, interpolated over octaves, as on a canvas
//! ([`crate::points::fields`]).

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::discs::poisson_discs;
use super::graph::SurfaceGraph;
use super::interpolation::{Weighing, interpolate};
use crate::document::{Body, Interpolation, Labels, Points, Progression, Towards};
use crate::grid::Domain;
use crate::measure::surface_stripes;
use crate::points::fields::{OCTAVE_SEED, round_robin_labels};
use crate::points::graph::PointGraph;
use crate::points::labels::{Order, clusters, connected, groups, ray_points};
use crate::points::level::smoothly;
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::plan::BodyPlan;
use crate::synth::body::point_form::PointForm;
use crate::synth::error::LayerError;
use crate::synth::pattern::EDGE;
use crate::synth::points::advice::advice;
use crate::synth::report::{PointsReport, PointsShare};

/// The distance from a vertex to the nearest point, at most, in radii of discs: no vertex lies outside of all discs.
const FARTHEST: f64 = 1.5;
/// The distance between the ends of a connected net, at most, in distances of its points ÷ √probability.
const ENDS: f64 = 4.0;
/// The distance from what the layers beneath have taken over which a field begins, in distances of its points.
const BESIDE: f64 = 0.5;
/// Range of values below which a field counts as flat.
const FLAT: f32 = 1e-4;
/// Bisections of the level: an error of 2⁻¹⁶ moves no edge that can be seen.
const HALVINGS: usize = 16;

/// A field of points that has grown.
pub struct GrownPoints {
    /// 0..1 by vertex; edges at ½.
    pub values: Vec<f32>,
    /// What was asked and what has grown.
    pub report: PointsReport,
}

/// The field of points on a surface.
struct PointsOnSurface<'a> {
    plan: &'a BodyPlan,
    points: &'a Points,
    /// Radius of the discs by vertex, px.
    distance: Vec<f64>,
    /// The probability of dark points by vertex.
    dark: Vec<f64>,
    /// How far each vertex is from what the layers beneath have taken, px; empty = nothing is taken.
    away: Vec<f64>,
}

/// Grows a field of points on the surface of a plan.
///
/// # Errors
/// All points have the same value.
pub fn grown(
    plan: &BodyPlan,
    form: &PointForm,
    points: &Points,
    body: &Body,
    seed: u64,
) -> Result<GrownPoints, LayerError> {
    let field = PointsOnSurface::new(plan, form, points, body);
    let (mut sum, mut weights, mut count) = (vec![0.0f32; plan.surface().cells()], 0.0f32, 0);
    for octave in 0..points.octaves {
        let scale = 0.5f64.powi(octave as i32);
        let mut rng = Pcg64Mcg::seed_from_u64(seed.wrapping_add(u64::from(octave).wrapping_mul(OCTAVE_SEED)));
        let (values, points_of) = field.octave(scale, &mut rng);
        let folded = |value: f32| if points.fold { (2.0 * value - 1.0).abs() } else { value };
        sum.iter_mut().zip(values).for_each(|(sum, value)| *sum += scale as f32 * folded(value));
        weights += scale as f32;
        count += points_of;
    }
    let faded = |(vertex, sum): (usize, f32)| field.free(vertex) * (sum / weights).clamp(0.0, 1.0);
    let mut values: Vec<f32> = sum.into_iter().enumerate().map(faded).collect();
    let [low, high] =
        values.iter().fold([1.0f32, 0.0], |[low, high], value| [low.min(*value), high.max(*value)]);
    if high - low < FLAT {
        return Err(LayerError::Flat { advice: advice(&points.labels) });
    }
    let asked = field.share(form);
    if let Some(asked) = asked {
        let level = field.level(&values, asked);
        values.iter_mut().for_each(|value| *value = smoothly(*value, level));
    }
    let range = |pick: fn(f64, f64) -> f64, from| field.distance.iter().copied().fold(from, pick);
    let report = PointsReport {
        labels: points.labels.name(),
        count,
        distance: [range(f64::min, f64::INFINITY), range(f64::max, 0.0)],
        share: PointsShare { asked, got: field.share_above(&values) },
    };
    Ok(GrownPoints { values, report })
}

impl<'a> PointsOnSurface<'a> {
    fn new(plan: &'a BodyPlan, form: &PointForm, points: &'a Points, body: &Body) -> Self {
        let surface = plan.surface();
        let progress = progress(surface, &points.progression, body);
        let distance = |(progress, wanted): (&f64, &crate::attributes::Attributes)| match form.given {
            Some([first, last]) if first != last => first * libm::pow(last / first, *progress),
            _ => wanted.distance().unwrap_or(surface.unit()),
        };
        let distance = progress.iter().zip(&plan.wanted).map(distance).collect();
        let dark = match points.labels {
            Labels::Random { dark: [first, last] } => match form.share {
                // There might be no level of another share.
                Some(share) if first == last => vec![share; progress.len()],
                _ => progress.iter().map(|progress| first + (last - first) * progress).collect(),
            },
            _ => vec![0.0; progress.len()],
        };
        let away = if plan.maps.obstacles.is_empty() {
            Vec::new()
        } else {
            let away = surface.distances(&plan.maps.obstacles).unwrap_or_default();
            away.into_iter().map(|away| away * surface.unit()).collect()
        };
        Self { plan, points, distance, dark, away }
    }

    /// How free a vertex is, 0..1: it is not beside what the layers beneath have taken.
    fn free(&self, vertex: usize) -> f32 {
        let far = |away: &f64| (away / (BESIDE * self.distance[vertex])).min(1.0) as f32;
        self.away.get(vertex).map_or(1.0, far)
    }

    /// The field of one octave, whose discs have this `scale`, and its number of points.
    fn octave(&self, scale: f64, rng: &mut Pcg64Mcg) -> (Vec<f32>, usize) {
        let radius = |vertex: usize| scale * self.distance[vertex];
        let places = poisson_discs(self.plan.surface(), &radius, &[], rng);
        let graph = self.graph(places, &radius);
        if let Labels::SpaceGiraffe { rays: [least, most] } = self.points.labels {
            let (places, dark) = self.space_giraffe(&graph, &(least as usize..most as usize + 1), rng);
            let graph = self.graph(places, &radius);
            return self.spread(&graph, &dark, rng);
        }
        let values = match self.points.labels {
            Labels::Values { group } => random_values(&graph, group as usize, rng),
            _ => numbers(&self.labels(&graph, &radius, rng)),
        };
        self.spread(&graph, &values, rng)
    }

    fn graph(&self, places: Vec<SurfacePoint>, radius: &dyn Fn(usize) -> f64) -> SurfaceGraph<'a> {
        SurfaceGraph::new(self.plan.surface(), places, &|vertex| FARTHEST * radius(vertex))
    }

    /// Which points are dark, for labels that are dark or light.
    fn labels(&self, graph: &SurfaceGraph, radius: &dyn Fn(usize) -> f64, rng: &mut Pcg64Mcg) -> Vec<bool> {
        let clustered = |size: u32, order: Order, rng: &mut Pcg64Mcg| -> Vec<bool> {
            clusters(graph, size as usize, order, rng).into_iter().map(|owner| owner.is_some()).collect()
        };
        match self.points.labels {
            Labels::BreadthFirst { size } => clustered(size, Order::BreadthFirst, rng),
            Labels::DepthFirst { size } => clustered(size, Order::DepthFirst, rng),
            Labels::RoundRobin { size, rings } => {
                round_robin_labels(graph, size as usize, rings as usize, rng)
            }
            Labels::Connected { start, rings } => {
                let far = ENDS / start.sqrt();
                let sparse = |ends: &[usize]| {
                    let places = ends.iter().map(|point| graph.places[*point]).collect();
                    SurfaceGraph::new(self.plan.surface(), places, &|vertex| far * radius(vertex))
                };
                connected(graph, sparse, start, rings as usize, rng)
            }
            Labels::Random { .. }
            | Labels::Image { .. }
            | Labels::Values { .. }
            | Labels::SpaceGiraffe { .. } => {
                let is_dark = |point: usize| rng.random::<f64>() < self.dark[graph.vertex(point)];
                (0..graph.count()).map(is_dark).collect()
            }
        }
    }

    /// The points of cells with rays round each of these centres, and their values.
    fn space_giraffe(
        &self,
        centers: &SurfaceGraph,
        rays: &std::ops::Range<usize>,
        rng: &mut Pcg64Mcg,
    ) -> (Vec<SurfacePoint>, Vec<f32>) {
        let surface = self.plan.surface();
        let (mut places, mut dark) = (Vec::new(), Vec::new());
        for (index, center) in centers.places.iter().enumerate() {
            let Some(around) = ray_points(centers, index, rays, rng) else { continue };
            places.push(*center);
            dark.push(true);
            for (displacement, is_dark) in around {
                places.push(surface.walk(*center, displacement));
                dark.push(is_dark);
            }
        }
        (places, numbers(&dark))
    }

    /// The field between the values of these points, of which none is dark near to what is taken; and their number.
    fn spread(&self, graph: &SurfaceGraph, values: &[f32], rng: &mut Pcg64Mcg) -> (Vec<f32>, usize) {
        let is_free = |point: usize| {
            let vertex = graph.vertex(point);
            self.away.get(vertex).is_none_or(|away| *away >= self.distance[vertex])
        };
        let free = |(point, value): (usize, &f32)| if is_free(point) { *value } else { 0.0 };
        let values: Vec<f32> = values.iter().enumerate().map(free).collect();
        let directions: Vec<[f64; 2]> = if self.points.shift > 0.0 {
            (0..graph.count()).map(|point| self.towards(graph.vertex(point), rng)).collect()
        } else {
            Vec::new()
        };
        let weighing = Weighing {
            length: self.points.axis,
            shift: (self.points.shift > 0.0).then_some((self.points.shift, &directions)),
            nearest: self.points.interpolation == Interpolation::Nearest,
        };
        (interpolate(graph, &values, &weighing), values.len())
    }

    /// The direction in which a point at a vertex shifts its weight, in the frame there.
    fn towards(&self, vertex: usize, rng: &mut Pcg64Mcg) -> [f64; 2] {
        let angle = match self.points.towards {
            Towards::Angle(angle) => {
                let along = self.plan.directions.as_ref().map_or(0.0, |field| field.degrees[vertex]);
                (angle + along).to_radians()
            }
            Towards::Random | Towards::Outward => std::f64::consts::TAU * rng.random::<f64>(),
        };
        let (sin, cos) = libm::sincos(angle);
        [cos, sin]
    }

    /// The share above the edge that is asked for: by the options, by drawn ellipses, or by the probability of dark points.
    fn share(&self, form: &PointForm) -> Option<f64> {
        let Points { octaves, fold, labels, .. } = self.points;
        let by_chance = labels.share_is_asked() && *octaves == 1 && !fold && self.points.has_level();
        form.share.or_else(|| {
            let surface = self.plan.surface();
            let [dark, all] = self.dark.iter().enumerate().fold([0.0; 2], |[dark, all], (vertex, own)| {
                let area = surface.cell_area(vertex);
                [dark + own * area, all + area]
            });
            by_chance.then(|| dark / all)
        })
    }

    /// The share of the free surface that is above the edge.
    fn share_above(&self, values: &[f32]) -> f64 {
        let group = |vertex: usize| if self.plan.maps.is_obstacle(vertex) { usize::MAX } else { 0 };
        let found = surface_stripes(self.plan.surface(), values, EDGE, 1, &group)[0];
        found.area / found.surface.max(f64::MIN_POSITIVE)
    }

    /// The level that becomes the edge where this share is above it.
    fn level(&self, values: &[f32], wanted: f64) -> f32 {
        let [mut low, mut high] = [0.0f32, 1.0];
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let with: Vec<f32> = values.par_iter().map(|value| smoothly(*value, middle)).collect();
            if self.share_above(&with) > wanted { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    }
}

/// Random values, one for each group of so many neighbours.
fn random_values(graph: &SurfaceGraph, size: usize, rng: &mut Pcg64Mcg) -> Vec<f32> {
    let group = if size > 1 { groups(graph, size, rng) } else { (0..graph.count() as u32).collect() };
    let count = group.iter().max().map_or(0, |last| *last as usize + 1);
    let of_group: Vec<f32> = (0..count).map(|_| rng.random()).collect();
    group.iter().map(|group| of_group[*group as usize]).collect()
}

fn numbers(dark: &[bool]) -> Vec<f32> {
    dark.iter().map(|dark| f32::from(u8::from(*dark))).collect()
}

/// The position of each vertex along the progression, 0..1: along the model, or from its top down.
fn progress(surface: &Surface, progression: &Progression, body: &Body) -> Vec<f64> {
    let axis = match progression {
        Progression::Down => body.up.vector().map(|part| -part),
        Progression::Across | Progression::Outward | Progression::Image(_) => body.along.vector(),
    };
    let along = |at: &[f64; 3]| (0..3).map(|i| at[i] * axis[i]).sum::<f64>();
    let places: Vec<f64> = surface.mesh.positions.iter().map(along).collect();
    let [low, high] = places
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(*at), high.max(*at)]);
    places.into_iter().map(|at| (at - low) / (high - low).max(f64::MIN_POSITIVE)).collect()
}
