//! The bar above the texture: the state of the growth, pause, stop, seed, alternatives.

use egui::{Align, DragValue, Label, Layout, ProgressBar, Response, RichText, Ui, vec2};

use crate::app::action::Action;
use crate::app::growth::{Growth, GrowthState};
use crate::app::icons::Icon;
use crate::document::Document;
use crate::editor::edit::Edit;
use crate::grid::Edges;
use crate::synth::Stage;

/// Shows the bar. `tiled`: the texture is shown two by two; `alternatives`: the alternatives are shown.
pub fn growth_bar(
    ui: &mut Ui,
    document: &Document,
    growth: &Growth,
    tiled: bool,
    alternatives: bool,
) -> Vec<Action> {
    let mut actions = Vec::new();
    let spacing = ui.spacing().item_spacing.x;
    // The buttons are placed first; the text gets the space that is left.
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        let width = ui.available_width();
        actions.extend(seed(ui, document.seed, width >= WITH_SEED));
        let help = "Other textures that fit the same sketch (A)";
        if width >= WITH_STRIP
            && Icon::Strip.button(ui, "Alternatives", alternatives).on_hover_text(help).clicked()
        {
            actions.push(Action::Alternatives(!alternatives));
        }
        if document.edges == Edges::Wrap {
            let help = "Show the tile two by two, to check that no seam is visible";
            if Icon::Tiles.button(ui, "Two by two", tiled).on_hover_text(help).clicked() {
                actions.push(Action::Tiled(!tiled));
            }
        }
        actions.extend(controls(ui, growth));
        ui.add_space(spacing - 4.0);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = spacing;
            if ui.available_width() >= TITLED {
                ui.strong("Texture");
                ui.add_space(4.0);
            }
            state(ui, growth);
        });
    });
    actions
}

/// Width beside the buttons from which the title is shown, points: from this width on there is also space for the state
/// of the growth.
const TITLED: f32 = 150.0;
/// Widths from which the number of the seed and the button of the alternatives are shown, points; both are also in the menus
/// or on keys.
const WITH_SEED: f32 = 230.0;
const WITH_STRIP: f32 = 178.0;
/// Width that the text about a finished growth needs, points.
const SPELLED_OUT: f32 = 90.0;

fn seed(ui: &mut Ui, mut seed: u64, with_number: bool) -> Option<Action> {
    let mut action = None;
    if with_number {
        let field = DragValue::new(&mut seed).speed(0.05).update_while_editing(false);
        let field = ui.add(field).accessible_name("Seed");
        let help = "Number of the random start: with the same number, the same sketch grows the same texture";
        if field.on_hover_text(help).changed() {
            action = Some(Action::Edit(Edit::Seed(seed)));
        }
    }
    let help = "Another random start (N): a texture of the same kind, with other positions and shapes";
    if Icon::Dice.button(ui, "Another seed", false).on_hover_text(help).clicked() {
        action = Some(Action::AnotherSeed);
    }
    action
}

/// Stop, pause, resume, grow again. From right to left.
fn controls(ui: &mut Ui, growth: &Growth) -> Vec<Action> {
    let mut actions = Vec::new();
    ui.add_enabled_ui(growth.is_growing(), |ui| {
        let help = "Stop growing and keep the picture as it is";
        if Icon::Stop.button(ui, "Stop", false).on_hover_text(help).clicked() {
            actions.push(Action::Stop);
        }
    });
    let (icon, name) = match (growth.is_growing(), growth.is_paused()) {
        (true, false) => (Icon::Pause, "Pause"),
        (true, true) => (Icon::Play, "Resume"),
        (false, _) => (Icon::Play, "Grow again"),
    };
    ui.add_enabled_ui(!growth.is_empty(), |ui| {
        if icon.button(ui, name, false).on_hover_text(name).clicked() {
            actions.push(if growth.is_growing() { Action::Pause } else { Action::Grow });
        }
    });
    actions
}

fn state(ui: &mut Ui, growth: &Growth) {
    match &growth.state {
        GrowthState::Idle | GrowthState::Failed(_) => {}
        GrowthState::Growing(stage, share) => {
            // The stages have the same shares of the bar as in the progress bar of `dapple grow`.
            let (text, from, to) = match stage {
                Stage::Plan => ("planning", 0.0, 0.05),
                Stage::Grow => ("growing", 0.05, 0.9),
                Stage::Refine | Stage::Write => ("refining", 0.9, 1.0),
            };
            let text = if growth.is_paused() { "paused" } else { text };
            let width = ui.available_width().min(90.0);
            ui.add_sized(
                vec2(width, 6.0),
                ProgressBar::new((from + (to - from) * share) as f32).desired_height(6.0),
            );
            said(ui, text);
        }
        GrowthState::Stopped => {
            said(ui, "stopped");
        }
        GrowthState::Settled(time) if time.is_zero() => {
            said(ui, "finished");
        }
        GrowthState::Settled(time) => {
            let seconds = format!("{:.1} s", time.as_secs_f64());
            let whole = format!("finished in {seconds}");
            let finds_room = ui.available_width() >= SPELLED_OUT;
            said(ui, if finds_room { &whole } else { &seconds }).on_hover_text(&whole);
        }
    }
}

/// A text that is cut off where there is not enough space.
fn said(ui: &mut Ui, text: &str) -> Response {
    ui.add(Label::new(RichText::new(text).weak()).truncate())
}
