//! Points on a grid and on a frame around it.

use std::ops::Range;

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

    /// Rectangles of all of it, whose sides are at least `side`.
    pub fn rectangles(&self, side: f64) -> Rectangles {
        Rectangles::new(self.bounds, side)
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

    fn moved(&self, from: [f64; 2], displacement: [f64; 2]) -> [f64; 2] {
        self.bounds.folded([from[0] + displacement[0], from[1] + displacement[1]])
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

    fn buckets(&self, side: f64) -> impl Buckets<Place = [f64; 2]> {
        self.rectangles(side)
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
    /// Width and height of each.
    side: [f64; 2],
    /// Rectangles to a unit along x and y.
    to_unit: [f64; 2],
}

/// Rectangles along a side at most: a few points in a huge space need no more.
const MOST: usize = 2_048;

/// For rounding errors of places, cells.
const HAIR: f64 = 1e-9;

impl Rectangles {
    /// Rectangles of `space` whose sides are at least `side`, where there is more than one.
    pub fn new(space: Bounds, side: f64) -> Self {
        let count = space.size.map(|whole| ((whole / side) as usize).clamp(1, MOST));
        let side = [0, 1].map(|axis| space.size[axis] / count[axis] as f64);
        Self { space, count, side, to_unit: side.map(|side| 1.0 / side) }
    }

    fn position(&self, at: [f64; 2]) -> [isize; 2] {
        [0, 1].map(|axis| {
            let count = self.count[axis];
            ((at[axis] / self.space.size[axis] * count as f64) as usize).min(count - 1) as isize
        })
    }

    /// The rectangles along an axis that may hold places within `reach` of the coordinate `at`, which is in rectangle `own`. Those
    /// before 0 and from the count on are images beyond the border, one of each at most on either side.
    fn along(&self, axis: usize, at: f64, own: isize, reach: f64) -> Range<isize> {
        let count = self.count[axis] as isize;
        let side = self.side[axis];
        let before = at - own as f64 * side;
        // The cast takes what is too large to the bound.
        let steps = |away: f64| ((reach + HAIR - away) * self.to_unit[axis] + 1.0).max(0.0) as isize;
        let first = own.saturating_sub(steps(before)).max(-count);
        first..own.saturating_add(steps(side - before)).min(2 * count - 1) + 1
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
    ) -> impl Iterator<Item = (Range<usize>, impl Fn([f64; 2]) -> Option<[f64; 2]>)> {
        let Self { space: Bounds { size: [w, h], edges }, count: [columns, rows], .. } = *self;
        let own = self.position(place);
        let [columns_near, rows_near] = [0, 1].map(|axis| self.along(axis, place[axis], own[axis], reach));
        // Before the border, inside, and behind it: `own` is inside.
        let (first, end, n) = (columns_near.start, columns_near.end, columns as isize);
        let parts = if first < 0 { 0 } else { 1 }..if end > n { 3 } else { 2 };
        let part = move |part: u8| match part {
            0 => first..0,
            1 => first.max(0)..end.min(n),
            _ => n..end,
        };
        rows_near.flat_map(move |row| parts.clone().map(move |k| (part(k), row))).map(move |(run, row)| {
            let (c, across) = images(run.clone(), columns, edges, w);
            let (r, down) = images(row..row + 1, rows, edges, h);
            let beyond = |i: isize, n: usize| i < 0 || i >= n as isize;
            let mirrored = [beyond(run.start, columns), beyond(row, rows)];
            let displacement = move |other: [f64; 2]| {
                let seen = [across.of(other[0]), down.of(other[1])];
                let delta = [seen[0] - place[0], seen[1] - place[1]];
                if delta[0].abs() > reach || delta[1].abs() > reach {
                    return None;
                }
                // The image of a point on the wall is that point, and counts once.
                let twice = |axis: usize| mirrored[axis] && (seen[axis] - other[axis]).abs() < 1e-6;
                let twice = twice(0) || twice(1);
                let itself = mirrored == [false; 2] && delta == [0.0, 0.0];
                (!itself && !twice).then_some(delta)
            };
            (r.start * columns + c.start..r.start * columns + c.end, displacement)
        })
    }

    fn is_to_image(&self, from: [f64; 2], to: [f64; 2], displacement: [f64; 2]) -> bool {
        self.space.edges == Edges::Closed
            && (0..2).any(|axis| (to[axis] - from[axis] - displacement[axis]).abs() > 1e-6)
    }

    fn transport_angle(&self, _: usize, _: usize) -> f64 {
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

/// The buckets whose images are the buckets `run` of `n`, on one side of the border, and the map of their coordinates to those of
/// the images.
fn images(run: Range<isize>, n: usize, edges: Edges, size: f64) -> (Range<usize>, Image) {
    let (before, behind) = (run.start < 0, run.start >= n as isize);
    if !before && !behind {
        // Most are inside.
        return (run.start as usize..run.end as usize, Image { sign: 1.0, offset: 0.0 });
    }
    let image = match edges {
        Edges::Closed if before => Image { sign: -1.0, offset: 0.0 },
        Edges::Closed if behind => Image { sign: -1.0, offset: 2.0 * size },
        Edges::Wrap if before => Image { sign: 1.0, offset: -size },
        Edges::Wrap if behind => Image { sign: 1.0, offset: size },
        Edges::Closed | Edges::Wrap => Image { sign: 1.0, offset: 0.0 },
    };
    // Mirrored ones are counted backwards.
    let ends = [edges.index(run.start, n), edges.index(run.end - 1, n)];
    (ends[0].min(ends[1])..ends[0].max(ends[1]) + 1, image)
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    /// The displacements to `other` and its images across a border, as far as `reach` along both axes.
    fn all_ways(bounds: Bounds, place: [f64; 2], other: [f64; 2], reach: f64) -> Vec<[f64; 2]> {
        let seen = |axis: usize| {
            let (v, size) = (other[axis], bounds.size[axis]);
            match bounds.edges {
                Edges::Wrap => [v, v - size, v + size],
                Edges::Closed => [v, -v, 2.0 * size - v],
            }
        };
        let ways = seen(1).into_iter().flat_map(|y| seen(0).map(|x| [x - place[0], y - place[1]]));
        ways.filter(|displacement| {
            *displacement != [0.0; 2] && displacement.iter().all(|along| along.abs() <= reach)
        })
        .collect()
    }

    #[test]
    fn rectangles_give_every_place_within_reach_and_its_images() {
        let mut rng = Pcg64Mcg::seed_from_u64(11);
        for (edges, side) in
            [(Edges::Closed, 8.0), (Edges::Wrap, 8.0), (Edges::Closed, 1.5), (Edges::Wrap, 3.0)]
        {
            let bounds = Bounds { size: [50.0, 35.0], edges };
            let rectangles = Rectangles::new(bounds, side);
            let places: Vec<[f64; 2]> =
                (0..120).map(|_| bounds.size.map(|side| side * rng.random::<f64>())).collect();
            for (place, reach) in places.iter().zip([0.5, 2.0, 4.0, 8.0, 30.0].into_iter().cycle()) {
                let found = rectangles.near(*place, reach).map(|(buckets, displacement)| {
                    let inside = places.iter().filter(|other| buckets.contains(&rectangles.bucket(**other)));
                    inside.filter(|other| displacement(**other).is_some()).count()
                });
                let expected = places.iter().map(|other| all_ways(bounds, *place, *other, reach).len());
                assert_eq!(found.sum::<usize>(), expected.sum::<usize>(), "{edges:?} {place:?} {reach}");
            }
        }
    }

    #[test]
    fn rectangles_in_which_nothing_is_near_are_not_looked_into() {
        let rectangles = Rectangles::new(Bounds { size: [40.0, 40.0], edges: Edges::Closed }, 2.0);
        let looked_into = |reach: f64| -> usize {
            rectangles.near([21.0, 21.0], reach).map(|(buckets, _)| buckets.len()).sum()
        };
        assert_eq!([0.5, 1.5, 2.5, 3.5, 100.0].map(looked_into), [1, 9, 9, 25, 3600]);
    }
}
