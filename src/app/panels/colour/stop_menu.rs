//! The menu of a stop.

use egui::{Button, Response, Ui};

use super::ColourPanel;
use crate::document::Colours;

/// Shows it where it was asked for on a stop, which becomes the selected one.
pub(super) fn stop_menu(stop: &Response, panel: &mut ColourPanel, colours: &mut Colours, index: usize) {
    if stop.secondary_clicked() {
        panel.choose(index, colours);
    }
    stop.context_menu(|ui| {
        ui.set_min_width(200.0);
        let count = colours.stops.len();
        if entry(ui, "Pick a colour…", true) {
            panel.open_picker = true;
        }
        if entry(ui, "Take a colour from a picture", true) {
            panel.picking = true;
        }
        ui.separator();
        for (text, other) in [
            ("Swap with previous", index.checked_sub(1)),
            ("Swap with next", Some(index + 1).filter(|next| *next < count)),
        ] {
            if let (true, Some(other)) = (entry(ui, text, other.is_some()), other) {
                colours.swap(index, other);
                panel.choose(other, colours);
            }
        }
        ui.separator();
        if entry(ui, "Remove", count > 1) && colours.remove(index) {
            panel.choose(index.min(count - 2), colours);
        }
    });
}

fn entry(ui: &mut Ui, text: &str, enabled: bool) -> bool {
    let is_clicked = ui.add_enabled(enabled, Button::new(text)).clicked();
    if is_clicked {
        ui.close();
    }
    is_clicked
}
