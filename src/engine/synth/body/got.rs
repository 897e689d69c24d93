//! What has grown around each anchor, beside what was wanted there.

use std::collections::BTreeMap;

use crate::attributes::{Attribute, Attributes, Spots, Stripes};
use crate::grid::Domain;
use crate::marks::{axial, turn};
use crate::measure::{SurfaceStripes, surface_directions, surface_edges};
use crate::surface::SurfacePoint;
use crate::synth::body::anchors::Anchor;
use crate::synth::body::direction_report::DirectionReport;
use crate::synth::body::layer::BodyLayer;
use crate::synth::body::threshold::Sums;

/// Below this aspect spots have a direction that is measured.
const DIRECTED: f64 = 0.85;
/// The coherence of directions above which a place is away from singularities. Not tuned.
const COHERENT: f64 = 0.98;
/// Directions of stripes are averaged over this share of a wavelength, as on canvases.
const AVERAGED: f64 = 0.5;

/// What has grown around an anchor.
#[derive(Default)]
pub struct Got {
    /// Whole spots; 1 of stripes, 0 where there are none.
    pub count: usize,
    /// Means, for what was asked at the anchor; `None` where nothing is measured.
    pub attributes: Option<Attributes>,
    /// By how much they differ from what was wanted.
    pub error: BTreeMap<Attribute, f64>,
    /// How far directions are off.
    pub direction: Option<DirectionReport>,
}

/// What has grown around each anchor of a layer.
#[must_use]
pub fn of_anchors(layer: &BodyLayer) -> Vec<Got> {
    if layer.plan.choice.system.is_striped() { stripes(layer) } else { spots(layer) }
}

/// Sums over the whole spots that are nearest to an anchor.
#[derive(Clone, Default)]
struct SpotSums {
    count: usize,
    area: f64,
    wanted_area: f64,
    aspect: f64,
    wanted_aspect: f64,
    /// Σ (1 − aspect)·(cos 2Δ, sin 2Δ) of the deviations of directed spots.
    turned: [f64; 2],
    /// Of directed spots away from singularities: degrees without a sign, and their weight.
    deviations: Vec<[f64; 2]>,
}

fn spots(layer: &BodyLayer) -> Vec<Got> {
    let (plan, measured) = (&layer.plan, &layer.levelled.measured);
    let mut sums = vec![SpotSums::default(); plan.anchors.len()];
    for (spot, anchor) in measured.spots.iter().zip(&measured.anchor).filter(|(spot, _)| spot.whole) {
        let vertex = plan.surface().vertex_of(spot.place);
        let Attributes::Spots(wanted) = &plan.wanted[vertex] else { continue };
        let (aspect, sums) = (spot.aspect(), &mut sums[*anchor]);
        sums.count += 1;
        sums.area += spot.area;
        sums.wanted_area += wanted.area;
        sums.aspect += aspect;
        sums.wanted_aspect += wanted.aspect;
        if wanted.aspect < DIRECTED {
            let coherence = plan.directions.as_ref().map_or(1.0, |field| field.coherence[vertex]);
            if coherence > COHERENT {
                sums.deviations.push([turn(spot.degrees, wanted.angle).abs(), 1.0]);
            }
            let (sin, cos) = libm::sincos(2.0 * (spot.degrees - wanted.angle).to_radians());
            sums.turned[0] += (1.0 - aspect) * cos;
            sums.turned[1] += (1.0 - aspect) * sin;
        }
    }
    let all = sums.into_iter().zip(spacings(layer)).zip(&plan.anchors);
    all.map(|((sums, spacing), anchor)| sums.got(spacing, &anchor.wanted)).collect()
}

/// For each anchor the weighted mean length of the edges between neighbours whose middles are nearest to it, and of the spacings
/// wanted there, px.
fn spacings(layer: &BodyLayer) -> Vec<Option<[f64; 2]>> {
    let plan = &layer.plan;
    let places: Vec<SurfacePoint> = layer.levelled.measured.spots.iter().map(|spot| spot.place).collect();
    let mut sums = vec![[0.0; 3]; plan.anchors.len()];
    for edge in surface_edges(plan.surface(), &places) {
        let vertex = plan.surface().vertex_of(edge.midpoint);
        let wanted = plan.wanted[vertex].distance().unwrap_or(edge.length);
        let weight = edge.weight(wanted);
        let sum = &mut sums[plan.influence.nearest(vertex)];
        for (sum, value) in sum.iter_mut().zip([weight, weight * edge.length, weight * wanted]) {
            *sum += value;
        }
    }
    let mean = |[weight, got, wanted]: [f64; 3]| (weight > 0.0).then(|| [got / weight, wanted / weight]);
    sums.into_iter().map(mean).collect()
}

/// The mean deviation of directions, degrees, from Σ w·(cos 2Δ, sin 2Δ); none where there are no directions.
fn mean_turn([x, y]: [f64; 2]) -> Option<f64> {
    (x != 0.0 || y != 0.0).then(|| 0.5 * libm::atan2(y, x).to_degrees())
}

impl SpotSums {
    fn got(self, spacing: Option<[f64; 2]>, asked: &Attributes) -> Got {
        let (Attributes::Spots(asked), true) = (asked, self.count > 0) else { return Got::default() };
        let count = self.count as f64;
        let angle = mean_turn(self.turned);
        let attributes = Spots {
            area: asked.area * self.area / self.wanted_area,
            aspect: asked.aspect + (self.aspect - self.wanted_aspect) / count,
            angle: axial(asked.angle + angle.unwrap_or(0.0)),
            spacing: spacing.and_then(|[got, wanted]| Some(asked.spacing? * got / wanted)),
        };
        let errors = [
            Some((Attribute::Area, self.area / self.wanted_area - 1.0)),
            Some((Attribute::Aspect, (self.aspect - self.wanted_aspect) / count)),
            spacing.map(|[got, wanted]| (Attribute::Spacing, got / wanted - 1.0)),
            angle.map(|angle| (Attribute::Angle, angle)),
        ];
        Got {
            count: self.count,
            attributes: Some(Attributes::Spots(attributes)),
            error: errors.into_iter().flatten().collect(),
            direction: DirectionReport::new(self.deviations),
        }
    }
}

/// Sums over the vertices that are nearest to an anchor.
#[derive(Clone, Default)]
struct StripeSums {
    /// Σ area, and Σ area ÷ wavelength.
    wanted: [f64; 2],
    turned: [f64; 2],
    deviations: Vec<[f64; 2]>,
}

fn stripes(layer: &BodyLayer) -> Vec<Got> {
    let plan = &layer.plan;
    let surface = plan.surface();
    let wavelength = |wanted: &Stripes| wanted.wavelength.unwrap_or(2.0 * wanted.width);
    let widest = plan.anchors.iter().filter_map(|anchor| match &anchor.wanted {
        Attributes::Stripes(stripes) => Some(wavelength(stripes)),
        Attributes::Spots(_) => None,
    });
    let radius = AVERAGED * widest.fold(0.0, f64::max);
    let directions = surface_directions(surface, &layer.levelled.pattern, radius);
    let mut sums = vec![StripeSums::default(); plan.anchors.len()];
    for (vertex, (wanted, found)) in plan.wanted.iter().zip(directions).enumerate() {
        let Attributes::Stripes(wanted) = wanted else { continue };
        let sums = &mut sums[plan.influence.nearest(vertex)];
        let area = surface.area(vertex);
        sums.wanted[0] += area;
        sums.wanted[1] += area / wavelength(wanted);
        let off = turn(found.degrees, wanted.angle);
        let (sin, cos) = libm::sincos(2.0 * off.to_radians());
        sums.turned[0] += found.weight * cos;
        sums.turned[1] += found.weight * sin;
        let coherence = plan.directions.as_ref().map_or(1.0, |field| field.coherence[vertex]);
        if coherence > COHERENT {
            sums.deviations.push([off.abs(), found.weight]);
        }
    }
    let measured = layer.levelled.measured.stripes.iter().zip(&layer.levelled.measured.sums);
    let of_anchor = |((sums, (found, sizes)), anchor): ((StripeSums, (&SurfaceStripes, &Sums)), &Anchor)| {
        let (Attributes::Stripes(asked), Some(got), true) =
            (&anchor.wanted, found.wavelength(), sizes.count > 0)
        else {
            return Got::default();
        };
        let [width, length] = [sizes.got / sizes.wanted, got * sums.wanted[1] / sums.wanted[0]];
        let angle = mean_turn(sums.turned).unwrap_or(0.0);
        let attributes = Stripes {
            width: asked.width * width,
            angle: axial(asked.angle + angle),
            wavelength: Some(wavelength(asked) * length),
        };
        if plan.curves.is_some() {
            // Lines run as the marks beneath let them: no direction was asked, and no distance.
            let attributes = Some(Attributes::Stripes(Stripes { width: attributes.width, ..*asked }));
            let error = [(Attribute::Width, width - 1.0)].into();
            return Got { count: 1, attributes, error, direction: None };
        }
        let errors = [
            (Attribute::Width, width - 1.0),
            (Attribute::Wavelength, length - 1.0),
            (Attribute::Angle, angle),
        ];
        Got {
            count: 1,
            attributes: Some(Attributes::Stripes(attributes)),
            error: errors.into(),
            direction: DirectionReport::new(sums.deviations),
        }
    };
    sums.into_iter().zip(measured).zip(&plan.anchors).map(of_anchor).collect()
}
