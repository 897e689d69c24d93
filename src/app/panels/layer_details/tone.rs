//! The picture that drives the active layer: one row for each thing that can be set.

use egui::{Label, Slider, Ui};

use super::fields::row;
use super::{CONTROL, share};
use crate::app::action::Action;
use crate::app::fields::reset;
use crate::document::{Drives, Layer, Tone, limits};
use crate::editor::edit::Edit;
use crate::editor::picture_use::PictureUse;
use crate::editor::session::Session;

/// Width of the slider's number, with the space before it, points.
const NUMBER: f32 = 52.0;

/// The rows of the active `layer`: of its tone, or the button that asks for a picture where it could have one.
pub(super) fn rows(ui: &mut Ui, session: &Session, layer: &Layer) -> Vec<Action> {
    let mut actions = Vec::new();
    let Some(before) = &layer.tone else {
        if session.beneath(session.active_layer).is_none() && layer.system.allows(|system| system.tone) {
            actions.extend(picture(ui, "Choose…"));
            ui.end_row();
        }
        return actions;
    };
    actions.extend(picture(ui, "Another…"));
    let removed = reset(ui, "Tone", false);
    ui.end_row();
    let mut tone = before.clone();
    drives(ui, &mut tone.drives);
    if tone.drives.direction {
        sketch(ui, &mut tone.sketch);
    }
    range(ui, &mut tone.range);
    equalise(ui, &mut tone.equalise);
    let tone = (!removed).then_some(tone);
    if tone.as_ref() != Some(before) {
        actions.push(Action::Edit(Edit::LayerTone(session.active_layer, tone)));
    }
    actions
}

fn picture(ui: &mut Ui, text: &str) -> Option<Action> {
    let help = "A picture that the layer follows: more ink where it is darker, stripes along its edges";
    ui.add(Label::new("Tone")).on_hover_text(help);
    let asked = ui.button(text).accessible_name("Picture of the tone").on_hover_text(help).clicked();
    asked.then_some(Action::ChoosePicture(PictureUse::Tone))
}

fn drives(ui: &mut Ui, drives: &mut Drives) {
    let help = "What follows the picture, at least one of three. Ink: the share of ink follows its tone. \
                Direction: marks run along its edges. Spacing: marks are closer together where it has fine \
                detail";
    let default = *drives == Drives::default();
    let control = |ui: &mut Ui| {
        ui.vertical(|ui| {
            let boxes = [
                (&mut drives.level, "Ink"),
                (&mut drives.direction, "Direction"),
                (&mut drives.spacing, "Spacing"),
            ];
            let only_one = boxes.iter().filter(|(set, _)| **set).count() == 1;
            for (set, name) in boxes {
                // At least one box stays ticked.
                let can = !(only_one && *set);
                let field = ui.add_enabled(can, egui::Checkbox::new(set, name));
                field.accessible_name(format!("{name} follows the picture"));
            }
        })
        .response
    };
    if row(ui, "Follows", help, default, control) {
        *drives = Drives::default();
    }
}

fn sketch(ui: &mut Ui, sketch: &mut f64) {
    let help = "How much the drawn direction counts against the edges of the picture. 0: parts without edges \
                take the directions of the nearest edges. 0.1: parts without edges take the drawn direction. \
                10: edges hardly change the drawn direction";
    let range = limits::SKETCH.low..=limits::SKETCH.high;
    let default = (*sketch - Tone::SKETCH).abs() < 1e-9;
    let control = |ui: &mut Ui| {
        // The slider and its number together are as wide as the other controls.
        ui.spacing_mut().slider_width = CONTROL - NUMBER;
        let slider = Slider::new(sketch, range).logarithmic(true).smallest_positive(0.01).max_decimals(2);
        ui.add(slider).accessible_name("Sketch")
    };
    if row(ui, "Sketch", help, default, control) {
        *sketch = Tone::SKETCH;
    }
}

fn range(ui: &mut Ui, range: &mut [f64; 2]) {
    let help = "The share of ink where the picture is white, and where it is black. If the first number is \
                the larger one, the result is a negative";
    let default = *range == Tone::RANGE;
    let control = |ui: &mut Ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 3.0;
            let [white, black] = range;
            let white = share(ui, "Ink at white", white, &limits::INK);
            ui.weak("–");
            white.union(share(ui, "Ink at black", black, &limits::INK))
        })
        .inner
    };
    if row(ui, "Ink", help, default, control) {
        *range = Tone::RANGE;
    }
}

fn equalise(ui: &mut Ui, equalise: &mut bool) {
    let help = "Spreads the tones of each part of the picture over the whole range";
    if row(ui, "Equalise", help, *equalise, |ui| ui.checkbox(equalise, "").accessible_name("Equalise")) {
        *equalise = true;
    }
}
