//! Anchors: what is wanted around places of a surface.

use crate::attributes::{Attributes, Spread};
use crate::document::{Body, BodyEllipse, BodyMark, Document, Pin};
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::asked::Asked;
use crate::synth::body::placed::Scale;

/// What is wanted around a place of a surface.
#[derive(Clone, Debug)]
pub struct Anchor {
    /// Where.
    pub place: SurfacePoint,
    /// What is wanted; the spacing of spots is filled in. The angle counts from +x of the sketch.
    pub wanted: Attributes,
    /// How much spots vary; not at all about marks on the model.
    pub spread: Spread,
    /// What says so.
    pub origin: Origin,
}

/// What an anchor comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The whole sketch, which holds everywhere.
    Sketch,
    /// A pin of the model, by its index, and the region that it pins.
    Pin(usize, [u32; 2]),
    /// A mark on the model, by its index.
    Mark(usize),
}

/// The ellipses among marks on a model, by their index.
pub fn ellipses(marks: &[BodyMark]) -> impl Iterator<Item = (usize, &BodyEllipse)> {
    marks.iter().enumerate().filter_map(|(index, mark)| match mark {
        BodyMark::Ellipse(one) => Some((index, one)),
        BodyMark::Path { .. } => None,
    })
}

/// Where an ellipse is on a surface.
#[must_use]
pub fn place_of(mark: &BodyEllipse, surface: &Surface, scale: &Scale) -> SurfacePoint {
    let at = scale.to_px(mark.at);
    match mark.normal {
        Some(normal) => surface.closest_facing(at, normal),
        None => surface.closest(at),
    }
}

/// The middle of the polyline through these points: halfway along it.
#[must_use]
pub fn middle_of(points: &[[f64; 3]]) -> [f64; 3] {
    let length = |[a, b]: [[f64; 3]; 2]| (0..3).map(|i| (b[i] - a[i]) * (b[i] - a[i])).sum::<f64>().sqrt();
    let mut left = 0.5 * points.array_windows().map(|pair| length(*pair)).sum::<f64>();
    for pair in points.array_windows() {
        let own = length(*pair);
        if left <= own && own > 0.0 {
            return std::array::from_fn(|i| pair[0][i] + left / own * (pair[1][i] - pair[0][i]));
        }
        left -= own;
    }
    points[0]
}

/// The anchors on a surface: pins and marks on the model; the sketch itself where it has neither.
#[must_use]
pub fn anchors(
    asked: &Asked,
    document: &Document,
    body: &Body,
    surface: &Surface,
    scale: &Scale,
) -> Vec<Anchor> {
    let pin = |(index, pin): (usize, &Pin)| {
        let (wanted, spread) = asked.of_region(pin.region)?;
        Some(Anchor {
            place: surface.closest(scale.to_px(pin.at)),
            wanted,
            spread,
            origin: Origin::Pin(index, pin.region),
        })
    };
    let mut anchors: Vec<Anchor> = body.pins.iter().enumerate().filter_map(pin).collect();
    let marks = document.layers[asked.layer].on_model.iter().enumerate();
    for ((index, mark), wanted) in marks.zip(&asked.marks) {
        let place = match mark {
            BodyMark::Ellipse(ellipse) => place_of(ellipse, surface, scale),
            BodyMark::Path { points, .. } => surface.closest(scale.to_px(middle_of(points))),
        };
        let (spread, origin) = (Spread::ZERO, Origin::Mark(index));
        anchors.push(Anchor { place, wanted: *wanted, spread, origin });
    }
    if let (true, Some((wanted, spread))) = (anchors.is_empty(), asked.of_region([0, 0])) {
        // Where it stands does not matter: there is no other.
        anchors.push(Anchor { place: surface.place_of(0), wanted, spread, origin: Origin::Sketch });
    }
    anchors
}
