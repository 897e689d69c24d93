//! Moving the view: wheel, touchpad, two fingers, dragging.

use egui::{Rect, Response, Ui, Vec2};

use super::view::View;
use crate::editor::wheel::Wheel;

/// A turn of the wheel that would scroll so many points zooms by the factor e: as egui zooms with Ctrl.
const WHEEL: f32 = 200.0;

/// Moves `view`, which is shown in `room`, by the `wheel`, by two fingers, and by dragging while it is `grabbed`. Returns
/// whether it moved.
pub fn navigate(
    ui: &Ui,
    response: &Response,
    room: Rect,
    view: &mut View,
    wheel: Wheel,
    grabbed: bool,
) -> bool {
    let before = *view;
    if grabbed && response.dragged() {
        view.pan(response.drag_delta());
    }
    if response.contains_pointer() {
        let (scroll, zoom, touch, at) = ui.input(|input| {
            (input.smooth_scroll_delta(), input.zoom_delta(), input.multi_touch(), input.pointer.hover_pos())
        });
        let (scroll, zoom) = match (touch, wheel) {
            (Some(touch), _) => (touch.translation_delta, zoom),
            (None, Wheel::Pan) => (scroll, zoom),
            (None, Wheel::Zoom) => (Vec2::new(scroll.x, 0.0), zoom * (scroll.y / WHEEL).exp()),
        };
        if scroll != Vec2::ZERO {
            view.pan(scroll);
        }
        if zoom != 1.0 {
            // Two fingers zoom about the point between them.
            let at = touch.map(|touch| touch.center_pos).or(at);
            view.zoom_at(room, at.unwrap_or(room.center()), zoom);
        }
    }
    *view != before
}
