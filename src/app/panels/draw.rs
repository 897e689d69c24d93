//! The tab for drawing: the tool or the selected marks, notes on what will not grow as drawn, and the attributes that
//! the marks ask for.

use egui::{RichText, Ui, vec2};

use super::form::{presets, rows};
use super::notes::notes;
use super::result::mark_result;
use super::selected;
use super::wanted::{here, region};
use crate::app::action::Action;
use crate::app::canvas::Canvas;
use crate::app::canvas::tool::Tool;
use crate::app::result::Drawn;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::units::Ruler;
use crate::synth::report::DrawnMark;

/// What the tab shows.
pub struct DrawState<'a> {
    /// The open document.
    pub session: &'a Session,
    /// The canvas: tool, size of new marks, overlays, reference picture, analysed regions.
    pub canvas: &'a Canvas,
    /// What has grown of each of its marks.
    pub drawn: Drawn<'a>,
    /// How lengths are shown and typed.
    pub ruler: Ruler,
}

/// Height of the fields for the tool or the selected marks, points. It is constant, so that what is below does not move
/// when marks are selected.
const FIELDS: f32 = 214.0;

impl<'a> DrawState<'a> {
    /// What has grown of a drawn mark.
    fn grown(&self, place: Option<Place>) -> Option<&'a DrawnMark> {
        self.drawn.mark(self.session, place?)
    }
}

/// Shows the tab.
pub fn draw(ui: &mut Ui, state: &DrawState) -> Vec<Action> {
    let &DrawState { session, canvas, ruler, .. } = state;
    let mut actions = Vec::new();
    ui.scope(|ui| {
        ui.set_min_size(vec2(ui.available_width(), FIELDS));
        if session.selection.is_empty() {
            actions.extend(tool(ui, session, canvas, ruler));
        } else {
            actions.extend(selected::selected(ui, session, ruler));
        }
    });
    if let Some(drawn) = selected_mark(state) {
        mark_result(ui, ruler, "Grown", drawn);
        ui.add_space(6.0);
    } else if let Some(drawn) = state.grown(canvas.hovered) {
        mark_result(ui, ruler, "The mark under the pointer", drawn);
        ui.add_space(6.0);
    } else if session.document().regions.is_some() {
        actions.extend(region(ui, session, canvas, ruler));
    } else {
        here(ui, session, canvas, ruler);
    }
    actions.extend(notes(ui, session, canvas, &state.drawn, ruler));
    actions
}

/// The tool, and the size of the marks that it makes.
fn tool(ui: &mut Ui, session: &Session, canvas: &Canvas, ruler: Ruler) -> Option<Action> {
    let (tool, nib) = (canvas.tool, canvas.nib);
    let mut new = nib;
    ui.label(RichText::new(tool.name()).strong());
    if matches!(tool, Tool::Pen | Tool::Line) {
        rows(ui, "nib", |ui| {
            ui.label("Line width").on_hover_text("Width of the stripe that a line stands for");
            let field = ruler.field(&mut new.width).suffix(ruler.unit());
            ui.add(field).accessible_name("Line width");
            ui.end_row();
        });
        new.width = new.width.clamp(0.5, 400.0);
        presets(ui, &mut new.width, ruler);
    } else if tool == Tool::Ellipse {
        rows(ui, "stamp", |ui| {
            ui.label("Click adds").on_hover_text("Radii of the ellipse that a click adds");
            ui.horizontal(|ui| {
                for (radius, name) in new.radii.iter_mut().zip(["Radius along", "Radius across"]) {
                    ui.add(ruler.field(radius)).accessible_name(name);
                    *radius = radius.clamp(0.5, 2000.0);
                }
                ui.weak(ruler.unit().trim_start());
            });
            ui.end_row();
        });
    } else {
        ui.weak("Nothing is selected.");
    }
    if session.areas(session.active_layer).is_some() && matches!(tool, Tool::Pen | Tool::Ellipse) {
        let [closed, _] = session.closed_strokes(session.active_layer);
        let what = if tool == Tool::Pen { "A closed stroke becomes" } else { "It becomes" };
        ui.weak(format!("{what} {closed} on this layer."));
    }
    (new != nib).then_some(Action::Nib(new))
}

/// What has grown of the selected mark; `None` where no mark or several marks are selected.
fn selected_mark<'a>(state: &DrawState<'a>) -> Option<&'a DrawnMark> {
    let mut selected = state.session.selection.places();
    let only = selected.next().filter(|_| selected.next().is_none());
    state.grown(only)
}
