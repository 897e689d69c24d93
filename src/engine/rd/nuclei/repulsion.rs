//! Mutual repulsion of points, which spreads them evenly.

use std::ops::Range;

use rayon::prelude::*;

use super::cell_list::CellList;
use super::geodesic::Christoffel;
use crate::grid::{Buckets, Space, turned};
use crate::rd::nucleus::Nucleus;

/// Number of points below which no other thread is used: pushing one point takes about 0.4 µs.
const FEW: usize = 32;

/// Curvature of a domain on which shortest ways are straight: none.
pub fn straight<P>(_: &Nucleus<P>) -> Option<Christoffel> {
    None
}

/// Rounds of repulsion in `space`: points closer than `reach` pitches push each other away. `nucleus(i, before, to)` is point i
/// after its move from `before`; only the points in the range `moving` move. `curvature` gives the curvature of shortest ways from
/// a point; see [`straight`].
pub fn relax<S: Space, B: Buckets<Place = S::Place>>(
    space: &S,
    placed: &mut CellList<B>,
    rounds: usize,
    reach: f64,
    moving: &Range<usize>,
    curvature: &(dyn Fn(&Nucleus<S::Place>) -> Option<Christoffel> + Sync),
    nucleus: impl Fn(usize, &Nucleus<S::Place>, S::Place) -> Nucleus<S::Place> + Sync,
) {
    let mut all = placed.all.clone();
    // Finer buckets than those of `placed`, which are large where some points are much larger than others: one point per bucket.
    let longest = all.iter().map(|point| point.reach).fold(0.0, f64::max);
    let room = (space.points(1.0) / all.len().max(1) as f64).sqrt();
    let buckets = space.buckets(room.max(0.5 * longest));
    for _ in 0..rounds {
        let sorted = Sorted::new(&buckets, &all);
        let moved = |(index, point): &(u32, Nucleus<S::Place>)| {
            let index = *index as usize;
            let push = || sorted.push(&buckets, point, reach, curvature(point));
            let to = if moving.contains(&index) { space.moved(point.at, push()) } else { point.at };
            nucleus(index, point, to)
        };
        let moved: Vec<Nucleus<S::Place>> = sorted.points.par_iter().with_min_len(FEW).map(moved).collect();
        for ((index, _), point) in sorted.points.iter().zip(moved) {
            all[*index as usize] = point;
        }
    }
    placed.replace(all);
}

/// Points in the order of their buckets, so that neighbours are adjacent in memory; within a bucket in their original order.
struct Sorted<P> {
    /// Index in `points` at which each bucket begins, and the number of points.
    starts: Vec<u32>,
    /// The place of each point: for most points nothing else is read.
    places: Vec<P>,
    /// Index and point.
    points: Vec<(u32, Nucleus<P>)>,
    /// The longest reach of any of them.
    longest: f64,
}

impl<P: Copy> Sorted<P> {
    /// Counting sort.
    fn new(buckets: &impl Buckets<Place = P>, all: &[Nucleus<P>]) -> Self {
        let own: Vec<usize> = all.iter().map(|point| buckets.bucket(point.at)).collect();
        let mut starts = vec![0; buckets.count() + 1];
        own.iter().for_each(|bucket| starts[bucket + 1] += 1);
        for bucket in 1..starts.len() {
            starts[bucket] += starts[bucket - 1];
        }
        let (mut next, mut order) = (starts.clone(), vec![0; all.len()]);
        for (index, bucket) in own.iter().enumerate() {
            order[next[*bucket] as usize] = index as u32;
            next[*bucket] += 1;
        }
        let points: Vec<_> = order.into_iter().map(|index| (index, all[index as usize])).collect();
        let places = points.iter().map(|(_, point)| point.at).collect();
        let longest = all.iter().map(|point| point.reach).fold(0.0, f64::max);
        Self { starts, places, points, longest }
    }

    /// The sum of all pushes on `point`, cells, in its frame. Points farther than `reach` pitches have no effect.
    fn push(
        &self,
        buckets: &impl Buckets<Place = P>,
        point: &Nucleus<P>,
        reach: f64,
        curvature: Option<Christoffel>,
    ) -> [f64; 2] {
        let farthest = point.reach_among(self.longest, reach);
        let mut shift = [0.0, 0.0];
        for (run, displacement) in buckets.near(point.at, farthest) {
            let inside = self.starts[run.start] as usize..self.starts[run.end] as usize;
            for (place, (_, other)) in self.places[inside.clone()].iter().zip(&self.points[inside]) {
                let Some(here) = displacement(*place) else { continue };
                let own = point.distance2(here);
                // Already too far by half of the mean of both distances.
                if 0.5 * own >= reach * reach {
                    continue;
                }
                let there = turned(here, buckets.transport_angle(point.cell, other.cell));
                let d = (0.5 * (own + other.distance2(there))).sqrt();
                if d > 1e-9 && d < reach {
                    // Half of the gap to the reach, shared with the other, damped for six neighbours.
                    let push = 0.22 * (reach - d) / d;
                    let way = curvature.map_or(here, |symbols| symbols.sets_out(here));
                    shift[0] -= push * way[0];
                    shift[1] -= push * way[1];
                }
            }
        }
        shift
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Domain, Edges, Grid};
    use crate::rd::nuclei::cell_list::distance2;
    use crate::rd::parameter_field::Parameters;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    /// One round of repulsion, point by point from the cell list: the reference of the test.
    fn plain<S: Space, B: Buckets<Place = S::Place>>(
        space: &S,
        placed: &mut CellList<B>,
        reach: f64,
        moving: &Range<usize>,
    ) {
        let moved = |(index, point): (usize, &Nucleus<S::Place>)| {
            let mut shift = [0.0; 2];
            placed.near(point, reach, |other, displacement| {
                let d = distance2(point, other, displacement).sqrt();
                if d > 1e-9 && d < reach {
                    let push = 0.22 * (reach - d) / d;
                    shift = [shift[0] - push * displacement.here[0], shift[1] - push * displacement.here[1]];
                }
            });
            let at = if moving.contains(&index) { space.moved(point.at, shift) } else { point.at };
            Nucleus { at, ..*point }
        };
        let all = placed.all.iter().enumerate().map(moved).collect();
        placed.replace(all);
    }

    #[test]
    fn points_are_pushed_as_by_a_plain_sum_over_neighbours() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let grid = Grid::unit([90, 70], edges);
            let of = |x: f64, y: f64| Parameters {
                rate: 1.0,
                ratio: 20.0,
                stretch: 0.4 + 0.005 * x as f32,
                direction: y as f32,
                pitch: 1.0,
            };
            let space = grid.space(12.0);
            let mut rng = Pcg64Mcg::seed_from_u64(3);
            let nucleus = |at: [f64; 2]| Nucleus::new(&of(at[0], at[1]), &grid, 0, at, 6.0 + 0.05 * at[0]);
            let points: Vec<_> =
                (0..150).map(|_| nucleus([90.0 * rng.random::<f64>(), 70.0 * rng.random::<f64>()])).collect();
            let mut fast = CellList::new(space.buckets(25.0));
            fast.replace(points);
            let (mut slow, moving) = (fast.emptied(), 20..120);
            slow.replace(fast.all.clone());
            relax(&space, &mut fast, 4, 1.25, &moving, &straight, |_, before, at| Nucleus { at, ..*before });
            (0..4).for_each(|_| plain(&space, &mut slow, 1.25, &moving));
            // The pushes are summed in another order, that of other buckets.
            for (fast, slow) in fast.all.iter().zip(&slow.all) {
                let apart = [0, 1].map(|axis| (fast.at[axis] - slow.at[axis]).abs());
                assert!(apart.iter().all(|apart| *apart < 1e-9), "{edges:?}: {:?} {:?}", fast.at, slow.at);
            }
        }
    }
}
