//! Lines and paths that cross: stripes of one layer have one direction at each place.

use super::{SketchNote, in_words};
use crate::document::{After, Layer};
use crate::marks::{Mark, Path};

pub(super) fn notes(layer: &Layer, marks: &[Option<Mark>]) -> Vec<SketchNote> {
    // Rings and webs follow the marks beneath; only the width of what was drawn counts.
    if matches!(layer.after, After::Around | After::Net) {
        return Vec::new();
    }
    let paths = marks.iter().enumerate().filter_map(|(index, mark)| Some((index, mark.as_ref()?.path()?)));
    let paths: Vec<(usize, Path)> = paths.collect();
    let mut notes = Vec::new();
    for (index, path) in &paths {
        let places = path.crossings();
        if !places.is_empty() {
            let text = format!(
                "this path crosses itself at {}: stripes have one direction at each place; cut it there and put the two parts \
                 on two layers",
                in_words(&places)
            );
            notes.push(SketchNote::new(vec![*index], places, text));
        }
    }
    let (mut strokes, mut places) = (Vec::new(), Vec::new());
    for (i, (a, path)) in paths.iter().enumerate() {
        for (b, other) in paths.iter().skip(i + 1).filter(|(_, other)| may_touch(path, other)) {
            let crossed = path.crossings_with(other);
            if !crossed.is_empty() {
                strokes.extend([*a, *b]);
                places.extend(crossed);
            }
        }
    }
    strokes.sort_unstable();
    strokes.dedup();
    if !places.is_empty() {
        let text = format!(
            "these cross each other at {}: stripes have one direction at each place; use two layers",
            in_words(&places)
        );
        notes.push(SketchNote::new(strokes, places, text));
    }
    notes
}

/// Whether the boxes around two paths overlap.
fn may_touch(a: &Path, b: &Path) -> bool {
    let ([low_a, high_a], [low_b, high_b]) = (a.bounds(), b.bounds());
    (0..2).all(|axis| low_a[axis] <= high_b[axis] && low_b[axis] <= high_a[axis])
}
