//! The printed table.

use std::fmt::Write;

use super::attribute::{ATTRIBUTES, Attribute};
use super::grown::{Outcome, Region};
use super::statistics::Summary;
use super::verdict::KINDS;

/// The number of worst regions that are named for each attribute.
const WORST: usize = 10;

/// Selects the documents that a line is about.
type Chosen = fn(&Outcome) -> bool;

/// Groups of documents; the bounds hold for the last.
const GROUPS: [(&str, Chosen); 3] =
    [("examples", |outcome| !outcome.random), ("sketches", |outcome| outcome.random), ("together", |_| true)];

/// The table, and whether all bounds hold and nothing has failed.
pub fn table(outcomes: &[Outcome]) -> (String, bool) {
    let (mut text, mut good) = (String::new(), true);
    for (kind, spots) in [("spots", true), ("stripes", false)] {
        counts(&mut text, outcomes, kind, spots);
        for (k, attribute) in ATTRIBUTES.iter().enumerate().filter(|(_, a)| a.spots == spots) {
            for (group, (name, chosen)) in GROUPS.iter().enumerate() {
                let errors = regions(outcomes).filter(|(outcome, _)| chosen(outcome));
                let errors = errors.filter_map(|(_, region)| region.errors[k]);
                let Some(summary) = Summary::from_errors(errors) else { continue };
                let held = line(&mut text, attribute, name, summary);
                good &= held || group + 1 < GROUPS.len();
            }
        }
        text.push('\n');
    }
    good &= failures(&mut text, outcomes);
    times(&mut text, outcomes);
    worst(&mut text, outcomes);
    (text, good)
}

fn regions(outcomes: &[Outcome]) -> impl Iterator<Item = (&Outcome, &Region)> {
    outcomes.iter().flat_map(|outcome| outcome.regions.iter().map(move |region| (outcome, region)))
}

fn counts(text: &mut String, outcomes: &[Outcome], kind: &str, spots: bool) {
    let output = GROUPS.map(|(name, chosen)| {
        let of_kind = outcomes.iter().filter(|outcome| outcome.spots == spots && chosen(outcome));
        let (documents, regions) =
            of_kind.fold((0, 0), |(documents, n), outcome| (documents + 1, n + outcome.regions.len()));
        format!("{name} {documents} documents with {regions} regions")
    });
    let _ = writeln!(text, "{kind}: {}", output.join("; "));
    let _ = writeln!(
        text,
        "  {:24} {:9} {:>7} {:>8} {:>8} {:>8}  {:>14}",
        "|error| of", "over", "regions", "median", "95 %", "max", "bounds"
    );
}

fn line(text: &mut String, attribute: &Attribute, group: &str, summary: Summary) -> bool {
    let [median, p95, max] = [summary.median, summary.p95, summary.max].map(|error| error * attribute.factor);
    let digits = if attribute.unit.is_empty() { 3 } else { 2 };
    let name = format!("{} {}", attribute.name, attribute.unit);
    let _ = write!(text, "  {name:24} {group:9} {:>7}", summary.count);
    let _ = write!(text, " {median:>8.digits$} {p95:>8.digits$} {max:>8.digits$}");
    let held = attribute.bounds.is_none_or(|[low, high]| median <= low && p95 <= high);
    if let Some([low, high]) = attribute.bounds {
        let _ = write!(text, "  {low:>6} / {high:<5} {}", if held { "ok" } else { "MISSED" });
    }
    text.push('\n');
    held
}

/// Counts by kind of failure, then each failure with its reason.
fn failures(text: &mut String, outcomes: &[Outcome]) -> bool {
    let count = |kind: &str| {
        outcomes.iter().filter(|outcome| outcome.failures.iter().any(|f| f.kind() == kind)).count()
    };
    let output: Vec<String> = KINDS.iter().map(|kind| format!("{kind} {}", count(kind))).collect();
    let unsettled = outcomes.iter().filter(|outcome| !outcome.settled).count();
    let _ =
        writeln!(text, "documents that failed: {} (still moving at the end: {unsettled})", output.join(", "));
    for outcome in outcomes {
        for failure in &outcome.failures {
            let _ = writeln!(text, "  {}: {failure}", outcome.name);
        }
    }
    outcomes.iter().all(|outcome| outcome.failures.is_empty())
}

fn times(text: &mut String, outcomes: &[Outcome]) {
    if let Some(summary) = Summary::from_errors(outcomes.iter().map(|outcome| outcome.seconds)) {
        let Summary { median, p95, max, .. } = summary;
        let _ = writeln!(
            text,
            "growing a document on one thread: median {median:.1} s, 95 % {p95:.1} s, max {max:.1} s\n"
        );
    }
}

fn worst(text: &mut String, outcomes: &[Outcome]) {
    for (k, attribute) in ATTRIBUTES.iter().enumerate().filter(|(_, attribute)| attribute.bounds.is_some()) {
        let mut found: Vec<(f64, &Outcome, &Region)> = regions(outcomes)
            .filter_map(|(outcome, region)| Some((region.errors[k]?, outcome, region)))
            .collect();
        found.sort_by(|(a, ..), (b, ..)| b.abs().total_cmp(&a.abs()));
        if found.is_empty() {
            continue;
        }
        let _ = writeln!(text, "worst regions by {} of {}", attribute.name, kind(attribute));
        for (error, outcome, region) in found.iter().take(WORST) {
            let [column, row] = region.place;
            let _ = write!(text, "  {:>+8.3} {:1}", error * attribute.factor, attribute.unit);
            let _ = write!(text, "  {} {column},{row}", outcome.name);
            let marks =
                if attribute.spots { format!(", {} whole marks", region.marks) } else { String::new() };
            let _ = writeln!(text, " ({}{marks})", outcome.systems.join(", "));
        }
    }
}

fn kind(attribute: &Attribute) -> &'static str {
    if attribute.spots { "spots" } else { "stripes" }
}
