//! The pointer on the canvas: its events become gestures.

use egui::{CursorIcon, Event, Key, Modifiers, PointerButton, Pos2, Rect, Response, Ui};

use super::gesture::{self, Gesture, Hand};
use super::tool::Tool;
use super::{Canvas, handles};
use crate::document::sketch_notes::outline_remark;
use crate::editor::session::Session;

impl Canvas {
    /// Carries out the pointer events since the last frame, one after the other: a slow frame may hold several strokes,
    /// and each of them is a gesture and a step to undo of its own.
    pub(super) fn follow_pointer(&mut self, ui: &Ui, response: &Response, room: Rect, session: &mut Session) {
        let (events, modifiers) = ui.input(|input| (pointer_events(&input.events), input.modifiers));
        for event in events {
            match event {
                Event::PointerMoved(at) => self.pointer_moved(room, session, at, modifiers),
                Event::PointerButton { pos, button, pressed: true, modifiers } => {
                    if self.gesture.is_none() && is_on_canvas(ui, response, pos) {
                        response.request_focus();
                        self.by_pointer = true;
                        self.button = button;
                        let space = ui.input(|input| input.key_down(Key::Space));
                        let is_drawing = button == PointerButton::Primary && !space;
                        let tool = if is_drawing { self.tool } else { Tool::Hand };
                        let handle = handles::at(&handles::handles(session, &self.view, room), pos);
                        let hand = self.hand(room, pos, modifiers);
                        self.gesture = Some(gesture::press(tool, session, handle, pos, hand));
                    }
                }
                Event::PointerButton { pos, button, .. } if button == self.button => {
                    self.pointer_released(ui, room, session, (pos, modifiers));
                }
                _ => {}
            }
        }
        // A release outside of the window may be unknown.
        let (is_down, at) =
            ui.input(|input| (input.pointer.button_down(self.button), input.pointer.latest_pos()));
        if let Some(at) = at.filter(|_| !is_down) {
            self.pointer_released(ui, room, session, (at, modifiers));
        }
    }

    /// The pointer and the keys, on the canvas.
    fn hand(&self, room: Rect, at: Pos2, modifiers: Modifiers) -> Hand {
        let zoom = f64::from(self.view.zoom);
        Hand { at: self.view.to_canvas(room, at), zoom, shift: modifiers.shift, alt: modifiers.alt }
    }

    fn pointer_moved(&mut self, room: Rect, session: &mut Session, at: Pos2, modifiers: Modifiers) {
        let hand = self.hand(room, at, modifiers);
        match &mut self.gesture {
            Some(Gesture::Pan(last)) => {
                let by = at - *last;
                *last = at;
                self.view.pan(by);
            }
            Some(gesture) => gesture.advance(session, hand),
            None => {}
        }
    }

    fn pointer_released(
        &mut self,
        ui: &Ui,
        room: Rect,
        session: &mut Session,
        (at, modifiers): (Pos2, Modifiers),
    ) {
        let Some(gesture) = self.gesture.take() else { return };
        let hand = self.hand(room, at, modifiers);
        let stroke = gesture.release(session, &mut self.nib, hand);
        self.remark = stroke.as_deref().and_then(outline_remark).or(self.remark.take());
        self.fading.extend(stroke.map(|points| (points, ui.input(|input| input.time))));
        session.commit();
    }

    /// Sets the form of the pointer.
    pub(super) fn cursor(&self, ui: &Ui, response: &Response, room: Rect, session: &Session) {
        let Some(at) = response.hover_pos() else { return };
        let space = ui.input(|input| input.key_down(Key::Space));
        let handles = handles::handles(session, &self.view, room);
        let over = if self.tool == Tool::Select { handles::at(&handles, at) } else { None };
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
}

/// The moves, presses and releases among the events of a frame.
fn pointer_events(events: &[Event]) -> Vec<Event> {
    let is_of_pointer =
        |event: &&Event| matches!(event, Event::PointerMoved(_) | Event::PointerButton { .. });
    events.iter().filter(is_of_pointer).cloned().collect()
}

/// Whether the canvas is the topmost control at a position, and no other one is being dragged.
///
/// egui knows one press a frame, and none that was released in the same frame.
fn is_on_canvas(ui: &Ui, canvas: &Response, at: Pos2) -> bool {
    let ctx = ui.ctx();
    let is_other_dragged = ctx.dragged_id().is_some_and(|id| id != canvas.id);
    if is_other_dragged || ctx.layer_id_at(at) != Some(canvas.layer_id) {
        return false;
    }
    let top = ctx.viewport(|viewport| {
        let widgets = viewport.prev_pass.widgets.get_layer(canvas.layer_id);
        widgets
            .filter(|widget| widget.sense.interactive() && widget.interact_rect.contains(at))
            .last()
            .map(|top| top.id)
    });
    top == Some(canvas.id)
}
