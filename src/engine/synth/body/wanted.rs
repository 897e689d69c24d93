//! What is wanted at each vertex of a surface: anchors, weighted by their geodesic distance.

use rayon::prelude::*;

use crate::attributes::{Attributes, Spots, Stripes};
use crate::surface::{Surface, distances};
use crate::synth::body::anchors::Anchor;

/// Weights of the anchors at each vertex.
#[derive(Clone, Debug)]
pub struct Influence {
    anchors: usize,
    /// Vertex by vertex, one an anchor; their sum is 1. Empty with one anchor.
    weights: Vec<f32>,
}

impl Influence {
    /// The inverse squares of geodesic distances. A part of the surface that no anchor reaches takes the mean of all.
    #[must_use]
    pub fn new(surface: &Surface, anchors: &[Anchor]) -> Self {
        let count = anchors.len();
        if count < 2 {
            return Self { anchors: count, weights: Vec::new() };
        }
        let far: Vec<Vec<f64>> =
            anchors.par_iter().map(|anchor| distances(surface, &[anchor.place])).collect();
        let least = surface.unit();
        let mut weights = vec![0.0; count * surface.mesh.positions.len()];
        weights.par_chunks_mut(count).enumerate().for_each(|(vertex, weights)| {
            let weight = |of: &Vec<f64>| {
                let distance = of[vertex].max(least);
                1.0 / (distance * distance)
            };
            let all: Vec<f64> = far.iter().map(weight).collect();
            let sum: f64 = all.iter().sum();
            let share = |weight: f64| if sum > 0.0 { weight / sum } else { 1.0 / count as f64 };
            weights.iter_mut().zip(all).for_each(|(slot, weight)| *slot = share(weight) as f32);
        });
        Self { anchors: count, weights }
    }

    /// The weights at a vertex.
    #[must_use]
    pub fn at(&self, vertex: usize) -> &[f32] {
        if self.weights.is_empty() { &[1.0] } else { &self.weights[vertex * self.anchors..][..self.anchors] }
    }

    /// The anchor with the largest weight at a vertex; the first of equal ones.
    #[must_use]
    pub fn nearest(&self, vertex: usize) -> usize {
        let weights = self.at(vertex).iter().enumerate();
        weights
            .fold((0, 0.0), |best, (index, weight)| if *weight > best.1 { (index, *weight) } else { best })
            .0
    }

    /// The weighted mean of numbers that are given one an anchor.
    #[must_use]
    pub fn mean(&self, vertex: usize, of_anchors: &[f64]) -> f64 {
        self.at(vertex).iter().zip(of_anchors).map(|(weight, value)| f64::from(*weight) * value).sum()
    }
}

/// What is wanted at each vertex; angles count from +x of the sketch. Lengths by the mean of their logarithms, directions by that of
/// double angles, of spots weighted by 1 − aspect.
#[must_use]
pub fn wanted(anchors: &[Anchor], influence: &Influence, vertices: usize) -> Vec<Attributes> {
    let of = |value: &dyn Fn(&Attributes) -> f64| {
        anchors.iter().map(|anchor| value(&anchor.wanted)).collect::<Vec<f64>>()
    };
    let sizes = of(&|wanted| {
        libm::log(match wanted {
            Attributes::Spots(spots) => spots.area,
            Attributes::Stripes(stripes) => stripes.width,
        })
    });
    let distances = of(&|wanted| wanted.distance().map_or(0.0, libm::log));
    let aspects = of(&aspect);
    let turned = |part: fn(f64) -> f64| {
        let weight = |wanted: &Attributes| {
            if matches!(wanted, Attributes::Spots(_)) { 1.0 - aspect(wanted) } else { 1.0 }
        };
        of(&|wanted| weight(wanted) * part(2.0 * wanted.angle().to_radians()))
    };
    let (cosines, sines) = (turned(libm::cos), turned(libm::sin));
    let is_spots = anchors.first().is_none_or(|anchor| matches!(anchor.wanted, Attributes::Spots(_)));
    let has_distance = anchors.iter().all(|anchor| anchor.wanted.distance().is_some());
    let at = |vertex: usize| {
        let mean = |of: &[f64]| influence.mean(vertex, of);
        let (x, y) = (mean(&cosines), mean(&sines));
        let angle = if x == 0.0 && y == 0.0 { 0.0 } else { 0.5 * libm::atan2(y, x).to_degrees() };
        let (size, angle) = (libm::exp(mean(&sizes)), crate::marks::axial(angle));
        let distance = has_distance.then(|| libm::exp(mean(&distances)));
        if is_spots {
            // Weights are rounded: their sum can be above 1.
            let aspect = mean(&aspects).min(1.0);
            Attributes::Spots(Spots { area: size, aspect, angle, spacing: distance })
        } else {
            Attributes::Stripes(Stripes { width: size, angle, wavelength: distance })
        }
    };
    (0..vertices).into_par_iter().map(at).collect()
}

/// The aspect of spots; that of stripes counts as 0.
#[must_use]
pub fn aspect(wanted: &Attributes) -> f64 {
    match wanted {
        Attributes::Spots(spots) => spots.aspect,
        Attributes::Stripes(_) => 0.0,
    }
}

/// What is wanted, with another angle.
#[must_use]
pub fn turned(wanted: Attributes, angle: f64) -> Attributes {
    let angle = crate::marks::axial(angle);
    match wanted {
        Attributes::Spots(spots) => Attributes::Spots(Spots { angle, ..spots }),
        Attributes::Stripes(stripes) => Attributes::Stripes(Stripes { angle, ..stripes }),
    }
}
