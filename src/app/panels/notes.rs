//! Notes while the user draws: what will not grow as it was drawn, and what to do about it.

use egui::{Button, RichText, Ui};

use super::form::heading;
use super::suggestions::suggestions;
use crate::app::action::Action;
use crate::app::canvas::Canvas;
use crate::app::result::Drawn;
use crate::attributes::free::Note;
use crate::document::sketch_notes::Remedy;
use crate::document::{AreaKind, PairKind, System, SystemChoice};
use crate::editor::edit::Edit;
use crate::editor::layer_action::LayerAction;
use crate::editor::layer_choices::system_refusal;
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::units::Ruler;

/// The most notes about the lines of one layer that are shown one by one.
const MOST: usize = 4;

/// What will not grow as it was drawn, and the remedies that dapple can carry out.
pub fn notes(ui: &mut Ui, session: &Session, canvas: &Canvas, drawn: &Drawn, ruler: Ruler) -> Vec<Action> {
    let notes = &canvas.analysis.notes;
    let lines = canvas.wanted.of(session.active_layer).map(|wanted| wanted.map.notes()).unwrap_or_default();
    // Crossings are among the notes on the sketch.
    let lines: Vec<&Note> = lines.iter().filter(|note| !matches!(note, Note::Crossing { .. })).collect();
    let layers = 0..session.document().layers.len();
    let has_missed = |layer: &usize| {
        let lost = drawn.of_layer(session, *layer).iter().any(|mark| !mark.there);
        lost || !drawn.merged(session, *layer).is_empty()
    };
    let missed: Vec<usize> = layers.filter(has_missed).collect();
    let mut actions = weaves(ui, session, canvas);
    actions.extend(dense(ui, session, canvas));
    actions.extend(cells(ui, session, canvas));
    actions.extend(suggestions(ui, session, canvas));
    if notes.is_empty() && lines.is_empty() && missed.is_empty() {
        return actions;
    }
    heading(ui, "Will not grow as drawn");
    for layer in missed {
        actions.extend(missed_of(ui, session, drawn, layer));
    }
    for note in notes {
        let layer = note.layer.map(|layer| format!("{}: ", session.layer_name(layer))).unwrap_or_default();
        let text = note.problem.in_words("", &|area| ruler.area(area));
        told(ui, &format!("{layer}{text}."));
        if let Some(layer) = note.layer {
            actions.extend(note.remedies.iter().filter_map(|remedy| remedied(ui, session, *remedy, layer)));
        }
    }
    let name = session.layer_name(session.active_layer);
    for note in lines.iter().take(MOST) {
        told(ui, &format!("{name}: {}.", note.in_words(&|length| ruler.rough(length))));
    }
    if let Some(more @ 1..) = lines.len().checked_sub(MOST) {
        told(ui, &format!("There are {more} more such places; signs on the sketch show them."));
    }
    actions
}

fn told(ui: &mut Ui, text: &str) {
    ui.label(RichText::new(text).weak());
}

/// The layers that are weaves because their lines cross.
fn weaves(ui: &mut Ui, session: &Session, canvas: &Canvas) -> Vec<Action> {
    let mut actions = Vec::new();
    for layer in &canvas.analysis.weaves {
        told(ui, &format!("{}: lines cross, so this layer grows a weave.", session.layer_name(*layer)));
        let help =
            "Stripes have one direction at each place: where lines cross, not both can grow. Can be undone.";
        let button = Button::new("Grow stripes instead");
        if ui.add_enabled(*layer >= session.frozen(), button).on_hover_text(help).clicked() {
            actions.push(Action::Edit(Edit::LayerSystem(*layer, SystemChoice::Stripes)));
        }
    }
    actions
}

/// The layers whose marks are too dense for spots.
fn dense(ui: &mut Ui, session: &Session, canvas: &Canvas) -> Vec<Action> {
    let mut actions = Vec::new();
    for (layer, kind) in &canvas.analysis.dense {
        let (name, noun) = (session.layer_name(*layer), kind.description().noun);
        told(
            ui,
            &format!(
                "{name}: spots cannot grow as close together as these marks, so this layer grows {noun} instead."
            ),
        );
        let help = "Spots of the drawn size, but farther apart than drawn. Can be undone.";
        let button = Button::new("Grow spots instead");
        if ui.add_enabled(*layer >= session.frozen(), button).on_hover_text(help).clicked() {
            let spots = System::first(|system| !system.is_striped() && system.free_spacing);
            actions.extend(spots.map(|system| {
                Action::Edit(Edit::LayerSystem(*layer, SystemChoice::Of(system.description())))
            }));
        }
    }
    actions
}

/// The layers whose outlines lie side by side as cells do.
fn cells(ui: &mut Ui, session: &Session, canvas: &Canvas) -> Vec<Action> {
    let mut actions = Vec::new();
    for layer in &canvas.analysis.cells {
        told(ui, &format!("{}: these outlines lie side by side, as cells do.", session.layer_name(*layer)));
        let help = "Cells of this size all over the canvas. The lines between them are as wide as the gaps \
                    between your outlines, or as a line that you draw. Can be undone.";
        let can = *layer >= session.frozen();
        if ui.add_enabled(can, Button::new("Grow cells")).on_hover_text(help).clicked() {
            let system = SystemChoice::Of(AreaKind::Polygons.description());
            actions.push(Action::Edit(Edit::LayerSystem(*layer, system)));
        }
    }
    actions
}

/// A button for a remedy.
fn remedied(ui: &mut Ui, session: &Session, remedy: Remedy, layer: usize) -> Option<Action> {
    let (action, text, help) = match remedy {
        Remedy::Weave => return to_weave(ui, session, layer),
        Remedy::TwoLayers => (
            LayerAction::SplitBySize(layer),
            "Split into two layers",
            "The large spots stay on this layer, the small ones go to a new layer above it. Can be undone.",
        ),
        Remedy::CrossingLayer => (
            LayerAction::SplitCrossings(layer),
            "Move crossing lines to a new layer",
            "The lines drawn first stay on this layer, those that cross them go to a new layer above it, whose stripes pass \
             under them. Can be undone.",
        ),
    };
    let button = ui.add_enabled(session.allows(action), Button::new(text)).on_hover_text(help);
    button.clicked().then_some(Action::Layer(action))
}

/// A button that makes a layer of lines a weave.
fn to_weave(ui: &mut Ui, session: &Session, layer: usize) -> Option<Action> {
    let weave = SystemChoice::Of(PairKind::Weave.description());
    let can = layer >= session.frozen() && system_refusal(session, layer, weave).is_none();
    let help = "Threads of all these directions, which cross each other. Can be undone.";
    let button = ui.add_enabled(can, Button::new("Grow a weave")).on_hover_text(help);
    button.clicked().then_some(Action::Edit(Edit::LayerSystem(layer, weave)))
}

/// Marks of a layer that do not grow, and spots that grew together.
fn missed_of(ui: &mut Ui, session: &Session, drawn: &Drawn, layer: usize) -> Vec<Action> {
    let mut actions = Vec::new();
    let name = session.layer_name(layer);
    let lost = drawn.of_layer(session, layer).iter().filter(|mark| !mark.there);
    let lost: Vec<Place> = lost.map(|mark| Place { layer, stroke: mark.mark }).collect();
    if !lost.is_empty() {
        told(
            ui,
            &match lost.len() {
                1 => format!("{name}: 1 mark does not grow (dashed outline): point at it to see why."),
                many => {
                    format!("{name}: {many} marks do not grow (dashed outlines): point at one to see why.")
                }
            },
        );
        let can_select = layer >= session.frozen();
        let text = if lost.len() == 1 { "Select it" } else { "Select them" };
        let help = "Selects the marks that do not grow, to move, shrink or delete them";
        if ui.add_enabled(can_select, Button::new(text)).on_hover_text(help).clicked() {
            actions.push(Action::SelectMarks(lost));
        }
    }
    let merged = drawn.merged(session, layer).len();
    if merged > 0 {
        let places = if merged == 1 { "1 place".to_owned() } else { format!("{merged} places") };
        told(
            ui,
            &format!(
                "{name}: spots grew together at {places} (signs on the sketch and beside the texture). Draw the marks around \
                 these places farther apart \
                 or smaller, or try another random start."
            ),
        );
        let help = "The same kind of texture with other positions: often no spots grow together then (N)";
        if ui.button("Try another seed").on_hover_text(help).clicked() {
            actions.push(Action::AnotherSeed);
        }
    }
    actions
}
