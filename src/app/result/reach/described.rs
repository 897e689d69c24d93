//! Describes a change of a sketch in words.

use super::sketch::Sketch;
use crate::marks::Mark;

/// What changes, in words with numbers.
pub(super) fn described(from: &Sketch, to: &Sketch) -> String {
    let mut changes = Vec::new();
    let mut more = |what: &str, [more, less]: [&str; 2], factor: f64| {
        let per_cent = 100.0 * (factor - 1.0).abs();
        // Smaller changes cannot be seen.
        if per_cent >= 0.5 {
            let word = if factor > 1.0 { more } else { less };
            let digits = usize::from(per_cent < 9.5);
            changes.push(format!("{what} {per_cent:.digits$} % {word}"));
        }
    };
    let mean = |marks: &[(usize, Mark)], of: &dyn Fn(&Mark) -> f64| {
        marks.iter().map(|(_, mark)| of(mark)).sum::<f64>() / marks.len().max(1) as f64
    };
    let factor = |of: &dyn Fn(&Mark) -> f64| mean(&to.marks, of) / mean(&from.marks, of);
    let spots = matches!(from.marks.first(), Some((_, Mark::Ellipse(_))));
    if spots {
        more("areas", ["larger", "smaller"], factor(&|mark| mark.ellipse().map_or(0.0, |e| e.area())));
        more("shapes", ["rounder", "longer"], factor(&|mark| mark.ellipse().map_or(0.0, |e| e.aspect())));
        more("places", ["farther apart", "nearer together"], extent(&to.marks) / extent(&from.marks));
    } else {
        let width = |mark: &Mark| mark.path().map_or(0.0, |path| path.width);
        more("lines", ["thicker", "thinner"], factor(&width));
    }
    if let Some(duty) = to.duty.given().filter(|_| from.duty != to.duty) {
        changes.push(format!("duty {duty:.2} on the whole layer"));
    }
    if changes.is_empty() { "different directions".to_owned() } else { changes.join(", ") }
}

/// Root mean square distance of the marks from their mean centre, px.
fn extent(marks: &[(usize, Mark)]) -> f64 {
    let n = marks.len().max(1) as f64;
    let midpoint = [0, 1].map(|axis| marks.iter().map(|(_, mark)| mark.center()[axis]).sum::<f64>() / n);
    let far = |(_, mark): &(usize, Mark)| {
        let center = mark.center();
        (0..2).map(|axis| (center[axis] - midpoint[axis]) * (center[axis] - midpoint[axis])).sum::<f64>()
    };
    (marks.iter().map(far).sum::<f64>() / n).sqrt().max(1e-9)
}
