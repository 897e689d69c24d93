//! Shows which control has the keyboard focus, while the keyboard is used.

use egui::{Event, FocusDirection, Id, Key, LayerId, Modifiers, Order, Stroke, StrokeKind, Ui};

use super::Window;
use crate::app::theme::Palette;

/// Keys that operate the control that has the focus, or move the focus from it.
const MOVES: [Key; 6] =
    [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown, Key::Enter, Key::Space];

impl Window {
    /// Whether the Tab key was pressed to hide or show the panels. While controls are chosen with the keyboard, it moves the
    /// focus from one to the next.
    pub(super) fn panels_key(&self, ui: &Ui) -> bool {
        let focused = ui.memory(egui::Memory::focused);
        let is_drawing = focused.is_none_or(|id| self.canvas.id == Some(id)) && !self.by_keys;
        let pressed = is_drawing
            && !self.menu_open
            && ui
                .input_mut(|input| input.modifiers.is_none() && input.consume_key(Modifiers::NONE, Key::Tab));
        if pressed {
            ui.memory_mut(|memory| memory.move_focus(FocusDirection::None));
        }
        pressed
    }

    /// Paints a frame around the control that has the focus, after all controls. Not while the pointer is used, and not around
    /// the canvas and text fields, which show it themselves.
    pub(super) fn focus_frame(&mut self, ui: &Ui) {
        let focused = ui.memory(egui::Memory::focused);
        let on_control = focused.is_some_and(|id| self.canvas.id != Some(id));
        ui.input(|input| {
            for event in &input.events {
                match event {
                    Event::Key { key: Key::Tab, pressed: true, .. } => self.by_keys = true,
                    Event::Key { key, pressed: true, .. } if on_control && MOVES.contains(key) => {
                        self.by_keys = true;
                    }
                    Event::PointerButton { pressed: true, .. } => self.by_keys = false,
                    _ => {}
                }
            }
        });
        let Some(id) = focused.filter(|_| self.by_keys) else { return };
        if self.canvas.id == Some(id) || ui.text_edit_focused() {
            return;
        }
        let Some(control) = ui.ctx().read_response(id) else { return };
        let rect = control.interact_rect.expand(1.5);
        if control.interact_rect.is_positive() {
            let painter = ui.ctx().layer_painter(LayerId::new(Order::Tooltip, Id::unique("focus")));
            let accent = Palette::current(ui.visuals()).accent;
            painter.rect_stroke(rect, 4.0, Stroke::new(2.0, accent), StrokeKind::Outside);
        }
    }
}
