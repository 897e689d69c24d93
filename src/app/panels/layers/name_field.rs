//! The field for the name of a layer.

use egui::text::CCursorRange;
use egui::text_edit::TextEditState;
use egui::{Key, Rect, TextEdit, Ui, vec2};

use super::{LayersPanel, row_id};
use crate::app::action::Action;
use crate::editor::edit::Edit;
use crate::editor::session::Session;

/// Longest name that can be typed, characters.
const NAME: usize = 60;

/// The field in which a name is typed. Enter, Tab and a click elsewhere accept it, Escape does not.
pub(super) fn name_field(
    ui: &mut Ui,
    session: &Session,
    panel: &mut LayersPanel,
    place: Rect,
    actions: &mut Vec<Action>,
) {
    let Some((layer, mut name)) = panel.naming.take() else { return };
    let field = ui.scope_id().with("name of layer");
    let edit = TextEdit::singleline(&mut name)
        .id(field)
        .char_limit(NAME)
        .hint_text(session.layer_name(layer))
        .margin(vec2(4.0, 3.0));
    let response = ui.put(place.shrink2(vec2(0.0, 2.0)), edit).accessible_name("Layer name");
    let [enter, tab] = [Key::Enter, Key::Tab].map(|key| ui.input(|input| input.key_pressed(key)));
    if response.lost_focus() {
        if enter || tab || ui.input(|input| input.pointer.any_down()) {
            let name = name.trim().to_owned();
            actions.push(Action::Edit(Edit::LayerName(layer, name)));
        }
        if std::mem::take(&mut panel.from_row) && !tab {
            ui.memory_mut(|memory| memory.request_focus(row_id(ui, layer)));
        }
        return;
    }
    if !response.has_focus() {
        response.request_focus();
        let mut state = TextEditState::load(ui.ctx(), field).unwrap_or_default();
        state.cursor.set_char_range(Some(CCursorRange::select_all_str(&name)));
        state.store(ui.ctx(), field);
    }
    panel.naming = Some((layer, name));
}
