//! The tools, undo and redo, in a column on the left.

use egui::{Ui, vec2};

use crate::app::action::Action;
use crate::app::canvas::tool::Tool;
use crate::app::icons::Icon;
use crate::app::shortcuts;
use crate::editor::session::Session;

/// Shows the column. `current`: the tool that is chosen.
pub fn tools(ui: &mut Ui, current: Tool, session: &Session) -> Option<Action> {
    let mut chosen = None;
    let [closed, _] = session.closed_strokes(session.active_layer);
    let size = vec2(36.0, 34.0);
    ui.spacing_mut().item_spacing.y = 4.0;
    ui.vertical_centered(|ui| {
        // Only hair and scales are combed.
        let is_shown = |tool: &Tool| *tool != Tool::Comb || current == Tool::Comb || session.can_comb();
        for tool in Tool::ALL.into_iter().filter(is_shown) {
            if tool == Tool::Eraser || tool == Tool::Pen {
                ui.add_space(4.0);
            }
            let button = tool.icon().sized_button(ui, tool.name(), tool == current, size);
            let keys = shortcuts::shortcut_text(ui.ctx(), &Action::Tool(tool)).unwrap_or_default();
            let button = button.on_hover_ui(|ui| {
                let keys = if keys.is_empty() { keys } else { format!(" ({keys})") };
                ui.strong(format!("{}{keys}", tool.name()));
                ui.label(tool.help(closed));
            });
            if button.clicked() {
                chosen = Some(Action::Tool(tool));
            }
        }
        ui.add_space(10.0);
        let [undo, redo] = session.can_undo_redo();
        for (icon, name, action, can) in
            [(Icon::Undo, "Undo", Action::Undo, undo), (Icon::Redo, "Redo", Action::Redo, redo)]
        {
            ui.add_enabled_ui(can, |ui| {
                let keys = shortcuts::shortcut_text(ui.ctx(), &action).unwrap_or_default();
                let button = icon.sized_button(ui, name, false, size);
                if button.on_hover_text(format!("{name} ({keys})")).clicked() {
                    chosen = Some(action);
                }
            });
        }
    });
    chosen
}
