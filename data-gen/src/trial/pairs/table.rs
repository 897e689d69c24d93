//! The printed table.

use std::fmt::Write;

use super::{Figure, Kind, Outcome};
use crate::trial::statistics::Summary;

/// The table, and whether all values are within the bounds and everything was measured. With `each`, also the errors of
/// each sketch.
pub fn table(kind: &Kind, outcomes: &[Outcome], each: bool) -> (String, bool) {
    let (mut text, mut good) = (format!("{}: {} sketches\n", kind.name, outcomes.len()), true);
    let _ = writeln!(
        text,
        "  {:24} {:>6} {:>8} {:>8} {:>8}  {:>14}",
        "|error| of", "count", "median", "95 %", "max", "bounds"
    );
    for (index, figure) in kind.figures.iter().enumerate() {
        let measured = outcomes.iter().filter_map(|outcome| outcome.errors.as_ref().ok());
        let errors = measured.flat_map(|errors| errors[index].iter().copied());
        if let Some(summary) = Summary::from_errors(errors) {
            good &= line(&mut text, figure, summary);
        }
    }
    if let Some(Summary { median, p95, max, .. }) = Summary::from_errors(outcomes.iter().map(|of| of.seconds))
    {
        let _ = writeln!(
            text,
            "growing one on one thread: median {median:.1} s, 95 % {p95:.1} s, max {max:.1} s"
        );
    }
    for outcome in outcomes {
        match &outcome.errors {
            Err(why) => {
                good = false;
                let _ = writeln!(text, "FAILED {} ({}): {why}", outcome.name, outcome.drawn);
            }
            Ok(errors) if each => {
                let _ = writeln!(text, "{} ({}), {:.1} s", outcome.name, outcome.drawn, outcome.seconds);
                let _ = writeln!(text, "   {}", listed(kind, errors));
            }
            Ok(_) => {}
        }
        for note in outcome.notes.iter().filter(|_| each) {
            let _ = writeln!(text, "   note: {note}");
        }
    }
    let told = outcomes.iter().filter(|outcome| !outcome.notes.is_empty()).count();
    let _ = writeln!(text, "sketches with a note: {told}");
    (text, good)
}

fn line(text: &mut String, figure: &Figure, summary: Summary) -> bool {
    let [median, p95, max] = [summary.median, summary.p95, summary.max].map(|error| error * figure.factor);
    let digits = if figure.factor > 1.0 { 2 } else { 3 };
    let _ = write!(text, "  {:24} {:>6}", figure.name, summary.count);
    let _ = write!(text, " {median:>8.digits$} {p95:>8.digits$} {max:>8.digits$}");
    let held = figure.bounds.is_none_or(|[low, high]| median <= low && p95 <= high);
    if let Some([low, high]) = figure.bounds {
        let _ = write!(text, "  {low:>6} / {high:<5} {}", if held { "ok" } else { "MISSED" });
    }
    text.push('\n');
    held
}

fn listed(kind: &Kind, errors: &[Vec<f64>]) -> String {
    let figures = kind.figures.iter().zip(errors).filter(|(_, errors)| !errors.is_empty());
    let figures = figures.map(|(figure, errors)| {
        let values: Vec<String> =
            errors.iter().map(|error| format!("{:+.2}", error * figure.factor)).collect();
        format!("{} {}", figure.name, values.join(" "))
    });
    figures.collect::<Vec<String>>().join("; ")
}
