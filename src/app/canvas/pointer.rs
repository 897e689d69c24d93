//! The pointer on the canvas: its events become gestures.

use egui::{CursorIcon, Event, Key, Modifiers, PointerButton, Pos2, Rect, Response, TouchPhase, Ui};

use super::gesture::{self, DrawnStroke, Gesture, Hand, Nib};
use super::tool::Tool;
use super::{Canvas, handles, reference_handles};
use crate::document::Kind;
use crate::document::sketch_notes::outline_remark;
use crate::editor::pens::Pressure;
use crate::editor::selection::Selection;
use crate::editor::session::Session;

/// The message when the user draws on a frozen layer.
pub const FROZEN: &str = "This layer is frozen. Click its snowflake to unfreeze it, or select another layer.";
/// The message when the user combs a finish without hair or scales.
const NO_HAIR: &str =
    "Nothing to comb: choose fur or scales as the material of the texture first, below the colours.";
/// A press that moves less than this is a click, points.
const CLICK: f32 = 3.0;
/// A finger that stays for so long rests, seconds.
const RESTS: f64 = 0.6;

impl Canvas {
    /// Carries out the pointer events since the last frame, one after the other: a slow frame may hold several strokes,
    /// and each of them is a gesture and a step to undo of its own.
    pub(super) fn follow_pointer(&mut self, ui: &Ui, response: &Response, room: Rect, session: &mut Session) {
        let (events, modifiers) = ui.input(|input| (pointer_events(&input.events), input.modifiers));
        for event in events {
            match event {
                // A pen's pressure comes before the move or the press that it belongs to.
                Event::Touch { force: Some(force), phase: TouchPhase::Start, .. } => {
                    self.pressure = Pressure::default();
                    self.pressure.add(force);
                }
                Event::Touch { force: Some(force), phase: TouchPhase::Move, .. } => self.pressure.add(force),
                Event::PointerMoved(at) => self.pointer_moved(room, session, at, modifiers),
                Event::PointerButton { pos, button, pressed: true, modifiers }
                    if self.gesture.is_none() && is_on_canvas(ui, response, pos) =>
                {
                    response.request_focus();
                    self.by_pointer = true;
                    self.button = button;
                    self.pressed_at = pos;
                    let space = ui.input(|input| input.key_down(Key::Space));
                    let is_drawing = button == PointerButton::Primary && !space;
                    let tool = if is_drawing { self.tool } else { Tool::Hand };
                    let erases = button == PointerButton::Secondary && self.pens.erases;
                    let handle = handles::at(&handles::handles(session, &self.view, room), pos);
                    let hand = self.hand(room, pos, modifiers);
                    let size = session.document().size;
                    let part = self
                        .reference_part(room, session, pos, gesture::REACH / hand.zoom)
                        .filter(|_| is_drawing && handle.is_none());
                    self.gesture = Some(match part.zip(self.reference.placement(size)) {
                        Some((part, before)) => Gesture::Reference(part, hand.at, before),
                        // A click opens the menu: only a drag erases.
                        None if erases => Gesture::Erase(hand.at),
                        None => gesture::press(tool, session, handle, pos, hand),
                    });
                }
                Event::PointerButton { pos, button, pressed: false, .. } if button == self.button => {
                    self.pointer_released(ui, room, session, (pos, modifiers));
                }
                _ => {}
            }
        }
        self.rest(ui, room, session, modifiers);
        // A release outside the window may not be reported.
        let (is_down, at) =
            ui.input(|input| (input.pointer.button_down(self.button), input.pointer.latest_pos()));
        if let Some(at) = at.filter(|_| !is_down) {
            self.pointer_released(ui, room, session, (at, modifiers));
        }
    }

    /// A finger that does not move opens the menu, like the secondary button of a mouse.
    fn rest(&mut self, ui: &Ui, room: Rect, session: &mut Session, modifiers: Modifiers) {
        let (is_finger, at, since) = ui.input(|input| {
            let since = input.pointer.press_start_time().map(|start| input.time - start);
            (input.any_touches(), input.pointer.latest_pos(), since)
        });
        let (Some(at), Some(since), true) = (at, since, is_finger && self.gesture.is_some()) else { return };
        if at.distance(self.pressed_at) >= CLICK {
            return;
        }
        if since < RESTS {
            ui.ctx().request_repaint_after_secs((RESTS - since) as f32);
        } else if self.cancel(session) {
            self.ask_menu_at(session, self.hand(room, at, modifiers));
        }
    }

    /// The position of the pointer on the canvas, with the keys that are held.
    fn hand(&self, room: Rect, at: Pos2, modifiers: Modifiers) -> Hand {
        let zoom = f64::from(self.view.zoom);
        Hand {
            at: self.view.to_canvas(room, at),
            zoom,
            shift: modifiers.shift,
            copy: modifiers.alt || modifiers.command,
            snap: self.snap,
        }
    }

    /// The size of new marks, changed by the pressure of a pen.
    pub(super) fn pressed_nib(&self) -> Nib {
        let factor = if self.pens.pressure { self.pressure.factor() } else { 1.0 };
        Nib { width: factor * self.nib.width, radii: self.nib.radii.map(|radius| factor * radius) }
    }

    fn pointer_moved(&mut self, room: Rect, session: &mut Session, at: Pos2, modifiers: Modifiers) {
        let hand = self.hand(room, at, modifiers);
        match &mut self.gesture {
            Some(Gesture::Pan(last)) => {
                let by = at - *last;
                *last = at;
                self.view.pan(by);
            }
            Some(Gesture::Reference(part, from, before)) => {
                let placement = self.reference.dragged(*before, *part, [*from, hand.at]);
                self.reference.place(session, Some(placement));
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
        if self.button == PointerButton::Secondary && at.distance(self.pressed_at) < CLICK {
            self.ask_menu_at(session, hand);
            return;
        }
        if matches!(gesture, Gesture::Box(..)) && at.distance(self.pressed_at) < CLICK && !modifiers.shift {
            self.choose_region(session, hand.at);
        }
        let pressed = self.pressed_nib();
        let mut nib = pressed;
        self.pressure = Pressure::default();
        let is_combed = matches!(gesture, Gesture::Comb(_));
        let drawn = gesture.release(session, &mut nib, hand);
        if nib.radii != pressed.radii {
            self.nib.radii = nib.radii;
        }
        if is_combed && !session.can_comb() {
            self.remark = Some(NO_HAIR.to_owned());
        }
        if let Some(drawn) = drawn
            && !session.add_outline(&drawn.points)
        {
            let remark = outline_remark(&drawn.points);
            self.fading.push((drawn.points.clone(), ui.input(|input| input.time)));
            self.add(session, drawn);
            self.remark = remark.or(self.remark.take());
        }
        session.commit();
    }

    /// Selects the region at a point, px; clears the selection where that region was selected.
    fn choose_region(&mut self, session: &Session, at: [f64; 2]) {
        let (size, grid) = (session.document().size.map(f64::from), session.document().region_grid());
        let is_on = (0..2).all(|axis| (0.0..=size[axis]).contains(&at[axis]));
        let place = [0, 1].map(|axis| {
            ((at[axis] / size[axis] * grid[axis] as f64) as usize).min(grid[axis].saturating_sub(1))
        });
        let chosen = (is_on && session.document().regions.is_some()).then_some(place);
        self.chosen_region = chosen.filter(|_| self.chosen_region != chosen);
    }

    /// Adds a mark that was drawn. Asks first where the mark does not belong on the active layer, and reports a new
    /// layer.
    fn add(&mut self, session: &mut Session, drawn: DrawnStroke) {
        let kind = Kind::from(&drawn.mark);
        if session.is_active_frozen() {
            self.remark = Some(FROZEN.to_owned());
        } else if session.is_out_of_place(kind) {
            self.question = Some(drawn);
        } else {
            let layers = session.document().layers.len();
            session.add_freehand(drawn.mark, &drawn.points);
            if layers > 0 && session.document().layers.len() > layers {
                let (marks, name) = (kind.name(), session.layer_name(session.active_layer));
                self.remark =
                    Some(format!("A layer holds ellipses or lines: the {marks} is on a new layer, {name}."));
            }
        }
    }

    /// Requests the menu at the pointer; a mark there that is not selected becomes selected.
    fn ask_menu_at(&mut self, session: &mut Session, hand: Hand) {
        match session.hit(hand.at, gesture::REACH / hand.zoom) {
            Some(place) if !session.selection.contains(place) => {
                session.selection = Selection::new([place]);
                session.active_layer = place.layer;
            }
            Some(_) => {}
            None => session.selection.clear(),
        }
        self.ask_menu(hand.at);
    }

    /// Sets the shape of the pointer.
    pub(super) fn cursor(&self, ui: &Ui, response: &Response, room: Rect, session: &Session) {
        let Some(at) = response.hover_pos() else { return };
        let space = ui.input(|input| input.key_down(Key::Space));
        let handles = handles::handles(session, &self.view, room);
        let over = if self.tool == Tool::Select { handles::at(&handles, at) } else { None };
        let held = self.gesture.is_some();
        let icon = match (&self.gesture, over) {
            (Some(Gesture::Pull(handle, ..)), _) => handles::cursor(*handle),
            (Some(Gesture::Reference(part, ..)), _) => reference_handles::cursor(*part),
            (_, Some(handle)) if !space => handles::cursor(handle),
            _ if space || self.tool == Tool::Hand => {
                if held {
                    CursorIcon::Grabbing
                } else {
                    CursorIcon::Grab
                }
            }
            _ if self.tool == Tool::Select => {
                let reach = gesture::REACH / f64::from(self.view.zoom);
                self.reference_part(room, session, at, reach)
                    .map_or(CursorIcon::Default, reference_handles::cursor)
            }
            _ => CursorIcon::Crosshair,
        };
        ui.ctx().set_cursor_icon(icon);
    }
}

/// The moves, presses and releases among the events of a frame.
fn pointer_events(events: &[Event]) -> Vec<Event> {
    let is_of_pointer = |event: &&Event| {
        matches!(event, Event::PointerMoved(_) | Event::PointerButton { .. } | Event::Touch { .. })
    };
    events.iter().filter(is_of_pointer).cloned().collect()
}

/// Whether the canvas is the topmost control at a position, and no other one is being dragged.
///
/// egui reports at most one press in a frame, and none that was released in the same frame.
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
