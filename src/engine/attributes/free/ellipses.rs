//! What free ellipses want anywhere on the canvas.

use super::far::Far;
use super::kernel::Kernels;
use super::nodes::{Nodes, layout_with};
use super::regression::{Manner, Observation, Regression};
use crate::attributes::regions::{MARKS_OF_A_SPREAD, RegionGrid};
use crate::attributes::{Spots, Spread, spacing};
use crate::grid::{Bounds, Edges, PointBuckets};
use crate::marks::{Ellipse, axial, turn};

/// How log area is regressed.
const SIZE: Manner = Manner { floor: 0.05, followed: 2.5 };

/// How log spacing is regressed. Edges of an even pattern differ by as much.
const SPACING: Manner = Manner { floor: 0.15, followed: 2.5 };

/// How the aspect is regressed.
const ASPECT: Manner = Manner { floor: 0.02, followed: 2.5 };

/// How unit double-angle vectors are regressed: 0.07 are 2°. A slope that is followed farther would turn them over.
const DIRECTION: Manner = Manner { floor: 0.07, followed: 1.2 };

/// About so many marks tell how far those about an edge are from their nearest.
const MARKS_ABOUT_AN_EDGE: usize = 9;

/// Area that must be far from all marks for spots to be laid there by themselves, in squares of their spacing. Not tuned.
const LEAST_ROOM: f64 = 8.0;

/// Nodes for planning in a distance between neighbours.
const NODES_A_SPACING: f64 = 2.0;

/// Nodes along the longer side.
const NODES: usize = 64;

/// Attributes of ellipses at nodes over the canvas.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct EllipseMap {
    /// Log area, aspect, log spacing (0 where it is free).
    values: Nodes<3>,
    /// Mean double-angle vector, its length 0..1 the coherence.
    directions: Nodes<2>,
    /// Whether there is no spacing: a single mark.
    spacing_is_free: bool,
    own: Vec<Spots>,
    /// What is wanted far from all marks; `None` where all places are near some, or where what is wanted changes far from them too.
    pub far: Option<Far>,
    pub mean: Spots,
    pub spread: Spread,
}

impl EllipseMap {
    /// The map of at least one ellipse; `far_before`: the spacing that was wanted far from them before they were changed, px.
    pub fn new(ellipses: &[Ellipse], canvas: &RegionGrid, far_before: Option<f64>) -> Option<Self> {
        let measured = Spots::measure(ellipses)?;
        let fit = Fit::new(ellipses, canvas.bounds());
        let mean = Spots { spacing: fit.mean_spacing(), ..measured };
        let layout = layout_with(canvas, if ellipses.len() > 1 { NODES } else { 1 });
        let all = Nodes::sampled(layout, |point| fit.at(point));
        let values = all.map(|[area, aspect, spacing, _, _]| [*area, *aspect, *spacing]);
        let directions = all.map(|[_, _, _, c, s]| [*c, *s]);
        let spacing_is_free = fit.spacing.is_none();
        let (own, spread) = (Vec::new(), Spread::ZERO);
        let mut map = Self { values, directions, spacing_is_free, own, far: None, mean, spread };
        let centers: Vec<[f64; 2]> = ellipses.iter().map(|ellipse| ellipse.center).collect();
        let distances = fit.spacing.as_ref().map(|spacing| &spacing.regression);
        map.keep_far(far_from(&centers, canvas.bounds(), distances, far_before));
        let own = |ellipse: &Ellipse| Spots {
            area: ellipse.area(),
            aspect: ellipse.aspect(),
            angle: ellipse.major_angle(),
            spacing: map.at(ellipse.center).spacing,
        };
        map.own = ellipses.iter().map(own).collect();
        if ellipses.len() >= MARKS_OF_A_SPREAD {
            map.spread = fit.spread(ellipses, &map);
        }
        Some(map)
    }

    /// Takes one spacing `far` from all marks, if what is wanted there is that of one pattern.
    fn keep_far(&mut self, far: Far) {
        if self.spacing_is_free {
            self.far = Some(far);
            return;
        }
        let places = self.far_places(&far);
        if places.is_empty() || !places.iter().all(|at| far.is_wanted(&self.at(*at), &self.mean)) {
            return;
        }
        let there = libm::log(far.spacing());
        let nearness = Nodes::sampled(self.values.layout, |point| [far.nearness(point)]);
        let blend = |[_, _, spacing]: &mut [f64; 3], [near]: &[f64; 1]| {
            *spacing = near * *spacing + (1.0 - near) * there;
        };
        self.values.change_with(&nearness, blend);
        self.far = Some(far);
    }

    /// The nodes far from all marks, px; none where there is room for a few spots only.
    fn far_places(&self, far: &Far) -> Vec<[f64; 2]> {
        // Of a single mark there is one node.
        let layout = layout_with(&self.values.layout, NODES);
        let centers = (0..layout.len()).map(|index| layout.center(layout.place(index)));
        let places: Vec<[f64; 2]> = centers.filter(|point| far.nearness(*point) == 0.0).collect();
        let room = layout.size[0] * layout.size[1] * places.len() as f64 / layout.len() as f64;
        if room < LEAST_ROOM * far.spacing() * far.spacing() { Vec::new() } else { places }
    }

    /// A grid of nodes that resolves the map: two a distance between neighbours.
    pub fn nodes(&self) -> RegionGrid {
        let canvas = self.values.layout;
        let longer = canvas.size[0].max(canvas.size[1]);
        let finest = canvas.grid[0].max(canvas.grid[1]);
        let wanted = self.mean.spacing.map_or(1.0, |spacing| NODES_A_SPACING * longer / spacing);
        // The cast takes what is too large to the bound.
        layout_with(&canvas, (wanted.ceil() as usize).clamp(1, finest))
    }

    pub fn at(&self, point: [f64; 2]) -> Spots {
        let [area, aspect, spacing] = self.values.at(point);
        let [c, s] = self.directions.at(point);
        Spots {
            area: libm::exp(area),
            // Rounding of the weights can exceed 1.
            aspect: aspect.min(1.0),
            angle: axial(0.5 * libm::atan2(s, c).to_degrees()),
            spacing: (!self.spacing_is_free).then(|| libm::exp(spacing)),
        }
    }

    /// The mean double-angle vector at a point.
    pub fn direction_at(&self, point: [f64; 2]) -> [f64; 2] {
        self.directions.at(point)
    }

    pub fn own(&self, mark: usize) -> Spots {
        self.own[mark]
    }

    pub fn resized(&self, size: [f64; 2]) -> Self {
        let far = self.far.as_ref().map(|far| far.resized(size));
        Self {
            values: self.values.resized(size),
            directions: self.directions.resized(size),
            far,
            ..self.clone()
        }
    }

    /// Takes the spacing that `spacing` returns for the spots, where it is free.
    pub fn fill_free_spacing(&mut self, mut spacing: impl FnMut(&Spots) -> f64) {
        if !self.spacing_is_free {
            return;
        }
        // A single mark: all nodes are alike.
        let found = spacing(&self.mean);
        self.set_spacing(found);
    }

    /// Widens the spacing where area ÷ spacing² is more than this. Returns whether it was anywhere.
    pub fn limit_density(&mut self, most: f64) -> bool {
        if self.spacing_is_free {
            return false;
        }
        let before = self.values.clone();
        let widest = -0.5 * libm::log(most);
        self.values.change(|[area, _, spacing]| *spacing = spacing.max(0.5 * *area + widest));
        let spacing = |of: &Spots| of.spacing.map(|spacing| spacing.max((of.area / most).sqrt()));
        self.mean.spacing = spacing(&self.mean);
        self.own.iter_mut().for_each(|own| own.spacing = spacing(own));
        let far = self.far.take();
        self.far =
            far.filter(|far| self.far_places(far).iter().all(|at| self.values.at(*at) == before.at(*at)));
        self.values != before
    }

    /// Takes this spacing everywhere, px.
    pub fn set_spacing(&mut self, found: f64) {
        self.spacing_is_free = false;
        self.mean.spacing = Some(found);
        self.values.change(|[_, _, spacing]| *spacing = libm::log(found));
        self.own.iter_mut().for_each(|own| own.spacing = Some(found));
        let far = self.far.as_ref().map(|far| far.with_spacing(found));
        self.far = far.filter(|far| !self.far_places(far).is_empty());
    }
}

/// The spacing that is wanted far from ellipses at `centers`, px, if that is one for all such places; `None` of fewer than two.
pub fn far_spacing(centers: &[[f64; 2]], bounds: Bounds, before: Option<f64>) -> Option<f64> {
    let lengths = edges_between(centers, bounds);
    if lengths.is_empty() {
        return None;
    }
    let regression = Regression::new(bounds, centers, lengths, SPACING);
    Some(far_from(centers, bounds, Some(&regression), before).spacing())
}

/// The places far from ellipses at `centers`, with the spacing that the regression of their distances, if there are any, says;
/// `before`: the one that was wanted before.
fn far_from(
    centers: &[[f64; 2]],
    bounds: Bounds,
    distances: Option<&Regression<1>>,
    before: Option<f64>,
) -> Far {
    let edges = distances.into_iter().flat_map(Regression::observations);
    let distances = edges.map(|(edge, robust)| (edge.value[0], edge.weight * robust));
    Far::new(bounds, centers, distances, before)
}

/// The regressions of all attributes.
struct Fit {
    area: Scalar,
    aspect: Scalar,
    direction: Regression<2>,
    spacing: Option<Scalar>,
}

impl Fit {
    fn new(ellipses: &[Ellipse], bounds: Bounds) -> Self {
        let centers: Vec<[f64; 2]> = ellipses.iter().map(|ellipse| ellipse.center).collect();
        let observed = |value: &dyn Fn(&Ellipse) -> f64| {
            let one = |(mark, ellipse): (usize, &Ellipse)| Observation {
                place: ellipse.center,
                value: [value(ellipse)],
                weight: 1.0,
                marks: [mark; 2],
            };
            ellipses.iter().enumerate().map(one).collect()
        };
        let logs = observed(&|ellipse| libm::log(ellipse.area()));
        let aspects = observed(&Ellipse::aspect);
        let direction = |(mark, ellipse): (usize, &Ellipse)| {
            let (s, c) = libm::sincos(2.0 * ellipse.major_angle().to_radians());
            let weight = 1.0 - ellipse.aspect();
            Observation { place: ellipse.center, value: [c, s], weight, marks: [mark; 2] }
        };
        let directions = ellipses.iter().enumerate().map(direction).collect();
        let lengths = edges_between(&centers, bounds);
        Self {
            area: Scalar::of_logs(bounds, &centers, logs, SIZE),
            aspect: Scalar::new(Regression::new(bounds, &centers, aspects, ASPECT)),
            direction: Regression::new(bounds, &centers, directions, DIRECTION),
            spacing: (!lengths.is_empty()).then(|| Scalar::of_logs(bounds, &centers, lengths, SPACING)),
        }
    }

    /// Weighted mean length of the edges, px.
    fn mean_spacing(&self) -> Option<f64> {
        let (mut sum, mut total) = (0.0, 0.0);
        for (edge, _) in self.spacing.as_ref()?.regression.observations() {
            sum += edge.weight * libm::exp(edge.value[0]);
            total += edge.weight;
        }
        Some(sum / total)
    }

    /// Log area, aspect, log spacing (0 where it is free), and the mean double-angle vector, not longer than 1.
    fn at(&self, point: [f64; 2]) -> [f64; 5] {
        // All have the kernels of the same marks. Spacings were found at the edges between these, the rest at the marks.
        let kernels = self.direction.kernels(point);
        let covered = self.direction.covered(&kernels);
        let of_marks = |scalar: &Scalar| scalar.kept(scalar.regression.among(point, &kernels, &covered));
        let spacing = self.spacing.as_ref().map_or(0.0, |spacing| {
            spacing.kept(spacing.regression.among(point, &kernels, &spacing.regression.covered(&kernels)))
        });
        let [c, s] = self.direction.among(point, &kernels, &covered);
        let length = (c * c + s * s).sqrt().max(1.0);
        [of_marks(&self.area), of_marks(&self.aspect), spacing, c / length, s / length]
    }

    /// How the ellipses depart from the map, odd ones with less weight.
    fn spread(&self, ellipses: &[Ellipse], map: &EllipseMap) -> Spread {
        let there: Vec<Spots> = ellipses.iter().map(|ellipse| map.at(ellipse.center)).collect();
        let root_mean_square = |departures: &mut dyn Iterator<Item = (f64, f64)>| {
            let (sum, total) = departures
                .fold((0.0, 0.0), |(sum, total), (by, weight)| (sum + weight * by * by, total + weight));
            if total > 0.0 { (sum / total).sqrt() } else { 0.0 }
        };
        let marks = || ellipses.iter().zip(&there);
        let areas = marks().map(|(ellipse, there)| ellipse.area() / there.area - 1.0);
        let aspects = marks().map(|(ellipse, there)| ellipse.aspect() - there.aspect);
        let turns = marks().map(|(ellipse, there)| turn(ellipse.major_angle(), there.angle));
        let weights = |regression: &Regression<1>| {
            regression.observations().map(|(one, robust)| one.weight * robust).collect::<Vec<_>>()
        };
        let turned = self.direction.observations().map(|(one, robust)| one.weight * robust);
        let spacing = self.spacing.as_ref().map_or(0.0, |spacing| {
            root_mean_square(&mut spacing.regression.observations().map(|(edge, robust)| {
                let wanted = spacing.at(edge.place);
                (libm::exp(edge.value[0] - wanted) - 1.0, edge.weight * robust)
            }))
        });
        Spread {
            area: root_mean_square(&mut areas.zip(weights(&self.area.regression))),
            angle: root_mean_square(&mut turns.zip(turned)),
            aspect: root_mean_square(&mut aspects.zip(weights(&self.aspect.regression))),
            spacing,
        }
    }
}

/// A regression of one number, kept within the range of the values.
struct Scalar {
    regression: Regression<1>,
    /// Smallest and largest value.
    range: [f64; 2],
    /// What is added to the estimate.
    shift: f64,
}

impl Scalar {
    fn new(regression: Regression<1>) -> Self {
        let values = || regression.observations().map(|(one, _)| one.value[0]);
        let range = [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
        Self { regression, range, shift: 0.0 }
    }

    /// The regression of logarithms, shifted so that at the marks the mean of the map itself is that of the marks
    /// (Duan, "Smearing estimate", Journal of the American Statistical Association 1983).
    fn of_logs(
        bounds: Bounds,
        centers: &[[f64; 2]],
        observations: Vec<Observation<1>>,
        manner: Manner,
    ) -> Self {
        let mut scalar = Self::new(Regression::new(bounds, centers, observations, manner));
        let (mut drawn, mut fitted) = (0.0, 0.0);
        for (one, robust) in scalar.regression.observations() {
            drawn += one.weight * robust * libm::exp(one.value[0]);
            fitted += one.weight * robust * libm::exp(scalar.at(one.place));
        }
        scalar.shift = libm::log(drawn / fitted);
        scalar
    }

    fn at(&self, point: [f64; 2]) -> f64 {
        self.kept(self.regression.at(point))
    }

    /// An estimate, shifted and kept within the range.
    fn kept(&self, [estimate]: [f64; 1]) -> f64 {
        (estimate + self.shift).clamp(self.range[0], self.range[1])
    }
}

/// Log lengths of the weighted Delaunay edges, at their midpoints.
fn edges_between(centers: &[[f64; 2]], bounds: Bounds) -> Vec<Observation<1>> {
    if centers.len() < 2 {
        return Vec::new();
    }
    let wrap = (bounds.edges == Edges::Wrap).then_some(bounds.size);
    let edges = spacing::edges(centers, wrap);
    let nearest = spacing::nearest(&edges, centers.len());
    let places = PointBuckets::new(bounds, centers.to_vec());
    let near = |point: [f64; 2]| {
        let kernels = Kernels::new(&places, point, |_| true, &[MARKS_ABOUT_AN_EDGE]);
        let (mut sum, mut total) = (0.0, 0.0);
        for mark in kernels.covered(&places) {
            let Some(nearest) = nearest[mark as usize] else { continue };
            kernels.each(centers[mark as usize], |_, _, weight| {
                sum += weight * nearest;
                total += weight;
            });
        }
        sum / total
    };
    let observed = |edge: spacing::WeightedEdge| Observation {
        place: edge.midpoint,
        value: [libm::log(edge.length)],
        weight: edge.weight,
        marks: edge.ends,
    };
    edges.iter().filter_map(|edge| edge.weighted(near(edge.midpoint))).map(observed).collect()
}
