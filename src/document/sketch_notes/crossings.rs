//! Lines and paths that cross: stripes of one layer have one direction at each place.

use super::{Problem, Remedy, SketchNote};
use crate::document::{After, Layer};
use crate::marks::{Mark, Path};

pub(super) fn notes(layer: &Layer, marks: &[Option<Mark>]) -> Vec<SketchNote> {
    // Rings and webs follow the marks beneath; only the width of what was drawn counts. Threads of a weave are to cross.
    if matches!(layer.after, After::Around | After::Net) || layer.system.pairs().is_some() {
        return Vec::new();
    }
    let paths = marks.iter().enumerate().filter_map(|(index, mark)| Some((index, mark.as_ref()?.path()?)));
    let paths: Vec<(usize, Path)> = paths.collect();
    let mut notes = Vec::new();
    for (index, path) in &paths {
        let places = path.crossings();
        if !places.is_empty() {
            notes.push(SketchNote::new(vec![*index], places, Problem::CrossesItself));
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
        let note = SketchNote::new(strokes, places, Problem::CrossEachOther);
        notes.push(SketchNote { remedy: Some(Remedy::CrossingLayer), ..note });
    }
    notes
}

/// The strokes to put on a layer of their own so that no two of those that stay cross: each that crosses an earlier one that
/// stays.
#[must_use]
pub fn crossing_strokes(marks: &[Option<Mark>]) -> Vec<usize> {
    let (mut staying, mut moving): (Vec<Path>, Vec<usize>) = (Vec::new(), Vec::new());
    for (index, mark) in marks.iter().enumerate() {
        let Some(path) = mark.as_ref().and_then(Mark::path) else { continue };
        if staying.iter().any(|other| may_touch(&path, other) && !path.crossings_with(other).is_empty()) {
            moving.push(index);
        } else {
            staying.push(path);
        }
    }
    moving
}

/// Whether the boxes around two paths overlap.
fn may_touch(a: &Path, b: &Path) -> bool {
    let ([low_a, high_a], [low_b, high_b]) = (a.bounds(), b.bounds());
    (0..2).all(|axis| low_a[axis] <= high_b[axis] && low_b[axis] <= high_a[axis])
}
