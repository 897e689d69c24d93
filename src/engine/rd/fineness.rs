//! The effect of a coarse mesh on spots, from rows such as those of `training/fineness.csv`.

use super::definition::System;
use crate::grid::ln;

/// Names of the columns that are read: D_b/Dₐ, minor ÷ major axis, vertices a spacing, and the three of [`Fineness`].
const COLUMNS: [&str; 6] = ["ratio", "stretch", "fineness", "factor", "smooth", "aspect"];

/// Ratio of a spot on a coarse mesh to that spot on an infinitely fine one, at half the peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fineness {
    /// Its area, where values between vertices are interpolated linearly.
    pub linear: f64,
    /// Its area as measured, with a smooth surface through the values of the vertices.
    pub smooth: f64,
    /// Its aspect as measured.
    pub aspect: f64,
}

impl Fineness {
    /// The ratios of an infinitely fine mesh, all 1.
    pub const NONE: Self = Self { linear: 1.0, smooth: 1.0, aspect: 1.0 };
}

/// The effect of a mesh with `fineness` vertices per spacing (spacing ÷ √(mean cell area)) on spots of this ratio and stretch. To
/// get a mark of a given area and aspect, ask for these ÷ the factors. [`Fineness::NONE`] for systems whose factors are not known.
///
/// Beyond the range of the rows the nearest row holds. The factors are accurate to half a per cent if a spot covers at least 14
/// vertices, or 18 with a stretch below 0.5 ([`System::cells`]); see also `training/README.md`.
#[must_use]
pub fn fineness(system: System, ratio: f64, fineness: f64, stretch: f64) -> Fineness {
    let rows = system.definition().fineness;
    rows.map_or(Fineness::NONE, |rows| Table::new(&read(rows)).at(ratio, fineness, stretch))
}

/// The values of [`COLUMNS`] in every row that the build script compiled: a line of names, then the numbers, each a double.
fn read(bytes: &[u8]) -> Vec<[f64; COLUMNS.len()]> {
    let end = bytes.iter().position(|byte| *byte == b'\n').unwrap_or(bytes.len());
    let names: Vec<&[u8]> = bytes[..end].split(|byte| *byte == b',').collect();
    let numbers = bytes.get(end + 1..).unwrap_or_default().chunks_exact(8);
    let numbers: Vec<f64> =
        numbers.filter_map(|bytes| bytes.try_into().ok()).map(f64::from_le_bytes).collect();
    let places = COLUMNS.map(|wanted| names.iter().position(|name| *name == wanted.as_bytes()));
    let value = |row: &[f64], place: Option<usize>| place.map_or(f64::NAN, |place| row[place]);
    numbers.chunks_exact(names.len()).map(|row| places.map(|place| value(row, place))).collect()
}

/// Factors by ratio, stretch and fineness.
struct Table {
    /// Natural logarithms of the ratios, ascending.
    ratios: Vec<f64>,
    /// Stretches, ascending.
    stretches: Vec<f64>,
    /// By ratio, then by stretch: 1 ÷ fineness², ascending from 0, and the factors.
    curves: Vec<Vec<[f64; 4]>>,
}

/// The distinct values, ascending.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// The interval of ascending `values` that holds a value, and the position in it, 0..1; beyond the range the nearest end.
fn interval(values: &[f64], value: f64) -> (usize, f64) {
    let first = values.partition_point(|known| *known <= value).clamp(1, values.len().max(2) - 1) - 1;
    let [Some(low), Some(high)] = [first, first + 1].map(|i| values.get(i)) else { return (0, 0.0) };
    (first, ((value - low) / (high - low)).clamp(0.0, 1.0))
}

impl Table {
    fn new(rows: &[[f64; COLUMNS.len()]]) -> Self {
        let ratios = distinct(rows.iter().map(|row| row[0]));
        let stretches = distinct(rows.iter().map(|row| row[1]));
        let curve = |ratio: f64, stretch: f64| {
            let own: Vec<_> = rows.iter().filter(|row| row[0] == ratio && row[1] == stretch).collect();
            let mut curve = vec![[0.0, 1.0, 1.0, 1.0]];
            for fineness in distinct(own.iter().map(|row| row[2])).into_iter().rev() {
                let these: Vec<_> = own.iter().filter(|row| row[2] == fineness).collect();
                let mean =
                    |column: usize| these.iter().map(|row| row[column]).sum::<f64>() / these.len() as f64;
                curve.push([1.0 / (fineness * fineness), mean(3), mean(4), mean(5)]);
            }
            curve
        };
        let curves =
            ratios.iter().flat_map(|ratio| stretches.iter().map(|stretch| curve(*ratio, *stretch))).collect();
        Self { ratios: ratios.iter().map(|ratio| ln(*ratio)).collect(), stretches, curves }
    }

    fn at(&self, ratio: f64, fineness: f64, stretch: f64) -> Fineness {
        let [linear, smooth, aspect] = [1, 2, 3].map(|factor| self.factor(factor, ratio, fineness, stretch));
        Fineness { linear, smooth, aspect }
    }

    /// One of the factors, by its index in a curve.
    fn factor(&self, factor: usize, ratio: f64, fineness: f64, stretch: f64) -> f64 {
        let (row, down) = interval(&self.ratios, ln(ratio));
        let (column, along) = interval(&self.stretches, stretch);
        let at = |row: usize, column: usize| {
            let row = row.min(self.ratios.len() - 1);
            let curve = &self.curves[row * self.stretches.len() + column.min(self.stretches.len() - 1)];
            let places: Vec<f64> = curve.iter().map(|[place, ..]| *place).collect();
            let (first, share) = interval(&places, 1.0 / (fineness * fineness));
            let [low, high] = [first, (first + 1).min(curve.len() - 1)].map(|i| curve[i][factor]);
            low + share * (high - low)
        };
        let mixed = |row: usize| at(row, column) + along * (at(row, column + 1) - at(row, column));
        mixed(row) + down * (mixed(row + 1) - mixed(row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_rows_factors_are_interpolated_and_beyond_them_kept() {
        let mut rows = Vec::new();
        for (ratio, more) in [(10.0, 0.0), (40.0, 0.1)] {
            for stretch in [0.5, 1.0] {
                for factor in [0.6, 0.8] {
                    rows.push([ratio, stretch, 10.0, factor + more, 1.0, 1.0]);
                    rows.push([ratio, stretch, 20.0, factor + more + 0.1, 1.0, 1.0]);
                }
            }
        }
        let table = Table::new(&rows);
        let close = |found: f64, wanted: f64| assert!((found - wanted).abs() < 1e-12, "{found} for {wanted}");
        close(table.factor(1, 10.0, 10.0, 1.0), 0.7);
        close(table.factor(1, 20.0, 20.0, 0.7), 0.85);
        close(table.factor(1, 5.0, 8.0, 0.1), 0.7);
        close(table.factor(1, 99.0, 8.0, 2.0), 0.8);
        close(table.factor(1, 40.0, 1e9, 1.0), 1.0);
        // Halfway between 1/20² and 0.
        close(table.factor(1, 10.0, 20.0 * 2.0f64.sqrt(), 1.0), 0.9);
    }

    #[test]
    fn the_built_in_rows_have_all_columns() {
        let rows = read(System::MEINHARDT_SPOTS.definition().fineness.expect("rows"));
        assert!(rows.len() > 300 && rows.iter().flatten().all(|value| value.is_finite()));
    }

    #[test]
    fn the_ruler_sees_less_of_a_coarse_mesh_than_a_linear_reading() {
        for stretch in [1.0, 0.6] {
            let found = fineness(System::MEINHARDT_SPOTS, 15.0, 12.0, stretch);
            assert!((found.smooth - 1.0).abs() < 0.8 * (found.linear - 1.0).abs(), "{found:?}");
            assert!(found.aspect > 0.97 && found.aspect < 1.08, "{found:?}");
        }
    }

    #[test]
    fn spots_are_smaller_on_coarser_meshes_and_the_more_so_the_smaller_they_are() {
        let factor = |ratio: f64, p: f64| fineness(System::MEINHARDT_SPOTS, ratio, p, 1.0).linear;
        for ratio in [12.0, 15.0, 24.0, 60.0] {
            let rising: Vec<f64> = [12.0, 14.0, 18.0, 26.0, 60.0].map(|p| factor(ratio, p)).into();
            assert!(
                rising.windows(2).all(|pair| pair[0] < pair[1]) && rising[4] < 1.0,
                "{ratio}: {rising:?}"
            );
        }
        // 1 ÷ (1 + 6.6/p²), measured independently.
        assert!((factor(15.0, 12.0) - 0.956).abs() < 0.02, "{}", factor(15.0, 12.0));
        assert!(factor(60.0, 16.0) < factor(30.0, 16.0) && factor(30.0, 16.0) < factor(15.0, 16.0));
        assert_eq!(fineness(System::TURING_SPOTS, 3.8, 12.0, 1.0), Fineness::NONE);
    }
}
