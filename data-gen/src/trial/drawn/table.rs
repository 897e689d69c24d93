//! The printed table: shares, errors with their limits, times, and the names of the worst sketches.

use std::fmt::Write;

use super::super::statistics::Summary;
use super::Kind;
use super::attempt::Attempt;
use super::limits::{MEASURES, MISSING, Measure, SECONDS, SLOWER};
use super::paths::COVERED;

/// The number of worst sketches that are named for each measure.
const WORST: usize = 10;

/// The table, and whether all limits hold and nothing failed.
pub fn table(kinds: &[Kind], attempts: &[Attempt]) -> (String, bool) {
    let (mut text, mut good) = (String::new(), true);
    for kind in kinds {
        let own: Vec<&Attempt> =
            attempts.iter().filter(|attempt| attempt.name.starts_with(kind.letter())).collect();
        let _ = writeln!(text, "({}) {} {}", kind.letter(), own.len(), kind.title());
        good &= if kind.is_striped() { strokes(&mut text, &own) } else { spots(&mut text, *kind, &own) };
        for measure in &MEASURES {
            if let Some(limits) = (measure.limits)(*kind) {
                good &= errors(&mut text, measure, limits, &own);
            }
        }
        good &= times(&mut text, &own);
        good &= failures(&mut text, &own);
        text.push('\n');
    }
    (text, good)
}

fn mark(good: bool) -> &'static str {
    if good { "ok" } else { "NOT" }
}

/// A line of counts: a label, how many of how many, and the limit where there is one.
fn share(text: &mut String, what: &str, [part, all]: [usize; 2], most: Option<f64>) -> bool {
    let share = part as f64 / all.max(1) as f64;
    let good = most.is_none_or(|most| share <= most);
    let _ = write!(text, "  {what:44} {part:>5} of {all:<5} {:>6.2} %", 100.0 * share);
    if let Some(most) = most {
        let _ = write!(text, "  ≤ {:.0} %  {}", 100.0 * most, mark(good));
    }
    text.push('\n');
    good
}

fn spots(text: &mut String, kind: Kind, own: &[&Attempt]) -> bool {
    let all: Vec<_> = own.iter().flat_map(|attempt| &attempt.spots).collect();
    let missing = all.iter().filter(|spot| !spot.there).count();
    let mut good = share(text, "not there", [missing, all.len()], (kind != Kind::B).then_some(MISSING));
    let free = all.iter().filter(|spot| !spot.there && !spot.too_near).count();
    good &= share(
        text,
        "not there, with no other mark close to it",
        [free, missing],
        (kind == Kind::B).then_some(0.0),
    );
    let listed: Vec<_> =
        own.iter().filter_map(|attempt| Some((attempt, attempt.reported.as_ref()?))).collect();
    if listed.is_empty() {
        let _ = writeln!(text, "  the reports do not list drawn marks");
    } else {
        let differ = listed.iter().map(|(attempt, there)| {
            attempt.spots.iter().zip(*there).filter(|(spot, there)| spot.there != **there).count()
        });
        let marks = listed.iter().map(|(_, there)| there.len()).sum();
        good &= share(
            text,
            "the report is wrong about whether the mark is there",
            [differ.sum(), marks],
            Some(0.0),
        );
    }
    let lost = |attempt: &Attempt| attempt.spots.iter().filter(|spot| !spot.there).count() as f64;
    worst(text, own, "marks not there", lost);
    let double = own.iter().fold([0, 0], |sum, attempt| [0, 1].map(|k| sum[k] + attempt.double[k]));
    share(text, "grown shapes that are two marks in one", double, None);
    good
}

fn strokes(text: &mut String, own: &[&Attempt]) -> bool {
    let all: Vec<_> = own.iter().flat_map(|attempt| &attempt.strokes).collect();
    let away = |stroke: &&&super::paths::Stroke| stroke.covered < COVERED;
    let missing = all.iter().filter(away).count();
    let good = share(text, "strokes not along a stripe for 90 %", [missing, all.len()], Some(MISSING));
    let uncovered =
        |attempt: &Attempt| attempt.strokes.iter().map(|stroke| 1.0 - stroke.covered).fold(0.0, f64::max);
    worst(text, own, "share of a stroke outside of a stripe", uncovered);
    good
}

fn errors(text: &mut String, measure: &Measure, [middle, high]: [f64; 2], own: &[&Attempt]) -> bool {
    let sizes = |attempt: &Attempt| (measure.values)(attempt).into_iter().map(|x| (x * measure.factor).abs());
    let Some(summary) = Summary::from_errors(own.iter().flat_map(|attempt| sizes(attempt))) else {
        return true;
    };
    let good = [summary.median <= middle, summary.p95 <= high];
    let digits = if middle < 1.0 { 3 } else { 2 };
    let _ = writeln!(
        text,
        "  {:30} {:>6}  median {:>7.digits$} ≤ {middle:<5} {:3}  95 % {:>7.digits$} ≤ {high:<5} {:3}  max {:.digits$}",
        format!("{} {}", measure.name, measure.unit),
        summary.count,
        summary.median,
        mark(good[0]),
        summary.p95,
        mark(good[1]),
        summary.max,
    );
    worst(text, own, measure.name, |attempt| sizes(attempt).fold(0.0, f64::max));
    good[0] && good[1]
}

fn times(text: &mut String, own: &[&Attempt]) -> bool {
    let mut line = |what: &str, most: f64, of: &dyn Fn(&Attempt) -> Option<f64>| {
        let Some(summary) = Summary::from_errors(own.iter().filter_map(|attempt| of(attempt))) else {
            return true;
        };
        let Summary { median, p95, max, .. } = summary;
        let good = max <= most;
        let _ = writeln!(
            text,
            "  {what:37} median {median:>7.2}  95 % {p95:>7.2}  max {max:>7.2} ≤ {most}  {}",
            mark(good)
        );
        worst(text, own, what, |attempt| of(attempt).unwrap_or(0.0));
        good
    };
    let slower = line("CPU time, default ÷ no spread", SLOWER, &|attempt| attempt.slower);
    line("CPU time, s", SECONDS, &|attempt| Some(attempt.seconds)) && slower
}

fn failures(text: &mut String, own: &[&Attempt]) -> bool {
    let failed: Vec<_> = own.iter().filter(|attempt| !attempt.failures.is_empty()).collect();
    share(text, "sketches that failed", [failed.len(), own.len()], Some(0.0));
    for attempt in &failed {
        let _ = writeln!(text, "    {}: {}", attempt.name, attempt.failures.join("; "));
    }
    failed.is_empty()
}

/// The sketches with the largest value.
fn worst(text: &mut String, own: &[&Attempt], what: &str, of: impl Fn(&Attempt) -> f64) {
    let mut found: Vec<(f64, &str)> =
        own.iter().map(|attempt| (of(attempt), attempt.name.as_str())).filter(|(x, _)| *x > 0.0).collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    if found.is_empty() {
        return;
    }
    let named = found.iter().take(WORST).map(|(value, name)| format!("{name} {value:.3}"));
    let _ = writeln!(text, "      most {what}: {}", named.collect::<Vec<_>>().join(", "));
}

#[cfg(test)]
mod tests {
    use super::super::spots::Spot;
    use super::*;

    fn attempt(name: &str, off: &[f64]) -> Attempt {
        let spot = |off: &f64| Spot {
            there: *off < 0.5,
            distance: Some(*off).filter(|off| *off < 0.5),
            ..Spot::default()
        };
        Attempt { name: name.to_owned(), spots: off.iter().map(spot).collect(), ..Attempt::default() }
    }

    #[test]
    fn a_table_holds_each_limit_and_names_the_worst() {
        let (text, good) =
            table(&[Kind::A], &[attempt("a-000", &[0.01; 200]), attempt("a-001", &[0.3, 0.02])]);
        assert!(good && text.contains("not there") && !text.contains("NOT"), "{text}");
        assert!(text.contains("most distance: a-001 0.300, a-000 0.010"), "{text}");
        let (text, good) = table(&[Kind::A], &[attempt("a-000", &[0.01, 0.9])]);
        assert!(!good && text.contains("1 of 2") && text.contains("NOT"), "{text}");
    }

    #[test]
    fn a_failure_or_a_slow_sketch_fails_the_table() {
        let fine = || attempt("a-000", &[0.01; 3]);
        assert!(table(&[Kind::A], &[fine()]).1);
        assert!(!table(&[Kind::A], &[Attempt { failures: vec!["blank".to_owned()], ..fine() }]).1);
        assert!(!table(&[Kind::A], &[Attempt { seconds: 9.0, ..fine() }]).1);
        assert!(!table(&[Kind::A], &[Attempt { slower: Some(5.0), ..fine() }]).1);
    }
}
