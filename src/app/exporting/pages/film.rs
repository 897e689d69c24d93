//! Films.

use egui::{Button, DragValue, Ui};

use super::{DialogAction, ExportContext};
use super::{named, number, one_of, rows, yes};
use crate::app::exporting::choices::KINDS;
use crate::app::exporting::{Choices, Film};
use crate::export::motion::Kind;
use crate::synth::render::clip::{Clip, FASTEST_GIF, RATES, SIDE, SIDES};

/// The choices.
pub fn page(ui: &mut Ui, choices: &mut Choices, context: &ExportContext) -> Option<DialogAction> {
    let film = &mut choices.film;
    let mut action = None;
    rows(ui, "film", |ui| {
        named(ui, "Shows", "What the film shows");
        ui.vertical(|ui| {
            ui.radio_value(&mut film.change, false, "The growth")
                .on_hover_text("From the beginning to the settled texture");
            let explained =
                "This document changes into another one: its marks move, turn, split, vanish, and change their size";
            ui.radio_value(&mut film.change, true, "The change into another document")
                .on_hover_text(explained);
        });
        ui.end_row();
        if film.change {
            named(ui, "To", "A document of the same size, with one layer of the same kind");
            let name = film.to.as_deref().and_then(std::path::Path::file_name);
            let text = name
                .map_or_else(|| "Choose a document…".to_owned(), |name| name.to_string_lossy().into_owned());
            if ui.add(Button::new(text)).clicked() {
                action = Some(DialogAction::ChooseOther);
            }
            ui.end_row();
        }
        named(
            ui,
            "Format",
            "GIF can be shown everywhere; animated PNG has all colours; single pictures are for video editing",
        );
        let texts = KINDS.map(|kind| {
            let text = match kind {
                Kind::Gif => "GIF",
                Kind::Apng => "Animated PNG",
                Kind::Folder => "Single PNG, in a folder",
            };
            (kind, text.to_owned())
        });
        one_of(ui, "Format of the film", &mut film.kind, &texts, |_| true);
        ui.end_row();
        times(ui, film, context);
        if film.kind != Kind::Folder {
            end(ui, &mut film.clip);
        }
    });
    action
}

/// Size and speed.
fn times(ui: &mut Ui, film: &mut Film, context: &ExportContext) {
    let clip = &mut film.clip;
    let canvas = context.request.document.size;
    let usual = SIDE.min(canvas[0].max(canvas[1]));
    named(ui, "Longer side", "Longer side of a frame");
    let mut side = clip.side.unwrap_or(usual);
    let field = DragValue::new(&mut side).range(SIDES);
    if number(ui, "Longer side", field, " px") {
        clip.side = (side != usual).then_some(side);
    }
    ui.end_row();
    named(ui, "Length", "Without the hold at the end");
    let field = DragValue::new(&mut clip.seconds).range(0.1..=600.0).speed(0.05).max_decimals(2);
    number(ui, "Length", field, " s");
    ui.end_row();
    named(ui, "Frames a second", "Browsers show a GIF no faster than 50");
    let fastest = if film.kind == Kind::Gif { FASTEST_GIF } else { *RATES.end() };
    number(ui, "Frames a second", DragValue::new(&mut clip.fps).range(1..=fastest).speed(0.1), "");
    ui.end_row();
}

/// What happens at the end.
fn end(ui: &mut Ui, clip: &mut Clip) {
    named(ui, "At the end", "What the film does at its end");
    let mut again = !clip.once;
    yes(ui, "loop", &mut again, true, "Otherwise it stops at the last frame");
    clip.once = !again;
    ui.end_row();
    if again {
        named(ui, "Hold", "How much longer the last frame is shown");
        let field = DragValue::new(&mut clip.hold).range(0.0..=60.0).speed(0.05).max_decimals(2);
        number(ui, "Hold", field, " s");
        ui.end_row();
    }
}
