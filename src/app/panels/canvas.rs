//! The tab for the canvas: size, regions, edges, resolution; what is shown over and under the sketch.

use egui::{Slider, Ui};

use super::form::{heading, rows};
use crate::app::action::Action;
use crate::app::canvas::Overlays;
use crate::app::fields::{DPI, REGIONS, SEAMLESS, SIDES, regions, resolution, sides};
use crate::app::reference::Reference;
use crate::document::Document;
use crate::editor::edit::Edit;
use crate::editor::units::Ruler;
use crate::grid::Edges;

/// What the tab shows.
pub struct CanvasState<'a> {
    /// The open document.
    pub document: &'a Document,
    /// What is shown over the sketch.
    pub overlays: Overlays,
    /// The picture under the sketch.
    pub reference: &'a Reference,
    /// How lengths are shown and typed.
    pub ruler: Ruler,
    /// Whether the texture is shown two by two.
    pub tiled: bool,
    /// Whether sketch and texture are zoomed and panned together.
    pub linked: bool,
}

/// Shows the tab.
pub fn canvas(ui: &mut Ui, state: &CanvasState) -> Vec<Action> {
    let mut actions = properties(ui, state.document, state.ruler);
    actions.extend(overlays(ui, state));
    actions
}

/// Size, regions, edges and resolution of the canvas.
fn properties(ui: &mut Ui, document: &Document, ruler: Ruler) -> Vec<Action> {
    let mut edits = Vec::new();
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

/// What is shown over and under the sketch, and how the views move.
fn overlays(ui: &mut Ui, state: &CanvasState) -> Vec<Action> {
    let mut actions = Vec::new();
    let mut check = |ui: &mut Ui, mut on: bool, label: &str, help: &str, action: fn(bool) -> Action| {
        if ui.checkbox(&mut on, label).on_hover_text(help).changed() {
            actions.push(action(on));
        }
    };
    heading(ui, "Shown");
    if state.document.regions.is_some() {
        check(ui, state.overlays.regions, "Region grid", REGIONS, Action::Regions);
    } else {
        let help = "What the marks of this layer ask for between them: an outline of about each spot, or a piece of each \
                    stripe. Fainter where directions hardly agree, a cross where they cancel.";
        check(ui, state.overlays.wanted, "Expected sizes and directions", help, Action::Wanted);
    }
    let help = "Fitted marks with their axes, the edges between neighbours whose mean length is the spacing, and the \
                mean mark of each region";
    check(ui, state.overlays.analysis, "Analysis of the sketch", help, Action::Analysis);
    if state.document.edges == Edges::Wrap {
        let help = "To check that no seam is visible";
        check(ui, state.tiled, "Tiles, two by two", help, Action::Tiled);
    }
    let help = "Zooming and panning the sketch does the same to the texture";
    check(ui, state.linked, "Link both views", help, Action::Linked);
    actions.extend(reference(ui, state.reference));
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
    if button.on_hover_text("A picture under the sketch, to draw over").clicked() {
        actions.push(Action::ChooseReference);
    }
    actions
}
