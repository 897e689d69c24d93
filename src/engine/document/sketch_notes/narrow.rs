//! Spots that are drawn narrower than any can be grown.

use super::{Problem, SketchNote};
use crate::learn::NARROWEST;
use crate::marks::Mark;

pub(super) fn note(marks: &[Option<Mark>]) -> Option<SketchNote> {
    let ellipses = marks.iter().enumerate().filter_map(|(index, mark)| match mark {
        Some(Mark::Ellipse(ellipse)) => Some((index, ellipse)),
        _ => None,
    });
    let found: Vec<_> = ellipses.filter(|(_, ellipse)| ellipse.aspect() < NARROWEST).collect();
    let (first, rest) = found.split_first()?;
    let least = rest.iter().fold(first.1.aspect(), |least, (_, ellipse)| least.min(ellipse.aspect()));
    let strokes = found.iter().map(|(index, _)| *index).collect();
    let places = found.iter().map(|(_, ellipse)| ellipse.center).collect();
    Some(SketchNote::new(strokes, places, Problem::Narrow { spots: found.len(), least }))
}

pub(super) fn in_words(spots: usize, least: f64) -> String {
    let drawn = match spots {
        1 => format!("this spot is drawn {least:.2} times as wide as long"),
        _ => format!("these spots are drawn down to {least:.2} times as wide as long"),
    };
    format!("{drawn}; spots grow {NARROWEST} times as wide or wider: draw wider ones, or draw lines")
}
