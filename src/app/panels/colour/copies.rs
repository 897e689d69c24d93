//! Copying colours from layer to layer, and palette files.

use egui::{Button, RichText, Ui};

use crate::app::action::Action;
use crate::app::panels::form::heading;
use crate::document::Colours;
use crate::editor::edit::Edit;
use crate::editor::session::Session;

/// Shows the buttons. `colours`: those of the active layer.
pub fn copies(ui: &mut Ui, session: &Session, colours: &Colours) -> Vec<Action> {
    heading(ui, "Copies and files");
    let mut actions: Vec<Action> = buttons(ui, session, colours).map(Action::Edit).into_iter().collect();
    ui.horizontal(|ui| {
        let open = ui.button("Open palette…");
        if open.on_hover_text("Read colours from a file: .json (dapple) or .gpl (GIMP)").clicked() {
            actions.push(Action::OpenPalette);
        }
        let save = ui.button("Save palette…");
        if save
            .on_hover_text("Save these colours: .json keeps everything, .gpl (GIMP) has no transitions")
            .clicked()
        {
            actions.push(Action::SavePalette);
        }
    });
    let layers = &session.document().layers;
    let ground = layers.iter().rposition(|layer| layer.visible && !layer.is_blank());
    if let Some(ground) = ground.filter(|ground| *ground != session.active_layer) {
        let text = format!("Background colour: set by {}.", session.layer_name(ground));
        ui.label(RichText::new(text).small().weak())
            .on_hover_text("The topmost visible layer sets the background colour, with its first stop");
    }
    actions
}

/// Copy to a layer, copy from a layer, back to the default.
fn buttons(ui: &mut Ui, session: &Session, colours: &Colours) -> Option<Edit> {
    let layer = session.active_layer;
    let layers = &session.document().layers;
    let others: Vec<usize> = (0..layers.len()).filter(|other| *other != layer).collect();
    let mut edit = None;
    ui.horizontal(|ui| {
        ui.add_enabled_ui(!others.is_empty(), |ui| {
            let menu = ui.menu_button("Copy to", |ui| {
                let mut to = choice(ui, session, &others).map(|other| vec![other]);
                if others.len() > 1 && ui.button("all other layers").clicked() {
                    to = Some(others.clone());
                }
                if let Some(to) = to {
                    edit = Some(Edit::Colours(to, Some(colours.clone())));
                }
            });
            menu.response.on_hover_text("Copy these colours to another layer").on_disabled_hover_text(ALONE);
            let menu = ui.menu_button("Copy from", |ui| {
                if let Some(from) = choice(ui, session, &others) {
                    edit = Some(Edit::Colours(vec![layer], Some(session.colours(from))));
                }
            });
            menu.response.on_hover_text("Copy the colours of another layer").on_disabled_hover_text(ALONE);
        });
        let has_own = layers.get(layer).is_some_and(|layer| layer.colours.is_some());
        let default = ui.add_enabled(has_own, Button::new("Default"));
        if default.on_hover_text("The default colours of a layer at this position").clicked() {
            edit = Some(Edit::Colours(vec![layer], None));
        }
    });
    edit
}

/// A button for each layer; gives the one that was clicked.
fn choice(ui: &mut Ui, session: &Session, layers: &[usize]) -> Option<usize> {
    let mut clicked = None;
    for &layer in layers {
        if ui.button(session.layer_name(layer)).clicked() {
            clicked = Some(layer);
        }
    }
    clicked
}

const ALONE: &str = "There is no other layer";
