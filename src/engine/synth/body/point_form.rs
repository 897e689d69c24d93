//! What is particular to fields of points on a surface: their distances, and the cells that they need.

use crate::attributes::{Attributes, Spots};
use crate::document::{Document, Points};
use crate::synth::points::plan::{drawn_distance, drawn_share};

/// Vertices a distance of the finest points, and of those of folded fields, whose creases have no width.
const VERTICES: [f64; 2] = [4.0, 8.0];
/// The smallest cells, px: finer details cannot be seen.
const SMALLEST: f64 = 1.0;
/// The largest cells, in longest sides of the model, which is seen with them.
const LARGEST: f64 = 1.0 / 160.0;

/// The form of a field of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForm {
    /// The distances of points at both ends of the progression, px; `None` = as the drawn ellipses.
    pub given: Option<[f64; 2]>,
    /// The share above the edge that is asked for in the options, or by drawn ellipses.
    pub share: Option<f64>,
    /// Vertices a distance of the points of the first octave.
    vertices: f64,
    /// The largest cell, px.
    largest: f64,
}

impl PointForm {
    /// The form of these `points` of a document on a model, whose drawn ellipses are `wanted`.
    #[must_use]
    pub fn new(document: &Document, points: &Points, wanted: &[Attributes]) -> Self {
        let longest = document.model.as_ref().map_or(0.0, |body| body.px);
        let given = match points.distance {
            None if wanted.is_empty() => Some([longest / Points::ACROSS; 2]),
            given => given,
        };
        let drawn = wanted.iter().map(drawn_share).sum::<f64>() / wanted.len() as f64;
        let share = points.share.or((!wanted.is_empty()).then_some(drawn)).filter(|_| points.has_level());
        let of_octaves = 2f64.powi(points.octaves as i32 - 1);
        let vertices = of_octaves * VERTICES[usize::from(points.fold)];
        Self { given, share, vertices, largest: LARGEST * longest }
    }

    /// What is wanted where nothing is drawn: points at the mean of the given distances.
    #[must_use]
    pub fn undrawn(&self) -> Option<Attributes> {
        let [first, last] = self.given?;
        let spacing = (first * last).sqrt();
        Some(Attributes::Spots(Spots {
            area: spacing * spacing,
            aspect: 1.0,
            angle: 0.0,
            spacing: Some(spacing),
        }))
    }

    /// What is wanted, with the distance of the points. Their form and direction follow nothing that is drawn.
    #[must_use]
    pub fn filled(&self, wanted: Spots) -> Spots {
        let drawn = || drawn_distance(&Attributes::Spots(wanted));
        let spacing = self.given.map_or_else(drawn, |[first, last]| (first * last).sqrt());
        Spots { spacing: Some(spacing), aspect: 1.0, ..wanted }
    }

    /// px a cell of the surface that suits points about here.
    #[must_use]
    pub fn cell(&self, wanted: &Spots) -> f64 {
        let least = self.given.map(|[first, last]| first.min(last)).or(wanted.spacing);
        (least.unwrap_or(f64::INFINITY) / self.vertices).min(self.largest).max(SMALLEST)
    }
}
