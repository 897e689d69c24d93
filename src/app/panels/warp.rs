//! The warp of the document: how its grown marks are bent.

use egui::{DragValue, Ui};

use super::form::{heading, rows};
use crate::app::action::Action;
use crate::app::units::number_field;
use crate::document::{Document, Warp, limits};
use crate::editor::edit::Edit;

/// Shows the warp of `document`; nothing where a model is grown on.
pub fn warp(ui: &mut Ui, document: &Document) -> Option<Action> {
    if document.model.is_some() {
        return None;
    }
    heading(ui, "Warp");
    let mut now = document.warp;
    rows(ui, "warp", |ui| {
        let help = "Bends the grown marks as if they were drawn on cloth that is pulled. They keep their areas, and are no \
                    longer quite where they were drawn";
        ui.label("Bent").on_hover_text(help);
        let mut bent = now.is_some();
        if ui.checkbox(&mut bent, "").accessible_name("Bend the marks").on_hover_text(help).changed() {
            now = bent.then_some(Warp::USUAL);
        }
        ui.end_row();
        if let Some(warp) = &mut now {
            numbers(ui, warp);
        }
    });
    (now != document.warp).then_some(Action::Edit(Edit::Warp(now)))
}

fn numbers(ui: &mut Ui, warp: &mut Warp) {
    let help = "The distance from a place that moves to one side to the next that moves to the other";
    ui.label("Size").on_hover_text(help);
    let limits::Range { low, high, .. } = limits::MAP_SIZE;
    let field = DragValue::new(&mut warp.size).range(low..=high).speed(0.5).max_decimals(0);
    ui.add(number_field(field, " px")).accessible_name("Size of the warp").on_hover_text(help);
    ui.end_row();
    let [least, most] = warp.allowed();
    warp.by = warp.by.min(most);
    let help = "How far places move in the mean; at most a fifth of the size";
    ui.label("By").on_hover_text(help);
    let field = DragValue::new(&mut warp.by).range(least..=most).speed(0.05).max_decimals(1);
    ui.add(number_field(field, " px")).accessible_name("Displacement of the warp").on_hover_text(help);
    ui.end_row();
}
