//! The column on the right: a tab for drawing, the canvas, colours or results; below it, the layers.

use egui::{Button, CentralPanel, Frame, Margin, Panel, ScrollArea, Ui, vec2};

use crate::app::action::{Action, Tab};
use crate::app::result::Verdict;
use crate::app::theme::Palette;

/// Shows the tabs, the content of the current one, and `layers` below them. The column keeps its width whatever its
/// content is. `is_missed`: something did not grow as it was drawn; a sign on *Result* shows that.
pub fn column(
    ui: &mut Ui,
    current: Tab,
    is_missed: bool,
    layers: impl FnOnce(&mut Ui) -> Vec<Action>,
    content: impl FnOnce(&mut Ui) -> Vec<Action>,
) -> Vec<Action> {
    let mut actions = Vec::new();
    let frame = Frame::NONE.inner_margin(Margin { top: 8, ..Margin::ZERO });
    let below = Panel::bottom("layers").frame(frame).resizable(false);
    below.show(ui, |ui| actions.extend(layers(ui)));
    CentralPanel::no_frame().show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.spacing_mut().button_padding.x = 4.0;
            let width = (ui.available_width() - 3.0 * 4.0) / Tab::ALL.len() as f32;
            for tab in Tab::ALL {
                let button = Button::new(tab.name()).selected(tab == current);
                let button = ui.add_sized(vec2(width, 26.0), button);
                if is_missed && tab == Tab::Result {
                    let sign = Verdict::corner(button.rect, 12.0, 1.0);
                    Verdict::Missed.paint(ui.painter(), sign, Palette::current(ui.visuals()));
                }
                if button.clicked() {
                    actions.push(Action::Tab(tab));
                }
                if is_missed && tab == Tab::Result {
                    button.on_hover_text("Something did not grow as you drew it");
                }
            }
        });
        ui.add_space(6.0);
        let area = ScrollArea::vertical().id_salt(current.name()).auto_shrink([false; 2]);
        area.show(ui, |ui| actions.extend(content(ui)));
    });
    actions
}
