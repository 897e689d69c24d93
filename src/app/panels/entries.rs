//! The entries of a menu, which are also reached by the arrow keys.

use egui::{Button, EventFilter, Id, Key, Response, Ui};

use crate::app::action::Action;
use crate::app::shortcuts;

/// The entries of a menu while it is shown, and the actions of those that are clicked.
pub struct Entries<'a> {
    /// The actions that the user asks for.
    pub actions: &'a mut Vec<Action>,
    /// The entries that can be chosen, from top to bottom.
    ids: Vec<Id>,
}

impl<'a> Entries<'a> {
    /// A menu without entries yet.
    pub fn new(actions: &'a mut Vec<Action>) -> Self {
        Self { actions, ids: Vec::new() }
    }

    /// An entry with its keys.
    pub fn item(&mut self, ui: &mut Ui, text: &str, action: &Action, enabled: bool) {
        let keys = shortcuts::shortcut_text(ui.ctx(), action).unwrap_or_default();
        self.item_with(ui, text, &keys, action, enabled);
    }

    /// An entry with these keys behind it.
    pub fn item_with(&mut self, ui: &mut Ui, text: &str, keys: &str, action: &Action, enabled: bool) {
        let button = ui.add_enabled(enabled, Button::new(text).shortcut_text(keys));
        self.take(ui, &button, action);
    }

    /// An entry that is on or off.
    pub fn check(&mut self, ui: &mut Ui, text: &str, on: bool, action: &Action, enabled: bool) {
        let mut value = on;
        let button = ui.add_enabled_ui(enabled, |ui| ui.checkbox(&mut value, text)).inner;
        self.take(ui, &button, action);
    }

    /// One of several entries of which one is chosen.
    pub fn radio(&mut self, ui: &mut Ui, text: &str, chosen: bool, action: &Action) {
        let button = ui.radio(chosen, text);
        self.take(ui, &button, action);
    }

    /// Another widget that takes part in the order of the arrow keys.
    pub fn reach(&mut self, response: &Response) {
        if response.enabled() {
            self.ids.push(response.id);
        }
    }

    fn take(&mut self, ui: &Ui, response: &Response, action: &Action) {
        self.reach(response);
        if response.clicked() {
            self.actions.push(action.clone());
            ui.close();
        }
    }

    /// Moves the keyboard focus by the arrow keys, after all entries; `first`: to the first one. Returns whether that
    /// was possible; it is not in the frame in which egui measures the menu.
    pub fn navigate(self, ui: &Ui, first: bool) -> bool {
        if self.ids.is_empty() || ui.is_sizing_pass() {
            return false;
        }
        let focused = ui.memory(egui::Memory::focused);
        let place = focused.and_then(|focused| self.ids.iter().position(|id| *id == focused));
        let pressed = |key| ui.input(|input| input.num_presses(key)) as isize;
        let by = pressed(Key::ArrowDown) - pressed(Key::ArrowUp);
        let entries = self.ids.len() as isize;
        let next = match place {
            _ if first => Some(0),
            Some(place) => Some((place as isize + by).rem_euclid(entries)),
            None if by != 0 => Some(if by > 0 { 0 } else { entries - 1 }),
            None => None,
        };
        if let Some(next) = next {
            let id = self.ids[next as usize];
            let filter =
                EventFilter { tab: false, horizontal_arrows: true, vertical_arrows: true, escape: false };
            ui.memory_mut(|memory| {
                memory.request_focus(id);
                memory.set_focus_lock_filter(id, filter);
            });
        }
        true
    }
}
