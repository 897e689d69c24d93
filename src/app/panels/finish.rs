//! The finish of the document: its material, the size of its parts, the direction of hair and scales.

use egui::{ComboBox, DragValue, RichText, Ui};

use super::form::{heading, rows};
use crate::app::action::Action;
use crate::app::units::number_field;
use crate::document::{Document, Finish, FinishKind, Finishing, FlowChoice};
use crate::editor::edit::Edit;

/// The name of no finish.
const NONE: &str = "none";

/// Shows the finish of `document`.
pub fn finish(ui: &mut Ui, document: &Document) -> Option<Action> {
    heading(ui, "Finish");
    if document.parametric.is_some() {
        ui.label(RichText::new("The map of a surface has no finish.").weak());
        return None;
    }
    let on_model = document.model.is_some();
    let mut now = document.finish.clone();
    rows(ui, "finish", |ui| {
        ui.label("Material").on_hover_text(
            "What the texture is made of. It changes the picture only: pattern, outlines and measurements stay",
        );
        kind(ui, &mut now, on_model);
        ui.end_row();
        if let Some(finishing) = &mut now {
            size(ui, &mut finishing.finish);
            mottling(ui, &mut finishing.finish);
            if finishing.finish.kind.has_flow() || finishing.flow.strokes() > 0 {
                let has_flow = finishing.finish.kind.has_flow();
                direction(ui, &mut finishing.flow, has_flow, on_model);
            }
        }
    });
    (now != document.finish).then_some(Action::Edit(Edit::Finish(now)))
}

fn kind(ui: &mut Ui, now: &mut Option<Finishing>, on_model: bool) {
    let shown = now.as_ref().map_or(NONE, |finishing| finishing.finish.kind.name());
    let combo = ComboBox::from_id_salt("finish").selected_text(words(shown)).width(110.0);
    let combo = combo.show_ui(ui, |ui| {
        let strokes = now.as_ref().map_or(0, |finishing| finishing.flow.strokes());
        let none = match strokes {
            0 => words(NONE),
            1 => format!("{} (removes a stroke of hair)", words(NONE)),
            _ => format!("{} (removes {strokes} strokes of hair)", words(NONE)),
        };
        if ui.selectable_label(now.is_none(), none).clicked() {
            *now = None;
        }
        for (name, kind) in FinishKind::NAMES {
            if let (true, Err(why)) = (on_model, kind.on_models()) {
                let entry = ui.add_enabled(false, egui::Button::selectable(false, words(name)));
                entry.on_disabled_hover_text(format!("Not on a model: {why}"));
                continue;
            }
            if ui.selectable_label(shown == name, words(name)).clicked() && shown != name {
                let flow = now.take().map_or(FlowChoice::Usual, |finishing| finishing.flow);
                // Strokes are kept for a later finish with a direction.
                let is_kept = kind.has_flow() || flow.strokes() > 0;
                let flow = if is_kept { flow } else { FlowChoice::Usual };
                *now = Some(Finishing { finish: Finish::new(kind), flow });
            }
        }
    });
    combo.response.accessible_name("Material of the texture");
}

fn size(ui: &mut Ui, finish: &mut Finish) {
    let help = format!("The {}, px of the canvas", finish.kind.measure());
    ui.label("Size").on_hover_text(&help);
    let [low, high] = Finish::SIZES;
    let field = DragValue::new(&mut finish.size).range(low..=high).speed(0.1).max_decimals(1);
    ui.add(number_field(field, " px")).accessible_name("Size of the material").on_hover_text(help);
    ui.end_row();
}

fn mottling(ui: &mut Ui, finish: &mut Finish) {
    let help = "How much the tone of the material varies, slowly and finely, in marks and ground alike";
    ui.label("Mottling").on_hover_text(help);
    let [low, high] = Finish::MOTTLING;
    let mut percent = 100.0 * finish.mottle;
    let field = DragValue::new(&mut percent).range(100.0 * low..=100.0 * high).speed(0.2).max_decimals(0);
    if ui.add(number_field(field, " %")).accessible_name("Mottling").on_hover_text(help).changed() {
        finish.mottle = percent / 100.0;
    }
    ui.end_row();
}

fn direction(ui: &mut Ui, flow: &mut FlowChoice, has_flow: bool, on_model: bool) {
    let help = match on_model {
        true => {
            "The way from head to tail, from +x of the sketch on the model. Automatic: across stripes, otherwise to the tail and down"
        }
        false => "The way from head to tail. Automatic: across stripes, otherwise to the left",
    };
    ui.label("Direction").on_hover_text(help);
    if matches!(flow, FlowChoice::Strokes(_)) {
        let text = match has_flow {
            true => "along the strokes of its layer of hair",
            false => "strokes of hair are kept for fur and scales",
        };
        ui.label(RichText::new(text).weak());
        ui.end_row();
        return;
    }
    ui.horizontal(|ui| {
        let mut automatic = *flow == FlowChoice::Usual;
        let field = ui.checkbox(&mut automatic, "automatic").accessible_name("Direction automatic");
        if field.on_hover_text(help).changed() {
            *flow = if automatic { FlowChoice::Usual } else { FlowChoice::Angle(FlowChoice::HEAD_TO_TAIL) };
        }
        if let FlowChoice::Angle(degrees) = flow {
            let field = DragValue::new(degrees).range(-360.0..=360.0).speed(0.5).max_decimals(0);
            ui.add(number_field(field, "°")).accessible_name("Direction of the material");
        }
    });
    ui.end_row();
}

/// The name of a finish in words, with a capital.
fn words(name: &str) -> String {
    let mut letters = name.replace('-', " ");
    if let Some(first) = letters.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    letters
}
