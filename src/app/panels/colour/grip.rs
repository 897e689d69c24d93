//! Keys for what can be dragged: arrows move it, Delete removes it.

use egui::{EventFilter, Key, Modifiers, Response, Ui};

/// Steps to the right and up by the arrow keys, where `response` has the keyboard focus: 1 each, 10 with Shift.
pub fn arrows(ui: &Ui, response: &Response) -> [f64; 2] {
    if !response.has_focus() {
        return [0.0; 2];
    }
    let filter = EventFilter { tab: false, horizontal_arrows: true, vertical_arrows: true, escape: false };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    ui.input_mut(|input| {
        let mut count = |key| {
            let many = 10 * input.count_and_consume_key(Modifiers::SHIFT, key);
            (many + input.count_and_consume_key(Modifiers::NONE, key)) as f64
        };
        let [left, right] = [Key::ArrowLeft, Key::ArrowRight].map(&mut count);
        let [down, up] = [Key::ArrowDown, Key::ArrowUp].map(&mut count);
        [right - left, up - down]
    })
}

/// Whether Delete or Backspace was pressed where `response` has the keyboard focus.
pub fn deleted(ui: &Ui, response: &Response) -> bool {
    response.has_focus()
        && ui.input_mut(|input| {
            let mut count = |key| input.count_and_consume_key(Modifiers::NONE, key);
            count(Key::Delete) + count(Key::Backspace) > 0
        })
}

/// `value` rounded to three decimals: finer than a point of the screen.
pub fn rounded(value: f64) -> f64 {
    (1e3 * value).round() / 1e3
}
