//! Above the texture: how far it is; pause, stop, another seed.

use egui::{DragValue, ProgressBar, Ui, vec2};

use crate::app::Window;
use crate::app::action::Action;
use crate::app::growth::Phase;
use crate::app::icons::Icon;
use crate::grid::Edges;
use crate::synth::Stage;

/// The bar. Gives what is chosen.
pub fn growth_bar(ui: &mut Ui, window: &mut Window) -> Vec<Action> {
    let mut actions = Vec::new();
    ui.horizontal_centered(|ui| {
        ui.strong("Texture");
        ui.add_space(4.0);
        phase(ui, window);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            let mut seed = window.session.document().seed;
            let field = DragValue::new(&mut seed).speed(0.05).update_while_editing(false);
            let field = ui.add(field).accessible_name("Seed");
            if field.on_hover_text("Where all chance comes from: the same seed, the same texture").changed() {
                window.session.edit(|document| document.seed = seed);
            }
            if Icon::Dice
                .button(ui, "Another seed", false)
                .on_hover_text("Another seed (N): the same, but different")
                .clicked()
            {
                actions.push(Action::AnotherSeed);
            }
            let shown = window.alternatives.shown;
            let help = "Other textures that fit the same sketch (A)";
            if Icon::Strip.button(ui, "Alternatives", shown).on_hover_text(help).clicked() {
                actions.push(Action::Alternatives(!shown));
            }
            if window.session.document().edges == Edges::Wrap {
                let tiled = window.texture.tiled;
                let help = "Shows the tile two by two, so that a seam would be seen";
                if Icon::Tiles.button(ui, "Two by two", tiled).on_hover_text(help).clicked() {
                    actions.push(Action::Tiled(!tiled));
                }
            }
            ui.add_enabled_ui(window.growth.is_growing(), |ui| {
                if Icon::Stop.button(ui, "Stop", false).on_hover_text("Stop; what is there stays").clicked() {
                    actions.push(Action::Stop);
                }
            });
            let (icon, name) = match (window.growth.is_growing(), window.growth.is_paused()) {
                (true, false) => (Icon::Pause, "Pause"),
                (true, true) => (Icon::Play, "Go on"),
                (false, _) => (Icon::Play, "Grow again"),
            };
            ui.add_enabled_ui(!window.growth.is_empty(), |ui| {
                if icon.button(ui, name, false).on_hover_text(name).clicked() {
                    actions.push(if window.growth.is_growing() { Action::Pause } else { Action::Grow });
                }
            });
        });
    });
    actions
}

fn phase(ui: &mut Ui, window: &Window) {
    match &window.growth.phase {
        Phase::Idle | Phase::Failed(_) => {}
        Phase::Growing(stage, share) => {
            // Shares of the whole, as `dapple grow` shows them.
            let (text, from, to) = match stage {
                Stage::Plan => ("planning", 0.0, 0.05),
                Stage::Grow => ("growing", 0.05, 0.9),
                Stage::Refine | Stage::Write => ("refining", 0.9, 1.0),
            };
            let text = if window.growth.is_paused() { "paused" } else { text };
            let bar =
                ProgressBar::new((from + (to - from) * share) as f32).desired_width(90.0).desired_height(6.0);
            ui.add_sized(vec2(90.0, 6.0), bar);
            ui.weak(text);
        }
        Phase::Stopped => {
            ui.weak("stopped");
        }
        Phase::Settled(time) if time.is_zero() => {
            ui.weak("settled");
        }
        Phase::Settled(time) => {
            ui.weak(format!("settled in {:.1} s", time.as_secs_f64()));
        }
    }
}
