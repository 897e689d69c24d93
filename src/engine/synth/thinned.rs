//! Layers whose marks are the rarer the farther away from the marks beneath they are: independent thinning of what has grown.
//!
//! A grown mark stays with the probability p(D) = exp(−D ÷ d), where D is the distance from its edge to the nearest mark beneath
//! (D. Stoyan, W. S. Kendall, J. Mecke, "Stochastic Geometry and its Applications", 1995, 5.1: p(x)-thinning). A drawn mark stays.
//! Marks that stay are as they have grown, and what the report says of a layer was measured before.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::grid::{Field, Grid, UnionFind, distance};
use crate::synth::pattern::{self, EDGE, LayerPattern, PatternRows};

/// Cells of the thinned pattern for each cell that the layer grew on.
const FINER: f64 = 2.0;
/// Half the width of the border between what is removed and what stays, cells.
const BORDER: f64 = 2.0;
/// Memory of a cell of the thinned pattern, bytes: two fields, three maps of distances, the marks, and what these take while they are made.
const BYTES: f64 = 62.0;
/// Combined with the layer's seed, so that thinning has random numbers of its own.
const SEED: u64 = 0x7468_696E_6E69_6E67;

/// The thinning of a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thinning {
    /// The distance d, px.
    pub near: f64,
    /// Seed of the random numbers.
    pub seed: u64,
}

impl Thinning {
    /// Bytes of memory that it needs for a layer that grows on `grid` cells.
    #[must_use]
    pub fn bytes(grid: [usize; 2]) -> f64 {
        BYTES * FINER * FINER * grid[0] as f64 * grid[1] as f64
    }

    /// The `pattern` of a grown layer without the marks that are removed; `None` where all stay. `beneath` are the patterns of the marks
    /// beneath, `drawn` the places of drawn marks, px.
    #[must_use]
    pub fn applied(
        &self,
        pattern: &dyn PatternRows,
        beneath: &[LayerPattern],
        drawn: &[[f64; 2]],
    ) -> Option<Field> {
        let grid = pattern.grid();
        let coarse = pattern.field(grid[0], grid[1]);
        let field = pattern::finer(pattern, &coarse, FINER);
        let mut covered = vec![false; field.values.len()];
        for other in beneath {
            let other = other.field(field.width, field.height);
            covered.iter_mut().zip(&other.values).for_each(|(covered, value)| *covered |= *value >= EDGE);
        }
        self.without_removed(field, &covered, drawn)
    }

    fn without_removed(&self, field: Field, covered: &[bool], drawn: &[[f64; 2]]) -> Option<Field> {
        let grid = field.grid();
        let to_beneath = distance::nearest(covered, &grid)?;
        let roots = roots(&field);
        let mut nearest = vec![f64::INFINITY; roots.len()];
        for (cell, root) in roots.iter().enumerate().filter(|(_, root)| **root != NONE) {
            let root = *root as usize;
            nearest[root] = nearest[root].min(distance::length(to_beneath[cell], &grid));
        }
        let mut stays = vec![true; roots.len()];
        let mut random = Pcg64Mcg::seed_from_u64(self.seed ^ SEED);
        // A set begins at its root, so that each mark gets its number in the order of the rows.
        for cell in (0..roots.len()).filter(|cell| roots[*cell] == *cell as u32) {
            stays[cell] = random.random::<f64>() < libm::exp(-nearest[cell] / self.near);
        }
        for place in drawn {
            let at = grid.to_cells(grid.bounds_px().inside(*place));
            let [column, row] = [0, 1].map(|axis| (at[axis].max(0.0) as usize).min(grid.size[axis] - 1));
            let root = roots[grid.index([column, row])];
            if root != NONE {
                stays[root as usize] = true;
            }
        }
        let of = |wanted: bool| -> Vec<bool> {
            roots.iter().map(|root| *root != NONE && stays[*root as usize] == wanted).collect()
        };
        let removed = of(false);
        let to_removed = distance::nearest(&removed, &grid)?;
        let to_kept = distance::nearest(&of(true), &grid);
        Some(removed_from(field, &grid, &to_removed, to_kept.as_deref()))
    }
}

/// No mark.
const NONE: u32 = u32::MAX;

/// For each cell the first cell of its mark.
fn roots(field: &Field) -> Vec<u32> {
    let (width, height) = (field.width, field.height);
    let is_mark = |cell: usize| field.values[cell] >= EDGE;
    let mut sets = UnionFind::new(field.values.len());
    for cell in (0..field.values.len()).filter(|cell| is_mark(*cell)) {
        let (x, y) = (cell % width, cell / width);
        let right = field.edges.index(x as isize + 1, width);
        let below = field.edges.index(y as isize + 1, height);
        for other in [y * width + right, below * width + x] {
            if is_mark(other) {
                sets.join(cell as u32, other as u32, [0, 0]);
            }
        }
    }
    (0..field.values.len()).map(|cell| if is_mark(cell) { sets.root(cell as u32).0 } else { NONE }).collect()
}

/// The field without what is nearer to removed marks than to those that stay; halfway it passes into the ground.
fn removed_from(
    mut field: Field,
    grid: &Grid,
    to_removed: &[[i32; 2]],
    to_kept: Option<&[[i32; 2]]>,
) -> Field {
    let border = BORDER * grid.px_a_cell();
    for (cell, value) in field.values.iter_mut().enumerate() {
        let to_kept = to_kept.map_or(f64::INFINITY, |to_kept| distance::length(to_kept[cell], grid));
        let nearer = distance::length(to_removed[cell], grid) - to_kept;
        let share = (0.5 + 0.5 * nearer / border).clamp(0.0, 1.0);
        // What stays is not changed.
        if to_kept > 0.0 {
            *value *= share as f32;
        }
    }
    field
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;
    use crate::synth::pattern::AreaPattern;

    const SIDE: usize = 240;

    /// Discs of radius 3, every 12 px, and a mark beneath along the left side, 2 px wide.
    fn discs() -> (Field, Vec<bool>) {
        let field = Field::from_fn([SIDE; 2], [1.0; 2], Edges::Wrap, |[x, y]| {
            let off = f64::hypot((x % 12.0) - 6.0, (y % 12.0) - 6.0);
            (0.5 + 0.25 * (3.0 - off)).clamp(0.0, 1.0) as f32
        });
        let beneath = (0..SIDE * SIDE).map(|cell| cell % SIDE < 2).collect();
        (field, beneath)
    }

    fn thinned(near: f64, drawn: &[[f64; 2]]) -> Field {
        let (field, beneath) = discs();
        Thinning { near, seed: 3 }.without_removed(field, &beneath, drawn).expect("some are removed")
    }

    /// The marks of a column of discs.
    fn marks(field: &Field, column: usize) -> usize {
        (0..SIDE / 12).filter(|row| field.values[(12 * row + 6) * SIDE + 12 * column + 6] >= EDGE).count()
    }

    #[test]
    fn marks_are_the_rarer_the_farther_away_they_are() {
        let field = thinned(40.0, &[]);
        let columns: Vec<usize> = (0..SIDE / 12).map(|column| marks(&field, column)).collect();
        let sum = |range: std::ops::Range<usize>| columns[range].iter().sum::<usize>();
        // Of 40 each: exp(−d ÷ 40) at about 8, 50 and 105 px gives 33, 11 and 3.
        let [near, middle, far] = [sum(0..2), sum(4..6), sum(9..11)];
        assert!((27..=39).contains(&near) && (5..=18).contains(&middle) && far <= 8, "{columns:?}");
    }

    #[test]
    fn marks_that_stay_are_not_changed_and_drawn_ones_stay() {
        let (before, _) = discs();
        let drawn = [[126.0, 126.0], [114.0, 18.0]];
        let field = thinned(5.0, &drawn);
        for [x, y] in drawn {
            assert!(field.values[y as usize * SIDE + x as usize] >= EDGE);
        }
        let is_changed = |(before, after): (&f32, &f32)| *after >= EDGE && before != after;
        assert!(!before.values.iter().zip(&field.values).any(is_changed));
        let inks = [&before, &field].map(|field| field.values.iter().filter(|value| **value >= EDGE).count());
        assert!(inks[1] * 3 < inks[0], "{inks:?}");
    }

    #[test]
    fn without_marks_beneath_all_stay() {
        let (field, _) = discs();
        let pattern = AreaPattern::new(&field);
        assert!(Thinning { near: 5.0, seed: 3 }.applied(&pattern, &[], &[]).is_none());
    }
}
