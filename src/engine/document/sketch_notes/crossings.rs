//! Lines and paths that cross: stripes of one layer have one direction at each place.

use super::{Problem, Remedy, SketchNote};
use crate::document::weaving::can_weave;
use crate::document::{After, Document, Layer};
use crate::marks::{Mark, Path};

pub(super) fn notes(document: &Document, layer: &Layer, marks: &[Option<Mark>]) -> Vec<SketchNote> {
    // Lines of rings, webs and gaps between cells are drawn for their width alone. Threads of a weave are meant to cross.
    let width_alone = matches!(layer.after, After::Around | After::Net) || layer.system.takes_lines_beside();
    if width_alone || document.pairs_of(layer, marks).is_some() {
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
        for (b, other) in paths.iter().skip(i + 1).filter(|(_, other)| path.may_touch(other)) {
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
        let lines: Vec<Path> = paths.into_iter().map(|(_, path)| path).collect();
        let weave = can_weave(document, &lines).then_some(Remedy::Weave);
        notes.push(SketchNote {
            remedies: [Remedy::CrossingLayer].into_iter().chain(weave).collect(),
            ..note
        });
    }
    notes
}

/// The strokes to move to a layer of their own so that no two of the others cross: every stroke that crosses an earlier one that
/// remains.
#[must_use]
pub fn crossing_strokes(marks: &[Option<Mark>]) -> Vec<usize> {
    let (mut staying, mut moving): (Vec<Path>, Vec<usize>) = (Vec::new(), Vec::new());
    for (index, mark) in marks.iter().enumerate() {
        let Some(path) = mark.as_ref().and_then(Mark::path) else { continue };
        if staying.iter().any(|other| path.may_touch(other) && !path.crossings_with(other).is_empty()) {
            moving.push(index);
        } else {
            staying.push(path);
        }
    }
    moving
}
