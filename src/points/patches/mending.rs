//! What the level joins or tears though the graph does not: patches that merged, and islands off a patch.

use crate::grid::{Domain, Field, Grid, UnionFind};
use crate::points::delaunay::Delaunay;

/// Whose the points are, and their values.
pub struct Labelled {
    /// The patch of each point; [`KEPT`] for those of kept outlines.
    pub owner: Vec<Option<u32>>,
    /// Value of each point.
    pub values: Vec<f32>,
}

/// Owner of the points of kept outlines.
pub const KEPT: u32 = u32::MAX;

/// Value of light points beside two patches. At 0 one patch in 150 merges at coverages of .6 and more, at −.3 one in 400; lower
/// values take from the level what it needs elsewhere.
const BETWEEN: f32 = -0.2;
/// What a light point between patches that merge is lowered by.
const LOWERED: f32 = 0.5;
/// The lowest value of a point: lower ones would eat into the patches themselves.
const LOWEST: f32 = -2.0;

impl Labelled {
    /// Gives light points beside two patches the value [`BETWEEN`].
    pub fn part(&mut self, graph: &Delaunay, least: f64) {
        for point in self.light() {
            if between(graph, &self.owner, point, least, |one, other| one != other) {
                self.values[point] = BETWEEN;
            }
        }
    }

    fn light(&self) -> Vec<usize> {
        (0..self.owner.len()).filter(|point| self.owner[*point].is_none()).collect()
    }

    /// Lowers the light points between patches that are one region of `field` above `level`, and makes islands off a patch light.
    /// Whether there were such.
    pub fn mend(&mut self, graph: &Delaunay, least: f64, field: &Field, level: f32) -> bool {
        let grid = field.grid();
        let regions = regions(field, level);
        let region = |point: usize| {
            let at = graph.points[point];
            let seen = graph.extent.contains(at);
            seen.then(|| regions[grid.cell_at(grid.to_cells(at))]).filter(|region| *region != NOWHERE)
        };
        // (patch, region, area of the patch's points in it)
        let mut parts: Vec<(u32, u32, f64)> = (0..self.owner.len())
            .filter_map(|point| Some((self.owner[point]?, region(point)?, graph.area(point))))
            .collect();
        parts.sort_by_key(|(patch, region, _)| (*patch, *region));
        parts.dedup_by(|next, sum| {
            let same = (next.0, next.1) == (sum.0, sum.1);
            if same {
                sum.2 += next.2;
            }
            same
        });
        // The largest part of each patch.
        let mut main: Vec<(u32, u32, f64)> = Vec::new();
        for part in &parts {
            match main.last_mut().filter(|last| last.0 == part.0) {
                Some(last) if part.2 > last.2 => *last = *part,
                Some(_) => {}
                None => main.push(*part),
            }
        }
        let main_region = |patch: u32| {
            main.binary_search_by_key(&patch, |part| part.0).ok().map(|index| main[index].1)
        };
        let mut changed = false;
        let islands: Vec<usize> = (0..self.owner.len())
            .filter(|point| {
                let patch = self.owner[*point].filter(|patch| *patch != KEPT);
                patch.is_some_and(|patch| region(*point).is_some_and(|region| main_region(patch) != Some(region)))
            })
            .collect();
        for point in islands {
            (self.owner[point], self.values[point], changed) = (None, 0.0, true);
        }
        let merged = |one: u32, other: u32| {
            one != other && main_region(one).is_some_and(|region| main_region(other) == Some(region))
        };
        for point in self.light() {
            if self.values[point] > LOWEST && between(graph, &self.owner, point, least, merged) {
                self.values[point] = (self.values[point] - LOWERED).max(LOWEST);
                changed = true;
            }
        }
        changed
    }
}

/// Whether `two` patches lie beside a point, or opposite to it across an edge of less clearance than `least`.
fn between(
    graph: &Delaunay,
    owner: &[Option<u32>],
    point: usize,
    least: f64,
    two: impl Fn(u32, u32) -> bool,
) -> bool {
    let across = graph.opposite(point).filter(|(_, clearance)| *clearance < least).map(|(other, _)| other);
    let beside: Vec<u32> = graph.neighbours(point).chain(across).filter_map(|other| owner[other]).collect();
    beside.iter().enumerate().any(|(k, one)| beside[..k].iter().any(|other| two(*one, *other)))
}

/// A cell that is not above the level.
const NOWHERE: u32 = u32::MAX;

/// The region above `level` that each cell belongs to, by cells that share a side.
fn regions(field: &Field, level: f32) -> Vec<u32> {
    let grid: Grid = field.grid();
    let [nx, ny] = grid.size;
    let mut sets = UnionFind::default();
    let mut labels = vec![NOWHERE; nx * ny];
    for cell in 0..nx * ny {
        if field.values[cell] <= level {
            continue;
        }
        let left = if cell % nx > 0 { labels[cell - 1] } else { NOWHERE };
        let above = if cell >= nx { labels[cell - nx] } else { NOWHERE };
        labels[cell] = match (left, above) {
            (NOWHERE, NOWHERE) => sets.add(),
            (one, NOWHERE) | (NOWHERE, one) => one,
            (one, other) => sets.join(one, other, [0, 0]),
        };
    }
    let mut join = |one: usize, other: usize| {
        if labels[one] != NOWHERE && labels[other] != NOWHERE {
            sets.join(labels[one], labels[other], [0, 0]);
        }
    };
    if field.edges == crate::grid::Edges::Wrap {
        (0..ny).for_each(|row| join(row * nx, row * nx + nx - 1));
        (0..nx).for_each(|column| join(column, (ny - 1) * nx + column));
    }
    labels.iter_mut().filter(|label| **label != NOWHERE).for_each(|label| *label = sets.find(*label).0);
    labels
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn regions_are_joined_across_the_border_of_a_tile_alone() {
        let stripes = |edges| Field::from_fn([9, 6], [1.0, 1.0], edges, |[x, _]| f32::from(u8::from((x - 4.5).abs() > 2.0)));
        let count = |edges| {
            let mut found = regions(&stripes(edges), 0.5);
            found.sort_unstable();
            found.dedup();
            found.len() - 1
        };
        assert_eq!((count(Edges::Closed), count(Edges::Wrap)), (2, 1));
    }
}
