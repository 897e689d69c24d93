//! The direction of the hair and the scales of a model: from head to tail, by vertex.

use rayon::prelude::*;

use crate::attributes::Attributes;
use crate::document::{Body, FlowChoice};
use crate::surface::vector::{Vector, across, cross, distance, dot, length, minus, plus, times, unit};
use crate::surface::{Surface, directions};
use crate::synth::body::given_directions::{degrees, pieces};
use crate::synth::body::grown::GrownBody;
use crate::synth::body::placed::Placed;
use crate::synth::drawn::is_replaced;

/// The weight of the axis `along` in the field of directions, as in that of the sketch.
const ALONG: f64 = 0.001;
/// How far a drawn direction says in which of two opposite directions the field leads, cells.
const KNOWN: f64 = 30.0;
/// How much hair points downwards where nothing says its direction, against towards the tail.
const DOWN: f64 = 0.6;
/// Rounds in which each vertex takes the mean of the directions around it: where the field turns against itself, hair parts smoothly.
const ROUNDS: usize = 24;

/// A place with a direction in space.
struct Given {
    place: Vector,
    direction: Vector,
}

/// By vertex of the finest surface, the direction of hair and scales: of length 1, along the surface.
#[must_use]
pub fn of(grown: &GrownBody, choice: &FlowChoice) -> Vec<[f64; 3]> {
    let surface = grown.finest().plan.surface();
    let Some(body) = &grown.document.model else { return vec![[0.0; 3]; surface.mesh.positions.len()] };
    let given = given(body, &grown.placed, surface);
    let directed = match choice {
        FlowChoice::Angle(angle) => rightward(surface, body, &given)
            .into_iter()
            .enumerate()
            .map(|(vertex, right)| turned(right, surface.normal(vertex), *angle))
            .collect(),
        FlowChoice::Usual | FlowChoice::Strokes(_) => usual(grown, surface, body, &given),
    };
    smooth(surface, directed)
}

/// The directions that pins and strokes give: +x of the sketch.
fn given(body: &Body, placed: &Placed, surface: &Surface) -> Vec<Given> {
    let pins = body
        .pins
        .iter()
        .filter_map(|pin| Some(Given { place: placed.scale.to_px(pin.at), direction: unit(pin.toward?)? }));
    let of_stroke = |stroke: &Vec<Vector>| {
        let pieces = pieces(stroke, surface, placed, 2.0 * surface.unit()).into_iter();
        pieces.map(|piece| {
            let [x, y] = surface.frame(surface.vertex_of(piece.middle));
            let (sin, cos) = libm::sincos(piece.degrees.to_radians());
            let direction = plus(times(x, cos), times(y, sin));
            Given { place: surface.position(piece.middle), direction }
        })
    };
    pins.chain(body.strokes.iter().flat_map(of_stroke)).collect()
}

/// By vertex, +x of the sketch without its sign: along drawn directions, and otherwise along the axis of the model.
fn axes(surface: &Surface, given: &[Given]) -> Vec<Vector> {
    let of_place = |given: &Given| {
        let place = surface.closest(given.place);
        Some((place, degrees(surface, place, given.direction)?, 1.0))
    };
    let known: Vec<_> = given.iter().filter_map(of_place).collect();
    let field = directions(surface, &known, ALONG).degrees;
    let of_vertex = |(vertex, degrees): (usize, f64)| {
        let ([x, y], (sin, cos)) = (surface.frame(vertex), libm::sincos(degrees.to_radians()));
        plus(times(x, cos), times(y, sin))
    };
    field.into_iter().enumerate().map(of_vertex).collect()
}

/// By vertex, +x of the sketch: in the direction of the nearest stroke or pin, and far from these towards the head.
fn rightward(surface: &Surface, body: &Body, given: &[Given]) -> Vec<Vector> {
    let reach = KNOWN * surface.unit();
    let along = body.along.vector();
    let towards = |vertex: usize| {
        let at = surface.mesh.positions[vertex];
        let far = |given: &&Given| distance(given.place, at);
        let nearest = given.iter().min_by(|a, b| far(a).total_cmp(&far(b)));
        let known = nearest
            .map_or([0.0; 3], |given| times(given.direction, 2.0 * (1.0 - far(&given) / reach).max(0.0)));
        across(plus(along, known), surface.normal(vertex))
    };
    let axes = axes(surface, given);
    (0..axes.len()).into_par_iter().map(|vertex| towards_one(axes[vertex], towards(vertex))).collect()
}

/// By vertex, the direction of hair where none is chosen: across the stripes of the lowest visible layer, otherwise along drawn
/// directions, otherwise towards the tail and down; in any case rather so than against it.
fn usual(grown: &GrownBody, surface: &Surface, body: &Body, given: &[Given]) -> Vec<Vector> {
    let tail = plus(times(body.along.vector(), -1.0), times(body.up.vector(), -DOWN));
    let towards = |vertex: usize| across(tail, surface.normal(vertex));
    let axes = across_stripes(grown, surface).or_else(|| (!given.is_empty()).then(|| axes(surface, given)));
    match axes {
        Some(axes) => (0..axes.len()).map(|vertex| towards_one(axes[vertex], towards(vertex))).collect(),
        None => (0..surface.mesh.positions.len()).map(towards).collect(),
    }
}

/// By vertex, a direction across the stripes of the lowest visible layer; `None` if it has no stripes.
fn across_stripes(grown: &GrownBody, surface: &Surface) -> Option<Vec<Vector>> {
    let document = &grown.document;
    let is_seen = |index: &usize| document.layers[*index].visible && !is_replaced(document, *index);
    let lowest = (0..document.layers.len()).find(is_seen)?;
    let plan = &grown.layers.iter().find(|layer| layer.plan.layer == lowest)?.plan;
    if !matches!(plan.wanted.first(), Some(Attributes::Stripes(_))) {
        return None;
    }
    let own = plan.surface();
    let of_vertex = |vertex: usize| {
        let place = own.closest_facing(surface.mesh.positions[vertex], surface.normal(vertex));
        let there = own.vertex_of(place);
        let ([x, y], (sin, cos)) = (own.frame(there), libm::sincos(plan.wanted[there].angle().to_radians()));
        // A quarter turn from the stripe.
        plus(times(x, -sin), times(y, cos))
    };
    Some((0..surface.mesh.positions.len()).into_par_iter().map(of_vertex).collect())
}

/// An axis in that of its two directions that is nearer to another direction.
fn towards_one(axis: Vector, other: Vector) -> Vector {
    if dot(axis, other) < 0.0 { times(axis, -1.0) } else { axis }
}

/// A direction turned by degrees, clockwise seen from outside.
fn turned(direction: Vector, normal: Vector, degrees: f64) -> Vector {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    plus(times(direction, cos), times(cross(direction, normal), sin))
}

/// Directions of length 1 along the surface, each the mean of those around it.
fn smooth(surface: &Surface, mut field: Vec<Vector>) -> Vec<Vector> {
    for _ in 0..ROUNDS {
        let mean = |vertex: usize| {
            let sum = surface.ring(vertex).fold(field[vertex], |sum, other| plus(sum, field[other]));
            let flat = across(sum, surface.normal(vertex));
            // Where directions meet head on, each keeps its own.
            if length(flat) > 0.3 { unit(flat).unwrap_or(field[vertex]) } else { field[vertex] }
        };
        field = (0..field.len()).into_par_iter().map(mean).collect();
    }
    let of_vertex = |(vertex, direction): (usize, &Vector)| {
        let normal = surface.normal(vertex);
        let [x, _] = surface.frame(vertex);
        unit(minus(*direction, times(normal, dot(*direction, normal)))).unwrap_or(x)
    };
    field.iter().enumerate().map(of_vertex).collect()
}
