//! The status line: how the tool is used, the pointer's position, the zoom, the export in progress.

use egui::{Align, Button, Layout, ProgressBar, RichText, Ui};

use crate::app::action::Action;
use crate::app::canvas::Canvas;
use crate::app::exporting::Exporting;
use crate::editor::units::Ruler;

/// Shows the line. `closed`: what a closed stroke becomes, with its article. `unfolded`: on a narrow screen, whether the column on the right is shown. There a button unfolds it,
/// and the help on the tool is left out.
pub fn status(
    ui: &mut Ui,
    canvas: &Canvas,
    closed: &str,
    ruler: Ruler,
    exporting: Option<&Exporting>,
    unfolded: Option<bool>,
) -> Option<Action> {
    let mut action = None;
    ui.horizontal_centered(|ui| {
        if unfolded.is_none() {
            ui.label(RichText::new(canvas.tool.help(closed)).small().weak());
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if let Some(unfolded) = unfolded
                && ui.selectable_label(unfolded, "Panels").clicked()
            {
                action = Some(Action::ToggleColumn);
            }
            let zoom = 100.0 * canvas.view.zoom * ui.pixels_per_point();
            ui.label(RichText::new(format!("{zoom:.0} %")).small());
            if let Some(position) = canvas.pointer {
                ui.label(RichText::new(ruler.place(position)).small().weak());
            }
            if let Some(exporting) = exporting {
                let is_cancelled = exporting.is_cancelled();
                let button = ui.add_enabled(!is_cancelled, Button::new("Cancel").small());
                if button.on_hover_text("Cancel the export").clicked() {
                    action = Some(Action::CancelExport);
                }
                ui.add(ProgressBar::new(exporting.progress()).desired_width(120.0).desired_height(6.0));
                let name = exporting.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
                let doing =
                    if is_cancelled { "Cancelling …".to_owned() } else { format!("Writing {name}") };
                ui.label(RichText::new(doing).small());
            }
        });
    });
    action
}
