//! Shows which control has the keyboard focus, while the keyboard is used.

use egui::{Event, Id, Key, LayerId, Order, Stroke, StrokeKind, Ui};

use super::Window;
use crate::app::theme::Palette;

/// Keys that move the focus, or operate the control that has it.
const MOVES: [Key; 7] =
    [Key::Tab, Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown, Key::Enter, Key::Space];

impl Window {
    /// Paints a frame around the control that has the focus, after all controls. Not while the pointer is used, and not around
    /// the canvas and text fields, which show it themselves.
    pub(super) fn focus_frame(&mut self, ui: &Ui) {
        ui.input(|input| {
            for event in &input.events {
                match event {
                    Event::Key { key, pressed: true, .. } if MOVES.contains(key) => self.by_keys = true,
                    Event::PointerButton { pressed: true, .. } => self.by_keys = false,
                    _ => {}
                }
            }
        });
        let Some(id) = ui.memory(egui::Memory::focused).filter(|_| self.by_keys) else { return };
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
