//! Colours from layer to layer, and from document to document.

use egui::{Button, RichText, Ui};

use super::{give, name_of, of};
use crate::app::action::Action;
use crate::app::panels::inspector::heading;
use crate::editor::session::Session;

/// Shows what can be done.
pub fn between(ui: &mut Ui, session: &mut Session, actions: &mut Vec<Action>) {
    heading(ui, "Copies and files");
    copies(ui, session);
    ui.horizontal(|ui| {
        let open = ui.button("Open palette…");
        if open.on_hover_text("Colours from a file: .json of dapple, .gpl of GIMP and others").clicked() {
            actions.push(Action::OpenPalette);
        }
        let save = ui.button("Save palette…");
        if save.on_hover_text("These colours as a file: .json keeps all, .gpl no transitions").clicked() {
            actions.push(Action::SavePalette);
        }
    });
    let ground =
        session.document().layers.iter().rposition(|layer| layer.visible && !layer.strokes.is_empty());
    if let Some(ground) = ground.filter(|ground| *ground != session.active_layer) {
        let text = format!("The ground around all marks is painted by {}.", name_of(session, ground));
        ui.label(RichText::new(text).small().weak()).on_hover_text(
            "Of several layers the topmost that is shown paints the ground, with its first colours",
        );
    }
}

/// Copies from layer to layer, and the way back to the default.
fn copies(ui: &mut Ui, session: &mut Session) {
    let layer = session.active_layer;
    let count = session.document().layers.len();
    let others: Vec<usize> = (0..count).filter(|other| *other != layer).collect();
    ui.horizontal(|ui| {
        ui.add_enabled_ui(!others.is_empty(), |ui| {
            let menu = ui.menu_button("Copy to", |ui| {
                let mut to = chosen(ui, session, &others).map(|other| vec![other]);
                if others.len() > 1 && ui.button("all other layers").clicked() {
                    to = Some(others.clone());
                }
                if let Some(to) = to {
                    let colours = of(session, layer);
                    give(session, &to, Some(&colours));
                }
            });
            menu.response.on_hover_text("Give another layer these colours").on_disabled_hover_text(ALONE);
            let menu = ui.menu_button("Take from", |ui| {
                if let Some(from) = chosen(ui, session, &others) {
                    let colours = of(session, from);
                    give(session, &[layer], Some(&colours));
                }
            });
            menu.response.on_hover_text("Take the colours of another layer").on_disabled_hover_text(ALONE);
        });
        let own = session.document().layers.get(layer).is_some_and(|layer| layer.colours.is_some());
        let back = ui.add_enabled(own, Button::new("Default"));
        if back.on_hover_text("The colours that a layer here has by itself").clicked() {
            give(session, &[layer], None);
        }
    });
}

/// A row a layer; gives the one that was clicked.
fn chosen(ui: &mut Ui, session: &Session, layers: &[usize]) -> Option<usize> {
    let mut chosen = None;
    for &layer in layers {
        if ui.button(name_of(session, layer)).clicked() {
            chosen = Some(layer);
        }
    }
    chosen
}

const ALONE: &str = "There is no other layer";
