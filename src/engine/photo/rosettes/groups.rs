//! Blotches that stand close together, as groups: the ink closed by a disc, and what it encloses.

use super::super::watershed::{component, fill};
use crate::grid::distance::{length, nearest};
use crate::grid::{Field, Grid};

/// A blotch of less than this share of the usual area is a speck.
const SPECK: f64 = 0.1;
/// Least depth of a dot inside the outline of its group, in √area of the group.
const DEEP: f64 = 0.17;

/// The ink of a picture.
pub struct Ink {
    grid: Grid,
    /// The blotch of each cell of ink, from 1; 0 on the ground.
    owners: Vec<u32>,
    /// Whether each blotch is large enough to count.
    counts: Vec<bool>,
}

/// A group of blotches with what they enclose.
#[derive(Clone, Debug)]
pub struct Group {
    /// Its cells.
    pub cells: Vec<usize>,
    /// Whether the border of the picture does not cut it.
    pub whole: bool,
    /// How many of its cells are ink.
    pub ink: usize,
    /// Its area ÷ that of the ellipse with its second moments.
    pub fill: f64,
    /// The greatest distance of an enclosed cell from the ink, cells.
    pub hole: f32,
    /// How many blotches stand at its outline.
    pub blotches: usize,
    /// How many stand inside.
    pub dots: usize,
}

impl Ink {
    /// The ink above `level`; `None` if there is none.
    pub fn new(field: &Field, level: f32) -> Option<Self> {
        // Cells are square: distances are counted in cells.
        let grid = Grid { cell: [1.0; 2], ..field.grid() };
        let ink: Vec<bool> = field.values.iter().map(|value| *value > level).collect();
        if !ink.contains(&true) {
            return None;
        }
        let mut seen: Vec<bool> = ink.iter().map(|ink| !ink).collect();
        let mut owners = vec![0; seen.len()];
        let mut sizes = Vec::new();
        for start in 0..owners.len() {
            if !seen[start] {
                let cells = component(start, &mut seen, grid.size);
                sizes.push(cells.len());
                cells.iter().for_each(|cell| owners[*cell] = sizes.len() as u32);
            }
        }
        let least = SPECK * crate::measure::usual_area(sizes.iter().map(|size| *size as f64));
        let counts = sizes.iter().map(|size| *size as f64 >= least).collect();
        Some(Self { grid, owners, counts })
    }

    /// The number of cells of the picture.
    pub fn cells(&self) -> usize {
        self.owners.len()
    }

    /// The number of blotches.
    pub fn blotches(&self) -> usize {
        self.counts.iter().filter(|counts| **counts).count()
    }

    /// Whether a cell is ink.
    pub fn holds(&self, cell: usize) -> bool {
        self.owners[cell] > 0
    }

    /// The groups of ink that gaps of up to twice `reach` cells do not part: the ground is where a disc of this radius fits between
    /// the ink and comes from the border, from the largest such place or from what is `taken`, which belongs to no group.
    pub fn groups(&self, reach: f32, taken: &[bool]) -> Vec<Group> {
        let size = self.grid.size;
        let free: Vec<bool> = (0..taken.len()).map(|cell| self.holds(cell) && !taken[cell]).collect();
        let Some(away) = distances(&free, &self.grid) else { return Vec::new() };
        let outside = self.outside(&away, reach, taken);
        let Some(outside) = distances(&outside, &self.grid) else { return Vec::new() };
        let depths = self.depths(&outside, reach);
        let is_in = |cell: usize| !taken[cell] && (free[cell] || outside[cell] > reach);
        let mut seen: Vec<bool> = (0..taken.len()).map(|cell| !is_in(cell)).collect();
        let mut met = vec![false; self.counts.len()];
        let mut groups = Vec::new();
        for start in 0..taken.len() {
            if !seen[start] {
                groups.push(self.group(component(start, &mut seen, size), &away, &depths, &mut met));
            }
        }
        groups
    }

    /// What is taken, and the cells around which a disc of radius `reach` fits between the ink, but for those that ink encloses.
    fn outside(&self, away: &[f32], reach: f32, taken: &[bool]) -> Vec<bool> {
        let size = self.grid.size;
        let mut seen: Vec<bool> =
            away.iter().zip(taken).map(|(away, taken)| *away <= reach || *taken).collect();
        let mut outside = taken.to_vec();
        let mut largest = Vec::new();
        for start in 0..outside.len() {
            if seen[start] {
                continue;
            }
            let cells = component(start, &mut seen, size);
            if cells.iter().any(|cell| is_at_border(*cell, size)) {
                cells.iter().for_each(|cell| outside[*cell] = true);
            }
            if cells.len() > largest.len() {
                largest = cells;
            }
        }
        largest.iter().for_each(|cell| outside[*cell] = true);
        outside
    }

    /// The least depth of the cells of each blotch inside the outline of its group, `reach` from the outside, cells.
    fn depths(&self, outside: &[f32], reach: f32) -> Vec<f32> {
        let mut depths = vec![f32::INFINITY; self.counts.len()];
        for (owner, away) in self.owners.iter().zip(outside).filter(|(owner, _)| **owner > 0) {
            let depth = &mut depths[*owner as usize - 1];
            *depth = depth.min(*away - reach);
        }
        depths
    }

    fn group(&self, cells: Vec<usize>, away: &[f32], depths: &[f32], met: &mut [bool]) -> Group {
        let size = self.grid.size;
        let deep = (DEEP * (cells.len() as f64).sqrt()) as f32;
        let (mut ink, mut hole, mut blotches, mut dots) = (0, 0.0_f32, 0, 0);
        for cell in &cells {
            hole = hole.max(away[*cell]);
            let Some(blotch) = (self.owners[*cell] as usize).checked_sub(1) else { continue };
            ink += 1;
            if std::mem::replace(&mut met[blotch], true) || !self.counts[blotch] {
                continue;
            }
            *if depths[blotch] > deep { &mut dots } else { &mut blotches } += 1;
        }
        let whole = !cells.iter().any(|cell| is_at_border(*cell, size));
        let fill = fill(cells.iter().copied(), size[0]);
        Group { cells, whole, ink, fill, hole, blotches, dots }
    }
}

/// The distance of each cell from the nearest of some cells, cells; `None` without any.
fn distances(to: &[bool], grid: &Grid) -> Option<Vec<f32>> {
    Some(nearest(to, grid)?.into_iter().map(|offset| length(offset, grid) as f32).collect())
}

fn is_at_border(cell: usize, [width, height]: [usize; 2]) -> bool {
    let (x, y) = (cell % width, cell / width);
    x == 0 || y == 0 || x + 1 == width || y + 1 == height
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    /// Four discs of radius 6 around a place 12 px from each, with a dot in it; a disc of radius 9 apart; and one at the border.
    fn field() -> Field {
        let middle = [40.0, 40.0];
        let around = [[12.0, 0.0], [0.0, 12.0], [-12.0, 0.0], [0.0, -12.0]];
        let mut discs: Vec<([f64; 2], f64)> =
            around.iter().map(|[x, y]| ([middle[0] + x, middle[1] + y], 7.0)).collect();
        discs.extend([(middle, 2.5), ([90.0, 40.0], 9.0), ([0.0, 90.0], 9.0)]);
        Field::from_fn([120, 100], [1.0; 2], Edges::Closed, |[x, y]| {
            let inside = |([cx, cy], r): &([f64; 2], f64)| 0.5 + 0.5 * (r - (x - cx).hypot(y - cy));
            discs.iter().map(inside).fold(0.0, f64::max).min(1.0) as f32
        })
    }

    #[test]
    fn blotches_around_a_place_are_one_group_with_what_they_enclose() {
        let ink = Ink::new(&field(), 0.5).unwrap();
        let mut groups = ink.groups(2.5, &[false; 12_000]);
        groups.sort_by_key(|group| group.cells.len());
        let found: Vec<_> =
            groups.iter().map(|group| (group.whole, group.blotches, group.dots, group.hole > 1.5)).collect();
        assert_eq!(found, [(false, 1, 0, false), (true, 1, 0, false), (true, 4, 1, true)]);
        assert!(groups[2].fill > 0.85 && groups[2].ink < groups[2].cells.len(), "{}", groups[2].fill);
    }

    #[test]
    fn what_is_taken_is_in_no_group_and_parts_others() {
        let ink = Ink::new(&field(), 0.5).unwrap();
        let none = [false; 12_000];
        let ring = ink.groups(2.5, &none).into_iter().max_by_key(|group| group.cells.len()).unwrap();
        let mut taken = none;
        ring.cells.iter().for_each(|cell| taken[*cell] = true);
        assert_eq!(ink.groups(30.0, &taken).iter().map(|group| group.ink).max(), Some(256));
    }

    #[test]
    fn a_reach_below_half_of_the_gaps_joins_nothing() {
        let ink = Ink::new(&field(), 0.5).unwrap();
        assert_eq!((ink.blotches(), ink.groups(0.5, &[false; 12_000]).len()), (7, 7));
    }
}
