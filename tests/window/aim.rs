//! Clicks on controls that may move in the meantime.

use egui::{Event, Modifiers, PointerButton, Pos2, Rect};
use egui_kittest::Harness;

/// How often the user aims again at a control that moves away.
const AIMS: usize = 20;

/// Moves the pointer to the control that `find` finds (`name` names it in messages), presses the button and releases
/// it, one frame each. Messages of a growth may move the controls below them: where the control has moved away from the
/// pointer, the user aims again.
#[track_caller]
pub fn click_on<State>(
    window: &mut Harness<'static, State>,
    name: &str,
    find: impl Fn(&Harness<'static, State>) -> Option<Rect>,
) {
    let button = |pos, pressed| {
        let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
        Event::PointerButton { pos, button, pressed, modifiers }
    };
    for _ in 0..AIMS {
        let at = find(window).unwrap_or_else(|| panic!("no {name}")).center();
        let is_there = |window: &Harness<'static, State>| find(window).is_some_and(|rect| rect.contains(at));
        window.hover_at(at);
        window.step();
        // The control under a press is found by the places of the frame before.
        if !is_there(window) {
            continue;
        }
        window.event(button(at, true));
        window.step();
        if is_there(window) {
            window.event(button(at, false));
            window.step();
            return;
        }
        // A release far from the press is not a click.
        window.hover_at(Pos2::ZERO);
        window.event(button(Pos2::ZERO, false));
        window.step();
    }
    panic!("{name} does not stay in its place");
}
