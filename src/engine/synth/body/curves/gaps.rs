//! Gaps of open rings: how many, where, and which vertices they block.

use std::collections::BTreeMap;

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::Request;
use super::nearest::{Nearest, apart};
use crate::surface::Surface;
use crate::synth::marks::plan::offset_curves::gaps::{
    APART, LEAST, LEAST_CUT, MORE_OR_LESS, REACH, RECEDES, TRIES,
};

/// Where rings are open.
pub struct Gaps {
    /// Whether a vertex lies in a gap.
    pub opened: Vec<bool>,
    /// Two vertices a gap: the ends of the arcs beside it.
    pub ends: Vec<usize>,
}

/// Opens the rings along `curve` by the requested share. `off` is the distance of each vertex to the curve, cells; `ring` gives the ring of
/// a vertex of the curve.
pub fn open(request: &Request, off: &[f64], curve: &[bool], ring: impl Fn(usize) -> usize) -> Gaps {
    let Request { surface, widths, broken, seed, .. } = request;
    let mut rings: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for vertex in (0..curve.len()).filter(|vertex| curve[*vertex]) {
        rings.entry(ring(vertex)).or_default().push(vertex);
    }
    let mut rng = Pcg64Mcg::seed_from_u64(*seed);
    let (mut cut, mut ends) = (vec![false; curve.len()], Vec::new());
    for vertices in rings.values() {
        // Of a band as wide as a cell, as many vertices as it is long.
        let length = surface.unit() * vertices.iter().filter(|vertex| off[**vertex] < 0.5).count() as f64;
        let width = vertices.iter().map(|vertex| widths[*vertex]).sum::<f64>() / vertices.len() as f64;
        let more = MORE_OR_LESS * (2.0 * rng.random::<f64>() - 1.0);
        let gaps = (length / (APART * width) + more).round().max(LEAST);
        let half = (0.5 * broken * length / gaps - RECEDES * width).max(LEAST_CUT * width);
        let is_member = |vertex: usize| vertices.binary_search(&vertex).is_ok();
        for place in places(surface, vertices, gaps as usize, &mut rng) {
            cut_along(surface, place, half, &is_member, &mut cut);
            ends.extend([place; 2]);
        }
    }
    let Some(to) = Nearest::new(surface, curve) else { return Gaps { opened: cut, ends } };
    let is_opened =
        |vertex: usize| off[vertex] * surface.unit() < REACH * widths[vertex] && cut[to.to[vertex] as usize];
    Gaps { opened: (0..curve.len()).map(is_opened).collect(), ends }
}

/// `count` of the `vertices`, far from each other.
fn places(surface: &Surface, vertices: &[usize], count: usize, rng: &mut impl Rng) -> Vec<usize> {
    let mut places: Vec<usize> = Vec::with_capacity(count);
    for _ in 0..count {
        let mut best = (f64::NEG_INFINITY, vertices[0]);
        for _ in 0..TRIES {
            let vertex = vertices[rng.random_range(0..vertices.len())];
            let nearest =
                places.iter().map(|other| apart(surface, vertex, *other)).fold(f64::INFINITY, f64::min);
            if nearest > best.0 {
                best = (nearest, vertex);
            }
        }
        places.push(best.1);
    }
    places
}

/// Cuts the curve within `half` px of `place` along it.
fn cut_along(
    surface: &Surface,
    place: usize,
    half: f64,
    is_member: &dyn Fn(usize) -> bool,
    cut: &mut [bool],
) {
    let mut known: BTreeMap<usize, f64> = BTreeMap::from([(place, 0.0)]);
    let mut left = vec![place];
    // Few vertices: each is looked at again whenever a shorter way to it is found.
    while let Some(vertex) = left.pop() {
        cut[vertex] = true;
        let so_far = known[&vertex];
        for next in surface.ring(vertex).filter(|next| is_member(*next)) {
            let along = so_far + apart(surface, vertex, next);
            if along <= half && known.get(&next).is_none_or(|known| along < known - 1e-9) {
                known.insert(next, along);
                left.push(next);
            }
        }
    }
}
