//! The menu of the selected marks or of the canvas.

use egui::{Pos2, Ui};

use super::Window;
use crate::app::action::Action;
use crate::app::panels;

/// Where the menu was opened.
#[derive(Clone, Copy, Debug, Default)]
pub struct ContextMenu {
    /// Its place on the screen, and whether it has not been shown there yet.
    place: Option<(Pos2, bool)>,
    /// The place on the canvas, px, where *Paste* puts marks.
    pub(super) at: Option<[f64; 2]>,
}

impl Window {
    /// Opens the menu where the secondary button was clicked, and shows it.
    pub(super) fn context_menu(&mut self, ui: &mut Ui) -> Vec<Action> {
        if let Some((on_screen, on_canvas)) = self.canvas.menu_asked.take() {
            self.context = ContextMenu { place: Some((on_screen, true)), at: Some(on_canvas) };
        }
        let Some((at, opens)) = self.context.place else { return Vec::new() };
        let (actions, shown) = panels::context_menu(ui, at, opens, &self.session);
        self.context.place = shown.map(|has_focus| (at, opens && !has_focus));
        if shown.is_none() && actions.is_empty() {
            self.context.at = None;
        }
        actions
    }

    /// Opens the menu by key: beside the selected marks, else in the middle of the view.
    pub(super) fn open_context_menu(&mut self) {
        let center = self.session.selected().next().map(|(_, mark)| mark.center());
        self.canvas.ask_menu(center.unwrap_or(self.canvas.view.center));
    }
}
