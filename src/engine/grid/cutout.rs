//! Rectangles cut out of a grid, also across wrapped edges.

use super::cells::Grid;
use super::domain::Domain;
use super::edges::Edges;

/// A rectangle of whole cells of a grid. On a wrapped grid it may lie across the border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutout {
    /// Column and row of its first cell.
    pub first: [usize; 2],
    /// The cells cut out, with closed edges.
    pub grid: Grid,
    whole: Grid,
}

/// First and last column and row + 1. Those of a wrapped grid may lie beyond its border.
type Sides = [[isize; 2]; 2];

impl Cutout {
    /// Disjoint rectangles that hold all cells of `whole` within so many cells of these places along either axis. `None` where one
    /// would reach round a wrapped grid.
    #[must_use]
    pub fn about(whole: &Grid, places: &[([f64; 2], f64)]) -> Option<Vec<Self>> {
        let mut disjoint: Vec<Sides> = Vec::new();
        for (at, reach) in places {
            let mut sides = [0, 1].map(|axis| {
                let ends = [(at[axis] - reach).floor() as isize, (at[axis] + reach).ceil() as isize];
                match whole.edges {
                    Edges::Wrap => ends,
                    Edges::Closed => ends.map(|end| end.clamp(0, whole.size[axis] as isize)),
                }
            });
            // Of two that overlap the union may overlap a third.
            while let Some(other) = disjoint.iter().position(|other| joined(whole, &sides, other).is_some()) {
                sides = joined(whole, &sides, &disjoint.swap_remove(other))?;
            }
            disjoint.push(sides);
        }
        disjoint.iter().map(|sides| Self::new(whole, sides)).collect()
    }

    fn new(whole: &Grid, sides: &Sides) -> Option<Self> {
        let size = sides.map(|[start, end]| (end - start) as usize);
        let reaches_round = |axis: usize| whole.edges == Edges::Wrap && size[axis] >= whole.size[axis];
        if reaches_round(0) || reaches_round(1) {
            return None;
        }
        let first = [0, 1].map(|axis| sides[axis][0].rem_euclid(whole.size[axis] as isize) as usize);
        Some(Self { first, grid: Grid { size, edges: Edges::Closed, ..*whole }, whole: *whole })
    }

    /// The cells of the whole grid that it holds, in the order of its own.
    pub fn cells(&self) -> impl Iterator<Item = usize> + use<> {
        let Self { first, grid, whole } = *self;
        (0..grid.cells()).map(move |cell| {
            let at = grid.position(cell);
            whole.index([0, 1].map(|axis| (first[axis] + at[axis]) % whole.size[axis]))
        })
    }

    /// The part that it holds of `values`, one a cell of the whole grid; nothing of none.
    #[must_use]
    pub fn of<T: Copy>(&self, values: &[T]) -> Vec<T> {
        if values.is_empty() { Vec::new() } else { self.cells().map(|cell| values[cell]).collect() }
    }

    /// Writes `part`, one value a cell of its own, over those of the whole grid.
    pub fn replace<T: Copy>(&self, values: &mut [T], part: &[T]) {
        self.cells().zip(part).for_each(|(cell, value)| values[cell] = *value);
    }

    /// Where a place of the whole grid lies in it, cells; `None` outside.
    #[must_use]
    pub fn place(&self, at: [f64; 2]) -> Option<[f64; 2]> {
        let inside = [0, 1].map(|axis| {
            let from = at[axis] - self.first[axis] as f64;
            if from < 0.0 && self.whole.edges == Edges::Wrap {
                from + self.whole.size[axis] as f64
            } else {
                from
            }
        });
        let holds = |axis: usize| (0.0..self.grid.size[axis] as f64).contains(&inside[axis]);
        (holds(0) && holds(1)).then_some(inside)
    }

    /// Distance, cells, of a place in it from the nearest of its sides beyond which the whole grid goes on; infinite without such
    /// a side.
    #[must_use]
    pub fn distance_from_cut(&self, place: [f64; 2]) -> f64 {
        let along = |axis: usize| {
            let (first, size) = (self.first[axis], self.grid.size[axis]);
            let wraps = self.whole.edges == Edges::Wrap;
            let before = if wraps || first > 0 { place[axis] } else { f64::INFINITY };
            let goes_on = wraps || first + size < self.whole.size[axis];
            let after = if goes_on { size as f64 - place[axis] } else { f64::INFINITY };
            before.min(after)
        };
        along(0).min(along(1))
    }

    /// Where a point of it, px from its corner, lies on the whole canvas, px.
    #[must_use]
    pub fn to_canvas(&self, point: [f64; 2]) -> [f64; 2] {
        let corner = self.whole.to_px(self.first.map(|at| at as f64));
        self.whole.bounds_px().folded([corner[0] + point[0], corner[1] + point[1]])
    }
}

/// The rectangle about two that overlap; `None` where they do not.
fn joined(whole: &Grid, a: &Sides, b: &Sides) -> Option<Sides> {
    let mut union = [[0; 2]; 2];
    for axis in 0..2 {
        let n = whole.size[axis] as isize;
        let round = if whole.edges == Edges::Wrap { 2 } else { 0 };
        let [start, end] = a[axis];
        let mut images = (-round..=round).map(|times| b[axis].map(|end| end + times * n));
        let [from, to] = images.find(|[from, to]| *from < end && start < *to)?;
        union[axis] = [start.min(from), end.max(to)];
    }
    Some(union)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLOSED: Grid = Grid { size: [50, 30], cell: [1.0, 2.0], edges: Edges::Closed };
    const WRAPPED: Grid = Grid { edges: Edges::Wrap, ..CLOSED };

    #[test]
    fn cutouts_hold_all_cells_near_their_places_once() {
        for whole in [CLOSED, WRAPPED] {
            let places = [([1.0, 2.5], 4.0), ([30.2, 15.0], 3.0), ([34.0, 17.0], 3.0), ([48.5, 29.0], 2.0)];
            let cutouts = Cutout::about(&whole, &places).expect("small ones");
            let mut held: Vec<usize> = cutouts.iter().flat_map(Cutout::cells).collect();
            held.sort_unstable();
            let once = held.len();
            held.dedup();
            assert_eq!(held.len(), once);
            let near = |cell: &usize| {
                places.iter().any(|(at, reach)| {
                    whole.displacement(*at, whole.center(*cell)).iter().all(|along| along.abs() <= *reach)
                })
            };
            assert!((0..whole.cells()).filter(near).all(|cell| held.contains(&cell)), "{:?}", whole.edges);
            assert_eq!(cutouts.len(), if whole.edges == Edges::Closed { 3 } else { 2 });
        }
    }

    #[test]
    fn values_and_places_are_those_of_the_whole_grid() {
        let values: Vec<usize> = (0..WRAPPED.cells()).collect();
        let cutout = Cutout::about(&WRAPPED, &[([49.0, 1.0], 3.0)]).expect("a small one")[0];
        let part = cutout.of(&values);
        for (cell, value) in part.iter().enumerate() {
            let center = cutout.grid.center(cell);
            assert_eq!(cutout.place(WRAPPED.center(*value)), Some(center));
            assert_eq!(cutout.to_canvas(WRAPPED.to_px(center)), WRAPPED.center_px(*value));
        }
        assert_eq!(cutout.place([25.5, 1.5]), None);
        let mut others = vec![0; values.len()];
        cutout.replace(&mut others, &part);
        assert!(part.iter().all(|value| others[*value] == *value));
        assert_eq!(
            others.iter().filter(|value| **value != 0).count(),
            part.iter().filter(|v| **v != 0).count()
        );
    }

    #[test]
    fn distances_from_the_cut_leave_out_the_edges_of_the_canvas() {
        let about = |whole: &Grid, at| Cutout::about(whole, &[(at, 4.0)]).expect("a small one")[0];
        let corner = about(&CLOSED, [1.0, 2.0]);
        assert_eq!(corner.grid.size, [5, 6]);
        assert_eq!(
            [[0.0, 0.0], [3.0, 1.0], [1.0, 5.5]].map(|at| corner.distance_from_cut(at)),
            [5.0, 2.0, 0.5]
        );
        assert_eq!(about(&WRAPPED, [1.0, 2.0]).distance_from_cut([1.0, 2.0]), 1.0);
        let all = Cutout::about(&CLOSED, &[([1.0, 2.0], 90.0)]).expect("closed edges")[0];
        assert_eq!(all.distance_from_cut([1.0, 2.0]), f64::INFINITY);
    }

    #[test]
    fn none_reaches_round_a_wrapped_grid() {
        assert_eq!(Cutout::about(&WRAPPED, &[([10.0, 5.0], 15.0)]), None);
        assert!(Cutout::about(&CLOSED, &[([10.0, 5.0], 90.0)]).is_some());
    }
}
