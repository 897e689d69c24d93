//! In which order to draw paths, so that the pen travels little in the air.
//!
//! First always the nearest that is left (closed paths may begin at any of their knots, open ones at either end), then
//! stretches of the way are turned round and single paths moved as long as that shortens it (2-opt and or-opt; Croes
//! 1958, Or 1976), at last closed paths begin where the way past them is shortest.

use super::path::{Path, distance};

/// Knots of a closed path at which the nearest is looked for.
const KNOTS: usize = 8;
/// Pairs of places that a round of improvement looks at, at most; so a hundred thousand hatch strokes take seconds.
const PAIRS: usize = 20_000_000;
/// Rounds of improvement.
const ROUNDS: usize = 12;

/// A way through paths.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The index of each path, in the order of drawing.
    pub order: Vec<usize>,
    /// The paths in that order, turned round or begun elsewhere.
    pub paths: Vec<Path>,
}

/// How far a pen that begins at `from` travels in the air between `paths`, px.
#[must_use]
pub fn travel(from: [f64; 2], paths: &[Path]) -> f64 {
    let mut pen = from;
    paths.iter().map(|path| distance(std::mem::replace(&mut pen, path.end()), path.start)).sum()
}

/// A visit to a path: where the pen comes down and where it goes up.
#[derive(Clone, Copy)]
struct Visit {
    path: usize,
    /// Pieces of a closed path that come last; of an open one 1 = turned round.
    turned: usize,
    begin: [f64; 2],
    end: [f64; 2],
}

impl Visit {
    fn reversed(self, closed: bool) -> Self {
        if closed { self } else { Self { turned: 1 - self.turned, begin: self.end, end: self.begin, ..self } }
    }
}

/// A short way through `paths` for a pen that begins at `from`; never a longer one than in the order given.
#[must_use]
pub fn route(paths: Vec<Path>, from: [f64; 2]) -> Route {
    let mut visits = nearest_first(&paths, from);
    for _ in 0..ROUNDS {
        let shorter = turn_stretches(&mut visits, &paths, from) | move_single(&mut visits, from);
        begin_best(&mut visits, &paths, from);
        if !shorter {
            break;
        }
    }
    let drawn: Vec<Path> = visits.iter().map(|visit| visited(&paths[visit.path], visit)).collect();
    if travel(from, &drawn) > travel(from, &paths) {
        return Route { order: (0..paths.len()).collect(), paths };
    }
    Route { order: visits.iter().map(|visit| visit.path).collect(), paths: drawn }
}

fn visited(path: &Path, visit: &Visit) -> Path {
    match (path.closed, visit.turned) {
        (true, first) => path.clone().begun_after(first),
        (false, 0) => path.clone(),
        (false, _) => path.reversed(),
    }
}

/// The ways to begin a path, all or of a closed one only so many.
fn beginnings(path: &Path, most: usize) -> Vec<(usize, [f64; 2], [f64; 2])> {
    if !path.closed {
        return vec![(0, path.start, path.end()), (1, path.end(), path.start)];
    }
    let n = path.pieces.len();
    let steps = n.min(most).max(1);
    let knots = (0..steps).map(|i| i * n / steps);
    knots
        .map(|first| {
            let at = if first == 0 { path.start } else { path.pieces[first - 1].end() };
            (first, at, at)
        })
        .collect()
}

/// Squares over the canvas, and in each the beginnings that lie in it.
struct Squares {
    corner: [f64; 2],
    side: f64,
    across: [usize; 2],
    visits: Vec<Vec<Visit>>,
}

impl Squares {
    fn of(visits: Vec<Visit>) -> Self {
        let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
            visits.iter().map(|visit| visit.begin[axis]).fold(start, pick)
        };
        let corner = [0, 1].map(|axis| bound(axis, f64::min, f64::MAX));
        let extent = [0, 1].map(|axis| bound(axis, f64::max, f64::MIN) - corner[axis]);
        // About two beginnings in each.
        let side = (extent[0] * extent[1] / (0.5 * visits.len() as f64)).sqrt();
        let side = side.max(extent[0].max(extent[1]) / 1000.0).max(f64::MIN_POSITIVE);
        let across = extent.map(|extent| (extent / side) as usize + 1);
        let mut squares = Self { corner, side, across, visits: vec![Vec::new(); across[0] * across[1]] };
        for visit in visits {
            let [x, y] = squares.square(visit.begin);
            squares.visits[y * across[0] + x].push(visit);
        }
        squares
    }

    fn square(&self, at: [f64; 2]) -> [usize; 2] {
        [0, 1].map(|axis| {
            (((at[axis] - self.corner[axis]) / self.side).max(0.0) as usize).min(self.across[axis] - 1)
        })
    }

    /// The nearest beginning of a path that is not `used`, looked for in ever wider rings of squares.
    fn nearest(&mut self, pen: [f64; 2], used: &[bool]) -> Option<Visit> {
        let [cx, cy] = self.square(pen).map(|c| c as isize);
        let mut best: Option<(f64, Visit)> = None;
        for reach in 0..self.across[0].max(self.across[1]) as isize {
            if best.is_some_and(|(off, _)| off < (reach - 1) as f64 * self.side) {
                break;
            }
            for y in cy - reach..=cy + reach {
                let step = if (y - cy).abs() == reach { 1 } else { (2 * reach).max(1) };
                let mut x = cx - reach;
                while x <= cx + reach {
                    self.look([x, y], pen, used, &mut best);
                    x += step;
                }
            }
        }
        best.map(|(_, visit)| visit)
    }

    fn look(&mut self, [x, y]: [isize; 2], pen: [f64; 2], used: &[bool], best: &mut Option<(f64, Visit)>) {
        let [nx, ny] = self.across.map(|n| n as isize);
        if x < 0 || y < 0 || x >= nx || y >= ny {
            return;
        }
        let square = &mut self.visits[(y * nx + x) as usize];
        square.retain(|visit| !used[visit.path]);
        for visit in square {
            let off = distance(pen, visit.begin);
            if best.is_none_or(|(least, _)| off < least) {
                *best = Some((off, *visit));
            }
        }
    }
}

fn nearest_first(paths: &[Path], from: [f64; 2]) -> Vec<Visit> {
    let all = paths.iter().enumerate().flat_map(|(path, drawn)| {
        let visit = move |(turned, begin, end)| Visit { path, turned, begin, end };
        beginnings(drawn, KNOTS).into_iter().map(visit)
    });
    let mut squares = Squares::of(all.collect());
    let mut used = vec![false; paths.len()];
    let mut visits: Vec<Visit> = Vec::with_capacity(paths.len());
    let mut pen = from;
    while let Some(visit) = squares.nearest(pen, &used) {
        used[visit.path] = true;
        pen = visit.end;
        visits.push(visit);
    }
    visits
}

/// How many places further on a round looks.
fn window(n: usize) -> usize {
    (PAIRS / n.max(1)).clamp(50, 100_000)
}

/// Gains below this are rounding, px.
const GAIN: f64 = 1e-9;

/// 2-opt: a stretch from i to j is drawn the other way round where that is shorter.
fn turn_stretches(visits: &mut [Visit], paths: &[Path], from: [f64; 2]) -> bool {
    let (n, mut shorter) = (visits.len(), false);
    for i in 0..n {
        for j in i..n.min(i + window(n)) {
            let before = if i == 0 { from } else { visits[i - 1].end };
            let old = distance(before, visits[i].begin);
            let new = distance(before, visits[j].end);
            let tail = |end: [f64; 2]| visits.get(j + 1).map_or(0.0, |next| distance(end, next.begin));
            if new + tail(visits[i].begin) + GAIN < old + tail(visits[j].end) {
                visits[i..=j].reverse();
                for visit in &mut visits[i..=j] {
                    *visit = visit.reversed(paths[visit.path].closed);
                }
                shorter = true;
            }
        }
    }
    shorter
}

/// Or-opt: a single path is drawn later or earlier where that is shorter.
fn move_single(visits: &mut [Visit], from: [f64; 2]) -> bool {
    let (n, mut shorter) = (visits.len(), false);
    for i in 0..n {
        let end = |k: usize, visits: &[Visit]| if k == 0 { from } else { visits[k - 1].end };
        let visit = visits[i];
        let after = |k: usize, end: [f64; 2], visits: &[Visit]| {
            visits.get(k).map_or(0.0, |next| distance(end, next.begin))
        };
        let saved = distance(end(i, visits), visit.begin) + after(i + 1, visit.end, visits)
            - after(i + 1, end(i, visits), visits);
        let half = window(n) / 2;
        let mut best = (GAIN, None);
        for k in i.saturating_sub(half)..=n.min(i + half) {
            if k == i || k == i + 1 {
                continue;
            }
            let (before, cost) = (end(k, visits), after(k, visit.end, visits));
            let gain = saved - (distance(before, visit.begin) + cost - after(k, before, visits));
            if gain > best.0 {
                best = (gain, Some(k));
            }
        }
        match best.1 {
            Some(k) if k > i => visits[i..k].rotate_left(1),
            Some(k) => visits[k..=i].rotate_right(1),
            None => continue,
        }
        shorter = true;
    }
    shorter
}

/// Each path begins where the way from the one before and to the next is shortest.
fn begin_best(visits: &mut [Visit], paths: &[Path], from: [f64; 2]) {
    let mut pen = from;
    for i in 0..visits.len() {
        let next = visits.get(i + 1).map(|next| next.begin);
        let way = |begin: [f64; 2], end: [f64; 2]| {
            distance(pen, begin) + next.map_or(0.0, |next| distance(end, next))
        };
        let Visit { path, begin, end, .. } = visits[i];
        let mut least = way(begin, end);
        for (turned, begin, end) in beginnings(&paths[path], usize::MAX) {
            if way(begin, end) < least {
                least = way(begin, end);
                visits[i] = Visit { path, turned, begin, end };
            }
        }
        pen = visits[i].end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::outline::path::Piece;
    use proptest::prelude::*;

    fn square([x, y]: [f64; 2], side: f64) -> Path {
        let corners = [[x + side, y], [x + side, y + side], [x, y + side], [x, y]];
        Path { start: [x, y], pieces: corners.map(Piece::Line).to_vec(), closed: true }
    }

    #[test]
    fn strokes_to_and_fro_are_drawn_without_a_detour() {
        let strokes: Vec<Path> =
            (0..9).map(|i| Path::stroke([0.0, f64::from(i)], [100.0, f64::from(i)])).collect();
        let way = route(strokes.iter().rev().cloned().collect(), [0.0, 0.0]);
        assert_eq!(travel([0.0, 0.0], &way.paths), 8.0);
        assert_eq!(way.order, [8, 7, 6, 5, 4, 3, 2, 1, 0]);
    }

    #[test]
    fn a_closed_path_begins_on_the_side_where_the_pen_is() {
        let way = route(vec![square([10.0, 10.0], 5.0), square([30.0, 10.0], 5.0)], [20.0, 10.0]);
        assert_eq!((way.paths[0].start, way.paths[1].start), ([15.0, 10.0], [30.0, 10.0]));
    }

    proptest! {
        #[test]
        fn every_path_is_drawn_once_and_no_way_is_longer(
            ends in prop::collection::vec([0.0..100.0, 0.0..100.0, 0.0..100.0, 0.0..100.0f64], 0..60),
            squares in prop::collection::vec([0.0..100.0, 0.0..100.0f64], 0..30),
        ) {
            let mut paths: Vec<Path> =
                ends.iter().map(|[a, b, c, d]| Path::stroke([*a, *b], [*c, *d])).collect();
            paths.extend(squares.iter().map(|corner| square(*corner, 3.0)));
            let before = travel([0.0, 0.0], &paths);
            let way = route(paths.clone(), [0.0, 0.0]);
            prop_assert!(travel([0.0, 0.0], &way.paths) <= before);
            let mut order = way.order.clone();
            order.sort_unstable();
            prop_assert_eq!(order, (0..paths.len()).collect::<Vec<_>>());
            for (index, path) in way.order.iter().zip(&way.paths) {
                let ends = [path.start, path.end()];
                let given = [paths[*index].start, paths[*index].end()];
                prop_assert!(path.closed || ends == given || ends == [given[1], given[0]]);
                prop_assert!(path.closed == paths[*index].closed);
                prop_assert!((path.length() - paths[*index].length()).abs() < 1e-9);
            }
        }
    }
}
