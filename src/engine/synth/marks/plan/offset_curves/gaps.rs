//! Gaps of open rings: their number, their places, and the cells that they block.

use crate::grid::Grid;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use std::collections::BTreeMap;

use crate::grid::distance::nearest;
use crate::synth::marks::plan::offset_curves::CurveRequest;

/// Mean distance of the gaps along a ring, in ring widths: a leopard's rosettes have three or four gaps.
pub const APART: f64 = 6.0;
/// Largest deviation of the number of gaps from the one that follows from the mean distance.
pub const MORE_OR_LESS: f64 = 0.8;
/// Fewest gaps a ring.
pub const LEAST: f64 = 2.0;
/// Places that are tried for each gap; the one farthest from the others is taken (Mitchell's best candidate).
pub const TRIES: usize = 6;
/// Ring widths to either side of the curve within which a gap blocks cells.
pub const REACH: f64 = 1.4;

/// The end of an arc recedes from a gap by this, ÷ its width.
pub const RECEDES: f64 = 0.65;
/// Half the length that is blocked in the smallest gap ÷ the width.
pub const LEAST_CUT: f64 = 0.2;

/// The open places of rings.
pub struct Gaps {
    /// Whether a cell lies in a gap.
    pub opened: Vec<bool>,
    /// Two places a gap: the ends of the arcs beside it, px.
    pub ends: Vec<[f64; 2]>,
}

/// Opens the rings along `curve` by the requested share. `off` is the distance of each cell to the curve, cells; `ring`
/// gives the ring of a cell of the curve.
pub fn open(
    request: &CurveRequest,
    grid: &Grid,
    off: &[f32],
    curve: &[bool],
    ring: impl Fn(usize) -> usize,
) -> Gaps {
    let mut rings: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for cell in (0..curve.len()).filter(|cell| curve[*cell]) {
        rings.entry(ring(cell)).or_default().push(cell);
    }
    let mut rng = Pcg64Mcg::seed_from_u64(request.seed);
    let mut cut = vec![false; curve.len()];
    let mut ends = Vec::new();
    for cells in rings.values() {
        // The number of cells of a band one cell wide is its length in cells.
        let length = grid.px_a_cell() * cells.iter().filter(|cell| off[**cell] < 0.5).count() as f64;
        let width =
            cells.iter().map(|cell| f64::from(request.width[*cell])).sum::<f64>() / cells.len() as f64;
        let more = MORE_OR_LESS * (2.0 * rng.random::<f64>() - 1.0);
        let gaps = (length / (APART * width) + more).round().max(LEAST);
        let half = (0.5 * request.broken * length / gaps - RECEDES * width).max(LEAST_CUT * width);
        let members = |cell: usize| curve[cell] && cells.binary_search(&cell).is_ok();
        for place in places(cells, grid, gaps as usize, &mut rng) {
            cut_along(place, grid, half, &members, &mut cut);
            ends.extend([grid.center_px(place); 2]);
        }
    }
    let Some(to) = nearest(curve, grid) else {
        return Gaps { opened: cut, ends };
    };
    let opened = (0..curve.len())
        .map(|cell| {
            let near = f64::from(off[cell]) * grid.px_a_cell() < REACH * f64::from(request.width[cell]);
            near && grid.step(cell, to[cell]).is_some_and(|(at, _)| cut[at])
        })
        .collect();
    Gaps { opened, ends }
}

/// `count` of the `cells` that are far from each other.
fn places(cells: &[usize], grid: &Grid, count: usize, rng: &mut impl Rng) -> Vec<usize> {
    let bounds = grid.bounds_px();
    let mut places: Vec<usize> = Vec::with_capacity(count);
    for _ in 0..count {
        let mut best = (f64::NEG_INFINITY, cells[0]);
        for _ in 0..TRIES {
            let cell = cells[rng.random_range(0..cells.len())];
            let apart = |other: &usize| {
                let [a, b] = [grid.center_px(cell), grid.center_px(*other)];
                let [x, y] = bounds.shortest([a[0] - b[0], a[1] - b[1]]);
                x * x + y * y
            };
            let nearest = places.iter().map(apart).fold(f64::INFINITY, f64::min);
            if nearest > best.0 {
                best = (nearest, cell);
            }
        }
        places.push(best.1);
    }
    places
}

/// Cuts the curve within `half` px of `place` along it.
fn cut_along(place: usize, grid: &Grid, half: f64, members: &dyn Fn(usize) -> bool, cut: &mut [bool]) {
    const STEPS: [[i32; 2]; 8] = [[1, 0], [-1, 0], [0, 1], [0, -1], [1, 1], [1, -1], [-1, 1], [-1, -1]];
    let mut known: BTreeMap<usize, f64> = BTreeMap::from([(place, 0.0)]);
    let mut left = vec![place];
    // There are few cells: each is processed again whenever a shorter way to it is found.
    while let Some(cell) = left.pop() {
        cut[cell] = true;
        let so_far = known[&cell];
        for step in STEPS {
            let Some((next, _)) = grid.step(cell, step).filter(|(next, _)| members(*next)) else { continue };
            let along = so_far + crate::grid::distance::length(step, grid);
            if along <= half && known.get(&next).is_none_or(|known| along < known - 1e-9) {
                known.insert(next, along);
                left.push(next);
            }
        }
    }
}
