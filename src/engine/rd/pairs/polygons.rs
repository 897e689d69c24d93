//! Cells: areas side by side, separated by lines of one width. They grow by one isotropic pair.
//!
//! Witkin and Kass's "reptile" and "giraffe" (their figure 3). The reaction begins as 1 in the cells and 0 on the lines between
//! them. With a threshold below 0 cells stay full, since there D = 0, and lines keep a width that follows from the size
//! s of the pair and, weakly, from the distance L of the cells:
//!
//! gap = 3.8 s − 11.8 s² ÷ L
//!
//! Measured at θ/K₀ = −0.1 from lines 2.5 s wide, after T = 10, for Voronoi cells with L/s from 9 to 40; every cell kept its place
//! (`facts.md` W). The gap is the area outside all cells ÷ half the length of the edges. It reduces a cell of the area A to
//!
//! √A = L − (0.965 − 0.48 gap ÷ L) gap
//!
//! since corners become rounder as lines become wider.

use super::shared_description::USUAL_DUTY;
use super::{Blurs, Combination, Course, MOST_PAIRS, PairModel};
use crate::attributes::Attribute;
use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::pair_columns::CELLS as CELLS_COLUMNS;
use crate::attributes::system::{Description, Family, Keys, LookupBy, picture};
use crate::rd::systems::embedded;

/// The description of cells. They follow from a law; training rows hold its error.
pub static POLYGONS: Description = Description {
    name: "cells",
    title: "Cells",
    noun: "cells",
    help: "Cells side by side, parted by lines, as on a giraffe or a reptile",
    picture: picture!("cells"),
    kind: Family::Areas,
    lines_beside: Some(
        "A layer holds ellipses or lines; only cells have lines beside them, which give the width of the lines between cells",
    ),
    free_spacing: true,
    option_keys: &["keep", "gap"],
    own_keys: &[Keys {
        keys: &["options.gap"],
        reason: "Only cells have this option: set \"system\" to \"cells\"",
    }],
    refused_keys: &[Keys {
        keys: &["maps.spacing"],
        reason: "The distance of cells follows from their area, which can have a map, and from the width of the lines between them",
    }],
    lookup: LookupBy::Pairs(&Coordinates {
        by_directions: false,
        asked: &[("sparse", Scale::Log), ("aspect", Scale::Plain)],
        answered: &[Coordinates::FACTOR, ("apart", Scale::Log)],
        duty: USUAL_DUTY,
    }),
    grown_errors: &[(Attribute::Area, [3.0, 8.0]), (Attribute::Gap, [4.0, 10.0])],
    columns: &CELLS_COLUMNS,
    training: embedded!["cells"],
    ..Description::PLAIN
};

/// The form of the blurs.
pub const BLURS: Blurs = Blurs::Round;
/// θ/K₀.
const THRESHOLD: f32 = -0.1;
/// w/K₀: 0.7 of the threshold, so that the reaction in a cell is 1.
const SOFTNESS: f32 = 0.07;
/// Time of the growth, in 1/b: after 30 the gaps were equal within 2 %, but corners rounder.
pub const TIME: f64 = 10.0;
/// Time after it, in 1/b, in which the reaction is the share of each cell of the grid above the threshold. Before, edges keep to the
/// borders of these cells, and those that are nearly along x or y have steps.
pub const SMOOTHING: f64 = 1.0;
/// The coefficients of the law of gaps, see the top.
const GAP: [f64; 2] = [3.8, 11.8];
/// The coefficients of the law of areas, see the top.
const TAKEN: [f64; 2] = [0.965, 0.48];
/// Least L ÷ gap, at L/s = 9: the gaps of closer cells vanish.
const LEAST_DISTANCE: f64 = 3.6;

/// The reaction.
#[must_use]
pub fn model() -> PairModel {
    PairModel {
        combination: Combination::Maximum,
        ratio: 1.5,
        threshold: Course::Constant(THRESHOLD),
        softness: SOFTNESS,
        weights: [1.0; MOST_PAIRS],
        gain: Course::Constant(1.0),
    }
}

/// The size s of the pair that keeps lines of width `gap` between cells at the distance `distance`, √(canvas ÷ cells); all in one
/// unit.
#[must_use]
pub fn size(gap: f64, distance: f64) -> f64 {
    let distance = distance.max(LEAST_DISTANCE * gap);
    let [a, b] = GAP;
    // The smaller root of b s²/L − a s + gap = 0, which exists down to the least distance.
    distance * (a - (a * a - 4.0 * b * gap / distance).max(0.0).sqrt()) / (2.0 * b)
}

/// The distance L = √(canvas ÷ cells) of cells with the side √A = `side` and lines of width `gap` between them; all in one unit.
#[must_use]
pub fn distance(side: f64, gap: f64) -> f64 {
    let [a, b] = TAKEN;
    // The larger root of L² − (side + a gap) L + b gap² = 0.
    let sum = side + a * gap;
    0.5 * (sum + (sum * sum - 4.0 * b * gap * gap).max(0.0).sqrt())
}

/// The widest lines between cells with the side √A `side`, in its unit.
#[must_use]
pub fn widest_gap(side: f64) -> f64 {
    let [a, b] = TAKEN;
    side / (LEAST_DISTANCE - a + b / LEAST_DISTANCE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Domain, Edges, Grid};
    use crate::rd::pairs::{PairField, PairGrowth, PairParameterField, PairStart};

    #[test]
    fn gaps_of_the_law_have_their_size() {
        for (gap, distance) in [(5.0, 18.0), (5.0, 25.0), (8.0, 80.0), (3.0, 300.0)] {
            let s = size(gap, distance);
            let found = GAP[0] * s - GAP[1] * s * s / distance;
            assert!((found / gap - 1.0).abs() < 1e-9, "{gap} {distance}: {s}");
        }
        for (side, gap) in [(20.0, 5.0), (60.0, 8.0)] {
            let l = distance(side, gap);
            assert!((l - (TAKEN[0] - TAKEN[1] * gap / l) * gap - side).abs() < 1e-9, "{side} {gap}: {l}");
        }
        assert!((distance(20.0, widest_gap(20.0)) - LEAST_DISTANCE * widest_gap(20.0)).abs() < 1e-9);
        // Closer than cells can be: the size for the least distance.
        assert!((size(5.0, 10.0) - size(5.0, LEAST_DISTANCE * 5.0)).abs() < 1e-12);
    }

    const SIDE: usize = 128;
    /// Rows by which lines fall from one column to the next.
    const SLOPE: f64 = 0.125;
    /// Rows between two lines.
    const APART: f64 = 16.0;
    /// Where a line begins below its row at column 0, and how wide it is, rows.
    const LINE: [f64; 2] = [5.0, 4.4];

    /// How sharp the corners are that the grid gives to the upper edges of lines between cells, where the field falls to ½: by how much an
    /// edge departs at a column from the middle between the columns beside; cells, root mean square.
    fn corners(field: &[f32]) -> f64 {
        let place = |x: usize| {
            let first = (SLOPE * x as f64 + APART + LINE[0]) as usize - 4;
            let row = (first..first + 8).find(|y| field[(y + 1) * SIDE + x] < 0.5).expect("an edge");
            let [above, below] = [row, row + 1].map(|y| f64::from(field[y * SIDE + x]));
            row as f64 + (0.5 - above) / (below - above)
        };
        let columns = 32..96;
        let departures = columns.clone().map(|x| place(x) - 0.5 * (place(x - 1) + place(x + 1)));
        (departures.map(|away| away * away).sum::<f64>() / columns.len() as f64).sqrt()
    }

    #[test]
    fn smoothing_takes_more_than_half_of_the_corners_of_the_grid_off_edges() {
        let grid = Grid::unit([SIDE; 2], Edges::Wrap);
        let pair = PairField::uniform(grid.cells(), 0.0, 1.75, BLURS);
        let maps = PairParameterField { grid, pairs: vec![pair], obstacles: Vec::new(), raised: Vec::new() };
        let model = model();
        // Lines that close over the border: over all columns they fall by one distance.
        let reaction = |cell: usize| {
            let [x, y] = [cell % SIDE, cell / SIDE].map(|k| k as f64);
            let away = (y - SLOPE * x).rem_euclid(APART) - LINE[0];
            f32::from(u8::from(!(0.0..LINE[1]).contains(&away)))
        };
        let start = PairStart::Drawn((0..SIDE * SIDE).map(reaction).collect());
        let mut growth = PairGrowth::new(&maps, &model, &start).expect("one pair");
        growth.advance(growth.steps_in(TIME));
        let before = corners(&growth.concentrations()[0]);
        let last = growth.steps_in(TIME + SMOOTHING);
        while growth.steps() < last {
            growth.advance_by_shares(&model, &[]).expect("one pair");
        }
        let after = corners(&growth.concentrations()[0]);
        assert!(after < 0.5 * before, "{after} after {before}");
    }
}
