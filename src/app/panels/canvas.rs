//! The tab for the canvas: size, regions, edges, resolution; what is shown over and under the sketch.

use egui::{DragValue, Slider, Ui};

use super::form::{heading, rows};
use crate::app::action::Action;
use crate::app::canvas::Overlays;
use crate::app::canvas::reference::Reference;
use crate::app::fields::{DPI, REGIONS, SEAMLESS, SIDES, regions, resolution, sides};
use crate::app::units::number_field;
use crate::document::Document;
use crate::editor::backdrop::Placement;
use crate::editor::edit::Edit;
use crate::editor::snap::{STEPS, Snap};
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
    /// The grid that marks snap to.
    pub snap: Snap,
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
        let help = "The sizes and directions in the space between the marks of this layer: about one outline \
                    for each spot, or one piece for each stripe. Outlines are faint where the directions of \
                    the marks around hardly agree; a cross shows where they cancel each other.";
        check(ui, state.overlays.wanted, "Sizes and directions between marks", help, Action::Wanted);
    }
    let help = "How dapple reads the sketch: each mark as an ellipse with its axes, lines between neighbours \
                (their mean length is the spacing), and the average mark of each region";
    check(ui, state.overlays.analysis, "Analysis of the sketch", help, Action::Analysis);
    if state.document.edges == Edges::Wrap {
        let help = "Shows the texture two by two, to check that no seam is visible";
        check(ui, state.tiled, "Tiles, two by two", help, Action::Tiled);
    }
    let help = "Zooming and panning the sketch does the same to the texture";
    check(ui, state.linked, "Link both views", help, Action::Linked);
    actions.extend(snap(ui, state.snap, state.ruler));
    actions.extend(reference(ui, state));
    actions
}

/// The grid that marks snap to.
fn snap(ui: &mut Ui, before: Snap, ruler: Ruler) -> Option<Action> {
    let mut snap = before;
    ui.horizontal(|ui| {
        let help =
            "Corners of new ellipses, ends of lines and centres of moved marks snap to the points of a grid";
        ui.checkbox(&mut snap.on, "Snap to grid").on_hover_text(help);
        let field = ruler.field(&mut snap.step).suffix(ruler.unit());
        ui.add_enabled(snap.on, field).accessible_name("Distance of the grid lines");
        snap.step = snap.step.clamp(STEPS[0], STEPS[1]);
    });
    (snap != before).then_some(Action::Snap(snap))
}

/// The picture under the canvas.
fn reference(ui: &mut Ui, state: &CanvasState) -> Vec<Action> {
    let reference = state.reference;
    heading(ui, "Reference picture");
    let Some(placement) = reference.placement(state.document.size) else {
        let button = ui.button("Choose a picture…");
        let help =
            "A picture under the sketch, to draw over. It can also be dropped on the window, or pasted";
        return button.on_hover_text(help).clicked().then_some(Action::ChooseReference).into_iter().collect();
    };
    let mut actions = Vec::new();
    ui.horizontal(|ui| {
        let mut on = reference.shown;
        if ui.checkbox(&mut on, "Show").on_hover_text(reference.name()).changed() {
            actions.push(Action::ShowReference(on));
        }
        let mut opacity = reference.opacity;
        let slider = Slider::new(&mut opacity, 0.0..=1.0).show_value(false);
        ui.spacing_mut().slider_width = 80.0;
        let slider = ui.add(slider).accessible_name("Opacity of the reference picture");
        if slider.on_hover_text("Opacity").changed() {
            actions.push(Action::ReferenceOpacity(opacity));
        }
        if ui.small_button("Remove").clicked() {
            actions.push(Action::RemoveReference);
        }
    });
    let mut locked = reference.locked;
    let help = "While the picture is not locked, the tool Select moves it: drag the picture, or its corners";
    if ui.checkbox(&mut locked, "Lock").on_hover_text(help).changed() {
        actions.push(Action::LockReference(locked));
    }
    if !locked {
        actions.extend(place(ui, placement, state.ruler));
    }
    actions
}

/// The place and the scale of the reference picture, as numbers.
fn place(ui: &mut Ui, placement: Placement, ruler: Ruler) -> Vec<Action> {
    let mut actions = Vec::new();
    let mut new = placement;
    rows(ui, "reference", |ui| {
        ui.label("Centre");
        ui.horizontal(|ui| {
            for (value, name) in new.center.iter_mut().zip(["Picture centre x", "Picture centre y"]) {
                ui.add(ruler.field(value)).accessible_name(name);
            }
            ui.weak(ruler.unit().trim_start());
        });
        ui.end_row();
        ui.label("Scale").on_hover_text("Px of the canvas per px of the picture");
        ui.horizontal(|ui| {
            let mut percent = 100.0 * new.scale;
            let field = DragValue::new(&mut percent).speed(0.5).max_decimals(1);
            if ui.add(number_field(field, " %")).accessible_name("Picture scale").changed() && percent > 0.0 {
                new.scale = 0.01 * percent;
            }
            if ui.small_button("Fit").on_hover_text("At the centre, as large as it fits").clicked() {
                actions.push(Action::FitReference);
            }
        });
        ui.end_row();
    });
    if new != placement {
        actions.push(Action::PlaceReference(new));
    }
    actions
}
