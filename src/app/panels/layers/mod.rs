//! The list of layers, the highest first; below it, how the active layer grows.

mod menu;
mod name_field;
mod row;

use egui::{Align, Button, Id, Layout, ScrollArea, Stroke, Ui, vec2};

use super::layer_details;
use crate::app::action::Action;
use crate::app::icons::Icon;
use crate::app::shortcuts;
use crate::app::theme::Palette;
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;

/// Height of a row, points.
const ROW: f32 = 28.0;
/// Rows that are visible at once; more are scrolled.
const ROWS: f32 = 6.0;

/// What the layer panel remembers from frame to frame.
#[derive(Clone, Debug, Default)]
pub struct LayersPanel {
    /// The layer whose name is being typed, and the name so far.
    pub naming: Option<(usize, String)>,
    /// Whether the settings of the active layer are unfolded.
    pub unfolded: bool,
    /// Whether the row of that layer had the keyboard focus and shall get it back.
    pub from_row: bool,
}

impl LayersPanel {
    /// Another document was opened.
    pub fn forget(&mut self) {
        self.naming = None;
    }
}

/// Shows the list and the settings of the active layer.
pub fn layers(ui: &mut Ui, session: &Session, panel: &mut LayersPanel) -> Vec<Action> {
    let mut actions = Vec::new();
    ui.spacing_mut().item_spacing.y = 4.0;
    ui.horizontal(|ui| {
        ui.strong("Layers");
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| buttons(ui, session, &mut actions));
    });
    if session.document().layers.is_empty() {
        ui.weak("Your first mark creates a layer.");
        return actions;
    }
    ScrollArea::vertical().id_salt("layers").max_height(ROWS * ROW).min_scrolled_height(ROWS * ROW).show(
        ui,
        |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            list(ui, session, panel, &mut actions);
        },
    );
    next(ui, session, &mut actions);
    actions.extend(layer_details::details(ui, session, &mut panel.unfolded));
    actions
}

/// The buttons for the active layer, from right to left.
fn buttons(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    ui.spacing_mut().item_spacing.x = 0.0;
    for (icon, name, help, action) in [
        (Icon::Bin, "Delete layer", "Delete the active layer with its marks", LayerAction::Delete),
        (Icon::Copies, "Duplicate layer", "Add a copy of the active layer above it", LayerAction::Duplicate),
        (Icon::Down, "Lower layer", "Move the active layer down", LayerAction::Shift(-1)),
        (Icon::Up, "Raise layer", "Move the active layer up", LayerAction::Shift(1)),
        (Icon::Add, "New layer", "Add an empty layer above the active one", LayerAction::Add),
    ] {
        ui.add_enabled_ui(session.allows(action), |ui| {
            let action = Action::Layer(action);
            let keys = shortcuts::shortcut_text(ui.ctx(), &action)
                .map_or(String::new(), |keys| format!(" ({keys})"));
            let button = icon.sized_button(ui, name, false, vec2(27.0, 26.0));
            if button.on_hover_text(format!("{help}{keys}")).clicked() {
                actions.push(action);
            }
        });
    }
}

/// The button that freezes the active layer and goes on with the one above.
fn next(ui: &mut Ui, session: &Session, actions: &mut Vec<Action>) {
    let action = LayerAction::SketchNext;
    let last = session.active_layer + 1 == session.document().layers.len();
    let text = if last { "Freeze layer and start the next" } else { "Freeze layer and go to the next" };
    let help = "Finish this layer: it can no longer be changed and is not grown again. Its texture is shown under the canvas while you draw the next layer. (F)";
    let size = vec2(ui.available_width(), 26.0);
    let button = ui.add_enabled_ui(session.allows(action), |ui| ui.add_sized(size, Button::new(text))).inner;
    let button = button.on_hover_text(help);
    if button.on_disabled_hover_text("The active layer is empty: draw in it first").clicked() {
        actions.push(Action::Layer(action));
    }
}

fn list(ui: &mut Ui, session: &Session, panel: &mut LayersPanel, actions: &mut Vec<Action>) {
    let layers = session.document().layers.len();
    let top = ui.cursor().top();
    let mut dragged = None;
    for layer in (0..layers).rev() {
        let response = row::row(ui, session, panel, layer, actions);
        if response.dragged() || response.drag_stopped() {
            dragged = Some((layer, response));
        }
    }
    let Some((from, response)) = dragged else { return };
    let Some(at) = response.interact_pointer_pos().or(ui.input(|input| input.pointer.latest_pos())) else {
        return;
    };
    // The gap nearest to the pointer, counted from the top.
    let gap = (((at.y - top) / ROW).round().max(0.0) as usize).min(layers);
    let above = layers - 1 - from;
    let place = if gap > above { gap - 1 } else { gap };
    let to = layers - 1 - place;
    if response.drag_stopped() {
        if to != from {
            actions.push(Action::Layer(LayerAction::Move(from, to)));
        }
    } else if to != from {
        let accent = Palette::current(ui.visuals()).accent;
        ui.painter().hline(ui.max_rect().x_range(), top + gap as f32 * ROW, Stroke::new(2.0, accent));
    }
}

/// The id of a layer's row.
fn row_id(ui: &Ui, layer: usize) -> Id {
    ui.scope_id().with(("layer", layer))
}
