//! Paints the sketch: paper, overlays, marks, the selection, the gesture under way. The background is not painted: the
//! window is cleared to it.

use std::time::Duration;

use egui::{Align2, Color32, FontId, Rect, Response, Stroke, StrokeKind, Ui, vec2};

use super::badges;
use super::gesture::Gesture;
use super::ink::Ink;
use super::tool::Tool;
use super::{Canvas, handles, lost, starter};
use crate::app::result::Drawn;
use crate::app::theme::Palette;
use crate::document;
use crate::editor::session::Session;
use crate::editor::units::Ruler;
use crate::grid::Edges;
use crate::marks::Mark;

/// A stroke that was recognised fades within this time, seconds.
const FADE: f64 = 0.7;

impl Canvas {
    pub(super) fn paint(
        &mut self,
        ui: &Ui,
        room: Rect,
        (session, drawn): (&Session, &Drawn),
        response: &Response,
    ) {
        let colours = Palette::current(ui.visuals());
        let painter = ui.painter_at(room);
        let paper = self.view.paper(room, session.document().size);
        painter.rect_filled(paper, 2.0, colours.paper);
        self.underlay.paint(&painter, paper);
        self.reference.paint(&painter, self.view, room, session.document().size);
        let ink = Ink { painter: &painter, view: &self.view, room };
        if self.snap.on {
            snap_grid(&ink, session.document().size, self.snap.step, colours);
        }
        if self.overlays.regions {
            grid(&ink, session, colours);
        }
        self.paint_chosen_region(&ink, session, colours);
        painter.rect_stroke(paper, 2.0, Stroke::new(1.0, colours.border), StrokeKind::Outside);
        if self.overlays.wanted
            && let Some(wanted) = self.wanted.of(session.active_layer)
        {
            let painter = painter.with_clip_rect(painter.clip_rect().intersect(paper));
            wanted.paint(&Ink { painter: &painter, ..ink }, colours);
        }
        self.paint_marks(&ink, session, drawn, colours);
        if self.overlays.analysis {
            self.analysis.paint(&ink, session, session.active_layer, colours);
        }
        if self.tool == Tool::Comb {
            self.combed.paint(&ink, session, colours);
        }
        if session.is_empty() && self.gesture.is_none() {
            starter::paint(&ink, session.document().size, colours, ui.visuals().weak_text_color());
        }
        badges::paint(&ink, &self.badges, colours);
        self.paint_reference_handles(&ink, session, colours);
        self.paint_selection(&ink, session, colours);
        self.paint_gesture(ui, &ink, Ruler { units: self.units, dpi: session.document().dpi }, colours);
        fade(ui, &ink, &mut self.fading, self.between_frames, colours);
        if response.has_focus() && !self.by_pointer {
            painter.rect_stroke(
                room.shrink(1.0),
                3.0,
                Stroke::new(1.0, colours.accent_pale),
                StrokeKind::Inside,
            );
        }
    }

    /// Paints the selection and the stroke that is being drawn once more, where something covers the part `seen` of the
    /// canvas.
    pub fn paint_over(&self, ui: &Ui, room: Rect, seen: Rect, session: &Session) {
        let colours = Palette::current(ui.visuals());
        let painter = ui.painter_at(seen);
        let ink = Ink { painter: &painter, view: &self.view, room };
        self.paint_selection(&ink, session, colours);
        self.paint_gesture(ui, &ink, Ruler { units: self.units, dpi: session.document().dpi }, colours);
        paint_fading(ui, &ink, &self.fading, colours);
    }

    /// Paints a frame around the region whose numbers are shown.
    fn paint_chosen_region(&self, ink: &Ink, session: &Session, colours: &Palette) {
        let Some(place) = self.chosen_region.filter(|_| session.document().regions.is_some()) else { return };
        let (size, grid) = (session.document().size.map(f64::from), session.document().region_grid());
        let corner =
            |by: usize| ink.at([0, 1].map(|axis| size[axis] * (place[axis] + by) as f64 / grid[axis] as f64));
        let rect = Rect::from_min_max(corner(0), corner(1));
        ink.painter.rect_stroke(rect, 0.0, Stroke::new(1.5, colours.accent), StrokeKind::Inside);
    }

    fn paint_marks(&self, ink: &Ink, session: &Session, drawn: &Drawn, colours: &Palette) {
        let fill = if self.overlays.analysis { 0.10 } else { 0.82 };
        for (place, mark) in session.marks() {
            if drawn.lost(session, place).is_some() {
                lost::paint(ink, &mark, session.selection.contains(place), colours);
                continue;
            }
            let colour = colours.ink(place.layer);
            let [body, outline] = self.opacity(session, place.layer);
            let (inside, line) = if session.selection.contains(place) {
                (0.6 * fill, Stroke::new(2.0, colours.accent))
            } else {
                (body * fill, Stroke::new(1.0, colour.gamma_multiply(outline)))
            };
            let layer = &session.document().layers[place.layer];
            match &layer.strokes[place.stroke] {
                document::Stroke::Outline(outline) => {
                    ink.polygon(&outline.points, colour.gamma_multiply(inside), line);
                }
                document::Stroke::Fitted { outline, .. } if session.areas(place.layer).is_some() => {
                    ink.polygon(&outline.points, colour.gamma_multiply(inside), line);
                }
                _ => ink.mark(&mark, colour.gamma_multiply(inside), line),
            }
        }
    }

    /// The opacity of a layer's marks: fill and outline. The active layer is opaque, the others are paler; hidden layers
    /// are outlines only.
    fn opacity(&self, session: &Session, layer: usize) -> [f32; 2] {
        if !session.document().layers[layer].visible {
            [0.0, 0.45]
        } else if layer < session.frozen() {
            if self.underlay.is_there() { [0.0, 0.5] } else { [0.25, 0.5] }
        } else if layer == session.active_layer || session.document().layers.len() == 1 {
            [1.0, 1.0]
        } else {
            [0.5, 0.7]
        }
    }

    fn paint_selection(&self, ink: &Ink, session: &Session, colours: &Palette) {
        let marks: Vec<_> = session.selected().collect();
        if marks.len() > 1
            && let Some(around) = handles::frame(&marks, ink.view, ink.room)
        {
            ink.dashed([around.min, around.max], Stroke::new(1.0, colours.accent));
        }
        if self.tool != Tool::Select || matches!(self.gesture, Some(Gesture::Move { .. })) {
            return;
        }
        for (handle, at) in handles::handles(session, ink.view, ink.room) {
            let stroke = Stroke::new(1.5, colours.accent);
            if handle == handles::Handle::Turn {
                ink.painter.circle(at, 4.5, colours.accent, stroke);
            } else {
                ink.painter.rect(
                    Rect::from_center_size(at, vec2(8.0, 8.0)),
                    2.0,
                    colours.paper,
                    stroke,
                    StrokeKind::Middle,
                );
            }
        }
    }

    /// Paints the gesture under way.
    fn paint_gesture(&self, ui: &Ui, ink: &Ink, ruler: Ruler, colours: &Palette) {
        match &self.gesture {
            Some(Gesture::Pen(points) | Gesture::Comb(points)) => {
                let width = (self.pressed_nib().width as f32 * ink.view.zoom).clamp(1.5, 3.0);
                ink.path(points, Stroke::new(width, colours.pen));
            }
            Some(Gesture::Box(ends, _)) => {
                ink.dashed(ends.map(|end| ink.at(end)), Stroke::new(1.0, colours.accent));
            }
            Some(gesture) => {
                if let Some(mark) = gesture.preview(&self.pressed_nib()) {
                    ink.mark(&mark, colours.pen.gamma_multiply(0.25), Stroke::new(1.5, colours.pen));
                    if let Some(at) = ui.input(|input| input.pointer.latest_pos()) {
                        label(ink, &mark, at, ruler, colours);
                    }
                }
            }
            None => {}
        }
    }
}

/// A fading stroke, and the time when it began to fade, seconds.
type Fading = (Vec<[f64; 2]>, f64);

/// Paints the strokes that were recognised while they fade, and asks for the next frame `between_frames` later.
fn fade(ui: &Ui, ink: &Ink, fading: &mut Vec<Fading>, between_frames: Duration, colours: &Palette) {
    let now = ui.input(|input| input.time);
    fading.retain(|(_, since)| now - since < FADE);
    paint_fading(ui, ink, fading, colours);
    if !fading.is_empty() {
        ui.ctx().request_repaint_after(between_frames);
    }
}

fn paint_fading(ui: &Ui, ink: &Ink, fading: &[Fading], colours: &Palette) {
    let now = ui.input(|input| input.time);
    for (points, since) in fading {
        let left = 1.0 - ((now - since) / FADE) as f32;
        ink.path(points, Stroke::new(2.0, colours.pen.gamma_multiply(left)));
    }
}

/// Shows the size of the new mark beside the pointer.
fn label(ink: &Ink, mark: &Mark, at: egui::Pos2, ruler: Ruler, colours: &Palette) {
    let text = match mark {
        Mark::Ellipse(ellipse) => ruler.area(ellipse.area()),
        Mark::Line(line) => format!("{:.0}°", line.angle()),
        Mark::Path(path) => ruler.length(path.length()),
    };
    let galley = ink.painter.layout_no_wrap(text, FontId::proportional(11.5), colours.paper);
    let rect = Align2::LEFT_TOP.anchor_size(at + vec2(14.0, 14.0), galley.size() + vec2(10.0, 4.0));
    ink.painter.rect_filled(rect, 4.0, colours.pen);
    ink.painter.galley(rect.min + vec2(5.0, 2.0), galley, Color32::PLACEHOLDER);
}

/// Paints the grid that marks snap to, every other line or fewer where these are too dense.
fn snap_grid(ink: &Ink, size: [u32; 2], step: f64, colours: &Palette) {
    /// The least distance of two lines, points.
    const LEAST: f64 = 6.0;
    let each = (LEAST / (step * f64::from(ink.view.zoom))).ceil().max(1.0) * step;
    let stroke = Stroke::new(1.0, colours.grid.gamma_multiply(0.45));
    let size = size.map(f64::from);
    for axis in 0..2 {
        for line in 1..(size[axis] / each).ceil() as usize {
            let [mut from, mut to] = [[0.0; 2], size];
            (from[axis], to[axis]) = (line as f64 * each, line as f64 * each);
            ink.segment([from, to], stroke);
        }
    }
}

/// Paints the borders between regions; on a seamless canvas its own border as well.
fn grid(ink: &Ink, session: &Session, colours: &Palette) {
    let document = session.document();
    let size = document.size.map(f64::from);
    let stroke = Stroke::new(1.0, colours.grid);
    for axis in 0..2 {
        let regions = document.region_grid()[axis];
        for line in 1..regions {
            let place = size[axis] * line as f64 / regions as f64;
            let [mut from, mut to] = [[0.0; 2], size];
            (from[axis], to[axis]) = (place, place);
            ink.segment([from, to], stroke);
        }
    }
    if document.edges == Edges::Wrap {
        ink.dashed([ink.at([0.0; 2]), ink.at(size)], Stroke::new(1.5, colours.accent_pale));
    }
}
