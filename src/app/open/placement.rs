//! Where the window opens on the screen.

use egui::ViewportBuilder;

use crate::app::settings::Layout;

/// Width and height of the first window, points.
const SIZE: [f32; 2] = [1280.0, 800.0];
/// Length of the window's upper edge that must be on a screen, px of the screen.
const SEEN: i32 = 60;

/// The window with its last placement, as far as the platform allows.
#[must_use]
pub fn placed(layout: &Layout) -> ViewportBuilder {
    let builder = ViewportBuilder::default()
        .with_inner_size(layout.size.unwrap_or(SIZE))
        .with_maximized(layout.maximised);
    match layout.position {
        Some(position) => builder.with_position(position),
        None => builder,
    }
}

/// Moves a window that would be outside all screens to the first one.
pub fn bring_into_view(cc: &eframe::CreationContext<'_>) {
    let Some(window) = cc.winit_window() else { return };
    // A platform that does not report the position has chosen it itself.
    let Ok(corner) = window.outer_position() else { return };
    let width = i32::try_from(window.outer_size().width).unwrap_or(i32::MAX);
    let seen = window.available_monitors().any(|monitor| {
        let (at, size) = (monitor.position(), monitor.size());
        let [right, bottom] = [(at.x, size.width), (at.y, size.height)]
            .map(|(from, side)| from.saturating_add(i32::try_from(side).unwrap_or(i32::MAX)));
        let across = corner.x.saturating_add(width).min(right) - corner.x.max(at.x);
        across >= SEEN && (at.y - SEEN / 2..bottom - SEEN).contains(&corner.y)
    });
    let Some(monitor) = window.available_monitors().next().filter(|_| !seen) else { return };
    window.set_outer_position(monitor.position());
}
