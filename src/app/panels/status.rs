//! The line at the bottom: the tool, the place, the export.

use egui::{Align, Layout, ProgressBar, RichText, Ui};

use crate::app::Window;

/// The line.
pub fn status(ui: &mut Ui, window: &Window) {
    ui.horizontal_centered(|ui| {
        let tool = window.canvas.tool;
        ui.label(RichText::new(tool.help()).small().weak());
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.label(
                RichText::new(format!("{:.0} %", 100.0 * window.canvas.view.zoom * ui.pixels_per_point()))
                    .small(),
            );
            if let Some(place) = window.canvas.pointer {
                ui.label(RichText::new(window.ruler().place(place)).small().weak());
            }
            if let Some(exporting) = &window.exporting {
                if ui.small_button("Cancel").on_hover_text("Give the export up").clicked() {
                    exporting.cancel();
                }
                ui.add(ProgressBar::new(exporting.progress()).desired_width(120.0).desired_height(6.0));
                let name = exporting.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                ui.label(RichText::new(format!("Writing {name}")).small());
            }
        });
    });
}
