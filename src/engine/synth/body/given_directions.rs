//! The directions that strokes, pins and drawn paths of a model give: +x of the sketch there.

use crate::document::{Body, BodyMark, Layer};
use crate::surface::{Surface, SurfacePoint};
use crate::synth::body::asked::Asked;
use crate::synth::body::placed::Placed;

/// A place, a direction in its frame, degrees, and its weight.
pub type Given = (SurfacePoint, f64, f64);

/// A straight piece of a polyline on a surface.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// Its middle.
    pub middle: SurfacePoint,
    /// Its direction in the frame there, degrees.
    pub degrees: f64,
    /// Its length, px.
    pub length: f64,
}

/// The directions of +x of the sketch that a body and the paths of a layer give.
#[must_use]
pub fn given(body: &Body, layer: &Layer, asked: &Asked, surface: &Surface, placed: &Placed) -> Vec<Given> {
    let mut given: Vec<Given> = Vec::new();
    for pin in &body.pins {
        if let Some(toward) = pin.toward {
            let place = surface.closest(placed.scale.to_px(pin.at));
            given.extend(degrees(surface, place, toward).map(|degrees| (place, degrees, 1.0)));
        }
    }
    let step = 2.0 * surface.unit();
    let along = |points: &[[f64; 3]], angle: f64| {
        let pieces = pieces(points, surface, placed, step).into_iter();
        pieces.map(move |piece| (piece.middle, piece.degrees - angle, 1.0)).collect::<Vec<Given>>()
    };
    given.extend(body.strokes.iter().flat_map(|stroke| along(stroke, 0.0)));
    for (mark, wanted) in layer.on_model.iter().zip(&asked.marks) {
        if let BodyMark::Path { points, .. } = mark {
            given.extend(along(points, wanted.angle()));
        }
    }
    given
}

/// The direction of a vector at a place, degrees in its frame; `None` where it has no part in the tangent plane.
pub fn degrees(surface: &Surface, place: SurfacePoint, vector: [f64; 3]) -> Option<f64> {
    let frame = surface.frame(surface.vertex_of(place));
    let [x, y] = frame.map(|axis| (0..3).map(|i| axis[i] * vector[i]).sum::<f64>());
    let length = vector.iter().map(|part| part * part).sum::<f64>().sqrt();
    (x.abs().max(y.abs()) > 1e-6 * length).then(|| libm::atan2(y, x).to_degrees())
}

/// The pieces of a polyline, given in coordinates of the file, of about `step` px.
#[must_use]
pub fn pieces(points: &[[f64; 3]], surface: &Surface, placed: &Placed, step: f64) -> Vec<Piece> {
    let of_segment = |[from, to]: &[[f64; 3]; 2]| {
        let [from, to] = [from, to].map(|at| placed.scale.to_px(*at));
        let way: [f64; 3] = std::array::from_fn(|i| to[i] - from[i]);
        let length = way.iter().map(|part| part * part).sum::<f64>().sqrt();
        let count = (length / step).ceil().clamp(1.0, 1_000.0) as usize;
        let at = move |k: usize| {
            let share = (k as f64 + 0.5) / count as f64;
            let middle = surface.closest(std::array::from_fn(|i| from[i] + share * way[i]));
            let degrees = degrees(surface, middle, way)?;
            Some(Piece { middle, degrees, length: length / count as f64 })
        };
        (0..count).filter_map(at).collect::<Vec<Piece>>()
    };
    points.array_windows().flat_map(of_segment).collect()
}
