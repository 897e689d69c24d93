//! The order in which to draw paths, so that the pen travels little in the air.
//!
//! First the nearest remaining path is taken, again and again (closed paths may start at any of their knots, open ones at either
//! end). Then stretches of the route are reversed and single paths moved while that shortens it (2-opt and or-opt; Croes 1958, Or
//! 1976). At last the start of each closed path is moved to the point where the route is shortest.

use kurbo::{BezPath, Point};

use super::path::{end, is_closed, pieces, start, started_after};

/// Number of knots of a closed path that are tried when the nearest path is searched.
const KNOTS: usize = 8;
/// Largest number of pairs of places tried in a round of improvement, so that a hundred thousand hatch strokes take seconds.
const PAIRS: usize = 20_000_000;
/// Rounds of improvement.
const ROUNDS: usize = 12;

/// An order of paths.
#[derive(Clone, Debug, PartialEq)]
pub struct Route {
    /// The index of each path, in the order of drawing.
    pub order: Vec<usize>,
    /// The paths in that order, some reversed or started elsewhere.
    pub paths: Vec<BezPath>,
}

/// Distance that a pen that starts at `from` travels in the air between `paths`, px.
#[must_use]
pub fn travel(from: Point, paths: &[BezPath]) -> f64 {
    let mut pen = from;
    paths.iter().map(|path| std::mem::replace(&mut pen, end(path)).distance(start(path))).sum()
}

/// A visit to a path: where the pen is lowered and where it is lifted.
#[derive(Clone, Copy)]
struct Visit {
    path: usize,
    /// For a closed path, the number of pieces after which it starts; for an open one, 1 if it is reversed, otherwise 0.
    turned: usize,
    begin: Point,
    end: Point,
}

impl Visit {
    fn reversed(self, closed: bool) -> Self {
        if closed { self } else { Self { turned: 1 - self.turned, begin: self.end, end: self.begin, ..self } }
    }
}

/// A short route through `paths` for a pen that starts at `from`; never longer than the given order.
#[must_use]
pub fn route(paths: Vec<BezPath>, from: Point) -> Route {
    let mut visits = nearest_first(&paths, from);
    for _ in 0..ROUNDS {
        let shorter = reverse_stretches(&mut visits, &paths, from) | move_single(&mut visits, from);
        choose_starts(&mut visits, &paths, from);
        if !shorter {
            break;
        }
    }
    let drawn: Vec<BezPath> = visits.iter().map(|visit| visited(&paths[visit.path], visit)).collect();
    if travel(from, &drawn) > travel(from, &paths) {
        return Route { order: (0..paths.len()).collect(), paths };
    }
    Route { order: visits.iter().map(|visit| visit.path).collect(), paths: drawn }
}

fn visited(path: &BezPath, visit: &Visit) -> BezPath {
    match (is_closed(path), visit.turned) {
        (true, first) => started_after(path.clone(), first),
        (false, 0) => path.clone(),
        (false, _) => path.reverse_subpaths(),
    }
}

/// The possible starts of a path: `turned`, start and end of a [`Visit`]. At most `most` for a closed path.
fn starts(path: &BezPath, most: usize) -> Vec<(usize, Point, Point)> {
    if !is_closed(path) {
        return vec![(0, start(path), end(path)), (1, end(path), start(path))];
    }
    let pieces = pieces(path);
    let steps = pieces.len().min(most).max(1);
    let knots = (0..steps).map(|i| i * pieces.len() / steps);
    knots
        .map(|first| {
            let knot = first.checked_sub(1).and_then(|last| pieces[last].end_point());
            let at = knot.unwrap_or_else(|| start(path));
            (first, at, at)
        })
        .collect()
}

/// Squares over the canvas, each with the visits that start in it.
struct Squares {
    corner: [f64; 2],
    side: f64,
    across: [usize; 2],
    visits: Vec<Vec<Visit>>,
}

impl Squares {
    fn new(visits: Vec<Visit>) -> Self {
        let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
            visits.iter().map(|visit| coordinates(visit.begin)[axis]).fold(start, pick)
        };
        let corner = [0, 1].map(|axis| bound(axis, f64::min, f64::MAX));
        let extent = [0, 1].map(|axis| bound(axis, f64::max, f64::MIN) - corner[axis]);
        // About two visits in each square.
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

    fn square(&self, at: Point) -> [usize; 2] {
        let at = coordinates(at);
        [0, 1].map(|axis| {
            (((at[axis] - self.corner[axis]) / self.side).max(0.0) as usize).min(self.across[axis] - 1)
        })
    }

    /// The nearest start of a path that is not `used`, searched in larger and larger rings of squares.
    fn nearest(&mut self, pen: Point, used: &[bool]) -> Option<Visit> {
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

    fn look(&mut self, [x, y]: [isize; 2], pen: Point, used: &[bool], best: &mut Option<(f64, Visit)>) {
        let [nx, ny] = self.across.map(|n| n as isize);
        if x < 0 || y < 0 || x >= nx || y >= ny {
            return;
        }
        let square = &mut self.visits[(y * nx + x) as usize];
        square.retain(|visit| !used[visit.path]);
        for visit in square {
            let off = pen.distance(visit.begin);
            if best.is_none_or(|(least, _)| off < least) {
                *best = Some((off, *visit));
            }
        }
    }
}

fn coordinates(point: Point) -> [f64; 2] {
    [point.x, point.y]
}

fn nearest_first(paths: &[BezPath], from: Point) -> Vec<Visit> {
    let all = paths.iter().enumerate().flat_map(|(path, drawn)| {
        let visit = move |(turned, begin, end)| Visit { path, turned, begin, end };
        starts(drawn, KNOTS).into_iter().map(visit)
    });
    let mut squares = Squares::new(all.collect());
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

/// Number of places ahead that a round of improvement tries.
fn window(n: usize) -> usize {
    (PAIRS / n.max(1)).clamp(50, 100_000)
}

/// Gains below this value are rounding errors, px.
const GAIN: f64 = 1e-9;

/// 2-opt: reverses stretches from i to j where that shortens the route.
fn reverse_stretches(visits: &mut [Visit], paths: &[BezPath], from: Point) -> bool {
    let (n, mut shorter) = (visits.len(), false);
    for i in 0..n {
        for j in i..n.min(i + window(n)) {
            let before = if i == 0 { from } else { visits[i - 1].end };
            let old = before.distance(visits[i].begin);
            let new = before.distance(visits[j].end);
            let tail = |end: Point| visits.get(j + 1).map_or(0.0, |next| end.distance(next.begin));
            if new + tail(visits[i].begin) + GAIN < old + tail(visits[j].end) {
                visits[i..=j].reverse();
                for visit in &mut visits[i..=j] {
                    *visit = visit.reversed(is_closed(&paths[visit.path]));
                }
                shorter = true;
            }
        }
    }
    shorter
}

/// Or-opt: moves single paths where that shortens the route.
fn move_single(visits: &mut [Visit], from: Point) -> bool {
    let (n, mut shorter) = (visits.len(), false);
    for i in 0..n {
        let end = |k: usize, visits: &[Visit]| if k == 0 { from } else { visits[k - 1].end };
        let visit = visits[i];
        let after = |k: usize, end: Point, visits: &[Visit]| {
            visits.get(k).map_or(0.0, |next| end.distance(next.begin))
        };
        let saved = end(i, visits).distance(visit.begin) + after(i + 1, visit.end, visits)
            - after(i + 1, end(i, visits), visits);
        let half = window(n) / 2;
        let mut best = (GAIN, None);
        for k in i.saturating_sub(half)..=n.min(i + half) {
            if k == i || k == i + 1 {
                continue;
            }
            let (before, cost) = (end(k, visits), after(k, visit.end, visits));
            let gain = saved - (before.distance(visit.begin) + cost - after(k, before, visits));
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

/// Starts each path at the point for which the distance from the previous path and to the next one is shortest.
fn choose_starts(visits: &mut [Visit], paths: &[BezPath], from: Point) {
    let mut pen = from;
    for i in 0..visits.len() {
        let next = visits.get(i + 1).map(|next| next.begin);
        let way =
            |begin: Point, end: Point| pen.distance(begin) + next.map_or(0.0, |next| end.distance(next));
        let Visit { path, begin, end, .. } = visits[i];
        let mut least = way(begin, end);
        for (turned, begin, end) in starts(&paths[path], usize::MAX) {
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
    use crate::export::outline::path::stroke;
    use kurbo::{PathEl, Shape as _};
    use proptest::prelude::*;

    fn square([x, y]: [f64; 2], side: f64) -> BezPath {
        let corners = [[x + side, y], [x + side, y + side], [x, y + side], [x, y]];
        let mut path = vec![PathEl::MoveTo(Point::new(x, y))];
        path.extend(corners.map(|[x, y]| PathEl::LineTo(Point::new(x, y))));
        path.push(PathEl::ClosePath);
        BezPath::from_vec(path)
    }

    #[test]
    fn strokes_to_and_fro_are_drawn_without_a_detour() {
        let strokes: Vec<BezPath> =
            (0..9).map(|i| stroke(Point::new(0.0, f64::from(i)), Point::new(100.0, f64::from(i)))).collect();
        let way = route(strokes.iter().rev().cloned().collect(), Point::ORIGIN);
        assert_eq!(travel(Point::ORIGIN, &way.paths), 8.0);
        assert_eq!(way.order, [8, 7, 6, 5, 4, 3, 2, 1, 0]);
    }

    #[test]
    fn a_closed_path_starts_on_the_side_where_the_pen_is() {
        let way = route(vec![square([10.0, 10.0], 5.0), square([30.0, 10.0], 5.0)], Point::new(20.0, 10.0));
        assert_eq!([0, 1].map(|i| coordinates(start(&way.paths[i]))), [[15.0, 10.0], [30.0, 10.0]]);
    }

    proptest! {
        #[test]
        fn every_path_is_drawn_once_and_no_way_is_longer(
            ends in prop::collection::vec([0.0..100.0, 0.0..100.0, 0.0..100.0, 0.0..100.0f64], 0..60),
            squares in prop::collection::vec([0.0..100.0, 0.0..100.0f64], 0..30),
        ) {
            let mut paths: Vec<BezPath> =
                ends.iter().map(|[a, b, c, d]| stroke(Point::new(*a, *b), Point::new(*c, *d))).collect();
            paths.extend(squares.iter().map(|corner| square(*corner, 3.0)));
            let before = travel(Point::ORIGIN, &paths);
            let way = route(paths.clone(), Point::ORIGIN);
            prop_assert!(travel(Point::ORIGIN, &way.paths) <= before);
            let mut order = way.order.clone();
            order.sort_unstable();
            prop_assert_eq!(order, (0..paths.len()).collect::<Vec<_>>());
            for (index, path) in way.order.iter().zip(&way.paths) {
                let ends = [start(path), end(path)];
                let given = [start(&paths[*index]), end(&paths[*index])];
                prop_assert!(is_closed(path) || ends == given || ends == [given[1], given[0]]);
                prop_assert!(is_closed(path) == is_closed(&paths[*index]));
                prop_assert!((path.perimeter(1e-9) - paths[*index].perimeter(1e-9)).abs() < 1e-9);
            }
        }
    }
}
