//! Level lines → shapes with holes, without the ones that are too small.

use kurbo::{BezPath, ParamCurveArclen, Shape as _};
use rayon::prelude::*;

use super::path::is_on_border;
use super::trace::{Ring, Traced};
use super::{Shape, Smallest, fit};
use crate::grid::UnionFind;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Accuracy of perimeters, px.
const ACCURACY: f64 = 0.01;

/// Area (px²) and perimeter (px) of a part of the canvas: an island or a hole.
#[derive(Clone, Copy, Default)]
struct Extent {
    area: f64,
    /// On a wrapped canvas, the perimeter without the parts along the border.
    perimeter: f64,
}

impl Extent {
    /// The width of the stadium (a rectangle between two half circles) with this area A and perimeter P:
    /// A = wP/2 − πw²/4: the diameter of a disc, and the width of a long stripe, straight or bent.
    fn width(self) -> f64 {
        let Self { area, perimeter } = self;
        if perimeter <= 0.0 {
            return f64::INFINITY;
        }
        (perimeter - (perimeter * perimeter - 4.0 * PI * area).max(0.0).sqrt()) / PI
    }

    fn is_below(self, smallest: Smallest) -> bool {
        self.area < smallest.area || (smallest.width > 0.0 && self.width() < smallest.width)
    }
}

/// An enclosed part, the part around it, and the index of its boundary.
struct Part {
    within: u32,
    ring: usize,
    kept: Option<bool>,
}

/// The shapes with these traced outlines on a canvas of `size` px, without those below `smallest`.
pub fn shapes(
    traced: &Traced,
    size: [f64; 2],
    wraps: bool,
    smallest: Smallest,
    tolerance: f64,
) -> Vec<Shape> {
    let mut parts: BTreeMap<u32, Part> = BTreeMap::new();
    let paths: Vec<BezPath> =
        traced.rings.par_iter().map(|ring| fit::ring(&ring.points, size, tolerance)).collect();
    let extents: Vec<Extent> = paths.par_iter().map(|path| extent(path, size, wraps)).collect();
    let around: Vec<bool> = traced.rings.iter().map(Ring::is_around_mark).collect();
    for (index, ring) in traced.rings.iter().enumerate() {
        let [inside, outside] = ring.sides;
        let (part, within) = if around[index] { (inside, outside) } else { (outside, inside) };
        if part != traced.outside {
            parts.insert(part, Part { within, ring: index, kept: None });
        }
    }
    let sizes = whole_sizes(traced, &parts, &extents);
    let keys: Vec<u32> = parts.keys().copied().collect();
    for part in keys {
        decide(part, &mut parts, &|part| !sizes[&part].is_below(smallest));
    }
    let kept = |(index, path): (usize, BezPath)| {
        let [inside, outside] = traced.rings[index].sides;
        let own = if around[index] { inside } else { outside };
        let kept = parts.get(&own).is_some_and(|part| part.ring == index && part.kept == Some(true));
        kept.then_some(path)
    };
    let paths = paths.into_iter().enumerate().map(kept).collect();
    gather(traced, &around, paths)
}

/// One shape for each island, in the order in which they were traced.
fn gather(traced: &Traced, around: &[bool], paths: Vec<Option<BezPath>>) -> Vec<Shape> {
    let mut shapes: Vec<Shape> = Vec::new();
    let mut places: BTreeMap<u32, usize> = BTreeMap::new();
    let mut holes: Vec<(u32, BezPath)> = Vec::new();
    for (index, path) in paths.into_iter().enumerate() {
        let inside = traced.rings[index].sides[0];
        match path {
            Some(path) if around[index] => {
                places.insert(inside, shapes.len());
                shapes.push(Shape { outer: path, holes: Vec::new() });
            }
            Some(path) => holes.push((inside, path)),
            None => {}
        }
    }
    for (inside, hole) in holes {
        if let Some(place) = places.get(&inside) {
            shapes[*place].holes.push(hole);
        }
    }
    shapes
}

/// Area and perimeter of a fitted path. (Traced points zigzag a little, so their perimeter is too long.)
fn extent(path: &BezPath, size: [f64; 2], wraps: bool) -> Extent {
    let counted = path.segments().filter(|segment| !(wraps && is_on_border(segment, size)));
    Extent { area: path.area(), perimeter: counted.map(|segment| segment.arclen(ACCURACY)).sum() }
}

/// The extent of each part together with the parts that touch it across a wrapped border.
fn whole_sizes(traced: &Traced, parts: &BTreeMap<u32, Part>, extents: &[Extent]) -> BTreeMap<u32, Extent> {
    let most = parts.keys().chain(traced.seams.iter().flatten()).copied().max().unwrap_or(0);
    let mut joined = UnionFind::new(most as usize + 1);
    for [a, b] in &traced.seams {
        joined.join(*a, *b, [0, 0]);
    }
    let mut sums: BTreeMap<u32, Extent> = BTreeMap::new();
    for (part, Part { ring, .. }) in parts {
        let sum = sums.entry(joined.find(*part).0).or_default();
        sum.area += extents[*ring].area.abs();
        sum.perimeter += extents[*ring].perimeter;
    }
    parts.keys().map(|part| (*part, sums[&joined.find(*part).0])).collect()
}

/// Decides whether to keep a part: it is kept if it is large enough and the part around it is kept. Removing an island therefore
/// also removes its holes, and removing a hole the islands in it.
fn decide(part: u32, parts: &mut BTreeMap<u32, Part>, large: &dyn Fn(u32) -> bool) {
    let mut chain = Vec::new();
    let mut at = part;
    let mut kept = loop {
        match parts.get(&at) {
            Some(Part { kept: Some(kept), .. }) => break *kept,
            Some(Part { within, .. }) if chain.len() <= parts.len() => {
                chain.push(at);
                at = *within;
            }
            _ => break true,
        }
    };
    while let Some(part) = chain.pop() {
        kept = kept && large(part);
        if let Some(part) = parts.get_mut(&part) {
            part.kept = Some(kept);
        }
    }
}
