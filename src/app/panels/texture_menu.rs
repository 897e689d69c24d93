//! The menu of the texture.

use egui::Response;

use super::entries::Entries;
use super::menu::{copy_link, copy_picture};
use crate::app::action::Action;
use crate::app::growth::Growth;

/// Shows it where it was asked for on the texture.
pub fn texture_menu(texture: &Response, growth: &Growth) -> Vec<Action> {
    let mut actions = Vec::new();
    texture.context_menu(|ui| {
        ui.set_min_width(230.0);
        let mut entries = Entries::new(&mut actions);
        copy_picture(ui, growth.texture.is_some(), &mut entries);
        copy_link(ui, !growth.is_empty(), &mut entries);
        entries.item(ui, "Export…", &Action::Export, !growth.is_empty());
        ui.separator();
        entries.item(ui, "Another seed", &Action::AnotherSeed, true);
        entries.item(ui, "Alternatives", &Action::Alternatives(true), true);
        ui.separator();
        entries.item(ui, "Show the whole canvas", &Action::Fit, true);
        entries.item(ui, "Actual size", &Action::ActualSize, true);
        entries.navigate(ui, false);
    });
    actions
}
