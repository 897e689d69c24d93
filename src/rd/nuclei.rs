//! Where spots begin: points one natural spacing apart.
//!
//! Left to noise, a system needs most of its time to find its own spacing. Points that already keep it, in
//! the metric of the local tensor, save that time and fix the number of spots; the system still moves, shapes
//! and, where there is no room, kills them.
//!
//! Dart throwing, then relaxation by mutual repulsion. Distances are measured by the local metric
//! ds² = (ρ·along² + across²/ρ)/pitch².

use rand::{Rng, RngExt};
use rayon::prelude::*;

use super::System;
use super::maps::{Maps, Parameters};
use crate::field::Edges;

/// One point, in cells, with its local metric.
#[derive(Clone, Copy, Debug)]
pub struct Nucleus {
    /// Position, cells.
    pub at: [f64; 2],
    /// M = [[xx, xy], [xy, yy]] with ds² = Δᵀ M Δ in units of the pitch.
    pub metric: [f64; 3],
    /// Reach of one pitch in any direction, cells.
    pub reach: f64,
}

impl Nucleus {
    /// The point `at`, cells, with the metric of the parameters there.
    pub fn at(maps: &Maps, at: [f64; 2], pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        let p = maps.at(at);
        Self::of(&p, maps.cell, at, pitch(&p))
    }

    /// The point `at`, cells, with the metric of the parameters `p`, whose pitch is `pitch` cells.
    pub fn of(p: &Parameters, cell: [f64; 2], at: [f64; 2], pitch: f64) -> Self {
        let stretch = f64::from(p.stretch);
        let t = super::selling::Tensor::oriented(stretch, 1.0 / stretch, f64::from(p.direction));
        let [cx, cy] = [(cell[0] / cell[1]).sqrt(), (cell[1] / cell[0]).sqrt()];
        let scale = 1.0 / (pitch * pitch);
        let metric = [t.xx * cx * cx * scale, t.xy * scale, t.yy * cy * cy * scale];
        Self { at, metric, reach: 1.05 * pitch / stretch.sqrt() }
    }

    /// Pitches that a cell of the shortest way to a wall across this axis is.
    fn pitches_to_wall(&self, axis: usize) -> f64 {
        let [xx, xy, yy] = self.metric;
        ((xx * yy - xy * xy) / [yy, xx][axis]).sqrt()
    }

    /// Squared distance of a point at `delta` cells from here, in pitches.
    pub fn distance2(&self, [x, y]: [f64; 2]) -> f64 {
        let [xx, xy, yy] = self.metric;
        xx * x * x + 2.0 * xy * x * y + yy * y * y
    }
}

/// Darts closer than this share of the pitch are refused: at 0.70 the wanted density is 81 % of what random
/// darts can reach, so that few darts are wasted.
const DART: f64 = 0.70;
/// Neighbours closer than this share of the pitch push each other: the first ring of a hexagonal lattice.
const PUSH: f64 = 1.25;
/// Rounds of relaxation. Tuned by the spread of the spacing: 0.16 after darts, 0.085 after 30, 0.08 after 100.
const ROUNDS: usize = 30;

/// How far beyond closed edges spots are laid, in reaches of one pitch: what is pushed there does not reach the edge.
const FRAME: f64 = 1.5;
/// Spots nearer to a closed edge than this share of the pitch are put on it. Seen: farther off they grow a tail to it.
const SNAP: f64 = 0.22;
/// Others are held this far from it; nearer they grow a tail too.
const HOLD: f64 = 0.42;

/// Rounds of relaxation around those that stand so.
const WALLED: usize = 10;

/// Points that are not worth handing to another thread.
const FEW: usize = 128;

/// Points that were laid.
pub struct Laid {
    /// Those on the grid.
    pub inside: Vec<Nucleus>,
    /// Beyond closed edges, those that keep the others from spreading over them.
    pub beyond: Vec<Nucleus>,
}

/// Points over the whole grid whose neighbours stand `pitch(parameters)` cells apart.
///
/// At closed edges as if the pattern went on beyond them: they are laid over a frame too, which is cut off.
pub fn lay(
    maps: &Maps,
    edges: Edges,
    pitch: &(dyn Fn(&Parameters) -> f64 + Sync),
    rng: &mut impl Rng,
) -> Laid {
    let crowd = Crowd::of(maps, pitch);
    let frame = if edges == Edges::Closed { (FRAME * crowd.largest).ceil() } else { 0.0 };
    let size = [maps.nx as f64, maps.ny as f64];
    let space = Space { size: size.map(|side| side + 2.0 * frame), edges: Edges::Wrap };
    let on_maps = |at: [f64; 2]| at.map(|v| v - frame);
    let nucleus = |at: [f64; 2]| Nucleus { at, ..Nucleus::at(maps, on_maps(at), pitch) };
    let wanted = crowd.wanted(frame);

    let mut placed = Buckets::new(space, PUSH * crowd.largest);
    let mut closest = DART;
    let mut refused = 0;
    while placed.all.len() < wanted {
        let at = [rng.random::<f64>() * space.size[0], rng.random::<f64>() * space.size[1]];
        if rng.random::<f64>() * crowd.densest > crowd.densities[maps.cell_at(on_maps(at))] {
            continue;
        }
        let dart = nucleus(at);
        let mut free = true;
        placed.near(&dart, DART, |other, delta| free &= distance2(&dart, other, delta) >= closest * closest);
        if free {
            placed.insert(dart);
            refused = 0;
        } else {
            refused += 1;
            if refused > 1_000 {
                closest *= 0.95;
                refused = 0;
            }
        }
    }
    for _ in 0..ROUNDS {
        relax(&mut placed, PUSH, &|_, at| nucleus(at));
    }
    let grid = Grid { frame, size };
    if edges == Edges::Closed {
        grid.keep_off_walls(&mut placed, |placed| relax(placed, PUSH, &|_, at| nucleus(at)));
    }
    let mut all = placed.all;
    all.iter_mut().for_each(|point| point.at = on_maps(point.at));
    if edges == Edges::Wrap {
        return Laid { inside: all, beyond: Vec::new() };
    }
    let inside = |point: &Nucleus| (0..2).all(|axis| (0.0..size[axis]).contains(&point.at[axis]));
    let (mut inside, beyond): (Vec<_>, Vec<_>) = all.into_iter().partition(inside);
    if inside.is_empty() {
        // A canvas that is smaller than the room of one spot still shows one.
        inside.push(Nucleus::at(maps, size.map(|side| 0.5 * side), pitch));
    }
    Laid { inside, beyond }
}

/// A grid with closed edges amid the frame over which points are laid, cells.
struct Grid {
    frame: f64,
    size: [f64; 2],
}

impl Grid {
    /// Near a wall a spot cannot keep its shape. One on the wall is half a spot, cut by the edge; nearer than [`HOLD`] it
    /// would be drawn out to the wall. So those that are near are moved, once and for all, and the others `relax` around
    /// them.
    fn keep_off_walls(&self, placed: &mut Buckets, mut relax: impl FnMut(&mut Buckets)) {
        let on_walls: Vec<[Option<f64>; 2]> =
            placed.all.iter().map(|point| [0, 1].map(|axis| self.wall_under(point, axis))).collect();
        for _ in 0..WALLED {
            relax(placed);
            placed.moved(|index, point| {
                [0, 1].map(|axis| on_walls[index][axis].unwrap_or_else(|| self.held(point, axis)))
            });
        }
    }

    /// The walls along one axis with the way inward.
    fn walls(&self, axis: usize) -> [(f64, f64); 2] {
        [(self.frame, 1.0), (self.frame + self.size[axis] * (1.0 - 1e-12), -1.0)]
    }

    /// The wall that a point is so near to that it is put on it.
    fn wall_under(&self, point: &Nucleus, axis: usize) -> Option<f64> {
        let near =
            |(wall, _): &(f64, f64)| (point.at[axis] - wall).abs() * point.pitches_to_wall(axis) < SNAP;
        self.walls(axis).into_iter().find(near).map(|(wall, _)| wall)
    }

    /// Where a point that is on no wall may stand: on the side that it is on, as far off as it must.
    fn held(&self, point: &Nucleus, axis: usize) -> f64 {
        let far = HOLD / point.pitches_to_wall(axis);
        let hold = |at: f64, (wall, inward): (f64, f64)| match (at - wall) * inward {
            away if away <= 0.0 => at,
            away => wall + inward * away.max(far),
        };
        self.walls(axis).into_iter().fold(point.at[axis], hold)
    }
}

/// Where the points `laid` come to stand in `rounds` rounds of mutual repulsion, each with the pitch and the metric of
/// its `own` parameters; those farther than `reach` pitches do not push each other. Those beyond the edges stay.
#[must_use]
pub fn make_room(
    system: System,
    maps: &Maps,
    edges: Edges,
    laid: &Places,
    own: &[Parameters],
    reach: f64,
    rounds: usize,
) -> Vec<[f64; 2]> {
    let at = &laid.inside;
    let nucleus = |i: usize, at: [f64; 2]| Nucleus::of(&own[i], maps.cell, at, system.spacing(&own[i]));
    let largest = (0..at.len()).map(|i| nucleus(i, at[i]).reach).fold(0.0, f64::max);
    let frame = if edges == Edges::Closed { (FRAME * largest).ceil() } else { 0.0 };
    let size = [maps.nx as f64, maps.ny as f64];
    let space = Space { size: size.map(|side| side + 2.0 * frame), edges: Edges::Wrap };
    let framed = |at: [f64; 2]| space.folded(at.map(|v| v + frame));
    let pitch = |p: &Parameters| system.spacing(p);
    let beyond = laid.beyond.iter().filter(|at| (0..2).all(|i| (-frame..size[i] + frame).contains(&at[i])));
    let beyond: Vec<Nucleus> =
        beyond.map(|at| Nucleus { at: framed(*at), ..Nucleus::at(maps, *at, &pitch) }).collect();
    let moved = |i: usize, at: [f64; 2]| if i < own.len() { nucleus(i, at) } else { beyond[i - own.len()] };
    let mut placed = Buckets::new(space, PUSH.max(reach) * largest);
    at.iter().enumerate().for_each(|(i, at)| placed.insert(nucleus(i, framed(*at))));
    beyond.iter().for_each(|point| placed.insert(*point));
    for _ in 0..rounds {
        relax(&mut placed, reach, &moved);
    }
    if edges == Edges::Closed {
        Grid { frame, size }.keep_off_walls(&mut placed, |placed| relax(placed, reach, &moved));
    }
    let stands = |point: &Nucleus| [0, 1].map(|i| (point.at[i] - frame).clamp(0.0, size[i] * (1.0 - 1e-12)));
    placed.all[..own.len()].iter().map(stands).collect()
}

/// Places of points, cells: those on the grid, and those beyond closed edges, which keep the others from spreading over
/// them.
#[derive(Clone, Debug, Default)]
pub struct Places {
    /// On the grid.
    pub inside: Vec<[f64; 2]>,
    /// Beyond closed edges.
    pub beyond: Vec<[f64; 2]>,
}

/// How crowded the grid will be.
struct Crowd {
    /// Points a cell, by cell.
    densities: Vec<f64>,
    /// Cells in a row.
    columns: usize,
    densest: f64,
    /// The farthest that a pitch reaches, cells.
    largest: f64,
}

impl Crowd {
    fn of(maps: &Maps, pitch: &(dyn Fn(&Parameters) -> f64 + Sync)) -> Self {
        let rows: Vec<(Vec<f64>, f64)> = maps
            .parameters
            .par_chunks(maps.nx)
            .map(|row| {
                let (mut before, mut here, mut largest) = (None, 0.0, 0.0f64);
                let densities = row
                    .iter()
                    .map(|p| {
                        // Mostly the same as beside it.
                        if before != Some(p) {
                            let pitch = pitch(p);
                            // A hexagonal lattice of pitch 1 has 2/√3 points a unit area.
                            here = 2.0 / (3.0f64.sqrt() * pitch * pitch);
                            largest = largest.max(1.05 * pitch / f64::from(p.stretch).sqrt());
                            before = Some(p);
                        }
                        here
                    })
                    .collect();
                (densities, largest)
            })
            .collect();
        let largest = rows.iter().map(|(_, largest)| *largest).fold(0.0, f64::max);
        let densities: Vec<f64> = rows.into_iter().flat_map(|(row, _)| row).collect();
        let densest = densities.iter().copied().fold(0.0, f64::max);
        Self { densities, columns: maps.nx, densest, largest }
    }

    /// Points in all, those over a frame of so many cells too: it is as crowded as the border beside it.
    fn wanted(&self, frame: f64) -> usize {
        let row = |row: &[f64]| {
            let ends = row.first().zip(row.last()).map_or(0.0, |(first, last)| first + last);
            row.iter().sum::<f64>() + frame * ends
        };
        let mut rows = self.densities.chunks_exact(self.columns);
        let ends = rows.clone().next().zip(rows.clone().next_back());
        let ends = ends.map_or(0.0, |(first, last)| row(first) + row(last));
        (rows.by_ref().map(row).sum::<f64>() + frame * ends).round().max(1.0) as usize
    }
}

/// Those of `laid` that have room among those before them, where they are `crowded`.
pub fn thinned(
    laid: Vec<Nucleus>,
    maps: &Maps,
    edges: Edges,
    crowded: &dyn Fn(&Nucleus) -> bool,
) -> Vec<Nucleus> {
    let (rest, roomy): (Vec<_>, Vec<_>) = laid.into_iter().partition(crowded);
    if rest.is_empty() {
        return roomy;
    }
    let space = Space { size: [maps.nx as f64, maps.ny as f64], edges };
    let largest = roomy.iter().chain(&rest).map(|nucleus| nucleus.reach).fold(0.0, f64::max);
    let mut kept = Buckets::new(space, PUSH * largest);
    roomy.into_iter().for_each(|nucleus| kept.insert(nucleus));
    for nucleus in rest {
        let mut free = true;
        kept.near(&nucleus, DART, |other, delta| free &= distance2(&nucleus, other, delta) >= DART * DART);
        if free {
            kept.insert(nucleus);
        }
    }
    kept.all
}

fn relax(placed: &mut Buckets, reach: f64, nucleus: &(dyn Fn(usize, [f64; 2]) -> Nucleus + Sync)) {
    let moved = |(index, point): (usize, &Nucleus)| {
        let mut shift = [0.0, 0.0];
        placed.near(point, reach, |other, delta| {
            let own = point.distance2(delta);
            // Too far by half of the mean already.
            if 0.5 * own >= reach * reach {
                return;
            }
            let d = (0.5 * (own + other.distance2(delta))).sqrt();
            if d > 1e-9 && d < reach {
                // Half of the gap to the reach, shared with the other, damped for six neighbours.
                let push = 0.22 * (reach - d) / d;
                shift[0] -= push * delta[0];
                shift[1] -= push * delta[1];
            }
        });
        nucleus(index, placed.space.folded([point.at[0] + shift[0], point.at[1] + shift[1]]))
    };
    let all: Vec<Nucleus> = placed.all.par_iter().enumerate().with_min_len(FEW).map(moved).collect();
    placed.replace(all);
}

/// Squared distance in pitches, by the mean of both metrics.
fn distance2(a: &Nucleus, b: &Nucleus, delta: [f64; 2]) -> f64 {
    0.5 * (a.distance2(delta) + b.distance2(delta))
}

#[derive(Clone, Copy)]
struct Space {
    size: [f64; 2],
    edges: Edges,
}

impl Space {
    /// Inside the grid: mirrored at closed edges, carried round on wrapped ones.
    fn folded(&self, at: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|i| {
            let n = self.size[i];
            let v = match self.edges {
                Edges::Wrap => at[i].rem_euclid(n),
                Edges::Closed => {
                    let v = at[i].rem_euclid(2.0 * n);
                    if v > n { 2.0 * n - v } else { v }
                }
            };
            v.clamp(0.0, n * (1.0 - 1e-12))
        })
    }
}

/// Points by place, so that neighbours are found without asking all.
struct Buckets {
    space: Space,
    columns: usize,
    rows: usize,
    all: Vec<Nucleus>,
    cells: Vec<Vec<u32>>,
}

impl Buckets {
    fn new(space: Space, reach: f64) -> Self {
        let count = |n: f64| ((n / reach) as usize).max(1);
        let (columns, rows) = (count(space.size[0]), count(space.size[1]));
        Self { space, columns, rows, all: Vec::new(), cells: vec![Vec::new(); columns * rows] }
    }

    fn bucket(&self, at: [f64; 2]) -> [isize; 2] {
        [
            ((at[0] / self.space.size[0] * self.columns as f64) as usize).min(self.columns - 1) as isize,
            ((at[1] / self.space.size[1] * self.rows as f64) as usize).min(self.rows - 1) as isize,
        ]
    }

    /// The same points elsewhere.
    fn moved(&mut self, to: impl Fn(usize, &Nucleus) -> [f64; 2]) {
        let all = self.all.iter().enumerate();
        let all = all.map(|(index, point)| Nucleus { at: to(index, point), ..*point }).collect();
        self.replace(all);
    }

    fn replace(&mut self, all: Vec<Nucleus>) {
        self.all.clear();
        self.cells.iter_mut().for_each(Vec::clear);
        all.into_iter().for_each(|point| self.insert(point));
    }

    fn insert(&mut self, point: Nucleus) {
        let [column, row] = self.bucket(point.at);
        self.cells[row as usize * self.columns + column as usize].push(self.all.len() as u32);
        self.all.push(point);
    }

    /// Calls `each(other, other − point)` for every point, or image of one beyond the border (its own too),
    /// that can lie within `pitches` of `point`; and for some farther ones.
    fn near(&self, point: &Nucleus, pitches: f64, mut each: impl FnMut(&Nucleus, [f64; 2])) {
        let [column, row] = self.bucket(point.at);
        let reach = pitches * point.reach * 1.5;
        let [w, h] = self.space.size;
        for dy in -1..=1 {
            for dx in -1..=1 {
                let (c, sx) = image(column + dx, self.columns, self.space.edges, w);
                let (r, sy) = image(row + dy, self.rows, self.space.edges, h);
                let beyond = |i: isize, n: usize| i < 0 || i >= n as isize;
                let mirrored = [beyond(column + dx, self.columns), beyond(row + dy, self.rows)];
                for &other in &self.cells[r * self.columns + c] {
                    let other = &self.all[other as usize];
                    let seen = [sx(other.at[0]), sy(other.at[1])];
                    let delta = [seen[0] - point.at[0], seen[1] - point.at[1]];
                    // The image of a point on the wall is that point, and counts once.
                    let twice = |axis: usize| mirrored[axis] && (seen[axis] - other.at[axis]).abs() < 1e-6;
                    let twice = twice(0) || twice(1);
                    let itself = dx == 0 && dy == 0 && delta == [0.0, 0.0];
                    if !itself && !twice && delta[0].abs() <= reach && delta[1].abs() <= reach {
                        each(other, delta);
                    }
                }
            }
        }
    }
}

/// The bucket that stands for bucket `i` of `n`, and where a coordinate of it is seen from there.
fn image(i: isize, n: usize, edges: Edges, size: f64) -> (usize, impl Fn(f64) -> f64) {
    let beyond = if i < 0 {
        -1.0
    } else if i >= n as isize {
        1.0
    } else {
        0.0
    };
    let mirrored = edges == Edges::Closed && beyond != 0.0;
    let index = edges.index(i, n);
    (index, move |v: f64| match (mirrored, beyond) {
        (true, -1.0) => -v,
        (true, _) => 2.0 * size - v,
        (false, b) => v + b * size,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    fn placed(edges: Edges, stretch: f32) -> Vec<Nucleus> {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch, direction: 20.0, pitch: 1.0 };
        let maps = Maps::uniform(240, 200, p);
        lay(&maps, edges, &|_| 14.0, &mut Pcg64Mcg::seed_from_u64(5)).inside
    }

    #[test]
    fn as_many_are_placed_as_a_hexagonal_lattice_of_the_pitch_would_have() {
        for edges in [Edges::Closed, Edges::Wrap] {
            for stretch in [1.0, 0.4] {
                let wanted = (240.0 * 200.0 / (14.0 * 14.0 * 0.866_025_4)) as usize + 1;
                // Closed edges cut through spots: those on them are half in.
                let (found, cut) = match edges {
                    Edges::Wrap => (placed(edges, stretch).len(), 0),
                    Edges::Closed => (placed(edges, stretch).len(), 24),
                };
                assert!(found.abs_diff(wanted) <= cut, "{found} of {wanted}");
            }
        }
    }

    #[test]
    fn the_smallest_canvas_has_a_spot() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.5, direction: 90.0, pitch: 1.0 };
        for edges in [Edges::Closed, Edges::Wrap] {
            for seed in 0..20 {
                let maps = Maps::uniform(8, 8, p);
                let laid = lay(&maps, edges, &|_| 40.0, &mut Pcg64Mcg::seed_from_u64(seed));
                let on = |at: f64| (0.0..8.0).contains(&at);
                assert!(!laid.inside.is_empty() && laid.inside.iter().all(|p| on(p.at[0]) && on(p.at[1])));
            }
        }
    }

    #[test]
    fn near_closed_edges_they_stand_on_them_or_well_off() {
        let p = Parameters { rate: 1.0, ratio: 20.0, stretch: 0.5, direction: 90.0, pitch: 1.0 };
        let maps = Maps::uniform(240, 200, p);
        let all = lay(&maps, Edges::Closed, &|_| 14.0, &mut Pcg64Mcg::seed_from_u64(5)).inside;
        // Upright marks of half the width: the metric is (ρ·along² + across²/ρ)/pitch².
        let off = |at: f64, side: f64, pitch: f64| at.min(side - at) / pitch;
        let (mut on, mut inside) = (0, 0);
        for point in &all {
            for away in
                [off(point.at[0], 240.0, 14.0 * 0.5f64.sqrt()), off(point.at[1], 200.0, 14.0 / 0.5f64.sqrt())]
            {
                assert!(!(1e-9..=HOLD - 1e-9).contains(&away), "{away}");
                on += usize::from(away < 1e-9);
                inside += usize::from(away > 1.0);
            }
        }
        assert!(on > 10 && inside > 2 * on, "{on} {inside}");
    }

    #[test]
    fn they_keep_their_distance_by_the_local_metric() {
        for stretch in [1.0, 0.4] {
            let all = placed(Edges::Wrap, stretch);
            let closest = |a: &Nucleus| {
                let others = all.iter().filter(|b| b.at != a.at);
                let deltas = others.map(|b| {
                    [0, 1].map(|i| {
                        let n = [240.0, 200.0][i];
                        let d: f64 = b.at[i] - a.at[i];
                        d - n * (d / n).round()
                    })
                });
                deltas.map(|d| a.distance2(d).sqrt()).fold(f64::INFINITY, f64::min)
            };
            let distances: Vec<f64> = all.iter().map(closest).collect();
            let mean = distances.iter().sum::<f64>() / distances.len() as f64;
            let least = distances.iter().copied().fold(f64::INFINITY, f64::min);
            assert!(mean > 0.85 && least > 0.6, "stretch {stretch}: mean {mean}, least {least}");
        }
    }
}
