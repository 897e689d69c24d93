//! The ranges of the trial, of the attributes that are measured on a sketch.

use dapple::document::Document;
use dapple::document::Edges;
use dapple_engine::attributes::AttributeMap;
use dapple_engine::attributes::{Attributes, Spots, Stripes};
use dapple_engine::marks::turn;
use dapple_engine::synth::drawn::sketch_targets;

/// Area of a spot, px².
pub const AREA: [f64; 2] = [40.0, 1_500.0];
/// Minor ÷ major radius.
pub const ASPECT: [f64; 2] = [0.3, 1.0];
/// area ÷ spacing².
pub const PACKING: [f64; 2] = [0.03, 0.2];
/// Width of a stripe, px.
pub const WIDTH: [f64; 2] = [4.0, 20.0];
/// Neighbouring regions differ in area or width at most by this factor.
pub const FACTOR: f64 = 2.0;
/// Neighbouring regions differ in direction at most by this angle, degrees.
pub const TURN: f64 = 45.0;
/// Neighbouring regions differ in area ÷ spacing² at most by this factor: the variation in hand-drawn sketches that are
/// meant to be even.
pub const LOOSER: f64 = 1.5;
/// The aspect above which marks are too round to have a direction.
const ROUND: f64 = 0.9;

/// Whether the attributes of all regions of `document` are within the ranges.
pub fn within(document: &Document) -> bool {
    let Ok(map) = sketch_targets::region_map(document, 0, &document.name) else { return false };
    let own = |index: usize| map.region(map.layout().place(index)).own;
    let sound = (0..map.layout().len()).all(|index| own(index).is_some_and(|own| reachable(&own)));
    sound && neighbours(&map).all(|[a, b]| own(a).zip(own(b)).is_some_and(|(a, b)| alike(&a, &b)))
}

fn holds([low, high]: [f64; 2], number: f64) -> bool {
    (low..=high).contains(&number)
}

fn packing(spots: &Spots) -> Option<f64> {
    spots.spacing.map(|spacing| spots.area / (spacing * spacing))
}

fn reachable(asked: &Attributes) -> bool {
    match asked {
        Attributes::Spots(spots) => {
            holds(AREA, spots.area)
                && holds(ASPECT, spots.aspect)
                && packing(spots).is_some_and(|packing| holds(PACKING, packing))
        }
        Attributes::Stripes(stripes) => holds(WIDTH, stripes.width),
    }
}

fn alike(a: &Attributes, b: &Attributes) -> bool {
    let near = |a: f64, b: f64, most: f64| a.max(b) <= most * a.min(b);
    match (a, b) {
        (Attributes::Spots(a), Attributes::Spots(b)) => {
            let directed = a.aspect <= ROUND && b.aspect <= ROUND;
            near(a.area, b.area, FACTOR)
                && packing(a).zip(packing(b)).is_some_and(|(a, b)| near(a, b, LOOSER))
                && !(directed && turn(a.angle, b.angle).abs() > TURN)
        }
        (Attributes::Stripes(Stripes { width, angle, .. }), Attributes::Stripes(b)) => {
            near(*width, b.width, FACTOR) && turn(*angle, b.angle).abs() <= TURN
        }
        _ => false,
    }
}

/// Pairs of regions that share a side, by index.
fn neighbours(map: &AttributeMap) -> impl Iterator<Item = [usize; 2]> {
    let layout = *map.layout();
    let step = move |index: usize, axis: usize| {
        let mut place = layout.place(index);
        place[axis] += 1;
        if place[axis] == layout.grid[axis] {
            if layout.edges == Edges::Closed {
                return None;
            }
            place[axis] = 0;
        }
        Some([index, layout.index(place)])
    };
    (0..layout.len()).flat_map(move |index| [0, 1].into_iter().filter_map(move |axis| step(index, axis)))
}
