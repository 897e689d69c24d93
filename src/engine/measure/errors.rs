//! Compares grown marks with the wanted ones, region by region: the *error* of `docs/format.md`.

use std::sync::LazyLock;

use super::directions::Directions;
use super::regions::Regions;
use super::spots::Spot;
use super::stripes::{Tally, tallies, wavelength};
use crate::attributes::metric_field::MetricField;
use crate::attributes::moments::{deviation, variation, weighted_mean, weighted_variation};
use crate::attributes::spacing::{Edge, edges, median, nearest};
use crate::attributes::spread::scatter;
use crate::attributes::{Attributes, Spots, Spread, Stripes, axial_mean};
use crate::grid::{Bounds, Domain, Edges, Field, sin_cos_degrees};
use crate::marks::{Ellipse, axial, turn};

/// The target of a layer: regions, and the attributes wanted at each place. Places are px.
pub struct Target<'a> {
    /// The canvas with its edges.
    pub bounds: Bounds,
    /// Its regions.
    pub regions: Regions<'a>,
    /// Whether the marks of another layer cover a place. Spots with such a mark between them do not count as neighbours.
    pub covered: &'a (dyn Fn([f64; 2]) -> bool + Sync),
    /// The region map: the attributes wanted at a place of the canvas.
    pub wanted: &'a (dyn Fn([f64; 2]) -> Attributes + Sync),
    /// The surface of which the canvas is the flat map: spots are compared on it. `None` = compared on the canvas.
    pub surface: Option<&'a MetricField>,
}

/// Differences between the spots of a region and the wanted ones.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SpotErrors {
    /// Whole marks whose centre is in the region.
    pub marks: usize,
    /// Means over them; `None` without any. The spacing is that of the edges with a weight.
    pub got: Option<Spots>,
    /// Means of the region map at their centres (spacing: at the edges' midpoints).
    pub wanted: Option<Spots>,
    /// got ÷ wanted − 1.
    pub area: Option<f64>,
    /// got − wanted.
    pub aspect: Option<f64>,
    /// Mean angle between the spots and the wanted direction, degrees in −90..90, weighted by 1 − aspect; only if the wanted aspect
    /// is below 0.85.
    pub angle: Option<f64>,
    /// got ÷ wanted − 1; `None` if the spacing is free or no edge has a weight.
    pub spacing: Option<f64>,
    /// Spread of the marks around the region map: of area ÷ wanted, of aspect − wanted, of the angle to the wanted direction, of
    /// edge ÷ wanted spacing.
    pub spread: Option<Spread>,
}

/// Differences between the stripes of a region and the wanted ones.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StripeErrors {
    /// Width, coherence-weighted direction and distance; `None` without stripes.
    pub got: Option<Stripes>,
    /// Means of the region map over the region.
    pub wanted: Option<Stripes>,
    /// got ÷ wanted − 1.
    pub width: Option<f64>,
    /// got ÷ wanted − 1; `None` if the wanted wavelength is twice the width.
    pub wavelength: Option<f64>,
    /// Coherence-weighted mean deviation of the local directions from the map, degrees in −90..90.
    pub angle: Option<f64>,
    /// Its root mean square, degrees.
    pub angle_rms: Option<f64>,
}

/// Rounder spots than this have no direction that could have an error.
const DIRECTED: f64 = 0.85;

fn mean(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let (count, sum) = values.into_iter().fold((0.0, 0.0), |(count, sum), value| (count + 1.0, sum + value));
    (count > 0.0).then(|| sum / count)
}

/// Errors of a layer's spots, by region.
///
/// `spots` are all spots of the layer, also those cut by the border: only whole ones are measured, but all are neighbours. Where
/// the map holds no spots nothing is compared.
#[must_use]
pub fn spot_errors(spots: &[Spot], target: &Target) -> Vec<SpotErrors> {
    let mut marks: Vec<Vec<(Ellipse, Spots)>> = vec![Vec::new(); target.regions.count()];
    for spot in spots.iter().filter(|spot| spot.whole) {
        let center = spot.ellipse.center;
        if let Attributes::Spots(wanted) = (target.wanted)(center) {
            let pair = on_surface(spot.ellipse, wanted, target.surface);
            marks[target.regions.of(center)].push(pair);
        }
    }
    let neighbours = neighbours(spots, target);
    marks.iter().zip(neighbours).map(|(marks, edges)| compare(marks, &edges)).collect()
}

/// A spot and the attributes wanted at its centre, both on the surface if there is one.
fn on_surface(spot: Ellipse, wanted: Spots, surface: Option<&MetricField>) -> (Ellipse, Spots) {
    let Some(metric) = surface.map(|surface| surface.at(spot.center)) else { return (spot, wanted) };
    let got = Spots { area: spot.area(), aspect: spot.aspect(), angle: spot.major_angle(), spacing: None };
    let [got, wanted] = [got, wanted].map(|spots| metric.spots_to_surface(&spots));
    (Ellipse::from_area(spot.center, got.area, got.aspect, got.angle), wanted)
}

/// An edge with a weight in the spacing of a region.
#[derive(Clone, Copy)]
struct Neighbours {
    length: f64,
    weight: f64,
    /// Spacing wanted at its midpoint; `None` = free.
    wanted: Option<f64>,
}

/// By region, the edges that have a weight. The length scale s of the weights is the spacing wanted at the midpoint; if that is
/// free, the median distance of the layer's spots to their nearest neighbours.
fn neighbours(spots: &[Spot], target: &Target) -> Vec<Vec<Neighbours>> {
    let centers: Vec<[f64; 2]> = spots.iter().map(|spot| mirrored_center(spot, &target.bounds)).collect();
    let tile = (target.bounds.edges == Edges::Wrap).then_some(target.bounds.size);
    let edges = edges(&centers, tile);
    let usual = median(nearest(&edges, centers.len())).unwrap_or(f64::INFINITY);
    let mut found = vec![Vec::new(); target.regions.count()];
    for edge in &edges {
        let Attributes::Spots(Spots { spacing: wanted, .. }) = (target.wanted)(edge.midpoint) else {
            continue;
        };
        let weight = edge.weight(wanted.unwrap_or(usual));
        if weight > 0.0 && !is_separated(edge, centers[edge.ends[0]], target) {
            let [from, to] = edge.ends.map(|end| centers[end]);
            let way = target.bounds.shortest([0, 1].map(|axis| to[axis] - from[axis]));
            let (length, wanted) = match target.surface.map(|surface| surface.at(edge.midpoint)) {
                Some(metric) => (metric.length(way), wanted.map(|wanted| wanted * metric.area().sqrt())),
                None => (edge.length, wanted),
            };
            found[target.regions.of(edge.midpoint)].push(Neighbours { length, weight, wanted });
        }
    }
    found
}

/// The centre of a spot together with its mirror image beyond a closed edge that cuts it; it lies on that edge. There is no flux
/// through the edge, so that the pattern continues beyond it as in a mirror.
fn mirrored_center(spot: &Spot, bounds: &Bounds) -> [f64; 2] {
    let center = spot.ellipse.center;
    if spot.whole || bounds.edges == Edges::Wrap {
        return center;
    }
    let reach = spot.ellipse.half_extents();
    [0, 1].map(|axis| {
        let side = bounds.size[axis];
        let touches = |distance: f64| distance < TOUCHING * reach[axis];
        match (touches(center[axis]), touches(side - center[axis])) {
            (true, false) => 0.0,
            (false, true) => side,
            _ => center[axis],
        }
    })
}

/// An edge cuts a spot if the centre of its visible part is within this number of its half extents: for half of an ellipse it is
/// within 0.8, for a whole one at 1.
const TOUCHING: f64 = 1.0;

/// Rings of points in the circle between the ends of an edge that are tested for a mark of another layer.
const RINGS: usize = 4;

/// Whether another layer's mark lies between the ends of an edge, one of which is `from`: in the circle that has the edge
/// as its diameter.
fn is_separated(edge: &Edge, from: [f64; 2], target: &Target) -> bool {
    let bounds = &target.bounds;
    let half = bounds.shortest([0, 1].map(|axis| edge.midpoint[axis] - from[axis]));
    is_circle_covered(edge.midpoint, half, |point| (target.covered)(bounds.inside(point)))
}

/// Points on rings within the unit circle, its centre first.
static IN_A_CIRCLE: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| {
    let ring = |ring: usize| {
        let points = (6 * ring).max(1);
        let radius = ring as f64 / RINGS as f64;
        (0..points).map(move |k| {
            let turn = std::f64::consts::TAU * k as f64 / points as f64;
            [radius * libm::cos(turn), radius * libm::sin(turn)]
        })
    };
    (0..=RINGS).flat_map(ring).collect()
});

/// Whether any of the points in the circle about `middle`, with radius `half`, is `covered`. Spots at the ends of that diameter are
/// no neighbours if marks of another layer lie between them.
pub fn is_circle_covered(middle: [f64; 2], half: [f64; 2], covered: impl Fn([f64; 2]) -> bool) -> bool {
    IN_A_CIRCLE.iter().any(|[x, y]| {
        let away = [x * half[0] - y * half[1], x * half[1] + y * half[0]];
        covered([0, 1].map(|axis| middle[axis] + away[axis]))
    })
}

fn compare(marks: &[(Ellipse, Spots)], edges: &[Neighbours]) -> SpotErrors {
    let got = |value: fn(&Ellipse) -> f64| mean(marks.iter().map(|(spot, _)| value(spot)));
    let asked = |value: fn(&Spots) -> f64| mean(marks.iter().map(|(_, wanted)| value(wanted)));
    let directed = |angle: &dyn Fn(&Ellipse, &Spots) -> f64| {
        let weighted = marks.iter().map(|(spot, wanted)| (angle(spot, wanted), 1.0 - spot.aspect()));
        axial_mean(weighted).map(|(angle, _)| angle)
    };
    let (Some(area), Some(aspect), Some(wanted_area), Some(wanted_aspect)) = (
        got(Ellipse::area),
        got(Ellipse::aspect),
        asked(|wanted| wanted.area),
        asked(|wanted| wanted.aspect),
    ) else {
        return SpotErrors::default();
    };
    let wanted_angle = axial_mean(marks.iter().map(|(_, wanted)| (wanted.angle, 1.0 - wanted.aspect)));
    let off = directed(&|spot, wanted| turn(spot.major_angle(), wanted.angle));
    let wanted: Option<Vec<(f64, f64)>> =
        edges.iter().map(|edge| edge.wanted.map(|wanted| (wanted, edge.weight))).collect();
    let wanted_spacing = wanted.and_then(weighted_mean);
    let spacing = weighted_mean(edges.iter().map(|edge| (edge.length, edge.weight)));
    SpotErrors {
        marks: marks.len(),
        got: Some(Spots {
            area,
            aspect,
            angle: directed(&|spot, _| spot.major_angle()).unwrap_or(0.0),
            spacing,
        }),
        wanted: Some(Spots {
            area: wanted_area,
            aspect: wanted_aspect,
            angle: wanted_angle.map_or(marks[0].1.angle, |(angle, _)| angle),
            spacing: wanted_spacing,
        }),
        area: Some(area / wanted_area - 1.0),
        aspect: Some(aspect - wanted_aspect),
        angle: off.filter(|_| wanted_aspect < DIRECTED).map(|off| turn(off, 0.0)),
        spacing: spacing.zip(wanted_spacing).map(|(got, wanted)| got / wanted - 1.0),
        spread: Some(vary(marks, edges)),
    }
}

/// The spread of marks about the region map instead of the means, see [`Spread::measure`].
fn vary(marks: &[(Ellipse, Spots)], edges: &[Neighbours]) -> Spread {
    let turned =
        |(spot, wanted): &(Ellipse, Spots)| (turn(spot.major_angle(), wanted.angle), 1.0 - spot.aspect());
    let free = edges.iter().any(|edge| edge.wanted.is_none());
    let relative =
        |edge: &Neighbours| (edge.length / edge.wanted.filter(|_| !free).unwrap_or(1.0), edge.weight);
    Spread {
        area: variation(marks.iter().map(|(spot, wanted)| spot.area() / wanted.area)),
        angle: scatter(marks.iter().map(turned)),
        aspect: deviation(marks.iter().map(|(spot, wanted)| spot.aspect() - wanted.aspect)),
        spacing: weighted_variation(edges.iter().map(relative)),
    }
}

/// Sums of the attributes wanted in a region.
#[derive(Clone, Copy, Default)]
struct Asked {
    count: f64,
    width: f64,
    /// NaN if none is wanted.
    wavelength: f64,
    double: [f64; 2],
}

impl Asked {
    /// Adds the stripes that are wanted in a `share` of a place.
    fn add(&mut self, wanted: &Attributes, share: f64) {
        let Attributes::Stripes(Stripes { width, angle, wavelength }) = wanted else { return };
        let (s, c) = sin_cos_degrees(2.0 * angle);
        self.count += share;
        self.width += share * width;
        self.wavelength += share * wavelength.unwrap_or(f64::NAN);
        self.double = [self.double[0] + share * c, self.double[1] + share * s];
    }

    fn mean(&self) -> Option<Stripes> {
        let [c, s] = self.double;
        (self.count > 0.0).then(|| Stripes {
            width: self.width / self.count,
            angle: axial(0.5 * libm::atan2(s, c).to_degrees()),
            wavelength: Some(self.wavelength / self.count).filter(|wavelength| wavelength.is_finite()),
        })
    }
}

/// px² of each region that no other layer's marks cover.
fn free(field: &Field, target: &Target) -> Vec<f64> {
    let mut free = vec![0.0; target.regions.count()];
    let grid = field.grid();
    for cell in 0..grid.cells() {
        let place = grid.center_px(cell);
        if !(target.covered)(place) {
            free[target.regions.of(place)] += field.cell[0] * field.cell[1];
        }
    }
    free
}

/// Errors of a layer of stripes, by region. The stripes are the areas above `level` in `field`, which covers the canvas.
#[must_use]
pub fn stripe_errors(field: &Field, level: f32, target: &Target) -> Vec<StripeErrors> {
    stripe_errors_of(field, &tallies(field, level, target.regions), target)
}

/// Errors of a layer of stripes, by region, from the known `tallies` of the regions.
#[must_use]
pub fn stripe_errors_of(field: &Field, tallies: &[Tally], target: &Target) -> Vec<StripeErrors> {
    let contour: f64 = tallies.iter().map(|tally| tally.contour).sum();
    if contour <= 0.0 {
        return vec![StripeErrors::default(); target.regions.count()];
    }
    let directions = Directions::measure(field, wavelength(field, contour));
    let asked = directions.at_places(|place| {
        let wanted = (target.wanted)(place);
        let (sin, cos) = sin_cos_degrees(2.0 * wanted.angle());
        (target.regions.of(place), [cos, sin], wanted)
    });
    let places: Vec<(usize, [f64; 2])> = asked.iter().map(|(region, double, _)| (*region, *double)).collect();
    let turns = directions.deviations(&places, target.regions.count());
    let angles = directions.means(&places, target.regions.count());
    let mut sums = vec![Asked::default(); target.regions.count()];
    for (quarters, (region, _, wanted)) in directions.quarters().zip(&asked) {
        // A place on the border between regions counts for each of them with the quarters inside.
        if quarters.iter().all(|point| target.regions.of(*point) == *region) {
            sums[*region].add(wanted, 1.0);
        } else {
            let quarter = |point| sums[target.regions.of(point)].add(&(target.wanted)(point), 0.25);
            quarters.into_iter().for_each(quarter);
        }
    }
    let wanted: Vec<Option<Stripes>> = sums.iter().map(Asked::mean).collect();
    let any_wavelength = wanted.iter().flatten().any(|wanted| wanted.wavelength.is_some());
    let free = if any_wavelength { free(field, target) } else { Vec::new() };
    let region = |k: usize| {
        let angle = angles[k];
        let width = tallies[k].width();
        let wanted = wanted[k];
        // Only if a wavelength is wanted; otherwise it is twice the width.
        let asked = wanted.and_then(|wanted| wanted.wavelength);
        let wavelength =
            asked.filter(|_| tallies[k].contour > 0.0).map(|_| 2.0 * free[k] / tallies[k].contour);
        StripeErrors {
            got: width.zip(angle).map(|(width, angle)| Stripes { width, angle, wavelength }),
            wanted,
            wavelength: wavelength.zip(asked).map(|(got, asked)| got / asked - 1.0),
            width: width.zip(wanted).map(|(width, wanted)| width / wanted.width - 1.0),
            angle: turns[k].map(|deviation| deviation.mean),
            angle_rms: turns[k].map(|deviation| deviation.rms),
        }
    };
    (0..target.regions.count()).map(region).collect()
}
