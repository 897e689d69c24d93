//! The canvas: the sketch, the tools, the selection.

pub mod analysis;
mod gesture;
mod handles;
pub mod ink;
mod lost;
mod navigate;
pub mod tool;
pub mod view;
pub mod wanted;

pub use gesture::Nib;
pub use navigate::navigate;

use egui::{
    Align2, Color32, CursorIcon, EventFilter, FontId, Id, Key, PointerButton, Rect, Response, Role, Sense,
    Stroke, StrokeKind, Ui, WidgetInfo, vec2,
};

use super::reference::Reference;
use super::result::Drawn;
use super::theme::Palette;
use super::underlay::Underlay;
use crate::document::sketch_notes::outline_remark;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::units::{Ruler, Units};
use crate::grid::Edges;
use crate::marks::Mark;
use crate::sketch::recognise;
use analysis::Analysis;
use gesture::{Gesture, Hand};
use ink::Ink;
use tool::Tool;
use view::View;
use wanted::LiveWanted;

/// A stroke that was recognised fades within this time, seconds.
const FADE: f64 = 0.7;
/// The pointer is on a mark within this distance, points.
const HOVER: f64 = 2.0;

/// What is shown over the sketch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlays {
    /// The region grid.
    pub regions: bool,
    /// Fitted ellipses, neighbours, directions.
    pub analysis: bool,
    /// Sizes and directions that free marks want between them.
    pub wanted: bool,
}

/// The state of the canvas; nothing of it is saved in documents.
pub struct Canvas {
    /// The current tool.
    pub tool: Tool,
    /// The size of new marks.
    pub nib: Nib,
    /// Which part is shown.
    pub view: View,
    /// What is shown over it.
    pub overlays: Overlays,
    /// The position of the pointer, px.
    pub pointer: Option<[f64; 2]>,
    /// The analysed sketch.
    pub analysis: Analysis,
    /// What the free marks of the active layer want between them.
    pub wanted: LiveWanted,
    /// The mark under the pointer.
    pub hovered: Option<Place>,
    /// The unit in which lengths are shown.
    pub units: Units,
    /// The reference picture under it.
    pub reference: Reference,
    /// The texture of frozen layers under it.
    pub underlay: Underlay,
    /// The id of its widget, once it was shown.
    pub id: Option<Id>,
    /// Whether it got the keyboard focus by a click; then the focus is not highlighted.
    by_pointer: bool,
    gesture: Option<Gesture>,
    /// What is to be told of the stroke that was drawn last.
    pub remark: Option<String>,
    /// Strokes that were recognised, and when, seconds.
    fading: Vec<(Vec<[f64; 2]>, f64)>,
}

impl Default for Canvas {
    fn default() -> Self {
        Self {
            tool: Tool::default(),
            nib: Nib::default(),
            view: View::default(),
            overlays: Overlays { regions: true, analysis: false, wanted: true },
            pointer: None,
            analysis: Analysis::default(),
            wanted: LiveWanted::default(),
            hovered: None,
            units: Units::default(),
            reference: Reference::default(),
            underlay: Underlay::default(),
            id: None,
            by_pointer: false,
            gesture: None,
            remark: None,
            fading: Vec::new(),
        }
    }
}

impl Canvas {
    /// Whether a gesture changes the document.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.gesture.as_ref().is_some_and(|gesture| !matches!(gesture, Gesture::Pan))
    }

    /// The mark that a release of the pointer would add now.
    #[must_use]
    pub fn pending_mark(&self) -> Option<Mark> {
        match self.gesture.as_ref()? {
            Gesture::Pen(points) => recognise(points, self.nib.width),
            gesture => gesture.preview(&self.nib),
        }
    }

    /// Cancels the gesture and undoes what it changed. Gives whether there was one.
    pub fn cancel(&mut self, session: &mut Session) -> bool {
        let held = self.gesture.take().is_some();
        if held {
            session.revert();
        }
        held
    }

    /// Shows the canvas in `room`; gestures change the document. `drawn`: what became of its marks.
    pub fn ui(&mut self, ui: &mut Ui, room: Rect, session: &mut Session, drawn: &Drawn) -> Response {
        let revision = session.revision();
        let response = ui.interact(room, ui.scope_id().with("sketch"), Sense::drag());
        self.id = Some(response.id);
        let marks = session.marks().count();
        let name = format!("Sketch canvas, {marks} {}", if marks == 1 { "mark" } else { "marks" });
        response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, &name));
        if self.view.fitted {
            self.view.fit(session.document().size, room);
        }
        self.by_pointer &= response.has_focus() || response.dragged();
        if response.has_focus() {
            let filter =
                EventFilter { tab: false, horizontal_arrows: true, vertical_arrows: true, escape: true };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        }
        self.pointer = response.hover_pos().map(|at| self.view.to_canvas(room, at));
        if ui.input(egui::InputState::multi_touch).is_some() {
            // Two fingers move the view: the gesture of the first one is cancelled.
            self.cancel(session);
        } else {
            self.gesture(ui, &response, room, session);
        }
        let grabbed = matches!(self.gesture, Some(Gesture::Pan));
        navigate(ui, &response, room, &mut self.view, grabbed);
        self.analysis.update(session);
        let changed = Drawn::default();
        let drawn = if session.revision() == revision { drawn } else { &changed };
        self.hovered =
            self.pointer.filter(|_| self.gesture.is_none()).and_then(|at| self.mark_at(session, drawn, at));
        self.paint(ui, room, (session, drawn), &response);
        match self.hovered.and_then(|place| drawn.lost(session, place)) {
            Some(reason) => response.on_hover_text_at_pointer(format!("Does not grow: {reason}")),
            None => response,
        }
    }

    /// The mark at a point, px; among several first one that does not grow.
    fn mark_at(&self, session: &Session, drawn: &Drawn, at: [f64; 2]) -> Option<Place> {
        let reach = HOVER / f64::from(self.view.zoom);
        let is_lost = |place: &Place| drawn.lost(session, *place).is_some();
        let here = session.marks().rev().filter(|(_, mark)| shape::distance(mark, at) <= reach);
        let lost = here.map(|(place, _)| place).find(is_lost);
        lost.or_else(|| session.hit(at, reach)).or_else(|| session.hit_frozen(at, reach))
    }

    fn gesture(&mut self, ui: &Ui, response: &Response, room: Rect, session: &mut Session) {
        let (modifiers, space) = ui.input(|input| (input.modifiers, input.key_down(Key::Space)));
        let zoom = f64::from(self.view.zoom);
        let view = self.view;
        let hand =
            |at| Hand { at: view.to_canvas(room, at), zoom, shift: modifiers.shift, alt: modifiers.alt };
        let handles = handles::handles(session, &self.view, room);
        if response.drag_started() {
            response.request_focus();
            self.by_pointer = true;
            let primary = ui.input(|input| input.pointer.button_down(PointerButton::Primary));
            if let Some(at) = ui.input(|input| input.pointer.press_origin()) {
                let handle = handles::at(&handles, at);
                let tool = if primary && !space { self.tool } else { Tool::Hand };
                self.gesture = Some(gesture::press(tool, session, handle, hand(at)));
            }
        }
        if let Some(gesture) = &mut self.gesture {
            // All positions since the last frame, not only the last one.
            let path = ui.input(|input| moves(&input.events));
            for at in path {
                gesture.advance(session, hand(at));
            }
        }
        if response.drag_stopped()
            && let Some(gesture) = self.gesture.take()
        {
            let at = response.interact_pointer_pos().or(ui.input(|input| input.pointer.latest_pos()));
            if let Some(at) = at {
                let stroke = gesture.release(session, &mut self.nib, hand(at));
                self.remark = stroke.as_deref().and_then(outline_remark);
                self.fading.extend(stroke.map(|points| (points, ui.input(|input| input.time))));
            }
        }
        self.cursor(ui, response, &handles, space);
    }

    fn cursor(&self, ui: &Ui, response: &Response, handles: &[(handles::Handle, egui::Pos2)], space: bool) {
        let Some(at) = response.hover_pos() else { return };
        let over = if self.tool == Tool::Select { handles::at(handles, at) } else { None };
        let held = self.gesture.is_some();
        let icon = match (&self.gesture, over) {
            (Some(Gesture::Pull(handle, ..)), _) => handles::cursor(*handle),
            (_, Some(handle)) if !space => handles::cursor(handle),
            _ if space || self.tool == Tool::Hand => {
                if held {
                    CursorIcon::Grabbing
                } else {
                    CursorIcon::Grab
                }
            }
            _ if self.tool == Tool::Select => CursorIcon::Default,
            _ => CursorIcon::Crosshair,
        };
        ui.ctx().set_cursor_icon(icon);
    }

    fn paint(&mut self, ui: &Ui, room: Rect, (session, drawn): (&Session, &Drawn), response: &Response) {
        let colours = Palette::current(ui.visuals());
        let painter = ui.painter_at(room);
        painter.rect_filled(room, 0.0, colours.background);
        let paper = self.view.paper(room, session.document().size);
        painter.rect_filled(paper, 2.0, colours.paper);
        self.underlay.paint(&painter, paper);
        self.reference.paint(&painter, paper);
        let ink = Ink { painter: &painter, view: &self.view, room };
        if self.overlays.regions {
            grid(&ink, session, colours);
        }
        painter.rect_stroke(paper, 2.0, Stroke::new(1.0, colours.border), StrokeKind::Outside);
        if self.overlays.wanted
            && let Some(wanted) = self.wanted.of(session.active_layer)
        {
            let painter = painter.with_clip_rect(painter.clip_rect().intersect(paper));
            wanted.paint(&Ink { painter: &painter, ..ink }, colours);
        }
        self.marks(&ink, session, drawn, colours);
        if self.overlays.analysis {
            self.analysis.paint(&ink, session, session.active_layer, colours);
        }
        self.selection(&ink, session, colours);
        self.paint_gesture(ui, &ink, Ruler { units: self.units, dpi: session.document().dpi }, colours);
        fade(ui, &ink, &mut self.fading, colours);
        if response.has_focus() && !self.by_pointer {
            painter.rect_stroke(
                room.shrink(1.0),
                3.0,
                Stroke::new(1.0, colours.accent_pale),
                StrokeKind::Inside,
            );
        }
    }

    fn marks(&self, ink: &Ink, session: &Session, drawn: &Drawn, colours: &Palette) {
        let fill = if self.overlays.analysis { 0.10 } else { 0.82 };
        for (place, mark) in session.marks() {
            if drawn.lost(session, place).is_some() {
                lost::paint(ink, &mark, session.selection.contains(place), colours);
                continue;
            }
            let colour = colours.ink(place.layer);
            let [body, outline] = self.opacity(session, place.layer);
            if session.selection.contains(place) {
                let outline = Stroke::new(2.0, colours.accent);
                ink.mark(&mark, colour.gamma_multiply(0.6 * fill), outline);
            } else {
                let line = Stroke::new(1.0, colour.gamma_multiply(outline));
                ink.mark(&mark, colour.gamma_multiply(body * fill), line);
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

    fn selection(&self, ink: &Ink, session: &Session, colours: &Palette) {
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
            Some(Gesture::Pen(points)) => {
                let width = (self.nib.width as f32 * ink.view.zoom).clamp(1.5, 3.0);
                ink.path(points, Stroke::new(width, colours.pen));
            }
            Some(Gesture::Box(ends, _)) => {
                ink.dashed(ends.map(|end| ink.at(end)), Stroke::new(1.0, colours.accent));
            }
            Some(gesture) => {
                if let Some(mark) = gesture.preview(&self.nib) {
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

/// Paints the strokes that were recognised, while they fade.
fn fade(ui: &Ui, ink: &Ink, fading: &mut Vec<(Vec<[f64; 2]>, f64)>, colours: &Palette) {
    let now = ui.input(|input| input.time);
    fading.retain(|(_, since)| now - since < FADE);
    for (points, since) in &*fading {
        let left = 1.0 - ((now - since) / FADE) as f32;
        ink.path(points, Stroke::new(2.0, colours.pen.gamma_multiply(left)));
    }
    if !fading.is_empty() {
        ui.ctx().request_repaint();
    }
}

/// The positions of the pointer before it was released: a slow frame may hold later moves as well.
fn moves(events: &[egui::Event]) -> Vec<egui::Pos2> {
    let place = |event: &egui::Event| match event {
        egui::Event::PointerMoved(at) => Some(*at),
        _ => None,
    };
    let released = |event: &egui::Event| matches!(event, egui::Event::PointerButton { pressed: false, .. });
    events.iter().take_while(|event| !released(event)).filter_map(place).collect()
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
