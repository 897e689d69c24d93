//! Moving single spots of a pattern while it grows.
//!
//! c′(x) = c(x − w(d) Δ), w = 1 for d ≤ inner, 0 for d ≥ outer, smooth between; d the distance from the spot in its own
//! metric, in pitches
//!
//! All chemicals move alike, so that the spot takes its surroundings along and only the ground between it and its
//! neighbours is drawn out.

use super::System;
use super::maps::{Maps, Parameters};
use super::nuclei::Nucleus;
use crate::field::resample::Spline;
use crate::field::{Edges, Field};

/// A spot that is to be moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slide {
    /// Where it stands, cells.
    pub at: [f64; 2],
    /// The parameters that it grows in.
    pub own: Parameters,
    /// How far it is to be moved, cells.
    pub by: [f64; 2],
}

/// What moves as one: a spot reaches to 0.2–0.28 pitches.
const INNER: f64 = 0.3;
/// Beyond this nothing moves: half way to the nearest neighbours, and some.
const OUTER: f64 = 0.6;

/// The cells of a chemical with these spots moved.
#[must_use]
pub fn slid(system: System, maps: &Maps, edges: Edges, chemical: &[f32], slides: &[Slide]) -> Vec<f32> {
    let shifts = shifts(system, maps, edges, slides);
    let field = Field { width: maps.nx, height: maps.ny, cell: [1.0, 1.0], edges, values: chemical.to_vec() };
    let surface = Spline::new(&field);
    let mut cells = field.values;
    for (cell, [x, y]) in shifts {
        let from = maps.middle(cell);
        // Between a steep spot and the ground the surface dips below it.
        cells[cell] = surface.at([from[0] - x, from[1] - y]).max(0.0);
    }
    cells
}

/// By how much the content of which cells moves.
fn shifts(system: System, maps: &Maps, edges: Edges, slides: &[Slide]) -> Vec<(usize, [f64; 2])> {
    let mut found: Vec<Option<[f64; 2]>> = vec![None; maps.nx * maps.ny];
    for Slide { at, own, by } in slides {
        let spot = Nucleus::of(own, maps.cell, *at, system.spacing(own));
        let far = OUTER * spot.reach;
        let range = |v: f64| (v - 0.5 - far).ceil() as isize..=(v - 0.5 + far).floor() as isize;
        let beyond = |i: isize, n: usize| edges == Edges::Closed && !(0..n as isize).contains(&i);
        for y in range(at[1]).filter(|y| !beyond(*y, maps.ny)) {
            for x in range(at[0]).filter(|x| !beyond(*x, maps.nx)) {
                let distance = spot.distance2([x as f64 + 0.5 - at[0], y as f64 + 0.5 - at[1]]).sqrt();
                let weight = weight(distance);
                let cell = edges.index(y, maps.ny) * maps.nx + edges.index(x, maps.nx);
                if weight > 0.0 && !maps.is_taken(cell) {
                    let shift = found[cell].get_or_insert([0.0; 2]);
                    shift[0] += weight * by[0];
                    shift[1] += weight * by[1];
                }
            }
        }
    }
    found.into_iter().enumerate().filter_map(|(cell, shift)| Some((cell, shift?))).collect()
}

/// w(d).
fn weight(distance: f64) -> f64 {
    let t = ((OUTER - distance) / (OUTER - INNER)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
