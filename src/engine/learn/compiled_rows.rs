//! The training rows that are compiled in, as `build.rs` writes them when the program is built.

use csv::StringRecord;

use super::csv_rows::{places, row, shown};
use super::{Row, TrainingError};
use crate::attributes::columns::Column;
use crate::attributes::system::Description;

/// Bytes of a number.
const NUMBER: usize = size_of::<f64>();

/// Reads and checks the rows of `file` (a name for messages), which equal those of the CSV that it was made from.
pub(super) fn compiled_rows(
    system: &Description,
    file: &str,
    bytes: &[u8],
) -> Result<Vec<Row>, TrainingError> {
    compiled_values(system, file, bytes, |seed, values| row(system, seed, values))
}

/// Converts each seed and the numbers after it, in the order of the columns of `system`, by `take`.
pub(super) fn compiled_values<T>(
    system: &Description,
    file: &str,
    bytes: &[u8],
    take: impl Fn(u64, &[f64]) -> T,
) -> Result<Vec<T>, TrainingError> {
    let broken = |line: u64, problem: &str| TrainingError::Table {
        file: file.to_owned(),
        line,
        problem: problem.to_owned(),
    };
    let end = bytes.iter().position(|byte| *byte == b'\n').ok_or_else(|| broken(1, "it has no header"))?;
    let header = str::from_utf8(&bytes[..end]).map_err(|error| broken(1, &error.to_string()))?;
    let header: StringRecord = header.split(',').collect();
    let places = places(system, file, &header)?;
    let (records, rest) = bytes[end + 1..].as_chunks::<NUMBER>();
    if !rest.is_empty() || records.len() % header.len() != 0 {
        return Err(broken(1, "its last row is cut off"));
    }
    let records = records.chunks_exact(header.len()).enumerate();
    let read = |(index, record): (usize, &[[u8; NUMBER]])| {
        let number = |column: usize| f64::from_le_bytes(record[places[column]]);
        let checked = |(column, described): (usize, &Column)| {
            let value = number(1 + column);
            let is_allowed = (described.range[0]..=described.range[1]).contains(&value);
            is_allowed.then_some(value).ok_or_else(|| TrainingError::Value {
                file: file.to_owned(),
                line: index as u64 + 2,
                column: described.name,
                value: shown(&value.to_string()),
                allowed: described.allowed,
            })
        };
        let values = system.columns.iter().enumerate().map(checked).collect::<Result<Vec<_>, _>>()?;
        // Seeds are whole numbers far below 2⁵³.
        Ok(take(number(0) as u64, &values))
    };
    records.map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::super::csv_rows::read_rows;
    use super::super::laws::SYSTEMS;
    use super::*;

    #[test]
    fn the_compiled_rows_are_those_of_the_files() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../training");
        for system in SYSTEMS {
            assert!(!system.training.is_empty());
            for file in system.training {
                let csv = std::fs::read(folder.join(format!("{}.csv", file.name))).unwrap();
                let of_csv = read_rows(system, file.name, &csv).unwrap();
                assert_eq!(compiled_rows(system, file.name, file.rows).unwrap(), of_csv, "{}", file.name);
            }
        }
    }

    #[test]
    fn a_damaged_set_is_reported_with_its_place() {
        let [system, ..] = SYSTEMS;
        let whole = system.training[0].rows;
        let message = |bytes: &[u8]| compiled_rows(system, "x", bytes).unwrap_err().to_string();
        assert!(message(&whole[..whole.len() - 3]).contains("cut off"));
        assert!(message(b"seed,area\n").contains("missing"));
        assert!(message(b"").contains("no header"));
        let mut other = whole.to_vec();
        // The last number but one of the last row becomes an invalid length.
        let at = other.len() - 2 * NUMBER;
        other[at..at + NUMBER].copy_from_slice(&f64::NAN.to_le_bytes());
        assert!(message(&other).contains("NaN"), "{}", message(&other));
    }
}
