//! Spots of any shape: attributes ↔ parameters, in two ranges of shapes with a map each.
//!
//! ```text
//!  aspect asked      0.15 ── narrow ── 0.27 ──────── usual ───────── 1
//!  stretch of rows   ──────── narrow ──────── 0.4
//!                              0.26 ──────────────── usual ───────── 1
//! ```
//!
//! A map divides its features by their standard deviations over its rows. Rows of narrow spots in the map of the others would
//! change these deviations, and so every answer, although narrow spots are rarely drawn.

use super::answer::Prediction;
use super::coverage::Limit;
use super::row::FEWEST_ROWS;
use super::spot_regression::{SpotRegression, elongations};
use super::{Parameters, Row};
use crate::attributes::{Attributes, Spots};

/// Questions about smaller aspects, and predictions for smaller stretches, are for the narrow map.
const NARROW: f64 = 0.27;
/// Rows of smaller stretches are not in the usual map.
const USUAL_ROWS: f64 = 0.26;
/// Rows of larger stretches are not in the narrow map. Up to this value their aspects are beyond [`NARROW`]: the map needs rows on
/// either side of that limit.
const NARROW_ROWS: f64 = 0.4;

/// The maps of a spot set.
pub(super) struct SpotRanges {
    usual: Range,
    /// `None` if too few rows are narrow for a map of their own: the usual map then holds all rows.
    narrow: Option<Range>,
    /// The limits of −ln(aspect) over both maps.
    pub elongation: Limit,
}

/// The map of some of the rows.
struct Range {
    /// Indices of these rows among all rows.
    numbers: Vec<usize>,
    map: SpotRegression,
}

impl Range {
    fn of(rows: &[Row], neighbours: Option<[usize; 3]>, belongs: impl Fn(f64) -> bool) -> Self {
        let chosen = rows.iter().enumerate().filter(|(_, row)| belongs(row.parameters.stretch));
        let (numbers, rows): (Vec<usize>, Vec<Row>) = chosen.map(|(number, row)| (number, *row)).unzip();
        Self { numbers, map: SpotRegression::new(&rows, neighbours) }
    }
}

impl SpotRanges {
    /// The maps of these rows. `neighbours` are the numbers of neighbours of their regressions, where they are known: three of
    /// the usual map, three of the narrow one.
    pub fn new(rows: &[Row], neighbours: &[usize]) -> Self {
        let (known, _) = neighbours.as_chunks::<3>();
        let known = |map: usize| known.get(map).copied();
        let spots = rows.iter().filter_map(|row| match &row.attributes.0 {
            Attributes::Spots(spots) => Some(spots),
            Attributes::Stripes(_) => None,
        });
        let elongation = elongations(spots);
        let usual = rows.iter().filter(|row| row.parameters.stretch >= USUAL_ROWS).count();
        if usual.min(rows.len() - usual) < FEWEST_ROWS {
            return Self { usual: Range::of(rows, known(0), |_| true), narrow: None, elongation };
        }
        let (usual, narrow) = rayon::join(
            || Range::of(rows, known(0), |stretch| stretch >= USUAL_ROWS),
            || Range::of(rows, known(1), |stretch| stretch <= NARROW_ROWS),
        );
        Self { usual, narrow: Some(narrow), elongation }
    }

    /// The numbers of neighbours of all regressions.
    #[cfg(test)]
    pub fn neighbours(&self) -> Vec<usize> {
        let maps = std::iter::once(&self.usual).chain(&self.narrow);
        maps.flat_map(|range| range.map.neighbours()).collect()
    }

    /// The map of most spots.
    pub fn usual(&self) -> &SpotRegression {
        &self.usual.map
    }

    fn range(&self, aspect: f64) -> &Range {
        self.narrow.as_ref().filter(|_| aspect < NARROW).unwrap_or(&self.usual)
    }

    /// The map for questions about spots of this aspect.
    pub fn map(&self, aspect: f64) -> &SpotRegression {
        &self.range(aspect).map
    }

    /// The attributes that grow with parameters.
    pub fn predict(&self, p: &Parameters) -> Prediction {
        self.map(p.stretch).predict(p)
    }

    /// Row, mirror image and weight of each sample that the answer about `spots` uses.
    pub fn near(&self, spots: &Spots) -> Vec<(usize, [f64; 2], f64)> {
        let range = self.range(spots.aspect);
        let near = range.map.near(spots).into_iter();
        near.map(|(row, signs, weight)| (range.numbers[row], signs, weight)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{MEASURED, MEINHARDT, meinhardt};
    use super::super::spot_regression::NARROWEST;
    use super::super::training_set::TrainingSet;
    use super::*;
    use crate::learn::InCells;

    /// Rows of narrow spots, which follow the same laws.
    fn narrow(n: u64) -> Vec<Row> {
        let narrower = |row: Row| {
            let InCells(Attributes::Spots(spots)) = row.attributes else { panic!("rows of spots") };
            // 0.3–1 becomes 0.13–0.26.
            let share = libm::log(row.parameters.stretch / 0.3) / libm::log(1.0 / 0.3);
            let stretch = 0.13 * libm::pow(2.0, share) * 0.9999;
            Row {
                attributes: InCells(Attributes::Spots(Spots { aspect: 0.99 * stretch, ..spots })),
                parameters: Parameters { stretch, ..row.parameters },
                ..row
            }
        };
        meinhardt(n, MEASURED).into_iter().map(narrower).collect()
    }

    fn set(rows: Vec<Row>) -> TrainingSet {
        TrainingSet::from_rows(&MEINHARDT, rows).unwrap()
    }

    fn spots(aspect: f64) -> InCells<Attributes> {
        InCells(Attributes::Spots(Spots { area: 60.0, aspect, angle: 33.0, spacing: Some(26.0) }))
    }

    #[test]
    fn rows_of_narrow_spots_change_no_bit_of_the_answers_about_others() {
        let usual = meinhardt(400, MEASURED);
        let both = set([narrow(300), usual.clone()].concat());
        let alone = set(usual);
        for aspect in [0.27, 0.31, 0.5, 0.9, 1.0] {
            let [with, without] = [&both, &alone].map(|set| set.ask(&spots(aspect)).unwrap().predict(set).0);
            assert_eq!(with.parameters, without.parameters, "{aspect}");
            assert_eq!(with.predicted, without.predicted, "{aspect}");
        }
    }

    #[test]
    fn narrow_spots_get_the_stretch_of_rows_like_them_down_to_the_narrowest() {
        let set = set([narrow(300), meinhardt(400, MEASURED)].concat());
        for aspect in [0.26, 0.2, NARROWEST] {
            let answer = set.ask(&spots(aspect)).unwrap();
            assert!((answer.parameters.stretch * 0.99 / aspect - 1.0).abs() < 0.02, "{answer:?}");
            assert!(answer.notes.0.is_empty(), "{answer:?}");
        }
        let note = set.ask(&spots(0.1)).unwrap().notes.0[0].to_string();
        assert_eq!(note, "aspect 0.1 is too narrow: the narrowest possible is 0.15, which grows instead");
    }

    #[test]
    fn the_neighbours_of_narrow_spots_are_numbered_among_all_rows() {
        let set = set([meinhardt(400, MEASURED), narrow(300)].concat());
        let near = set.neighbours(&spots(0.2));
        assert!(near.iter().all(|near| near.parameters.stretch < NARROW_ROWS), "{near:?}");
        assert!(near.iter().all(|near| set.rows()[near.row].parameters.rate == near.parameters.rate));
    }

    #[test]
    fn too_few_narrow_rows_have_no_map_of_their_own() {
        let rows = [narrow(FEWEST_ROWS as u64 - 1), meinhardt(400, MEASURED)].concat();
        assert!(SpotRanges::new(&rows, &[]).narrow.is_none());
    }
}
