//! The tab for drawing: the tool or the selected marks, the canvas, a region, what is shown.

use egui::{RichText, Slider, Ui};

use super::form::{heading, presets, rows};
use super::notes::notes;
use super::result::mark_result;
use super::selected;
use super::wanted::{here, region};
use crate::app::action::Action;
use crate::app::canvas::tool::Tool;
use crate::app::canvas::{Canvas, Nib};
use crate::app::fields::{DPI, REGIONS, SEAMLESS, SIDES, regions, resolution, sides};
use crate::app::reference::Reference;
use crate::app::result::Drawn;
use crate::document::Document;
use crate::editor::edit::Edit;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::units::Ruler;
use crate::grid::Edges;
use crate::synth::report::DrawnMark;

/// What the tab shows.
pub struct DrawState<'a> {
    /// The open document.
    pub session: &'a Session,
    /// The canvas: tool, size of new marks, overlays, reference picture, analysed regions.
    pub canvas: &'a Canvas,
    /// What became of its marks.
    pub drawn: Drawn<'a>,
    /// How lengths are shown and typed.
    pub ruler: Ruler,
    /// Whether the texture is shown two by two.
    pub tiled: bool,
    /// Whether sketch and texture are zoomed and panned together.
    pub linked: bool,
}

impl<'a> DrawState<'a> {
    /// What became of a drawn mark.
    fn grown(&self, place: Option<Place>) -> Option<&'a DrawnMark> {
        self.drawn.mark(self.session, place?)
    }
}

/// Shows the tab.
pub fn draw(ui: &mut Ui, state: &DrawState) -> Vec<Action> {
    let &DrawState { session, canvas, ruler, .. } = state;
    let mut actions = Vec::new();
    if session.selection.is_empty() {
        actions.extend(tool(ui, canvas.tool, canvas.nib, ruler));
    } else {
        actions.extend(selected::selected(ui, session, ruler));
    }
    // Above the canvas, so that they are seen without scrolling.
    actions.extend(notes(ui, session, canvas, &state.drawn));
    if let Some(drawn) = selected_mark(state) {
        ui.add_space(4.0);
        mark_result(ui, ruler, "Grown", drawn);
    }
    actions.extend(canvas_properties(ui, session.document(), ruler));
    if let Some(drawn) = state.grown(canvas.hovered).filter(|_| selected_mark(state).is_none()) {
        ui.add_space(8.0);
        mark_result(ui, ruler, "The mark under the pointer", drawn);
    } else if session.document().regions.is_some() {
        region(ui, session, canvas, ruler);
    } else {
        here(ui, session, canvas, ruler);
    }
    actions.extend(overlays(ui, state));
    actions
}

/// The tool, and the size of the marks that it makes.
fn tool(ui: &mut Ui, tool: Tool, nib: Nib, ruler: Ruler) -> Option<Action> {
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
            ui.label("A click makes").on_hover_text("The size of the ellipse that a click adds");
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
    (new != nib).then_some(Action::Nib(new))
}

/// Size, regions, edges and resolution of the canvas.
fn canvas_properties(ui: &mut Ui, document: &Document, ruler: Ruler) -> Vec<Action> {
    let mut edits = Vec::new();
    heading(ui, "Canvas");
    let (mut size, mut grid) = (document.size, document.regions);
    let (mut seamless, mut dpi) = (document.edges == Edges::Wrap, document.dpi);
    rows(ui, "canvas", |ui| {
        ui.label("Size").on_hover_text("Width and height of the canvas");
        ui.horizontal(|ui| {
            if sides(ui, &mut size, ruler, SIDES, ["Canvas width", "Canvas height"]) {
                edits.push(Edit::Size(size));
            }
        });
        ui.end_row();
        ui.label("Regions").on_hover_text(REGIONS);
        ui.horizontal(|ui| {
            if regions(ui, &mut grid, ["Canvas regions", "Region columns", "Region rows"]) {
                edits.push(Edit::Regions(grid));
            }
        });
        ui.end_row();
        ui.label("Seamless").on_hover_text(SEAMLESS);
        if ui.checkbox(&mut seamless, "tiles").accessible_name("Seamless").on_hover_text(SEAMLESS).changed() {
            edits.push(Edit::Edges(if seamless { Edges::Wrap } else { Edges::Closed }));
        }
        ui.end_row();
        ui.label("Resolution").on_hover_text(DPI);
        if resolution(ui, &mut dpi, "Resolution") {
            edits.push(Edit::Dpi(dpi));
        }
        ui.end_row();
    });
    edits.into_iter().map(Action::Edit).collect()
}

/// What became of the selected mark; `None` where none or several are.
fn selected_mark<'a>(state: &DrawState<'a>) -> Option<&'a DrawnMark> {
    let mut selected = state.session.selection.places();
    let only = selected.next().filter(|_| selected.next().is_none());
    state.grown(only)
}

/// What is shown over and under the sketch, and how the views move.
fn overlays(ui: &mut Ui, state: &DrawState) -> Vec<Action> {
    let mut actions = Vec::new();
    let mut check = |ui: &mut Ui, mut on: bool, label: &str, help: &str, action: fn(bool) -> Action| {
        if ui.checkbox(&mut on, label).on_hover_text(help).changed() {
            actions.push(action(on));
        }
    };
    heading(ui, "Shown");
    if state.session.document().regions.is_some() {
        check(ui, state.canvas.overlays.regions, "Region grid", REGIONS, Action::Regions);
    } else {
        let help = "What the marks of this layer ask for between them: an outline of about each spot, or a piece of each \
                    stripe. Fainter where directions hardly agree, a cross where they cancel.";
        check(ui, state.canvas.overlays.wanted, "Wanted sizes and directions", help, Action::Wanted);
    }
    let help = "Fitted marks with their axes, the edges between neighbours whose mean length is the spacing, and the \
                mean mark of each region";
    check(ui, state.canvas.overlays.analysis, "What dapple sees", help, Action::Analysis);
    if state.session.document().edges == Edges::Wrap {
        let help = "To check that no seam is visible";
        check(ui, state.tiled, "Tiles, two by two", help, Action::Tiled);
    }
    let help = "Zooming and panning the sketch does the same to the texture";
    check(ui, state.linked, "Views move together", help, Action::Linked);
    actions.extend(reference(ui, &state.canvas.reference));
    actions
}

/// The picture under the canvas.
fn reference(ui: &mut Ui, reference: &Reference) -> Vec<Action> {
    let mut actions = Vec::new();
    if reference.is_there() {
        ui.horizontal(|ui| {
            let mut on = reference.shown;
            if ui.checkbox(&mut on, "Picture").on_hover_text(&reference.name).changed() {
                actions.push(Action::ShowReference(on));
            }
            let mut opacity = reference.opacity;
            let slider = Slider::new(&mut opacity, 0.0..=1.0).show_value(false);
            ui.spacing_mut().slider_width = 80.0;
            if ui.add(slider).accessible_name("Opacity of the reference picture").changed() {
                actions.push(Action::ReferenceOpacity(opacity));
            }
            if ui.small_button("Remove").clicked() {
                actions.push(Action::RemoveReference);
            }
        });
        return actions;
    }
    let button = ui.button("Reference picture…");
    if button.on_hover_text("A photo under the canvas, to draw over").clicked() {
        actions.push(Action::ChooseReference);
    }
    actions
}
