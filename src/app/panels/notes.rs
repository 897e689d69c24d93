//! What will not grow as it was drawn, told while one draws.

use egui::{Button, RichText, Ui};

use super::form::heading;
use crate::app::action::Action;
use crate::app::canvas::Canvas;
use crate::app::result::Drawn;
use crate::document::sketch_notes::Remedy;
use crate::editor::layer_action::LayerAction;
use crate::editor::session::Session;

/// What will not grow as it was drawn, and the remedies that dapple can carry out.
pub fn notes(ui: &mut Ui, session: &Session, canvas: &Canvas, drawn: &Drawn) -> Vec<Action> {
    let notes = &canvas.analysis.notes;
    let mut actions = Vec::new();
    let layers = 0..session.document().layers.len();
    let lost: Vec<String> = layers.filter_map(|layer| lost_of(session, drawn, layer)).collect();
    let remarks =
        canvas.wanted.of(session.active_layer).map(|wanted| wanted.map.remarks()).unwrap_or_default();
    if notes.is_empty() && lost.is_empty() && remarks.is_empty() {
        return actions;
    }
    heading(ui, "Will not grow as drawn");
    for text in lost {
        ui.label(RichText::new(text).weak());
    }
    for note in notes {
        let layer = note.layer.map(|layer| format!("{}: ", session.layer_name(layer))).unwrap_or_default();
        ui.label(RichText::new(format!("{layer}{}.", note.text)).weak());
        if let (Some(Remedy::TwoLayers), Some(layer)) = (note.remedy, note.layer) {
            let action = LayerAction::SplitBySize(layer);
            let button = ui.add_enabled(session.allows(action), Button::new("Split into two layers"));
            let help = "The large spots stay on this layer, the small ones go to a new layer above it. Can be undone.";
            if button.on_hover_text(help).clicked() {
                actions.push(Action::Layer(action));
            }
        }
    }
    for remark in remarks {
        ui.label(RichText::new(format!("{}: {remark}.", session.layer_name(session.active_layer))).weak());
    }
    actions
}

/// How many marks of a layer do not grow; `None` where all do, as far as that is known.
fn lost_of(session: &Session, drawn: &Drawn, layer: usize) -> Option<String> {
    let lost = drawn.of_layer(session, layer).iter().filter(|mark| !mark.there).count();
    let name = session.layer_name(layer);
    match lost {
        0 => None,
        1 => Some(format!("{name}: 1 mark does not grow (dashed outline): point at it to see why.")),
        _ => Some(format!("{name}: {lost} marks do not grow (dashed outlines): point at one to see why.")),
    }
}
