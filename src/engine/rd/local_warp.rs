//! Moving single spots, or pieces of stripes, of a pattern while it grows.
//!
//! ```text
//! c′(x) = c(x − Σₖ wₖ sₖ Δₖ ÷ Σₖ sₖ),  sₖ = exp(−dₖ² ÷ 2τ²)
//! ```
//!
//! dₖ is the distance from spot k in its own metric, in pitches of the room that the spot needs itself; wₖ is 1 up to the inner
//! distance, 0 from the outer one on, smooth between. The sums are over all spots, including the spots that stay (Δₖ = 0), so that
//! a spot does not drag its neighbours. All chemicals move alike: only the ground between spots is stretched.

use std::ops::Range;

use multiversion::multiversion;
use rayon::prelude::*;

use crate::grid::resample::Spline;
use crate::grid::{Domain, Edges, Field, Grid, exp, turned};
use crate::rd::System;
use crate::rd::nucleus::Nucleus;
use crate::rd::parameter_field::{ParameterField, Parameters};
use crate::rd::prolongation::within_range;
use crate::rd::shepard::TAU;

/// A spot to move, or to keep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalWarp<P = [f64; 2]> {
    /// Its place, cells.
    pub at: P,
    /// The parameters at its place, in the frame of this place.
    pub own: Parameters,
    /// The displacement, cells, in the frame of its place.
    pub by: [f64; 2],
}

/// Up to this distance, pitches, everything moves together: the radius of a spot is 0.2–0.28 pitches.
const INNER: f64 = 0.3;
/// Beyond this distance, pitches, nothing moves: slightly more than halfway to the nearest neighbours.
const OUTER: f64 = 0.6;

/// Side of a tile, cells. A tile that contains moved cells is interpolated as a whole.
const TILE: usize = 48;
/// Width of the frame of cells around a tile that determines its spline up to 10⁻⁸, see [`Spline`].
const MARGIN: usize = 16;
/// Fewest moved cells that a thread interpolates at once. Not tuned.
const CELLS_AT_ONCE: usize = 2_048;

/// Cells that move, sorted by tile.
pub(super) struct Moves<'a> {
    grid: &'a Grid,
    /// The centre of each cell and its displacement, in the order of the cells.
    moves: Vec<[[f64; 2]; 2]>,
    /// The indices of these, tile by tile.
    order: Vec<u32>,
    /// Column and row of each tile, and where its indices end in `order`.
    tiles: Vec<([usize; 2], usize)>,
}

impl<'a> Moves<'a> {
    /// Prepares the displacements `shifts`, which are in the order of the cells.
    pub fn new(grid: &'a Grid, shifts: &'a [(usize, [f64; 2])]) -> Self {
        let across = grid.size[0].div_ceil(TILE);
        let mut moves = Vec::with_capacity(shifts.len());
        let mut keyed: Vec<(usize, u32)> = Vec::with_capacity(shifts.len());
        // Divisions are slow: there is one per row, besides divisions by constants.
        for (row, indices) in rows(grid, shifts) {
            for (index, (cell, by)) in indices.clone().zip(&shifts[indices]) {
                let column = cell - row * grid.size[0];
                moves.push([[column as f64 + 0.5, row as f64 + 0.5], *by]);
                keyed.push((row / TILE * across + column / TILE, index as u32));
            }
        }
        keyed.sort_by_key(|(tile, _)| *tile);
        let mut end = 0;
        let tiles = keyed.chunk_by(|(a, _), (b, _)| a == b).map(|group| {
            end += group.len();
            ([group[0].0 % across, group[0].0 / across], end)
        });
        let tiles = tiles.collect();
        Self { grid, moves, order: keyed.into_iter().map(|(_, index)| index).collect(), tiles }
    }

    /// The values of a chemical, whose rows are `row(y)`, at these cells after the move.
    ///
    /// The spline is computed only around the cells that move if these are few.
    pub fn moved<'b>(&self, row: impl Fn(usize) -> &'b [f32] + Sync) -> Vec<f32> {
        let around = TILE + 2 * MARGIN;
        if self.tiles.len() * around * around >= self.grid.cells() {
            self.of_whole(row)
        } else {
            self.by_tile(row)
        }
    }

    /// The moved cells of a chemical, interpolated by a spline of the whole chemical.
    fn of_whole<'b>(&self, row: impl Fn(usize) -> &'b [f32]) -> Vec<f32> {
        let Grid { size, edges, .. } = *self.grid;
        let mut values = Vec::with_capacity(self.grid.cells());
        (0..size[1]).for_each(|y| values.extend_from_slice(row(y)));
        let whole = Field::new(&Grid::unit(size, edges), values);
        let surface = Spline::new(&whole);
        let moved = |[to, by]: &[[f64; 2]; 2]| {
            let from = [0, 1].map(|axis| to[axis] - by[axis]);
            within_range(surface.at(from), &whole, from)
        };
        self.moves.par_iter().with_min_len(CELLS_AT_ONCE).map(moved).collect()
    }

    /// The moved cells of a chemical, interpolated by one spline per tile.
    fn by_tile<'b>(&self, row: impl Fn(usize) -> &'b [f32] + Sync) -> Vec<f32> {
        let starts = std::iter::once(0).chain(self.tiles.iter().map(|(_, end)| *end));
        let tiles: Vec<_> =
            self.tiles.iter().zip(starts).map(|((at, end), start)| (*at, &self.order[start..*end])).collect();
        let by_tile: Vec<Vec<f32>> =
            tiles.par_iter().map(|(at, order)| self.in_tile(*at, order, &row)).collect();
        let mut moved = vec![0.0; self.moves.len()];
        self.order
            .iter()
            .zip(by_tile.iter().flatten())
            .for_each(|(index, value)| moved[*index as usize] = *value);
        moved
    }

    /// The moved cells whose indices are `order`, in the tile at `at`.
    fn in_tile<'b>(&self, at: [usize; 2], order: &[u32], row: &impl Fn(usize) -> &'b [f32]) -> Vec<f32> {
        let grid = self.grid;
        let moves = || order.iter().map(|index| self.moves[*index as usize]);
        let longest = moves().flat_map(|[_, by]| by).fold(0.0, |most: f64, by| most.max(by.abs()));
        let margin = MARGIN + longest.ceil() as usize;
        let [x, y] = at.map(|tile| (tile * TILE) as isize - margin as isize);
        let side = TILE + 2 * margin;
        let columns: Vec<usize> = (0..side).map(|i| grid.edges.index(x + i as isize, grid.size[0])).collect();
        let mut values = Vec::with_capacity(side * side);
        for i in 0..side {
            let row = row(grid.edges.index(y + i as isize, grid.size[1]));
            values.extend(columns.iter().map(|column| row[*column]));
        }
        let part = Field::new(&Grid::unit([side; 2], Edges::Closed), values);
        let surface = Spline::new(&part);
        let moved = |[to, by]: [[f64; 2]; 2]| {
            let from = [to[0] - x as f64 - by[0], to[1] - y as f64 - by[1]];
            within_range(surface.at(from), &part, from)
        };
        moves().map(moved).collect()
    }
}

/// The rows of `grid` that hold some of `shifts`, which are in the order of the cells, each with the indices of these.
pub(super) fn rows<'a>(
    grid: &'a Grid,
    shifts: &'a [(usize, [f64; 2])],
) -> impl Iterator<Item = (usize, Range<usize>)> + 'a {
    let nx = grid.size[0];
    let mut start = 0;
    std::iter::from_fn(move || {
        let row = shifts.get(start)?.0 / nx;
        let end = start + shifts[start..].partition_point(|(cell, _)| *cell < (row + 1) * nx);
        Some((row, std::mem::replace(&mut start, end)..end))
    })
}

/// The cells whose content moves, with their displacements in the frame of each cell, in the order of the cells.
pub(super) fn shifts<D: Domain>(
    system: System,
    maps: &ParameterField<D>,
    warps: &[LocalWarp<D::Place>],
) -> Vec<(usize, [f64; 2])> {
    let domain = &maps.domain;
    let spot = |LocalWarp { at, own, .. }: &LocalWarp<D::Place>| {
        Nucleus::new(own, domain, domain.cell_at(*at), *at, system.spacing(own)).alone()
    };
    let spots: Vec<Nucleus<D::Place>> = warps.iter().map(spot).collect();
    // Only cells near spots that move can move.
    let mut reached = vec![false; domain.cells()];
    for (warp, spot) in warps.iter().zip(&spots).filter(|(warp, _)| warp.by != [0.0; 2]) {
        let near = domain.runs_near(warp.at, OUTER * spot.reach, 0..domain.cells());
        near.for_each(|(run, _)| reached[run].fill(true));
    }
    let parts: Vec<Vec<(usize, [f64; 2])>> = reached
        .par_chunks(domain.part())
        .enumerate()
        .map(|(part, reached)| shifts_in(maps, warps, &spots, part * domain.part(), reached))
        .collect();
    parts.concat()
}

/// The shifts of the cells from `first` on that are `reached`.
fn shifts_in<D: Domain>(
    maps: &ParameterField<D>,
    warps: &[LocalWarp<D::Place>],
    spots: &[Nucleus<D::Place>],
    first: usize,
    reached: &[bool],
) -> Vec<(usize, [f64; 2])> {
    if !reached.contains(&true) {
        return Vec::new();
    }
    let (domain, cells) = (&maps.domain, first..first + reached.len());
    let mut sums = vec![[0.0f64; 3]; reached.len()];
    let mut shares = Vec::new();
    let may_reach = |spot: &Nucleus<D::Place>| domain.may_reach(spot.at, OUTER * spot.reach, &cells);
    for (warp, spot) in warps.iter().zip(spots).filter(|(_, spot)| may_reach(spot)) {
        for (run, [x, y]) in domain.runs_near(warp.at, OUTER * spot.reach, cells.clone()) {
            let there = &reached[run.start - first..run.end - first];
            let Some(start) = there.iter().position(|reached| *reached) else { continue };
            shares.resize(there.len() - start, [0.0; 2]);
            shares_of(&spot.metric, [x + start as f64, y], &mut shares);
            let by = turned(warp.by, domain.transport_angle(spot.cell, run.start));
            for ([share, moves], cell) in shares.iter().zip(run.start + start..) {
                if reached[cell - first] && !maps.is_obstacle(cell) {
                    let [x, y, total] = &mut sums[cell - first];
                    *x += moves * by[0];
                    *y += moves * by[1];
                    *total += share;
                }
            }
        }
    }
    let moved = cells.zip(sums).filter(|(_, [x, y, _])| *x != 0.0 || *y != 0.0);
    moved.map(|(cell, [x, y, total])| (cell, [x / total, y / total])).collect()
}

/// sₖ and sₖ wₖ at a run of adjacent cells, the first at `displacement` from a spot with this metric; 0 from the outer distance on.
#[multiversion(targets("x86_64+avx2"))]
fn shares_of(metric: &[f64; 3], displacement: [f64; 2], shares: &mut [[f64; 2]]) {
    for (k, share) in shares.iter_mut().enumerate() {
        let [xx, xy, yy] = *metric;
        let [x, y] = [displacement[0] + k as f64, displacement[1]];
        let distance2 = xx * x * x + 2.0 * xy * x * y + yy * y * y;
        let own = if distance2 < OUTER * OUTER { exp(-0.5 * distance2 / (TAU * TAU)) } else { 0.0 };
        *share = [own, own * fading(distance2.sqrt(), [INNER, OUTER])];
    }
}

/// 1 up to the inner distance, 0 from the outer one on, smooth between.
#[inline]
pub(super) fn fading(distance: f64, [inner, outer]: [f64; 2]) -> f64 {
    let t = ((outer - distance) / (outer - inner)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    const P: Parameters = Parameters { rate: 3.0, ratio: 20.0, stretch: 1.0, direction: 0.0, pitch: 1.0 };

    /// The cells of a chemical with these spots moved.
    fn warped(maps: &ParameterField, chemical: &[f32], warps: &[LocalWarp]) -> Vec<f32> {
        let shifts = shifts(System::MEINHARDT_SPOTS, maps, warps);
        let nx = maps.domain.size[0];
        let mut cells = chemical.to_vec();
        let moved = Moves::new(&maps.domain, &shifts).moved(|y| &chemical[y * nx..][..nx]);
        shifts.iter().zip(moved).for_each(|((cell, _), value)| cells[*cell] = value);
        cells
    }

    /// A bell at a place on a ground of 1, on 60 × 50 cells.
    fn bell(at: [f64; 2]) -> Vec<f32> {
        let maps = ParameterField::uniform([60, 50], Edges::Closed, P);
        let cell = |cell| {
            let [x, y] = maps.domain.center(cell);
            let away2 = (x - at[0]) * (x - at[0]) + (y - at[1]) * (y - at[1]);
            1.0 + 5.0 * libm::exp(-0.5 * away2 / 6.0) as f32
        };
        (0..60 * 50).map(cell).collect()
    }

    #[test]
    fn a_moved_spot_is_at_its_new_place_and_everything_else_is_unchanged() {
        for (edges, at) in [(Edges::Closed, [30.0, 25.0]), (Edges::Wrap, [1.0, 25.0])] {
            let maps = ParameterField::uniform([60, 50], edges, P);
            let warp = LocalWarp { at, own: P, by: [1.3, -0.8] };
            let moved = warped(&maps, &bell(at), &[warp]);
            if edges == Edges::Closed {
                let wanted = bell([31.3, 24.2]);
                let worst = moved.iter().zip(&wanted).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(worst < 0.06, "{worst}");
            }
            let still = moved.iter().zip(&bell(at)).filter(|(a, b)| a.to_bits() == b.to_bits()).count();
            assert!(still > 60 * 50 / 2, "{still}");
        }
    }

    #[test]
    fn cells_are_moved_by_the_spline_through_the_whole_chemical() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let maps = ParameterField::uniform([140, 110], edges, P);
            let wave = |cell: usize| {
                let [x, y] = maps.domain.center(cell);
                (2.0 + libm::sin(0.9 * x) * libm::cos(0.7 * y)) as f32
            };
            let chemical: Vec<f32> = (0..140 * 110).map(wave).collect();
            let places = [[2.0, 3.0], [47.0, 50.0], [96.5, 95.0], [139.0, 60.0]];
            let warps = places.map(|at| LocalWarp { at, own: P, by: [0.7, -1.1] });
            let field = Field::new(&Grid::unit(maps.domain.size, edges), chemical.clone());
            let surface = Spline::new(&field);
            let shifts = shifts(System::MEINHARDT_SPOTS, &maps, &warps);
            let moves = Moves::new(&maps.domain, &shifts);
            let row = |y: usize| &chemical[y * 140..][..140];
            assert!(shifts.len() > 500);
            let found = moves.by_tile(row).into_iter().chain(moves.of_whole(row));
            for ((cell, by), found) in shifts.iter().chain(&shifts).zip(found) {
                let to = maps.domain.center(*cell);
                let from = [to[0] - by[0], to[1] - by[1]];
                let expected = within_range(surface.at(from), &field, from);
                assert!((found - expected).abs() < 3e-6, "{edges:?} {cell}: {found} {expected}");
            }
        }
    }

    #[test]
    fn obstacle_cells_are_unchanged() {
        let mut maps = ParameterField::uniform([60, 50], Edges::Closed, P);
        maps.obstacles = (0..60 * 50).map(|cell| cell % 60 > 31).collect();
        let warp = LocalWarp { at: [30.0, 25.0], own: P, by: [1.0, 0.0] };
        let before = bell([30.0, 25.0]);
        let moved = warped(&maps, &before, &[warp]);
        let same = |cell: &usize| moved[*cell].to_bits() == before[*cell].to_bits();
        assert!((0..60 * 50).filter(|cell| maps.obstacles[*cell]).all(|cell| same(&cell)));
        assert!((0..60 * 50).any(|cell| !same(&cell)));
    }
}
