//! Training rows ↔ CSV. The format is described in `training/README.md`.

use std::io::Write;

use csv::{ReaderBuilder, StringRecord, Trim};

use super::{InCells, Parameters, Row, TrainingError};
use crate::attributes::columns::{Column, ColumnKind, SEED};
use crate::attributes::system::{Description, MarkKind};
use crate::attributes::{Attributes, Spots, Stripes};
use crate::marks::axial;

/// The number of a row for a column; `None` if it has none.
fn number(kind: ColumnKind, row: &Row) -> Option<f64> {
    let p = &row.parameters;
    let (spots, stripes) = match &row.attributes.0 {
        Attributes::Spots(spots) => (Some(spots), None),
        Attributes::Stripes(stripes) => (None, Some(stripes)),
    };
    match kind {
        ColumnKind::Seed | ColumnKind::Named => None,
        ColumnKind::Extent => Some(row.extent),
        ColumnKind::Evenness => Some(row.evenness),
        ColumnKind::Area => Some(spots?.area),
        ColumnKind::Aspect => Some(spots?.aspect),
        ColumnKind::Angle => Some(row.attributes.0.angle()),
        ColumnKind::Spacing => spots?.spacing,
        ColumnKind::Width => Some(stripes?.width),
        ColumnKind::Wavelength => stripes?.wavelength,
        ColumnKind::Rate => Some(p.rate),
        ColumnKind::Ratio => p.ratio,
        ColumnKind::Stretch => Some(p.stretch),
        ColumnKind::Direction => Some(p.direction),
        ColumnKind::Level => p.level,
    }
}

/// The numbers of a row in the order of the columns of `system`; `None` if the row does not belong to this system.
fn numbers(system: &Description, row: &Row) -> Option<Vec<f64>> {
    system.columns.iter().map(|column| number(column.kind, row)).collect()
}

/// The row with these numbers, which are in the order of the columns of `system`.
pub(super) fn row(system: &Description, seed: u64, numbers: &[f64]) -> Row {
    let find = |kind| {
        let place = system.columns.iter().position(|column| column.kind == kind)?;
        numbers.get(place).copied()
    };
    // Tests check that every system has these columns.
    let always = |kind| find(kind).unwrap_or_default();
    let angle = axial(always(ColumnKind::Angle));
    let attributes = match system.marks {
        MarkKind::Spots => Attributes::Spots(Spots {
            area: always(ColumnKind::Area),
            aspect: always(ColumnKind::Aspect),
            angle,
            spacing: find(ColumnKind::Spacing),
        }),
        MarkKind::Stripes => Attributes::Stripes(Stripes {
            width: always(ColumnKind::Width),
            angle,
            wavelength: find(ColumnKind::Wavelength),
        }),
    };
    Row {
        seed,
        extent: always(ColumnKind::Extent),
        evenness: always(ColumnKind::Evenness),
        attributes: InCells(attributes),
        parameters: Parameters {
            rate: always(ColumnKind::Rate),
            ratio: find(ColumnKind::Ratio),
            stretch: always(ColumnKind::Stretch),
            direction: axial(always(ColumnKind::Direction)),
            level: find(ColumnKind::Level),
        },
    }
}

/// The position of each column (seed first) in the file.
pub(super) fn places(
    system: &Description,
    file: &str,
    header: &StringRecord,
) -> Result<Vec<usize>, TrainingError> {
    let names: Vec<&str> =
        std::iter::once(SEED.name).chain(system.columns.iter().map(|column| column.name)).collect();
    let wrong =
        |problem: String| TrainingError::Columns { file: file.to_owned(), problem, columns: names.join(",") };
    for (i, found) in header.iter().enumerate() {
        if !names.contains(&found) {
            return Err(wrong(format!("the column '{}' is unknown", shown(found))));
        }
        if header.iter().take(i).any(|before| before == found) {
            return Err(wrong(format!("the column '{}' is there twice", shown(found))));
        }
    }
    names
        .iter()
        .map(|name| {
            let place = header.iter().position(|found| found == *name);
            place.ok_or_else(|| wrong(format!("the column '{name}' is missing")))
        })
        .collect()
}

/// Text from a file for a message: shortened, with control characters escaped.
#[must_use]
pub fn shown(text: &str) -> String {
    const LONGEST: usize = 40;
    let cut = if text.chars().count() > LONGEST { "…" } else { "" };
    let start: String = text.chars().take(LONGEST).collect();
    format!("{}{cut}", start.escape_debug())
}

/// The line, from 1, of a record in the file `bytes`.
///
/// The csv reader may give the line number of an empty line before the record.
#[must_use]
pub fn line_of(bytes: &[u8], position: Option<&csv::Position>) -> u64 {
    let Some(position) = position else { return 1 };
    let start = usize::try_from(position.byte()).unwrap_or(usize::MAX).min(bytes.len());
    let empty = bytes[start..].iter().take_while(|byte| matches!(byte, b'\r' | b'\n'));
    position.line() + empty.filter(|byte| **byte == b'\n').count() as u64
}

/// Reads and checks the rows of `file` (a name for messages).
pub(super) fn read_rows(system: &Description, file: &str, bytes: &[u8]) -> Result<Vec<Row>, TrainingError> {
    read_values(system, file, bytes, |seed, values| row(system, seed, values))
}

/// Reads and checks a table with the columns of `system`: converts each seed and the numbers after it, in the order of the columns,
/// by `take`. `file` is its name in messages.
pub(super) fn read_values<T>(
    system: &Description,
    file: &str,
    bytes: &[u8],
    take: impl Fn(u64, &[f64]) -> T,
) -> Result<Vec<T>, TrainingError> {
    let mut reader = ReaderBuilder::new().trim(Trim::All).from_reader(bytes);
    let broken = |error: &csv::Error| TrainingError::Table {
        file: file.to_owned(),
        line: line_of(bytes, error.position()),
        problem: error.to_string(),
    };
    let header = reader.headers().map_err(|error| broken(&error))?.clone();
    let places = places(system, file, &header)?;
    let mut rows = Vec::new();
    // One record and one list of values for all rows: there are thousands.
    let (mut record, mut values) = (StringRecord::new(), Vec::with_capacity(system.columns.len()));
    while reader.read_record(&mut record).map_err(|error| broken(&error))? {
        let text = |i: usize| record.get(places[i]).unwrap_or_default();
        let wrong = |column: &Column, value: &str| TrainingError::Value {
            file: file.to_owned(),
            line: line_of(bytes, record.position()),
            column: column.name,
            value: shown(value),
            allowed: column.allowed,
        };
        let seed = text(0).parse().map_err(|_| wrong(&SEED, text(0)))?;
        values.clear();
        for (i, column) in system.columns.iter().enumerate() {
            match text(i + 1).parse::<f64>() {
                Ok(value) if column.range[0] <= value && value <= column.range[1] => values.push(value),
                _ => return Err(wrong(column, text(i + 1))),
            }
        }
        rows.push(take(seed, &values));
    }
    Ok(rows)
}

/// Writes `rows` of `system` as CSV: a header, then a line a row.
///
/// Numbers are rounded to six significant digits, far below the noise of any measurement, so that the same rows give the
/// same bytes and rows that were read are written unchanged.
///
/// # Errors
/// [`TrainingError::Row`] where a row is not one of this system or a
/// value is out of range; [`TrainingError::Write`].
pub fn write_rows(system: &Description, rows: &[Row], mut out: impl Write) -> Result<(), TrainingError> {
    let names: Vec<&str> = system.columns.iter().map(|column| column.name).collect();
    let mut text = format!("{},{}\n", SEED.name, names.join(","));
    for (index, row) in rows.iter().enumerate() {
        let wrong =
            |problem: String| TrainingError::Row { index, seed: row.seed, system: system.name, problem };
        let values = numbers(system, row).ok_or_else(|| {
            wrong("its attributes or parameters are those of another kind of system".into())
        })?;
        text.push_str(&row.seed.to_string());
        for (column, value) in system.columns.iter().zip(values) {
            if !(column.range[0] <= value && value <= column.range[1]) {
                return Err(wrong(format!("its {} {value} is not {}", column.name, column.allowed)));
            }
            text.push(',');
            text.push_str(&six_digits(value));
        }
        text.push('\n');
    }
    out.write_all(text.as_bytes())?;
    Ok(())
}

/// `value` with six significant digits, in its shortest form.
///
/// ```
/// use dapple_engine::learn::six_digits;
///
/// assert_eq!(six_digits(1.0 / 3.0), "0.333333");
/// ```
#[must_use]
pub fn six_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    // (+0.0 turns −0 into 0)
    (rounded + 0.0).to_string()
}

#[cfg(test)]
mod tests {
    use super::super::laws::{
        LINES, MEASURED, MEINHARDT, STRIPES, TURING, lines, meinhardt, stripes, turing,
    };
    use super::*;

    fn written(system: &Description, rows: &[Row]) -> String {
        let mut out = Vec::new();
        write_rows(system, rows, &mut out).unwrap();
        String::from_utf8(out).unwrap()
    }

    fn message(text: &str) -> String {
        read_rows(&STRIPES, "s.csv", text.as_bytes()).unwrap_err().to_string()
    }

    const HEADER: &str = "seed,wavelengths,width,angle,coherence,rate,stretch,direction";

    #[test]
    fn rows_that_are_written_and_read_are_the_same_to_six_digits_and_then_exactly() {
        let sets = [
            (&TURING, turing(40, MEASURED)),
            (&MEINHARDT, meinhardt(40, MEASURED)),
            (&STRIPES, stripes(40, MEASURED)),
            (&LINES, lines(40, MEASURED)),
        ];
        for (system, rows) in sets {
            let text = written(system, &rows);
            let back = read_rows(system, "x.csv", text.as_bytes()).unwrap();
            assert_eq!(back.len(), rows.len());
            for (a, b) in rows.iter().zip(&back) {
                let pairs = numbers(system, a).unwrap().into_iter().zip(numbers(system, b).unwrap());
                assert!(a.seed == b.seed && pairs.into_iter().all(|(a, b)| (a - b).abs() <= 1e-5 * a.abs()));
            }
            assert_eq!(written(system, &back), text);
            assert_eq!(read_rows(system, "x.csv", written(system, &back).as_bytes()).unwrap(), back);
        }
    }

    #[test]
    fn columns_may_be_in_any_order() {
        let text =
            "direction,seed,stretch,rate,coherence,angle,width,wavelengths\n10,7,0.5,0.4,0.9,-11,8,12\n";
        let row = read_rows(&STRIPES, "s.csv", text.as_bytes()).unwrap()[0];
        assert_eq!((row.seed, row.extent, row.evenness), (7, 12.0, 0.9));
        assert_eq!(
            row.attributes,
            InCells(Attributes::Stripes(Stripes { width: 8.0, angle: 169.0, wavelength: None }))
        );
        assert_eq!(row.parameters.named(), [("rate", 0.4), ("stretch", 0.5), ("direction", 10.0)]);
    }

    #[test]
    fn an_invalid_value_is_reported_with_its_place() {
        let with = |row: &str| message(&format!("{HEADER}\n\n\n{row}\n"));
        assert_eq!(
            with("2,9,-8,10,0.9,0.4,0.5,10"),
            "s.csv, line 4, column width: '-8' is not a length from 0.1 to 1e5 cells"
        );
        for (row, place) in [
            ("-1,9,8,10,0.9,0.4,0.5,10", "column seed: '-1'"),
            ("2,9,8,10,0.9,NaN,0.5,10", "column rate: 'NaN'"),
            ("2,9,inf,10,0.9,1,0.5,10", "column width: 'inf'"),
            ("2,9,8,10,1.2,1,0.5,10", "column coherence: '1.2'"),
            ("2,9,8,ten,0.9,1,0.5,10", "column angle: 'ten'"),
            ("2,9,8,10,0.9,1,,10", "column stretch: ''"),
        ] {
            let message = with(row);
            assert!(message.contains("line 4") && message.contains(place), "{message}");
        }
        assert!(with("2,9,8").starts_with("s.csv, line 4: "));
    }

    #[test]
    fn an_invalid_column_is_reported() {
        assert!(message("").contains("the column 'seed' is missing"));
        assert!(message(&HEADER.replace("width", "widht")).contains("the column 'widht' is unknown"));
        assert!(message(&HEADER.replace(",stretch", "")).contains("the column 'stretch' is missing"));
        assert!(message(&format!("{HEADER},angle")).contains("the column 'angle' is there twice"));
    }

    #[test]
    fn a_row_of_another_system_or_out_of_range_is_not_written() {
        let mut rows = stripes(3, MEASURED);
        let error = write_rows(&TURING, &rows, std::io::sink()).unwrap_err().to_string();
        assert!(error.contains("row 0 (seed 0) cannot be written to turing-spots"), "{error}");
        rows[2].parameters.rate = f64::NAN;
        let error = write_rows(&STRIPES, &rows, std::io::sink()).unwrap_err().to_string();
        assert!(error.contains("row 2 (seed 2)") && error.contains("rate NaN"), "{error}");
    }

    #[test]
    fn numbers_are_written_in_their_shortest_form() {
        let seen = [0.1 + 0.2, 1.0, -0.0, 123_456.7, 0.000_012_345_678, 1e-9].map(six_digits);
        assert_eq!(seen, ["0.3", "1", "0", "123457", "0.0000123457", "0.000000001"]);
    }
}
