//! Outcomes as text and as CSV.

use super::outcome::{Of, Outcome, verdict};
use crate::learn::Errors;
use std::fmt::Write;

/// The columns of the CSV, described in `docs/learning.md`.
const COLUMNS: &str =
    "system,errors,method,rows,all,quantity,unit,count,median,p95,median_bound,p95_bound,verdict";

/// One line for each error, and one for the failed targets.
pub fn csv(outcomes: &[Outcome]) -> String {
    let mut text = format!("{COLUMNS}\n");
    for outcome in outcomes {
        let Outcome { system, of, way, rows, all, failed, .. } = outcome;
        let begin = format!("{},{},{},{rows},{all}", system, of.name(), way);
        for errors in &outcome.errors {
            let Errors { quantity, unit, count, median, p95 } = errors;
            let bounds = match outcome.bound(quantity) {
                Some([median, p95]) => format!("{median},{p95}"),
                None => ",".to_owned(),
            };
            let verdict = verdict(outcome.holds(errors));
            // Writing to a String cannot fail.
            let _ =
                writeln!(text, "{begin},{quantity},{unit},{count},{median:.5},{p95:.5},{bounds},{verdict}");
        }
        if *of == Of::Grown {
            let verdict = verdict(outcome.none_failed());
            let _ = writeln!(text, "{begin},failed,,{},,,,,{verdict}", failed.len());
        }
    }
    text
}

/// The outcomes of one system.
pub fn text(system: &str, outcomes: &[Outcome]) -> String {
    let mut text = format!("{system}\n");
    for of in [Of::Parameters, Of::Grown] {
        let outcomes: Vec<&Outcome> = outcomes.iter().filter(|outcome| outcome.of == of).collect();
        if outcomes.is_empty() {
            continue;
        }
        let _ = match of {
            Of::Parameters => writeln!(
                text,
                "\n  parameters of rows that were left out of the training: |error|, median / 95th percentile"
            ),
            Of::Grown => {
                writeln!(text, "\n  random targets that were grown: |error|, median / 95th percentile")
            }
        };
        text += &lines(of, &outcomes);
    }
    text += &verdicts(outcomes);
    text + "\n"
}

/// One line for each outcome.
fn lines(of: Of, outcomes: &[&Outcome]) -> String {
    let mut heads: Vec<(&str, &str)> = Vec::new();
    for errors in outcomes.iter().flat_map(|outcome| &outcome.errors) {
        // Quantities that never vary in a training set are left out.
        if errors.p95 > 1e-9 && !heads.iter().any(|(quantity, _)| *quantity == errors.quantity) {
            heads.push((errors.quantity, errors.unit));
        }
    }
    let mut text = format!("  {:22}{:>6}{:>7}", "", "rows", "asked");
    for (quantity, unit) in &heads {
        let _ = write!(text, "{:>17}", format!("{quantity} {unit}").trim_end());
    }
    text += if of == Of::Grown { "   failed\n" } else { "\n" };
    for outcome in outcomes {
        let _ = write!(text, "  {:22}{:>6}{:>7}", outcome.way, outcome.rows, outcome.asked);
        for (quantity, _) in &heads {
            let found = outcome.errors.iter().find(|errors| errors.quantity == *quantity);
            let _ = write!(text, "{:>17}", found.map_or("–".to_owned(), figures));
        }
        if of == Of::Grown {
            let _ = write!(text, "{:>9}", outcome.failed.len());
        }
        text.push('\n');
    }
    text
}

/// Median and 95th percentile, for example `1.2 / 3.4`.
fn figures(errors: &Errors) -> String {
    let digits = if errors.unit.is_empty() { 4 } else { 2 };
    format!("{:.digits$} / {:.digits$}", errors.median, errors.p95)
}

/// The bounds that are met and missed, and the targets that failed, for complete training sets.
fn verdicts(outcomes: &[Outcome]) -> String {
    let mut text = String::new();
    for outcome in outcomes.iter().filter(|outcome| outcome.none_failed().is_some()) {
        let _ = writeln!(text, "\n  {}, {} rows:", outcome.way, outcome.rows);
        for errors in &outcome.errors {
            if let Some([median, p95]) = outcome.bound(errors.quantity) {
                let (figures, verdict) = (figures(errors), verdict(outcome.holds(errors)));
                let allowed = format!("{median} / {p95} {}", errors.unit);
                let _ =
                    writeln!(text, "    {:8}{figures:>17}   allowed {allowed:14} {verdict}", errors.quantity);
            }
        }
        let failed = format!("{} of {}", outcome.failed.len(), outcome.asked);
        let _ = writeln!(
            text,
            "    {:8}{failed:>17}   allowed {:14} {}",
            "failed",
            "none",
            verdict(outcome.none_failed())
        );
        for why in &outcome.failed {
            let _ = writeln!(text, "      {why}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::super::bounds::bounds;
    use super::super::way::Way;
    use super::*;
    use crate::rd::System;

    fn outcome(of: Of, all: bool, median: f64, failed: &[&str]) -> Outcome {
        let errors = Errors { quantity: "width", unit: "%", count: 9, median, p95: 2.5 };
        Outcome {
            system: System::MEINHARDT_STRIPES.name(),
            of,
            way: Way::REGRESSION.name(),
            bounds: bounds(System::MEINHARDT_STRIPES, Way::REGRESSION),
            rows: 300,
            all,
            asked: 10,
            failed: failed.iter().map(ToString::to_string).collect(),
            errors: vec![errors],
        }
    }

    #[test]
    fn a_csv_line_has_every_column() {
        let table = csv(&[
            outcome(Of::Parameters, true, 1.0, &[]),
            outcome(Of::Grown, false, 1.0, &[]),
            outcome(Of::Grown, true, 2.25, &["a, b"]),
        ]);
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(
            lines[1..],
            [
                "meinhardt-stripes,parameters,LWR,300,true,width,%,9,1.00000,2.50000,,,",
                "meinhardt-stripes,grown,LWR,300,false,width,%,9,1.00000,2.50000,,,",
                "meinhardt-stripes,grown,LWR,300,false,failed,,0,,,,,",
                "meinhardt-stripes,grown,LWR,300,true,width,%,9,2.25000,2.50000,2,6,MISSED",
                "meinhardt-stripes,grown,LWR,300,true,failed,,1,,,,,MISSED",
            ]
        );
        let columns = COLUMNS.matches(',').count();
        assert!(lines.iter().all(|line| line.matches(',').count() == columns), "{table}");
    }

    #[test]
    fn verdicts_show_the_numbers() {
        let text =
            text(System::MEINHARDT_STRIPES.name(), &[outcome(Of::Grown, true, 1.5, &["width 3 px: why"])]);
        assert!(text.contains("width         1.50 / 2.50   allowed 2 / 6 %        ok\n"), "{text}");
        assert!(
            text.contains(
                "failed            1 of 10   allowed none           MISSED\n      width 3 px: why\n"
            )
        );
    }
}
