//! What the free marks of the active layer want between them: sizes, shapes and directions at a grid of places, shown
//! over the sketch while one draws. Computed beside the window.

use std::sync::Arc;

use egui::{Color32, Stroke, vec2};

use super::ink::Ink;
use crate::app::theme::Palette;
use crate::attributes::Attributes;
use crate::attributes::free::{FreeMap, FreeRules};
use crate::document::{After, Document, Kind, Layer};
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::task::{Task, Tasks, Worker};
use crate::marks::{Ellipse, Line, Mark};

/// The most places along the longer side of the canvas, and the fewest.
const ALONG: [f64; 2] = [2.0, 24.0];
/// Area ÷ spacing² of spots whose spacing is free.
const PACKED: f64 = 0.22;
/// Period ÷ width of stripes whose period is free.
const PERIOD: f64 = 2.0;
/// Marks and places that are shown nearer to each other than this, in steps of the grid, hide the place.
const BESIDE: f64 = 0.35;
/// Below this coherence the directions of the marks around a place cancel.
const CANCEL: f64 = 0.3;
/// Above this aspect a spot has no direction that one could see.
const ROUND: f64 = 0.85;
/// Places that are shown nearer to each other than this are not painted, points.
const SMALLEST: f32 = 7.0;

/// What is wanted at a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glyph {
    /// The place, px.
    pub at: [f64; 2],
    /// Size, shape, direction.
    pub wanted: Attributes,
    /// How far the marks around it agree on a direction, 0..1.
    pub coherence: f64,
}

impl Glyph {
    /// Whether the marks around it want directions that cancel.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        let is_round = matches!(self.wanted, Attributes::Spots(spots) if spots.aspect > ROUND);
        self.coherence < CANCEL && !is_round
    }
}

/// What is wanted on a layer.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// At any place.
    pub map: FreeMap,
    /// At the places that are shown.
    pub glyphs: Vec<Glyph>,
    /// Distance of these, px.
    step: f64,
}

/// The revision and the layer that something was computed for.
type Key = (u64, usize);

/// What is wanted on the active layer of a session, as it was when the last computation ended.
#[derive(Default)]
pub struct LiveWanted {
    known: Option<(Key, Option<Wanted>)>,
    computing: Option<(Key, Task<Option<Wanted>>)>,
}

impl LiveWanted {
    /// Receives what was computed, and computes it anew where the sketch has changed; never waits, unless no thread can be
    /// started. One computation runs at a time, so that a drag shows each that ends. While `waits` is true none
    /// starts, so that a growth has the processor to itself.
    pub fn follow(&mut self, session: &Session, tasks: &Tasks, waits: bool) {
        if let Some((key, task)) = &mut self.computing {
            let wanted = task.poll();
            if wanted.is_none() && !task.has_ended() {
                return;
            }
            (self.known, self.computing) = (Some((*key, wanted.flatten())), None);
        }
        let key = (session.revision(), session.active_layer);
        if self.known.as_ref().is_some_and(|(known, _)| *known == key) {
            return;
        }
        let mut marks = session.marks_on_tile(session.active_layer);
        // Lines between cells want nothing at their places.
        let kind = session.kind(session.active_layer);
        marks.retain(|mark| Some(Kind::from(mark)) == kind);
        let document = session.document();
        if document.regions.is_some() || marks.is_empty() || !is_one_field(document, key.1) {
            self.known = Some((key, None));
            return;
        }
        if waits {
            return;
        }
        let (marks, document, layer) = (Arc::new(marks), Arc::new(session.document().clone()), key.1);
        let work = {
            let (marks, document) = (Arc::clone(&marks), Arc::clone(&document));
            move |worker: &Worker<_>| worker.send(Wanted::new(&marks, &document, layer))
        };
        match tasks.start("the wanted sizes and directions", work) {
            Ok(task) => self.computing = Some((key, task)),
            Err(_) => self.known = Some((key, Wanted::new(&marks, &document, layer))),
        }
    }

    /// Another document is open.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// Whether it is being computed.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.computing.is_some()
    }

    /// What is wanted on this layer; `None` in documents with regions, of layers without marks, of lines around marks or
    /// between them, of which only the width counts, and of weaves, which have several directions in one place. While it is
    /// computed anew, what was wanted before.
    #[must_use]
    pub fn of(&self, layer: usize) -> Option<&Wanted> {
        let ((_, known), wanted) = self.known.as_ref()?;
        wanted.as_ref().filter(|_| *known == layer)
    }
}

/// Whether the marks of a layer want one size and one direction in each place: not only a width, nor several directions.
pub(super) fn is_one_field(document: &Document, layer: usize) -> bool {
    let is_along_curves = |layer: &Layer| matches!(layer.after, After::Around | After::Net);
    !document.layers.get(layer).is_some_and(is_along_curves) && document.pairs(layer).is_none()
}

impl Wanted {
    /// What the `marks` of a layer want; `None` where they are mixed, or only their width counts, or where they want several
    /// directions in one place.
    fn new(marks: &[Mark], document: &Document, layer: usize) -> Option<Self> {
        let of_layer = document.layers.get(layer).filter(|_| is_one_field(document, layer))?;
        let size = document.size.map(f64::from);
        let rules = FreeRules { far_spacing: of_layer.far_spacing, ..FreeRules::default() };
        let map = FreeMap::with_rules(marks, size, document.edges, rules).ok()?;
        let map = if let Some(duty) = of_layer.options.duty.given() { map.with_duty(duty) } else { map };
        let step = step(&map.mean(), size);
        let is_free = |at: &[f64; 2]| marks.iter().all(|mark| shape::distance(mark, *at) > BESIDE * step);
        let glyph = |at| Glyph { at, wanted: map.at(at), coherence: map.coherence_at(at) };
        let glyphs = places(size, step).into_iter().filter(is_free).map(glyph).collect();
        Some(Self { map, glyphs, step })
    }

    /// Paints it.
    pub fn paint(&self, ink: &Ink, colours: &Palette) {
        let step = self.step as f32 * ink.view.zoom;
        if step < SMALLEST {
            return;
        }
        for glyph in &self.glyphs {
            let is_cancelled = glyph.is_cancelled();
            // A spot has a size there, a stripe has nothing.
            if !is_cancelled || matches!(glyph.wanted, Attributes::Spots(_)) {
                ink.mark(&self.example(glyph), Color32::TRANSPARENT, stroke(glyph, colours));
            }
            if is_cancelled {
                cross(ink, glyph.at, colours);
            }
        }
    }

    /// The mark that stands for a place: a spot as it is wanted there, or a piece of a stripe.
    fn example(&self, glyph: &Glyph) -> Mark {
        match glyph.wanted {
            Attributes::Spots(spots) => {
                Mark::Ellipse(Ellipse::from_area(glyph.at, spots.area, spots.aspect, spots.angle))
            }
            Attributes::Stripes(stripes) => {
                let half = 0.3 * self.step;
                let end = |x| shape::out_of_frame([x, 0.0], glyph.at, stripes.angle);
                Mark::Line(Line { from: end(-half), to: end(half), width: stripes.width })
            }
        }
    }
}

/// The distance of the places: about that of one spot from the other, or of every other stripe.
fn step(mean: &Attributes, size: [f64; 2]) -> f64 {
    let wanted = match mean {
        Attributes::Spots(spots) => spots.spacing.unwrap_or_else(|| (spots.area / PACKED).sqrt()),
        Attributes::Stripes(stripes) => 2.0 * stripes.wavelength.unwrap_or(PERIOD * stripes.width),
    };
    let (longer, [fewest, most]) = (size[0].max(size[1]), ALONG);
    wanted.clamp(longer / most, longer / fewest)
}

/// Places about `step` px apart, in rows of which every other one is shifted by half a step.
fn places(size: [f64; 2], step: f64) -> Vec<[f64; 2]> {
    let [columns, rows] = size.map(|side| (side / step).round().max(1.0));
    let mut places = Vec::new();
    for row in 0..rows as usize {
        let shift = if row.is_multiple_of(2) { 0.25 } else { 0.75 };
        for column in 0..columns as usize {
            places.push([(column as f64 + shift) / columns * size[0], (row as f64 + 0.5) / rows * size[1]]);
        }
    }
    places
}

/// The outline of what is wanted: faint where the directions of the marks around it hardly agree.
fn stroke(glyph: &Glyph, colours: &Palette) -> Stroke {
    let agreed = match glyph.wanted {
        Attributes::Spots(spots) if spots.aspect > ROUND => 1.0,
        _ => glyph.coherence.clamp(0.0, 1.0) as f32,
    };
    Stroke::new(1.0, colours.edge.gamma_multiply(0.2 + 0.5 * agreed))
}

/// A cross where directions cancel.
fn cross(ink: &Ink, at: [f64; 2], colours: &Palette) {
    let (middle, stroke) = (ink.at(at), Stroke::new(1.2, colours.wrong.gamma_multiply(0.8)));
    for arm in [vec2(3.5, 3.5), vec2(3.5, -3.5)] {
        ink.painter.line_segment([middle - arm, middle + arm], stroke);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Layer, Stroke, SystemChoice};

    fn wanted(strokes: Vec<Stroke>) -> Wanted {
        let marks: Vec<Mark> = strokes.iter().filter_map(Stroke::mark).collect();
        let document = Document { layers: vec![Layer::new(strokes)], ..Document::default() };
        Wanted::new(&marks, &document, 0).unwrap()
    }

    fn angle(glyph: &Glyph) -> f64 {
        match glyph.wanted {
            Attributes::Spots(spots) => spots.angle,
            Attributes::Stripes(stripes) => stripes.angle,
        }
    }

    #[test]
    fn there_is_about_one_glyph_for_each_spot_and_none_on_a_mark() {
        let strokes: Vec<Stroke> = (0..16)
            .map(|k| [64.0 + 64.0 * f64::from(k % 4), 64.0 + 64.0 * f64::from(k / 4)])
            .map(|center| Stroke::ellipse(center, [14.0, 8.0], 40.0))
            .collect();
        let shown = wanted(strokes.clone());
        let per_spot = 512.0 * 512.0 / (64.0 * 64.0);
        let share = shown.glyphs.len() as f64 / (per_spot - 16.0);
        assert!((0.6..1.4).contains(&share), "{}", shown.glyphs.len());
        for glyph in &shown.glyphs {
            assert!((angle(glyph) - 40.0).abs() < 0.5 && !glyph.is_cancelled(), "{glyph:?}");
            let beside = strokes.iter().filter_map(Stroke::mark).map(|mark| shape::distance(&mark, glyph.at));
            assert!(beside.fold(f64::INFINITY, f64::min) > 0.0, "{glyph:?}");
        }
    }

    #[test]
    fn directions_that_cancel_are_marked() {
        let lines = [
            Stroke::line([60.0, 100.0], [450.0, 100.0], 8.0),
            Stroke::line([256.0, 220.0], [256.0, 480.0], 8.0),
        ];
        let cancelled =
            |strokes: Vec<Stroke>| wanted(strokes).glyphs.iter().filter(|glyph| glyph.is_cancelled()).count();
        assert!(cancelled(lines.to_vec()) > 0);
        assert_eq!(cancelled(lines[..1].to_vec()), 0);
    }

    #[test]
    fn crossing_lines_of_a_weave_do_not_cancel() {
        let lines = [[[20.0, 60.0], [140.0, 60.0]], [[80.0, 10.0], [80.0, 110.0]]];
        let lines = lines.map(|[from, to]| Line { from, to, width: 8.0 });
        let marks = lines.map(Mark::Line);
        let mut document = Document { size: [160, 120], ..Document::default() };
        document.layers.push(Layer { strokes: lines.map(Stroke::Line).to_vec(), ..Layer::default() });
        assert!(Wanted::new(&marks, &document, 0).is_none());
        document.layers[0].system = SystemChoice::Stripes;
        assert!(Wanted::new(&marks, &document, 0).is_some());
    }

    #[test]
    fn round_spots_have_no_directions_that_could_cancel() {
        let round =
            [[100.0, 100.0], [200.0, 120.0], [150.0, 300.0]].map(|at| Stroke::ellipse(at, [9.0, 9.0], 0.0));
        assert!(wanted(round.to_vec()).glyphs.iter().all(|glyph| !glyph.is_cancelled()));
    }
}
