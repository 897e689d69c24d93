//! Placement of the window on the screen, and what is shown in it, kept from one run to the next.

use egui::Ui;

use super::Window;

impl Window {
    /// Restores what was shown last.
    pub(super) fn restore_layout(&mut self) {
        let layout = &self.settings.layout;
        self.tab = layout.tab;
        self.over = layout.over;
        self.curtain = layout.curtain;
        self.linked = layout.linked;
        self.goals.shown = layout.goals;
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
        layout.goals = self.goals.shown;
        layout.regions = self.canvas.overlays.regions;
        layout.analysis = self.canvas.overlays.analysis;
        layout.wanted = self.canvas.overlays.wanted;
        layout.snap = self.canvas.snap;
        let scale = ui.ctx().zoom_factor();
        ui.input(|input| {
            let viewport = input.viewport();
            if viewport.minimized == Some(true) || viewport.fullscreen == Some(true) {
                return;
            }
            layout.maximised = viewport.maximized == Some(true);
            if layout.maximised {
                // The size from before the window was maximised is kept.
                return;
            }
            // A window opens with a size in points of the system, whatever the scale of the interface is.
            if let Some(inner) = viewport.inner_rect {
                layout.size = Some((inner.size() * scale).into());
            }
            if let Some(outer) = viewport.outer_rect {
                layout.position = Some((outer.min.to_vec2() * scale).into());
            }
        });
    }

    /// Called when the window closes: waits for files that are being written, and writes the settings.
    pub fn leave(&mut self) {
        self.finish_saving();
        self.finish_palette();
        self.finish_settings();
    }
}
