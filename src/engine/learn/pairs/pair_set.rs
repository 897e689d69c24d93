//! The rows of one system of pairs, prepared for questions.

use crate::attributes::coordinates::{Coordinates, Scale};
use crate::attributes::system::Description;
use crate::learn::answer::Z90;
use crate::learn::brought_rows::rows_of;
use crate::learn::compiled_rows::compiled_values;
use crate::learn::csv_rows::read_values;
use crate::learn::folder::Folder;
use crate::learn::folder_rows::rows_of_folder;
use crate::learn::local::{AS_IT_IS, Local, Sample};
use crate::learn::row::FEWEST_ROWS;
use crate::learn::small_vector::SmallVector;
use crate::learn::{TrainingError, six_digits};

/// One accepted run of `data-gen`.
#[derive(Clone, Debug, PartialEq)]
pub struct PairRow {
    /// The seed of the run.
    pub seed: u64,
    /// Its numbers, in the order of the columns of its system.
    pub values: Vec<f64>,
}

/// The answer of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct PairAnswer {
    /// The answered values, in the order of the table in this room's documentation: the factor of the size first.
    pub values: Vec<f64>,
    /// Half widths of the 90 % intervals; relative for factors.
    pub within: Vec<f64>,
    /// Whether the question lies within the range of the rows.
    pub inside: bool,
}

/// The rows of one system of pairs, prepared for questions.
pub struct PairSet {
    system: &'static Description,
    coordinates: &'static Coordinates,
    rows: Vec<PairRow>,
    /// One group for two directions and one for more; or a single group of all rows.
    groups: Vec<Group>,
}

/// Rows that are learnt together.
struct Group {
    local: Local,
    /// Standard deviation of each coordinate of a question.
    spread: Vec<f64>,
    /// Lowest and highest value of each column of a question.
    ranges: Vec<[f64; 2]>,
}

impl PairSet {
    /// The embedded set of `system`; `None` if it has no coordinates.
    ///
    /// # Errors
    /// [`TrainingError`], only if the program was built from a broken file.
    pub fn embedded(system: &'static Description) -> Result<Option<Self>, TrainingError> {
        let mut rows = Vec::new();
        for file in system.training {
            let name = format!("training/{}.csv (compiled in)", file.name);
            rows.extend(compiled_values(system, &name, rows_of(file), row)?);
        }
        Self::from_rows(system, rows)
    }

    /// The set of `system` in `folder`; `known` are all systems that may have files there.
    ///
    /// # Errors
    /// [`TrainingError`]: no such file, or a fault in one with file, line, column and value.
    pub fn load(
        folder: &dyn Folder,
        system: &'static Description,
        known: &[&'static Description],
    ) -> Result<Option<Self>, TrainingError> {
        let read = |name: &str, bytes: &[u8]| read_values(system, name, bytes, row);
        let (rows, _) = rows_of_folder(folder, system, known, read)?;
        Self::from_rows(system, rows)
    }

    /// The set of `system` with these rows; `None` if it has no coordinates or no rows.
    ///
    /// # Errors
    /// [`TrainingError::TooFew`].
    pub fn from_rows(
        system: &'static Description,
        rows: Vec<PairRow>,
    ) -> Result<Option<Self>, TrainingError> {
        let Some(coordinates) = system.coordinates().filter(|_| !rows.is_empty()) else { return Ok(None) };
        let many = |row: &PairRow| value(system, row, "directions") > 2.5;
        let groups: Vec<Vec<&PairRow>> = if coordinates.by_directions {
            [false, true].map(|of| rows.iter().filter(|row| many(row) == of).collect()).into()
        } else {
            vec![rows.iter().collect()]
        };
        if let Some(few) = groups.iter().map(Vec::len).find(|rows| *rows < FEWEST_ROWS) {
            let file = format!("training/{}.csv", system.name);
            return Err(TrainingError::TooFew { file, rows: few, needed: FEWEST_ROWS });
        }
        let groups = groups.iter().map(|rows| Group::new(system, coordinates, rows)).collect();
        Ok(Some(Self { system, coordinates, rows, groups }))
    }

    /// The system.
    #[must_use]
    pub fn system(&self) -> &'static Description {
        self.system
    }

    /// The rows.
    #[must_use]
    pub fn rows(&self) -> &[PairRow] {
        &self.rows
    }

    /// The names of the columns of a question.
    pub fn asked(&self) -> impl Iterator<Item = &'static str> {
        self.coordinates.asked.iter().map(|(name, _)| *name)
    }

    /// The names of the answered values.
    pub fn answered(&self) -> impl Iterator<Item = &'static str> {
        self.coordinates.answered.iter().map(|(name, _)| *name)
    }

    /// The value of a row in the column `name`; 0 if there is no such column.
    #[must_use]
    pub fn value(&self, row: &PairRow, name: &str) -> f64 {
        value(self.system, row, name)
    }

    /// The answer for lines of `directions` directions to a question with these values, in the order of [`Self::asked`].
    #[must_use]
    pub fn ask(&self, directions: usize, question: &[f64]) -> PairAnswer {
        let group = &self.groups[usize::from(directions > 2).min(self.groups.len() - 1)];
        let moved = |(value, [low, high]): (&f64, &[f64; 2])| value.clamp(*low, *high);
        let inside: Vec<f64> = question.iter().zip(&group.ranges).map(moved).collect();
        let fit = group.local.fit(&group.place(self.coordinates, &inside), None);
        let answered = self.coordinates.answered.iter().zip(fit.value.iter());
        PairAnswer {
            values: answered.map(|((_, scale), value)| scale.back(*value)).collect(),
            within: fit.deviation.iter().map(|deviation| Z90 * deviation).collect(),
            inside: question.iter().zip(&group.ranges).all(is_inside),
        }
    }

    /// The answer of the row nearest to a question, for comparison.
    #[must_use]
    pub fn nearest(&self, directions: usize, question: &[f64]) -> Option<Vec<f64>> {
        let group = &self.groups[usize::from(directions > 2).min(self.groups.len() - 1)];
        let sample = group.local.nearest(&group.place(self.coordinates, question), None)?;
        let answered = self.coordinates.answered.iter().zip(sample.gives.iter());
        Some(answered.map(|((_, scale), value)| scale.back(*value)).collect())
    }
}

/// A question counts as inside up to this share of the range beyond the outermost rows: rows rarely lie at the ends of the swept
/// range, such as right angles.
const MARGIN: f64 = 0.02;

fn is_inside((value, [low, high]): (&f64, &[f64; 2])) -> bool {
    // Directions have no limits.
    let margin = if low.is_finite() { MARGIN * (high - low) } else { 0.0 };
    (low - margin..=high + margin).contains(value)
}

impl Group {
    fn new(system: &Description, coordinates: &Coordinates, rows: &[&PairRow]) -> Self {
        let columns = |row: &PairRow, of: &[(&str, Scale)]| -> Vec<f64> {
            of.iter().map(|(name, _)| value(system, row, name)).collect()
        };
        let asked: Vec<Vec<f64>> = rows.iter().map(|row| columns(row, coordinates.asked)).collect();
        let placed: Vec<Vec<f64>> = asked.iter().map(|row| scaled(coordinates.asked, row)).collect();
        let range = |(column, (_, scale)): (usize, &(&str, Scale))| {
            // Every direction is equivalent to one between 0° and 90°.
            if *scale == Scale::Quarter {
                return [f64::NEG_INFINITY, f64::INFINITY];
            }
            let values = asked.iter().map(|row| row[column]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        let ranges = coordinates.asked.iter().enumerate().map(range).collect();
        let dims = placed.first().map_or(0, Vec::len);
        let spread: Vec<f64> = (0..dims).map(|axis| deviation(placed.iter().map(|row| row[axis]))).collect();
        let sample = |(placed, row): (&Vec<f64>, &&PairRow)| Sample {
            at: SmallVector::new(placed.iter().zip(&spread).map(|(x, spread)| x / spread)),
            gives: SmallVector::new(scaled(coordinates.answered, &columns(row, coordinates.answered))),
        };
        let local = Local::new(placed.iter().zip(rows).map(sample).collect(), AS_IT_IS, None);
        Self { local, spread, ranges }
    }

    /// The coordinates of a question.
    fn place(&self, coordinates: &Coordinates, question: &[f64]) -> SmallVector {
        let all = scaled(coordinates.asked, question);
        SmallVector::new(all.iter().zip(&self.spread).map(|(x, spread)| x / spread))
    }
}

/// The coordinates of values of these columns.
fn scaled(columns: &[(&str, Scale)], values: &[f64]) -> Vec<f64> {
    columns.iter().zip(values).flat_map(|((_, scale), value)| scale.of(*value)).collect()
}

/// The standard deviation; 1 if the values do not vary.
fn deviation(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let count = values.clone().count().max(1) as f64;
    let mean = values.clone().sum::<f64>() / count;
    let variance = values.map(|x| (x - mean) * (x - mean)).sum::<f64>() / count;
    if variance > 1e-12 { variance.sqrt() } else { 1.0 }
}

fn row(seed: u64, values: &[f64]) -> PairRow {
    PairRow { seed, values: values.to_vec() }
}

fn value(system: &Description, row: &PairRow, name: &str) -> f64 {
    let place = system.columns.iter().position(|column| column.name == name);
    place.and_then(|place| row.values.get(place).copied()).unwrap_or(0.0)
}

/// The line of a row in the file of `system`, with six significant digits.
///
/// # Errors
/// [`TrainingError::Row`] where a value is missing or out of the range of its column.
pub fn write_pair_row(system: &'static Description, row: &PairRow) -> Result<String, TrainingError> {
    let wrong =
        |problem: String| TrainingError::Row { index: 0, seed: row.seed, system: system.name, problem };
    if row.values.len() != system.columns.len() {
        return Err(wrong(format!("it has {} numbers of {}", row.values.len(), system.columns.len())));
    }
    let mut line = row.seed.to_string();
    for (column, value) in system.columns.iter().zip(&row.values) {
        if !(column.range[0]..=column.range[1]).contains(value) {
            return Err(wrong(format!("its {} {value} is not {}", column.name, column.allowed)));
        }
        line.push(',');
        line.push_str(&six_digits(*value));
    }
    Ok(line)
}
