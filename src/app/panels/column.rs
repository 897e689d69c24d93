//! The column on the right: a tab for drawing, colours or results; below it, the layers.

use egui::{Button, CentralPanel, Frame, Margin, Panel, ScrollArea, Ui, vec2};

use crate::app::action::{Action, Tab};

/// Shows the tabs, the content of the current one, and `layers` below them.
pub fn column(
    ui: &mut Ui,
    current: Tab,
    layers: impl FnOnce(&mut Ui) -> Vec<Action>,
    content: impl FnOnce(&mut Ui) -> Vec<Action>,
) -> Vec<Action> {
    let mut actions = Vec::new();
    let frame = Frame::NONE.inner_margin(Margin { top: 8, ..Margin::ZERO });
    let below = Panel::bottom("layers").frame(frame).resizable(false);
    below.show(ui, |ui| actions.extend(layers(ui)));
    CentralPanel::no_frame().show(ui, |ui| {
        ui.horizontal(|ui| {
            for tab in Tab::ALL {
                let button = Button::new(tab.name()).selected(tab == current);
                if ui.add_sized(vec2(64.0, 26.0), button).clicked() {
                    actions.push(Action::Tab(tab));
                }
            }
        });
        ui.add_space(6.0);
        let area = ScrollArea::vertical().id_salt(current.name()).auto_shrink([false; 2]);
        area.show(ui, |ui| actions.extend(content(ui)));
    });
    actions
}
