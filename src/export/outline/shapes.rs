//! Level lines → shapes with holes, without those that are too small.

use rayon::prelude::*;

use super::labels::Labels;
use super::path::{Path, Piece, borders, distance};
use super::trace::Traced;
use super::{Shape, Smallest, fit};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// What a part of the canvas, island or hole, is bounded by.
#[derive(Clone, Copy, Default)]
struct Extent {
    area: f64,
    /// Of its boundary; on a wrapped canvas what runs along the border is left out.
    perimeter: f64,
}

impl Extent {
    /// The width of the stadium (a rectangle between two half circles) with this area A and perimeter P:
    /// A = wP/2 − πw²/4. It is the diameter of a disc, and the width of a long stripe, however it bends.
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

/// An enclosed part: the one it lies in, and its boundary.
struct Part {
    within: u32,
    ring: usize,
    kept: Option<bool>,
}

/// The shapes whose outlines were traced on a canvas of `size` px.
pub fn shapes(
    traced: &Traced,
    size: [f64; 2],
    wraps: bool,
    smallest: Smallest,
    tolerance: f64,
) -> Vec<Shape> {
    let mut parts: BTreeMap<u32, Part> = BTreeMap::new();
    let paths: Vec<Path> =
        traced.rings.par_iter().map(|ring| fit::ring(&ring.points, size, tolerance)).collect();
    let extents: Vec<Extent> = paths.par_iter().map(|path| extent(path, size, wraps)).collect();
    for (index, ring) in traced.rings.iter().enumerate() {
        let [inside, outside] = ring.sides;
        let (part, within) = if extents[index].area > 0.0 { (inside, outside) } else { (outside, inside) };
        if part != traced.outside {
            parts.insert(part, Part { within, ring: index, kept: None });
        }
    }
    let sizes = whole_sizes(traced, &parts, &extents);
    let keys: Vec<u32> = parts.keys().copied().collect();
    for part in keys {
        settle(part, &mut parts, &|part| !sizes[&part].is_below(smallest));
    }
    let kept = |(index, path): (usize, Path)| {
        let [inside, outside] = traced.rings[index].sides;
        let own = if extents[index].area > 0.0 { inside } else { outside };
        let kept = parts.get(&own).is_some_and(|part| part.ring == index && part.kept == Some(true));
        kept.then_some(path)
    };
    let paths = paths.into_iter().enumerate().map(kept).collect();
    gather(traced, &extents, paths)
}

/// One shape an island, in the order in which they were traced.
fn gather(traced: &Traced, extents: &[Extent], paths: Vec<Option<Path>>) -> Vec<Shape> {
    let mut shapes: Vec<Shape> = Vec::new();
    let mut places: BTreeMap<u32, usize> = BTreeMap::new();
    let mut holes: Vec<(u32, Path)> = Vec::new();
    for (index, path) in paths.into_iter().enumerate() {
        let inside = traced.rings[index].sides[0];
        match path {
            Some(path) if extents[index].area > 0.0 => {
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

/// Of a fitted path: the points that were traced zigzag a little, and the perimeter with them.
fn extent(path: &Path, size: [f64; 2], wraps: bool) -> Extent {
    let along = |(start, piece): ([f64; 2], Piece)| match piece {
        Piece::Line(end) if borders(start, size) & borders(end, size) != 0 => distance(start, end),
        _ => 0.0,
    };
    let left_out = if wraps { path.steps().map(along).sum() } else { 0.0 };
    Extent { area: path.area(), perimeter: path.length() - left_out }
}

/// The extent of each part, with what it goes on with across a wrapped border.
fn whole_sizes(traced: &Traced, parts: &BTreeMap<u32, Part>, extents: &[Extent]) -> BTreeMap<u32, Extent> {
    let most = parts.keys().chain(traced.seams.iter().flatten()).copied().max().unwrap_or(0);
    let mut joined = Labels::of(most + 1);
    for [a, b] in &traced.seams {
        joined.join(*a, *b);
    }
    let mut sums: BTreeMap<u32, Extent> = BTreeMap::new();
    for (part, Part { ring, .. }) in parts {
        let sum = sums.entry(joined.find(*part)).or_default();
        sum.area += extents[*ring].area.abs();
        sum.perimeter += extents[*ring].perimeter;
    }
    parts.keys().map(|part| (*part, sums[&joined.find(*part)])).collect()
}

/// A part is kept where it is large enough and the one around it is kept: with an island go its holes, and with a hole
/// the islands in it.
fn settle(part: u32, parts: &mut BTreeMap<u32, Part>, large: &dyn Fn(u32) -> bool) {
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
