//! The canvas: the sketch, the tools, the selection.

pub mod analysis;
pub mod badges;
mod comb;
mod gesture;
mod handles;
pub mod ink;
mod lost;
mod navigate;
mod paint;
mod pointer;
pub mod reference;
mod reference_handles;
mod starter;
pub mod tool;
pub mod view;
pub mod wanted;

pub use gesture::Nib;
pub use navigate::navigate;
pub use pointer::FROZEN;
pub use starter::starter;

use std::time::Duration;

use egui::{EventFilter, Id, PointerButton, Pos2, Rect, Response, Role, Sense, Ui, WidgetInfo};

use super::result::Drawn;
use super::underlay::Underlay;
use crate::editor::pens::{Pens, Pressure};
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::editor::snap::Snap;
use crate::editor::units::{Ruler, Units};
use crate::editor::wheel::Wheel;
use crate::marks::Mark;
use crate::sketch::recognise;
use analysis::Analysis;
use badges::Badge;
use comb::Combed;
use gesture::{DrawnStroke, Gesture};
use reference::Reference;
use tool::Tool;
use view::View;
use wanted::LiveWanted;

/// The pointer is on a mark within this distance, points.
const HOVER: f64 = 2.0;

/// What is shown over the sketch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overlays {
    /// The region grid.
    pub regions: bool,
    /// Fitted ellipses, neighbours, directions.
    pub analysis: bool,
    /// The sizes and directions that the free marks ask for in the space between them.
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
    /// What the free marks of the active layer ask for in the space between them.
    pub wanted: LiveWanted,
    /// The mark under the pointer.
    pub hovered: Option<Place>,
    /// The region that was clicked, (column, row): its numbers are shown and can be typed.
    pub chosen_region: Option<[usize; 2]>,
    /// The grid that marks snap to.
    pub snap: Snap,
    /// The unit in which lengths are shown.
    pub units: Units,
    /// The reference picture under it.
    pub reference: Reference,
    /// The texture of frozen layers under it.
    pub underlay: Underlay,
    /// The id of the canvas widget, once it was shown.
    pub id: Option<Id>,
    /// Whether the canvas got the keyboard focus by a click; then the focus is not highlighted.
    by_pointer: bool,
    gesture: Option<Gesture>,
    /// How pens are used.
    pub pens: Pens,
    /// What the wheel does.
    pub wheel: Wheel,
    /// The pressure during the gesture.
    pressure: Pressure,
    /// The button of the gesture.
    button: PointerButton,
    /// Where the pointer was pressed, on the screen.
    pressed_at: Pos2,
    /// Where the menu of the canvas was requested: the place on the screen, and px of the canvas.
    pub menu_asked: Option<(Pos2, [f64; 2])>,
    /// The part of the screen that shows the canvas.
    room: Rect,
    /// A message about the stroke that was drawn last.
    pub remark: Option<String>,
    /// A mark of a kind that the active layer does not hold: the user is to be asked whether it gets a new layer.
    pub question: Option<DrawnStroke>,
    /// The flow of the finish, while it is combed.
    combed: Combed,
    /// Signs at places that do not grow as they were drawn.
    pub badges: Vec<Badge>,
    /// Strokes that were recognised, and when, seconds.
    fading: Vec<(Vec<[f64; 2]>, f64)>,
    /// Time between two frames while they fade: longer while a texture grows, which needs the processor.
    pub between_frames: Duration,
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
            chosen_region: None,
            snap: Snap::default(),
            units: Units::default(),
            reference: Reference::default(),
            underlay: Underlay::default(),
            id: None,
            by_pointer: false,
            gesture: None,
            pens: Pens::default(),
            wheel: Wheel::default(),
            pressure: Pressure::default(),
            button: PointerButton::Primary,
            pressed_at: Pos2::ZERO,
            menu_asked: None,
            room: Rect::ZERO,
            remark: None,
            question: None,
            combed: Combed::default(),
            badges: Vec::new(),
            fading: Vec::new(),
            between_frames: Duration::ZERO,
        }
    }
}

impl Canvas {
    /// Whether a gesture changes the document.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.gesture
            .as_ref()
            .is_some_and(|gesture| !matches!(gesture, Gesture::Pan(_) | Gesture::Reference(..)))
    }

    /// Whether a gesture changes the document or moves the reference picture.
    #[must_use]
    pub fn is_changing(&self) -> bool {
        self.gesture.as_ref().is_some_and(|gesture| !matches!(gesture, Gesture::Pan(_)))
    }

    /// The mark that a release of the pointer would add now.
    #[must_use]
    pub fn pending_mark(&self) -> Option<Mark> {
        match self.gesture.as_ref()? {
            Gesture::Pen(points) => recognise(points, self.pressed_nib().width),
            gesture => gesture.preview(&self.pressed_nib()),
        }
    }

    /// Cancels the gesture and undoes its changes. Returns whether there was a gesture.
    pub fn cancel(&mut self, session: &mut Session) -> bool {
        self.pressure = Pressure::default();
        if self.gesture.take().is_none() {
            return false;
        }
        session.revert();
        true
    }

    /// Requests the menu of the canvas at a point, px.
    pub fn ask_menu(&mut self, at: [f64; 2]) {
        let on_screen = self.view.to_screen(self.room, at);
        self.menu_asked = Some((on_screen.clamp(self.room.min, self.room.max), at));
    }

    /// Shows the canvas in `room`; gestures change the document. `drawn`: what has grown of each of its marks.
    pub fn ui(&mut self, ui: &mut Ui, room: Rect, session: &mut Session, drawn: &Drawn) -> Response {
        let revision = session.revision();
        self.room = room;
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
            self.follow_pointer(ui, &response, room, session);
        }
        self.cursor(ui, &response, room, session);
        navigate(ui, &response, room, &mut self.view, self.wheel, false);
        self.analysis.update(session);
        if self.tool == Tool::Comb {
            self.combed.update(session.document());
        }
        let changed = Drawn::default();
        let drawn = if session.revision() == revision { drawn } else { &changed };
        self.hovered =
            self.pointer.filter(|_| self.gesture.is_none()).and_then(|at| self.mark_at(session, drawn, at));
        let wanted = self.wanted.of(session.active_layer);
        let ruler = Ruler { units: self.units, dpi: session.document().dpi };
        self.badges = badges::badges(&self.analysis.notes, wanted, (session, drawn), ruler);
        self.paint(ui, room, (session, drawn), &response);
        let told = response.hover_pos().and_then(|at| badges::told(&self.badges, self.view, room, at));
        let lost = || {
            let place = self.hovered?;
            let (reason, remedy) = (drawn.lost(session, place)?, badges::remedy(session.kind(place.layer)));
            Some(format!("Does not grow: {reason}. {remedy}"))
        };
        match told.map(str::to_owned).or_else(lost) {
            Some(text) if self.gesture.is_none() => response.on_hover_text_at_pointer(text),
            _ => response,
        }
    }

    /// The mark at a point, px. Of several marks there, one that does not grow comes first.
    fn mark_at(&self, session: &Session, drawn: &Drawn, at: [f64; 2]) -> Option<Place> {
        let reach = HOVER / f64::from(self.view.zoom);
        let is_lost = |place: &Place| drawn.lost(session, *place).is_some();
        let here = session.marks().rev().filter(|(_, mark)| shape::distance(mark, at) <= reach);
        let lost = here.map(|(place, _)| place).find(is_lost);
        lost.or_else(|| session.hit(at, reach)).or_else(|| session.hit_frozen(at, reach))
    }
}
