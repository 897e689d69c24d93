//! Points on a grid and on a frame around it.

use std::ops::RangeInclusive;

use rand::{Rng, RngExt};

use super::cells::Grid;
use super::edges::{Bounds, Edges};
use super::space::{Buckets, Space, Wall};

/// A grid with a frame beyond closed edges, whose outer borders meet as those of a tile; a tile has no frame. Places are
/// in cells from the corner of the frame.
#[derive(Clone, Copy)]
pub struct Framed {
    grid: Grid,
    /// Width of the frame, cells.
    frame: f64,
    /// The frame with all in it.
    bounds: Bounds,
}

impl Framed {
    /// `grid` with a frame of this width, cells.
    pub fn new(grid: Grid, width: f64) -> Self {
        let Bounds { size, edges } = grid.bounds();
        let frame = if edges == Edges::Closed { width } else { 0.0 };
        let bounds = Bounds { size: size.map(|side| side + 2.0 * frame), edges: Edges::Wrap };
        Self { grid, frame, bounds }
    }

    /// Rectangles of all of it, whose sides are at least `reach`.
    pub fn rectangles(&self, reach: f64) -> Rectangles {
        Rectangles::new(self.bounds, reach)
    }
}

impl Space for Framed {
    type Place = [f64; 2];
    type Wall = Side;

    fn to_space(&self, place: [f64; 2]) -> [f64; 2] {
        place.map(|at| at + self.frame)
    }

    fn to_domain(&self, place: [f64; 2]) -> [f64; 2] {
        place.map(|at| at - self.frame)
    }

    fn is_inside(&self, place: [f64; 2]) -> bool {
        let size = self.grid.bounds().size;
        (0..2).all(|axis| (0.0..size[axis]).contains(&place[axis]))
    }

    fn covers(&self, place: [f64; 2]) -> bool {
        let size = self.grid.bounds().size;
        (0..2).all(|axis| (-self.frame..size[axis] + self.frame).contains(&place[axis]))
    }

    fn moved(&self, from: [f64; 2], way: [f64; 2]) -> [f64; 2] {
        self.bounds.folded([from[0] + way[0], from[1] + way[1]])
    }

    fn points(&self, density: f64) -> f64 {
        let [wide, high] = self.bounds.size;
        density * wide * high
    }

    fn integral(&self, density: impl Fn(usize) -> f64) -> f64 {
        let [nx, ny] = self.grid.size;
        let row = |y: usize| {
            let ends = density(y * nx) + density(y * nx + nx - 1);
            (0..nx).map(|x| density(y * nx + x)).sum::<f64>() + self.frame * ends
        };
        let ends = row(0) + row(ny - 1);
        (0..ny).map(row).sum::<f64>() + self.frame * ends
    }

    fn random(&self, rng: &mut impl Rng) -> [f64; 2] {
        self.bounds.size.map(|side| rng.random::<f64>() * side)
    }

    fn cells(&self) -> usize {
        let [nx, ny] = self.bounds.size.map(|side| side as usize);
        nx * ny
    }

    fn place_in(&self, cell: usize, at: [f64; 2]) -> [f64; 2] {
        let columns = self.bounds.size[0] as usize;
        [(cell % columns) as f64 + at[0], (cell / columns) as f64 + at[1]]
    }

    fn walls(&self) -> Vec<Side> {
        if self.grid.edges == Edges::Wrap {
            return Vec::new();
        }
        let size = self.grid.bounds().size;
        let sides = [0, 1].map(|axis| {
            let far = self.frame + size[axis] * (1.0 - 1e-12);
            [Side { axis, at: self.frame, inward: 1.0 }, Side { axis, at: far, inward: -1.0 }]
        });
        sides.concat()
    }

    fn buckets(&self, reach: f64) -> impl Buckets<Place = [f64; 2]> {
        self.rectangles(reach)
    }
}

/// One of the four closed edges of a grid.
#[derive(Clone, Copy)]
pub struct Side {
    /// The axis that it stands across.
    axis: usize,
    /// Its coordinate on this axis.
    at: f64,
    /// The direction inwards along the axis, 1 or −1.
    inward: f64,
}

impl Wall<[f64; 2]> for Side {
    fn depth(&self, place: [f64; 2]) -> f64 {
        (place[self.axis] - self.at) * self.inward
    }

    fn inward(&self, _: [f64; 2]) -> [f64; 2] {
        let mut inward = [0.0; 2];
        inward[self.axis] = self.inward;
        inward
    }

    fn at_depth(&self, mut place: [f64; 2], depth: f64) -> [f64; 2] {
        place[self.axis] = self.at + self.inward * depth;
        place
    }

    fn faces(&self, other: &Self) -> bool {
        self.axis == other.axis && self.inward != other.inward
    }
}

/// Equal rectangles of a flat space.
#[derive(Clone, Copy)]
pub struct Rectangles {
    space: Bounds,
    /// Columns and rows.
    count: [usize; 2],
}

/// Rectangles along a side at most: a few points in a huge space need no more.
const MOST: usize = 2_048;

/// For rounding errors of places, cells.
const HAIR: f64 = 1e-9;

impl Rectangles {
    /// Rectangles of `space` whose sides are at least `reach`, where there is more than one.
    pub fn new(space: Bounds, reach: f64) -> Self {
        Self { space, count: space.size.map(|side| ((side / reach) as usize).clamp(1, MOST)) }
    }

    fn position(&self, at: [f64; 2]) -> [isize; 2] {
        [0, 1].map(|axis| {
            let count = self.count[axis];
            ((at[axis] / self.space.size[axis] * count as f64) as usize).min(count - 1) as isize
        })
    }

    /// The rectangles that may hold places within `reach` of `at`, which is in rectangle `own`: by their steps from it along an
    /// axis, −1 to 1.
    fn steps(&self, axis: usize, at: f64, own: isize, reach: f64) -> RangeInclusive<isize> {
        let side = self.space.size[axis] / self.count[axis] as f64;
        let before = at - own as f64 * side;
        let reaches = |away: f64| isize::from(away <= reach + HAIR);
        -reaches(before)..=reaches(side - before)
    }
}

impl Buckets for Rectangles {
    type Place = [f64; 2];

    fn count(&self) -> usize {
        self.count[0] * self.count[1]
    }

    fn bucket(&self, at: [f64; 2]) -> usize {
        let [column, row] = self.position(at);
        row as usize * self.count[0] + column as usize
    }

    /// Images of places beyond the border are found too, of the place itself as well.
    fn near(
        &self,
        place: [f64; 2],
        reach: f64,
    ) -> impl Iterator<Item = (usize, impl Fn([f64; 2]) -> Option<[f64; 2]>)> {
        let Self { space: Bounds { size: [w, h], edges }, count: [columns, rows] } = *self;
        let [column, row] = self.position(place);
        let [columns_near, rows_near] =
            [0, 1].map(|axis| self.steps(axis, place[axis], [column, row][axis], reach));
        let steps = rows_near.flat_map(move |dy| columns_near.clone().map(move |dx| (dx, dy)));
        steps.map(move |(dx, dy)| {
            let (c, across) = image(column + dx, columns, edges, w);
            let (r, down) = image(row + dy, rows, edges, h);
            let beyond = |i: isize, n: usize| i < 0 || i >= n as isize;
            let mirrored = [beyond(column + dx, columns), beyond(row + dy, rows)];
            let way = move |other: [f64; 2]| {
                let seen = [across.of(other[0]), down.of(other[1])];
                let delta = [seen[0] - place[0], seen[1] - place[1]];
                if delta[0].abs() > reach || delta[1].abs() > reach {
                    return None;
                }
                // The image of a point on the wall is that point, and counts once.
                let twice = |axis: usize| mirrored[axis] && (seen[axis] - other[axis]).abs() < 1e-6;
                let twice = twice(0) || twice(1);
                let itself = dx == 0 && dy == 0 && delta == [0.0, 0.0];
                (!itself && !twice).then_some(delta)
            };
            (r * columns + c, way)
        })
    }

    fn is_to_image(&self, from: [f64; 2], to: [f64; 2], way: [f64; 2]) -> bool {
        self.space.edges == Edges::Closed
            && (0..2).any(|axis| (to[axis] - from[axis] - way[axis]).abs() > 1e-6)
    }

    fn turn(&self, _: usize, _: usize) -> f64 {
        0.0
    }
}

/// The map of a coordinate to that of its image: ±v + an offset.
#[derive(Clone, Copy)]
struct Image {
    sign: f64,
    offset: f64,
}

impl Image {
    #[inline]
    fn of(self, v: f64) -> f64 {
        self.sign * v + self.offset
    }
}

/// The bucket whose image is bucket `i` of `n`, and the map of its coordinates to those of the image.
fn image(i: isize, n: usize, edges: Edges, size: f64) -> (usize, Image) {
    let (before, behind) = (i < 0, i >= n as isize);
    let image = match edges {
        Edges::Closed if before => Image { sign: -1.0, offset: 0.0 },
        Edges::Closed if behind => Image { sign: -1.0, offset: 2.0 * size },
        Edges::Wrap if before => Image { sign: 1.0, offset: -size },
        Edges::Wrap if behind => Image { sign: 1.0, offset: size },
        Edges::Closed | Edges::Wrap => Image { sign: 1.0, offset: 0.0 },
    };
    (edges.index(i, n), image)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    /// The ways to `other` and its images across a border, as far as `reach` along both axes.
    fn all_ways(bounds: Bounds, place: [f64; 2], other: [f64; 2], reach: f64) -> Vec<[f64; 2]> {
        let seen = |axis: usize| {
            let (v, size) = (other[axis], bounds.size[axis]);
            match bounds.edges {
                Edges::Wrap => [v, v - size, v + size],
                Edges::Closed => [v, -v, 2.0 * size - v],
            }
        };
        let ways = seen(1).into_iter().flat_map(|y| seen(0).map(|x| [x - place[0], y - place[1]]));
        ways.filter(|way| *way != [0.0; 2] && way.iter().all(|along| along.abs() <= reach)).collect()
    }

    #[test]
    fn rectangles_give_every_place_within_reach_and_its_images() {
        let mut rng = Pcg64Mcg::seed_from_u64(11);
        for edges in [Edges::Closed, Edges::Wrap] {
            let bounds = Bounds { size: [50.0, 35.0], edges };
            let rectangles = Rectangles::new(bounds, 8.0);
            let places: Vec<[f64; 2]> =
                (0..120).map(|_| bounds.size.map(|side| side * rng.random::<f64>())).collect();
            for (place, reach) in places.iter().zip([0.5, 2.0, 4.0, 8.0].into_iter().cycle()) {
                let found = rectangles.near(*place, reach).map(|(bucket, way)| {
                    let inside = places.iter().filter(|other| rectangles.bucket(**other) == bucket);
                    inside.filter(|other| way(**other).is_some()).count()
                });
                let expected = places.iter().map(|other| all_ways(bounds, *place, *other, reach).len());
                assert_eq!(found.sum::<usize>(), expected.sum::<usize>(), "{edges:?} {place:?} {reach}");
            }
        }
    }
}
