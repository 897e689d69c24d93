//! What a pattern grows on: the interface of a flat grid that a triangle surface has as well.
//!
//! A flat [`Grid`](super::Grid) implements [`Domain`] for lengths in cells. A [`Surface`](crate::surface::Surface) implements it
//! with points of its triangles as places, vertices as cells, the square root of the mean cell area as its unit of length, and
//! tangent planes as frames. Callers are generic or use the grid itself: there are no virtual calls, and the solvers'
//! inner loops do not go through this trait at all.

use std::ops::Range;

use super::space::{Buckets, Space};

/// Cells with places, areas, neighbours and a frame for directions. Lengths are in units of a mean cell's side.
///
/// Every cell has a frame of two axes at right angles, in which directions (degrees from the first axis towards the
/// second) and displacements ([along the first, along the second]) are given. The frame of a place is that of the cell it lies
/// in.
pub trait Domain: Sync {
    /// A point of the domain.
    type Place: Copy + Send + Sync + PartialEq;

    /// Number of cells.
    fn cells(&self) -> usize;

    /// The centre of a cell, which is below [`Self::cells`].
    fn center(&self, cell: usize) -> Self::Place;

    /// The cell that a place lies in, or the nearest one.
    fn cell_at(&self, place: Self::Place) -> usize;

    /// Area of a cell, as a share of the mean cell's.
    fn area(&self, cell: usize) -> f64;

    /// The shortest displacement from one place to another, in the frame of the first.
    fn displacement(&self, from: Self::Place, to: Self::Place) -> [f64; 2];

    /// The place at the end of a displacement, which is given in the frame of its start.
    fn moved(&self, from: Self::Place, displacement: [f64; 2]) -> Self::Place;

    /// Degrees to add to a direction in the frame of cell `from` to give the same direction in the frame of cell `to`.
    fn transport_angle(&self, from: usize, to: usize) -> f64;

    /// Whether two cells face the same way: the cosine of the angle between their normals; 1 of a flat domain.
    fn facing(&self, _from: usize, _to: usize) -> f64 {
        1.0
    }

    /// The cells that share a side or a corner with a cell.
    fn neighbours(&self, cell: usize) -> impl Iterator<Item = usize>;

    /// Cells of the range `among` whose centres lie within `reach` of a place, with the displacement to each centre in the frame
    /// of the place. Some that lie farther away may be among them; a cell of which several images across
    /// the border are near is given several times.
    fn near(
        &self,
        place: Self::Place,
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (usize, [f64; 2])>;

    /// The cells of [`Self::near`] as runs: of so many cells that follow each other, with the displacement to the centre of the first;
    /// each next one is a unit farther along the first axis, and all have the frame of the first.
    fn runs_near(
        &self,
        place: Self::Place,
        reach: f64,
        among: Range<usize>,
    ) -> impl Iterator<Item = (Range<usize>, [f64; 2])> {
        self.near(place, reach, among).map(|(cell, displacement)| (cell..cell + 1, displacement))
    }

    /// Whether some cells of the range `among` may lie within `reach` of a place. May be true although none does.
    fn may_reach(&self, _place: Self::Place, _reach: f64, _among: &Range<usize>) -> bool {
        true
    }

    /// Distance from the centre of each cell to that of the nearest `set` one; infinite where none is set. `None` where the
    /// domain has no fast way to tell.
    fn distances(&self, _set: &[bool]) -> Option<Vec<f64>> {
        None
    }

    /// The cells that are `set`, and those whose centres lie within `reach(cell)` of the centre of a set one.
    fn dilated(&self, set: &[bool], reach: impl Fn(usize) -> f64) -> Vec<bool> {
        let mut dilated = set.to_vec();
        for cell in (0..set.len()).filter(|cell| set[*cell]) {
            let reach = reach(cell);
            for (other, [x, y]) in self.near(self.center(cell), reach, 0..self.cells()) {
                dilated[other] |= x * x + y * y <= reach * reach;
            }
        }
        dilated
    }

    /// Lengths of the units in which displacements along the two axes are given. Only their ratio matters.
    fn units(&self) -> [f64; 2] {
        [1.0; 2]
    }

    /// How many cells that follow each other one thread works on at a time, at least 1.
    fn part(&self) -> usize {
        1 << 14
    }

    /// A place in a cell for two numbers from 0 to 1; places for uniform random numbers are uniform in the cell.
    fn place_in(&self, cell: usize, [u, v]: [f64; 2]) -> Self::Place {
        let side = self.area(cell).sqrt();
        self.moved(self.center(cell), [(u - 0.5) * side, (v - 0.5) * side])
    }

    /// The place of the domain nearest to one in its [`Space`].
    fn inside(&self, place: Self::Place) -> Self::Place {
        place
    }

    /// A place as far as possible from any border.
    fn middle(&self) -> Self::Place {
        self.center(0)
    }

    /// The domain with a margin of this width beyond its border, where it has one.
    fn space(&self, margin: f64) -> impl Space<Place = Self::Place>;

    /// Buckets for places of the domain, about `side` wide.
    fn buckets(&self, side: f64) -> impl Buckets<Place = Self::Place>;
}

/// A displacement, or any other vector, in a frame that is turned by this: see [`Domain::transport_angle`].
#[must_use]
#[inline]
pub fn turned([x, y]: [f64; 2], degrees: f64) -> [f64; 2] {
    if degrees == 0.0 {
        return [x, y];
    }
    let (sin, cos) = libm::sincos(degrees.to_radians());
    [cos * x - sin * y, sin * x + cos * y]
}
