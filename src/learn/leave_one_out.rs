//! How good a training set's answers are: each row asked of all the others.

use std::fmt;

use super::training_set::Map;
use super::{Parameters, Row, TrainingSet};
use crate::attributes::Attributes;
use crate::marks::turn;

/// Directions of marks rounder than this say nothing (the contract measures angles below it only).
const DIRECTED: f64 = 0.85;

/// How far answers are off in one quantity, over all rows.
#[derive(Clone, Debug, PartialEq)]
pub struct Errors {
    /// `parameters`: asked for a row's attributes, against its parameters; `prediction`: told a row's
    /// parameters, against its attributes; `round trip`: what is predicted for the answered parameters,
    /// against the attributes that were asked for.
    pub of: &'static str,
    /// The attribute or parameter.
    pub name: &'static str,
    /// `%` of the row's value, `°`, or nothing for a plain difference.
    pub unit: &'static str,
    /// Rows that count (directions only of marks below aspect, or stretch, 0.85).
    pub rows: usize,
    /// Mean of the absolute errors.
    pub mean: f64,
    /// Their median.
    pub median: f64,
    /// Their 95th percentile.
    pub p95: f64,
}

/// The errors of one training set.
#[derive(Clone, Debug, PartialEq)]
pub struct ErrorTable {
    /// The system.
    pub system: &'static str,
    /// Rows in the set.
    pub rows: usize,
    /// One line a quantity.
    pub lines: Vec<Errors>,
}

impl fmt::Display for ErrorTable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}: each of {} rows asked of the others", self.system, self.rows)?;
        writeln!(f, "{:<12}{:<12}{:>6}{:>10}{:>10}{:>10}", "", "|error|", "rows", "mean", "median", "p95")?;
        for line in &self.lines {
            let unit = line.unit;
            writeln!(
                f,
                "{:<12}{:<12}{:>6}{:>10.3}{:>10.3}{:>10.3} {unit}",
                line.of, line.name, line.rows, line.mean, line.median, line.p95
            )?;
        }
        Ok(())
    }
}

/// One error: of, name, unit, value.
type Error = (&'static str, &'static str, &'static str, f64);

fn parameter_errors(got: &Parameters, row: &Parameters) -> Vec<Error> {
    let of = "parameters";
    let percent = |got: f64, row: f64| 100.0 * (got / row - 1.0).abs();
    let mut errors = vec![(of, "rate", "%", percent(got.rate, row.rate))];
    if let (Some(got), Some(row)) = (got.ratio, row.ratio) {
        errors.push((of, "ratio", "%", percent(got, row)));
    }
    errors.push((of, "stretch", "", (got.stretch - row.stretch).abs()));
    if row.stretch < DIRECTED {
        errors.push((of, "direction", "°", turn(got.direction, row.direction).abs()));
    }
    if let (Some(got), Some(row)) = (got.level, row.level) {
        errors.push((of, "level", "", (got - row).abs()));
    }
    errors
}

fn attribute_errors(of: &'static str, got: &Attributes, row: &Attributes) -> Vec<Error> {
    let percent = |got: f64, row: f64| 100.0 * (got / row - 1.0).abs();
    let angle = (of, "angle", "°", turn(got.angle(), row.angle()).abs());
    match (got, row) {
        (Attributes::Spots(got), Attributes::Spots(row)) => {
            let mut errors = vec![
                (of, "area", "%", percent(got.area, row.area)),
                (of, "aspect", "", (got.aspect - row.aspect).abs()),
            ];
            if row.aspect < DIRECTED {
                errors.push(angle);
            }
            if let (Some(got), Some(row)) = (got.spacing, row.spacing) {
                errors.push((of, "spacing", "%", percent(got, row)));
            }
            errors
        }
        (Attributes::Stripes(got), Attributes::Stripes(row)) => {
            vec![(of, "width", "%", percent(got.width, row.width)), angle]
        }
        _ => Vec::new(),
    }
}

fn row_errors(map: &Map, i: usize, row: &Row) -> Vec<Error> {
    let answered = match map {
        Map::Spots(map) => map.left_out(i),
        Map::Stripes(map) => map.left_out(i, row.attributes.angle()),
    };
    let predict = |p: &Parameters| match map {
        Map::Spots(map) => map.predict(p, Some(i)).attributes,
        Map::Stripes(map) => map.predict(p, Some(i)).attributes,
    };
    let mut errors = parameter_errors(&answered, &row.parameters);
    errors.extend(attribute_errors("prediction", &predict(&row.parameters), &row.attributes));
    errors.extend(attribute_errors("round trip", &predict(&answered), &row.attributes));
    errors
}

/// Asks for each row's attributes, and predicts from its parameters, as if that row were not there.
#[must_use]
pub fn leave_one_out(set: &TrainingSet) -> ErrorTable {
    let mut seen: Vec<(Error, Vec<f64>)> = Vec::new();
    for (i, row) in set.rows().iter().enumerate() {
        for error in row_errors(&set.map, i, row) {
            match seen.iter_mut().find(|(first, _)| (first.0, first.1) == (error.0, error.1)) {
                Some((_, values)) => values.push(error.3),
                None => seen.push((error, vec![error.3])),
            }
        }
    }
    let mut lines: Vec<Errors> = seen.into_iter().map(|(error, values)| summary(error, values)).collect();
    let groups = ["parameters", "prediction", "round trip"];
    lines.sort_by_key(|line| groups.iter().position(|group| *group == line.of));
    ErrorTable { system: set.system(), rows: set.rows().len(), lines }
}

fn summary((of, name, unit, _): Error, mut values: Vec<f64>) -> Errors {
    values.sort_by(f64::total_cmp);
    let n = values.len();
    let share = |p: f64| values[((n - 1) as f64 * p).round() as usize];
    Errors {
        of,
        name,
        unit,
        rows: n,
        mean: values.iter().sum::<f64>() / n as f64,
        median: share(0.5),
        p95: share(0.95),
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{MEASURED, meinhardt, stripes, turing};
    use super::*;

    fn p95(table: &ErrorTable, of: &str, name: &str) -> f64 {
        table.lines.iter().find(|line| (line.of, line.name) == (of, name)).unwrap().p95
    }

    #[test]
    fn errors_are_those_of_the_noise() {
        // Noise: area 1 %, spacing 1.5 %, aspect 0.4 %, angle 0.3°; 95 % of normal errors are within 2 σ.
        let set = TrainingSet::from_rows("meinhardt-spots", meinhardt(200, MEASURED)).unwrap();
        let table = leave_one_out(&set);
        assert!(p95(&table, "prediction", "area") < 2.5);
        assert!(p95(&table, "prediction", "spacing") < 3.8);
        assert!(p95(&table, "prediction", "aspect") < 0.008);
        assert!(p95(&table, "prediction", "angle") < 0.8);
        assert!(p95(&table, "round trip", "area") < 1.0);
        assert!(p95(&table, "parameters", "ratio") < 9.0);
        assert!(p95(&table, "prediction", "area") > 1.0, "the row itself must have no say");
    }

    #[test]
    fn a_table_has_a_line_for_each_quantity() {
        let set = TrainingSet::from_rows("meinhardt-stripes", stripes(40, MEASURED)).unwrap();
        let text = leave_one_out(&set).to_string();
        assert_eq!(text.lines().count(), 2 + 3 + 2 + 2, "{text}");
        let set = TrainingSet::from_rows("turing-spots", turing(40, MEASURED)).unwrap();
        assert_eq!(leave_one_out(&set).to_string().lines().count(), 2 + 5 + 4 + 4);
    }
}
