//! What the free marks of the active layer ask for in the space between them: sizes, shapes and directions on a grid of
//! places, shown over the sketch while the user draws. They are computed on another thread.

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

/// Limits of the number of places along the longer side of the canvas: the fewest and the most.
const ALONG: [f64; 2] = [2.0, 24.0];
/// Area ÷ spacing² that is assumed for spots whose spacing is not set.
const PACKED: f64 = 0.22;
/// Period ÷ width that is assumed for stripes whose period is not set.
const PERIOD: f64 = 2.0;
/// A place that is nearer to a drawn mark than this share of the grid's step is not shown.
const BESIDE: f64 = 0.35;
/// Below this coherence, the directions of the marks around a place cancel each other.
const CANCEL: f64 = 0.3;
/// Above this aspect a spot is so round that its direction cannot be seen.
const ROUND: f64 = 0.85;
/// Where places are closer together than this on the screen, they are not painted, points.
const SMALLEST: f32 = 7.0;

/// What the marks ask for at one place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glyph {
    /// The place, px.
    pub at: [f64; 2],
    /// Size, shape, direction.
    pub wanted: Attributes,
    /// How well the directions of the marks around the place agree, 0..1.
    pub coherence: f64,
}

impl Glyph {
    /// Whether the directions of the marks around the place cancel each other.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        let is_round = matches!(self.wanted, Attributes::Spots(spots) if spots.aspect > ROUND);
        self.coherence < CANCEL && !is_round
    }
}

/// What the marks of a layer ask for.
#[derive(Clone, Debug)]
pub struct Wanted {
    /// The attributes at any place.
    pub map: FreeMap,
    /// At the places that are shown.
    pub glyphs: Vec<Glyph>,
    /// Distance between these places, px.
    step: f64,
}

/// The revision and the layer of the sketch from which a result was computed.
type Key = (u64, usize);

/// What the marks of the active layer of a session ask for, from the last computation that has ended.
#[derive(Default)]
pub struct LiveWanted {
    known: Option<(Key, Option<Wanted>)>,
    computing: Option<(Key, Task<Option<Wanted>>)>,
}

impl LiveWanted {
    /// Receives the result of a computation, and starts a new one where the sketch has changed; never blocks, unless no
    /// thread can be started. One computation runs at a time, so that during a drag the results appear one after the
    /// other. While `waits` is true no computation is started, so that a growth has the processor to itself.
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
        // Lines between cells set no attributes in the space around them.
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

    /// Removes the result, because another document was opened.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// Whether a computation is running.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.computing.is_some()
    }

    /// What the marks of this layer ask for. `None` for documents with regions, for layers without marks, for lines
    /// around or between the marks beneath, of which only the width counts, and for weaves, which have several
    /// directions at one place. While a new computation runs, this is the result before it.
    #[must_use]
    pub fn of(&self, layer: usize) -> Option<&Wanted> {
        let ((_, known), wanted) = self.known.as_ref()?;
        wanted.as_ref().filter(|_| *known == layer)
    }
}

/// Whether the marks of a layer ask for one size and one direction at each place: not only for a width, and not for
/// several directions.
pub(super) fn is_one_field(document: &Document, layer: usize) -> bool {
    let is_along_curves = |layer: &Layer| matches!(layer.after, After::Around | After::Net);
    !document.layers.get(layer).is_some_and(is_along_curves) && document.pairs(layer).is_none()
}

impl Wanted {
    /// What the `marks` of a layer ask for. `None` where they are of several kinds, where only their width counts, or
    /// where they ask for several directions at one place.
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
            // A spot shows its size there; a stripe shows nothing.
            if !is_cancelled || matches!(glyph.wanted, Attributes::Spots(_)) {
                ink.mark(&self.example(glyph), Color32::TRANSPARENT, stroke(glyph, colours));
            }
            if is_cancelled {
                cross(ink, glyph.at, colours);
            }
        }
    }

    /// The mark that is shown at a place: a spot with the attributes there, or a piece of a stripe.
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

/// The distance between the places, px: about the spacing of the spots, or twice the period of the stripes.
fn step(mean: &Attributes, size: [f64; 2]) -> f64 {
    let wanted = match mean {
        Attributes::Spots(spots) => spots.spacing.unwrap_or_else(|| (spots.area / PACKED).sqrt()),
        Attributes::Stripes(stripes) => 2.0 * stripes.wavelength.unwrap_or(PERIOD * stripes.width),
    };
    let (longer, [fewest, most]) = (size[0].max(size[1]), ALONG);
    wanted.clamp(longer / most, longer / fewest)
}

/// Places in rows, about `step` px apart; every other row is shifted by half a step.
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

/// The stroke of an outline: faint where the directions of the marks around the place hardly agree.
fn stroke(glyph: &Glyph, colours: &Palette) -> Stroke {
    let agreed = match glyph.wanted {
        Attributes::Spots(spots) if spots.aspect > ROUND => 1.0,
        _ => glyph.coherence.clamp(0.0, 1.0) as f32,
    };
    Stroke::new(1.0, colours.edge.gamma_multiply(0.2 + 0.5 * agreed))
}

/// A cross where the directions cancel each other.
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
