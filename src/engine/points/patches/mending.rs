//! Repair of patches whose interpolated field is connected differently from the graph: merged patches, and islands beside a patch.

use std::collections::BTreeMap;

use crate::grid::{Domain, Edges, Field, UnionFind};
use crate::points::delaunay::Delaunay;
use crate::points::graph::PointGraph;

/// The owners and the values of the points.
pub struct Labelled {
    /// The patch of each point.
    pub owner: Vec<Option<u32>>,
    /// Value of each point.
    pub values: Vec<f32>,
}

/// Value of light points beside two patches. With 96 points in each patch and coverages of .6 and .7, one patch in 170 merges at 0,
/// one in 450 at −.3. The lower the value, the farther the level is below ½.
const BETWEEN: f32 = -0.2;
/// Decrease of the value of a light point between merged patches.
const LOWERED: f32 = 0.5;
/// The lowest value of a point: lower ones would shrink the patches themselves.
const LOWEST: f32 = -2.0;

/// The largest hole that is filled, as a share of the area of the patch: one of the seven points of the coarsest patches.
const HOLE: f64 = 0.2;

/// Assigns light points that one patch encloses to this patch: they would be pinholes. Light points joined by edges of at least the
/// clearance `least` are one hole. Holes with a `taken` point, and holes that reach beyond all points, stay.
pub fn fill(graph: &impl PointGraph, owner: &mut [Option<u32>], taken: &[bool], least: f64) {
    let mut areas: BTreeMap<u32, f64> = BTreeMap::new();
    for (point, owner) in owner.iter().enumerate() {
        if let Some(patch) = owner {
            *areas.entry(*patch).or_default() += graph.area(point);
        }
    }
    let mut seen: Vec<bool> = owner.iter().map(Option::is_some).collect();
    for start in 0..owner.len() {
        if seen[start] {
            continue;
        }
        let hole = hole_from(graph, start, &mut seen, least);
        let Some(patch) = enclosing(graph, &hole, owner, taken) else { continue };
        let area: f64 = hole.iter().map(|point| graph.area(*point)).sum();
        if area <= HOLE * areas[&patch] {
            hole.iter().for_each(|point| owner[*point] = Some(patch));
        }
    }
}

/// The points not yet `seen` that edges of at least the clearance `least` join with `start`.
fn hole_from(graph: &impl PointGraph, start: usize, seen: &mut [bool], least: f64) -> Vec<usize> {
    let mut hole = vec![start];
    seen[start] = true;
    let mut next = 0;
    while let Some(point) = hole.get(next).copied() {
        next += 1;
        for axis in graph.axes(point).iter().filter(|axis| axis.clearance >= least) {
            if let Some(to) = axis.to.map(|to| to as usize).filter(|to| !seen[*to]) {
                seen[to] = true;
                hole.push(to);
            }
        }
    }
    hole
}

/// The only patch among the owners of the points beside a hole; `None` if there is none or
/// more than one, or if a point of the hole is taken.
fn enclosing(graph: &impl PointGraph, hole: &[usize], owner: &[Option<u32>], taken: &[bool]) -> Option<u32> {
    let mut found = None;
    for &point in hole {
        if taken[point] {
            return None;
        }
        for axis in graph.axes(point) {
            match (owner[axis.to? as usize], found) {
                (Some(one), Some(other)) if one != other => return None,
                (None, _) => {}
                (one, _) => found = one,
            }
        }
    }
    found
}

impl Labelled {
    /// Gives a value below 0 to light points beside two patches.
    pub fn part(&mut self, graph: &impl PointGraph, least: f64) {
        for point in self.light() {
            if between(graph, &self.owner, point, least, |one, other| one != other) {
                self.values[point] = BETWEEN;
            }
        }
    }

    fn light(&self) -> Vec<usize> {
        (0..self.owner.len()).filter(|point| self.owner[*point].is_none()).collect()
    }

    /// Lowers the light points between patches that form one region of `field` above `level`, and makes islands beside a patch
    /// light. Returns whether there were any.
    pub fn mend(&mut self, graph: &Delaunay, least: f64, field: &Field, level: f32) -> bool {
        let lit = self.darken_islands(graph, field, level + MARGIN);
        let parted = self.part_merged(
            graph,
            least,
            &Parts::new(graph, &self.owner, field, level - MARGIN, Touch::Corners),
        );
        lit || parted
    }

    fn darken_islands(&mut self, graph: &Delaunay, field: &Field, level: f32) -> bool {
        let parts = Parts::new(graph, &self.owner, field, level, Touch::Sides);
        let is_island = |point: &usize| {
            self.owner[*point].is_some_and(|patch| {
                parts.region[*point].is_some_and(|region| parts.main(patch) != Some(region))
            })
        };
        let islands: Vec<usize> = (0..self.owner.len()).filter(is_island).collect();
        for point in &islands {
            (self.owner[*point], self.values[*point]) = (None, 0.0);
        }
        !islands.is_empty()
    }

    fn part_merged(&mut self, graph: &Delaunay, least: f64, parts: &Parts) -> bool {
        let merged = |one: u32, other: u32| {
            one != other && parts.main(one).is_some() && parts.main(one) == parts.main(other)
        };
        let mut changed = false;
        for point in self.light() {
            if self.values[point] > LOWEST && between(graph, &self.owner, point, least, merged) {
                self.values[point] = (self.values[point] - LOWERED).max(LOWEST);
                changed = true;
            }
        }
        changed
    }
}

/// The regions of a field in which the patches' points lie.
struct Parts {
    /// For each point of a patch on the canvas, its region, if any.
    region: Vec<Option<u32>>,
    /// Patches in order, each with the region that holds the largest part of its points' area.
    main: Vec<(u32, u32)>,
}

impl Parts {
    fn new(graph: &Delaunay, owner: &[Option<u32>], field: &Field, level: f32, touch: Touch) -> Self {
        let (grid, regions) = (field.grid(), regions(field, level, touch));
        let region = |point: usize| {
            let at = graph.points[point];
            let seen = owner[point].is_some() && graph.extent.contains(at);
            seen.then(|| regions[grid.cell_at(grid.to_cells(at))]).filter(|region| *region != NOWHERE)
        };
        let region: Vec<Option<u32>> = (0..owner.len()).map(region).collect();
        let mut areas: BTreeMap<(u32, u32), f64> = BTreeMap::new();
        for point in 0..owner.len() {
            if let (Some(patch), Some(region)) = (owner[point], region[point]) {
                *areas.entry((patch, region)).or_default() += graph.area(point);
            }
        }
        let mut main: Vec<(u32, u32)> = Vec::new();
        let mut largest = 0.0;
        for ((patch, region), area) in areas {
            let known = main.last().is_some_and(|last| last.0 == patch);
            if !known || area > largest {
                if known {
                    main.pop();
                }
                main.push((patch, region));
                largest = area;
            }
        }
        Self { region, main }
    }

    /// The region of the largest part of a patch.
    fn main(&self, patch: u32) -> Option<u32> {
        self.main.binary_search_by_key(&patch, |part| part.0).ok().map(|index| self.main[index].1)
    }
}

/// The neighbourhood that joins cells above a level to one region.
#[derive(Clone, Copy, PartialEq)]
enum Touch {
    /// A common side. The contour may join further cells, so that separate regions may be one patch.
    Sides,
    /// A common side or corner. The contour may separate some of them, so that one region may be two patches.
    Corners,
}

/// Regions are tested for joining at the level − this value, and for separation at the level + this value: between the cells'
/// centres the smooth surface may be higher or lower than at any of them.
const MARGIN: f32 = 0.03;

/// Whether two patches that fulfil the condition `two` both lie beside a point, or opposite to it across an edge of less clearance
/// than `least`.
fn between(
    graph: &impl PointGraph,
    owner: &[Option<u32>],
    point: usize,
    least: f64,
    two: impl Fn(u32, u32) -> bool,
) -> bool {
    let across = graph.opposite(point).filter(|(_, clearance)| *clearance < least).map(|(other, _)| other);
    let beside: Vec<u32> = graph.neighbours(point).chain(across).filter_map(|other| owner[other]).collect();
    beside.iter().enumerate().any(|(k, one)| beside[..k].iter().any(|other| two(*one, *other)))
}

/// The region of a cell that is not above the level.
const NOWHERE: u32 = u32::MAX;

/// The region above `level` of each cell, for this neighbourhood.
fn regions(field: &Field, level: f32, touch: Touch) -> Vec<u32> {
    let [nx, ny] = field.grid().size;
    let mut sets = UnionFind::default();
    let mut labels = vec![NOWHERE; nx * ny];
    for cell in 0..nx * ny {
        if field.values[cell] <= level {
            continue;
        }
        let (column, row) = (cell % nx, cell / nx);
        let cornered = touch == Touch::Corners && row > 0;
        let before = [
            (column > 0).then(|| cell - 1),
            (row > 0).then(|| cell - nx),
            (cornered && column > 0).then(|| cell - nx - 1),
            (cornered && column + 1 < nx).then(|| cell - nx + 1),
        ];
        let beside = before.into_iter().flatten().map(|other| labels[other]);
        let region = beside.filter(|region| *region != NOWHERE).reduce(|a, b| sets.join(a, b, [0, 0]));
        labels[cell] = region.unwrap_or_else(|| sets.add());
    }
    if field.edges == Edges::Wrap {
        let mut join = |one: usize, other: usize| {
            if labels[one] != NOWHERE && labels[other] != NOWHERE {
                sets.join(labels[one], labels[other], [0, 0]);
            }
        };
        let reach = if touch == Touch::Corners { -1..=1 } else { 0..=0 };
        let beside =
            |k: usize, by: isize, count: usize| (k as isize + by).rem_euclid(count as isize) as usize;
        for by in reach {
            (0..ny).for_each(|row| join(row * nx, beside(row, by, ny) * nx + nx - 1));
            (0..nx).for_each(|column| join(column, (ny - 1) * nx + beside(column, by, nx)));
        }
    }
    labels.iter_mut().filter(|label| **label != NOWHERE).for_each(|label| *label = sets.find(*label).0);
    labels
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::points::discs::poisson_discs;
    use crate::points::extent::Extent;
    use crate::points::metric::Metric;

    #[test]
    fn regions_are_joined_across_borders_that_wrap_only() {
        let stripes = |edges| {
            Field::from_fn([9, 6], [1.0, 1.0], edges, |[x, _]| f32::from(u8::from((x - 4.5).abs() > 2.0)))
        };
        assert_eq!([Edges::Closed, Edges::Wrap].map(|edges| count(&stripes(edges), Touch::Sides)), [2, 1]);
    }

    /// Number of regions above ½.
    fn count(field: &Field, touch: Touch) -> usize {
        let mut found = regions(field, 0.5, touch);
        found.retain(|region| *region != NOWHERE);
        found.sort_unstable();
        found.dedup();
        found.len()
    }

    #[test]
    fn cells_that_share_a_corner_are_one_region_where_corners_count() {
        let cells = |lit: &'static [[u32; 2]], edges| {
            Field::from_fn([6, 6], [1.0, 1.0], edges, move |[x, y]| {
                f32::from(u8::from(lit.contains(&[x as u32, y as u32])))
            })
        };
        for lit in [&[[2, 2], [3, 3]], &[[3, 2], [2, 3]]] {
            let field = cells(lit, Edges::Closed);
            assert_eq!([Touch::Sides, Touch::Corners].map(|touch| count(&field, touch)), [2, 1]);
        }
        // The corners of a tile touch each other, and so do the last cell of a row and the first cell of the next.
        for lit in [&[[0, 0], [5, 5]], &[[5, 2], [0, 3]], &[[2, 5], [3, 0]]] {
            let of = |edges| [Touch::Sides, Touch::Corners].map(|touch| count(&cells(lit, edges), touch));
            assert_eq!([of(Edges::Closed), of(Edges::Wrap)], [[2, 2], [2, 1]]);
        }
    }

    #[test]
    fn small_holes_that_a_patch_encloses_are_filled_and_others_are_not() {
        let extent = Extent { size: [90.0, 90.0], wrap: [false; 2] };
        let mut rng = Pcg64Mcg::seed_from_u64(3);
        let points = poisson_discs(&extent, 20.0, &|_| Metric::circle(4.0), &[], &mut rng);
        let graph = Delaunay::new(&points, extent);
        let away = |at: [f64; 2], from: [f64; 2]| libm::hypot(at[0] - from[0], at[1] - from[1]);
        let holes = [[30.0, 40.0], [60.0, 40.0]];
        // A disc with a hole of two or three points at each of two places, and one with a large hole.
        let filled = |hole: f64, is_taken: bool| {
            let light = |at: [f64; 2]| holes.iter().any(|from| away(at, *from) < hole);
            let dark = |at: &[f64; 2]| away(*at, [45.0, 45.0]) < 38.0 && !light(*at);
            let mut owner: Vec<Option<u32>> = points.iter().map(|at| dark(at).then_some(7)).collect();
            let taken: Vec<bool> = points.iter().map(|at| is_taken && light(*at)).collect();
            fill(&graph, &mut owner, &taken, 0.2);
            let inside = points.iter().zip(&owner).filter(|(at, _)| light(**at));
            let count = inside.clone().count();
            (inside.filter(|(_, owner)| owner.is_some()).count(), count, owner.iter().flatten().count())
        };
        let (given, of, dark) = filled(5.0, false);
        assert!(given == of && of > 3 && dark < points.len() / 2, "{given} of {of}, {dark}");
        assert_eq!(filled(5.0, true).0, 0);
        assert_eq!(filled(14.0, false).0, 0);
    }
}
