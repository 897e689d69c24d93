//! Placement of the window on the screen and what it shows, kept from one run to the next.

use egui::{Ui, ViewportBuilder};

use super::Window;
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

impl Window {
    /// Restores what was shown last.
    pub(super) fn restore_layout(&mut self) {
        let layout = &self.settings.layout;
        self.tab = layout.tab;
        self.over = layout.over;
        self.curtain = layout.curtain;
        self.linked = layout.linked;
        self.canvas.overlays.regions = layout.regions;
        self.canvas.overlays.analysis = layout.analysis;
        self.canvas.overlays.wanted = layout.wanted;
        self.canvas.snap = layout.snap;
    }

    /// Records the placement in the settings, which are written when the window closes.
    pub(super) fn note_layout(&mut self, ui: &Ui) {
        let layout = &mut self.settings.layout;
        layout.tab = self.tab;
        layout.over = self.over;
        layout.curtain = self.curtain;
        layout.linked = self.linked;
        layout.regions = self.canvas.overlays.regions;
        layout.analysis = self.canvas.overlays.analysis;
        layout.wanted = self.canvas.overlays.wanted;
        layout.snap = self.canvas.snap;
        ui.input(|input| {
            let viewport = input.viewport();
            if viewport.minimized == Some(true) || viewport.fullscreen == Some(true) {
                return;
            }
            layout.maximised = viewport.maximized == Some(true);
            if layout.maximised {
                // The size before it was maximised is kept.
                return;
            }
            if let Some(inner) = viewport.inner_rect {
                layout.size = Some(inner.size().into());
            }
            if let Some(outer) = viewport.outer_rect {
                layout.position = Some(outer.min.into());
            }
        });
    }

    /// The window closes: waits for files that are being written, and writes the settings.
    pub fn leave(&mut self) {
        self.finish_saving();
        self.finish_palette();
        self.finish_settings();
    }
}
