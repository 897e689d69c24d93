//! Regions for which measurements are counted.

use crate::attributes::regions::RegionGrid;

/// Regions of a canvas.
#[derive(Clone, Copy)]
pub enum Regions<'a> {
    /// The regions of a grid.
    Grid(&'a RegionGrid),
    /// A number of regions, with a function that returns the region of a place, px.
    Any(usize, &'a (dyn Fn([f64; 2]) -> usize + Sync)),
}

impl<'a> Regions<'a> {
    /// The whole canvas.
    pub const ONE: Self = Self::Any(1, &|_| 0);

    /// Number of regions.
    #[must_use]
    pub fn count(&self) -> usize {
        match self {
            Self::Grid(grid) => grid.len(),
            Self::Any(count, _) => *count,
        }
    }

    /// The region of a place, px, below [`Self::count`].
    #[must_use]
    pub fn of(&self, place: [f64; 2]) -> usize {
        match self {
            Self::Grid(grid) => grid.index(grid.region_of(place)),
            Self::Any(_, of) => of(place),
        }
    }

    /// The regions of the places at `xs` in any row, px.
    pub(super) fn at(self, xs: Vec<f64>) -> RegionsAt<'a> {
        let columns = match self {
            Self::Grid(grid) => xs.iter().map(|x| grid.region_of([*x, 0.0])[0] as u32).collect(),
            Self::Any(..) => Vec::new(),
        };
        RegionsAt { regions: self, xs, columns }
    }
}

/// The regions of places in rows: those of a grid are found by column and row.
pub(super) struct RegionsAt<'a> {
    regions: Regions<'a>,
    xs: Vec<f64>,
    /// By place, the column of a grid.
    columns: Vec<u32>,
}

impl RegionsAt<'_> {
    /// The regions of the row at `y`, px, by the index of the place.
    pub(super) fn row(&self, y: f64) -> impl Fn(usize) -> usize {
        let first = match self.regions {
            Regions::Grid(grid) => grid.index([0, grid.region_of([0.0, y])[1]]),
            Regions::Any(..) => 0,
        };
        move |place| match self.regions {
            Regions::Grid(_) => first + self.columns[place] as usize,
            Regions::Any(_, of) => of([self.xs[place], y]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    #[test]
    fn places_in_a_row_are_in_the_regions_in_which_they_are_one_by_one() {
        for edges in [Edges::Closed, Edges::Wrap] {
            let grid = RegionGrid { size: [70.0, 50.0], grid: [3, 4], edges };
            let xs: Vec<f64> = (0..=70).map(f64::from).collect();
            let of = |place| grid.index(grid.region_of(place));
            for regions in [Regions::Grid(&grid), Regions::Any(12, &of)] {
                let at = regions.at(xs.clone());
                for y in 0..=50 {
                    let row = at.row(f64::from(y));
                    assert!((0..xs.len()).all(|i| row(i) == of([xs[i], f64::from(y)])), "{edges:?} {y}");
                }
                assert_eq!(regions.count(), 12);
            }
        }
    }
}
