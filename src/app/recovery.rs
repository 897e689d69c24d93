//! The page that offers documents which were not saved before dapple was closed.

use std::time::Duration;

use egui::{Button, Frame, Label, Layout, RichText, Role, ScrollArea, Sense, Ui, WidgetInfo, vec2};

use super::small_screen::fit_width;
use crate::app::action::{Action, Page};
use crate::app::small_sketch;
use crate::app::theme::Palette;
use crate::editor::recovery::{LostDocument, Recovery};

/// Width and height of the small sketches, points.
const SKETCH: [f32; 2] = [92.0, 70.0];

/// Shows the page; returns the action that was chosen. `asked` is the document for which *Discard* was pressed once; a
/// second press deletes it.
pub fn page(ui: &mut Ui, recovery: &Recovery, asked: &mut Option<String>) -> Option<Action> {
    fit_width(ui, 560.0);
    ui.heading("Unsaved work was found");
    ui.label(match recovery.lost().len() {
        0 if recovery.is_searching() => "Searching …",
        0 => "All of it has been restored, saved or discarded.",
        1 => "dapple was closed before this was saved. At most the last few seconds of it are missing.",
        _ => "dapple was closed before these were saved. At most the last few seconds of each are missing.",
    });
    ui.add_space(6.0);
    let mut action = None;
    let height = (ui.ctx().content_rect().height() - 260.0).clamp(120.0, 420.0);
    ScrollArea::vertical().max_height(height).show(ui, |ui| {
        fit_width(ui, 560.0);
        for (index, lost) in recovery.lost().iter().enumerate() {
            action = action.take().or(one(ui, lost, index == 0, asked));
        }
    });
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        let later = Button::new(if recovery.lost().is_empty() { "Close" } else { "Decide later" });
        let help = "You can decide at the next start, or under File, Recover unsaved work";
        if ui.add(later.min_size(vec2(96.0, 28.0))).on_hover_text(help).clicked() {
            action = Some(Action::Page(Page::Recovery));
        }
    });
    action
}

fn one(ui: &mut Ui, lost: &LostDocument, first: bool, asked: &mut Option<String>) -> Option<Action> {
    let mut action = None;
    let id = lost.id();
    let fill = ui.visuals().faint_bg_color;
    Frame::NONE.fill(fill).corner_radius(7).inner_margin(10).show(ui, |ui| {
        fit_width(ui, 540.0);
        ui.horizontal(|ui| {
            sketch(ui, lost);
            ui.add_space(4.0);
            ui.vertical(|ui| {
                fit_width(ui, (ui.available_width() - 140.0).min(262.0));
                ui.spacing_mut().item_spacing.y = 3.0;
                description(ui, lost);
            });
            ui.with_layout(Layout::top_down(egui::Align::Max), |ui| {
                let text = RichText::new("Restore").color(ui.visuals().selection.stroke.color);
                let restore = Button::new(text).fill(ui.visuals().selection.bg_fill);
                let restore = ui.add_sized(vec2(132.0, 28.0), restore);
                let restore = restore.on_hover_text("Opens it; it is not saved yet");
                if first && ui.memory(|memory| memory.focused().is_none()) {
                    restore.request_focus();
                }
                if restore.clicked() {
                    action = Some(Action::Restore(id.clone()));
                }
                let sure = asked.as_ref() == Some(&id);
                let text = if sure {
                    RichText::new("Discard permanently").color(Palette::current(ui.visuals()).wrong)
                } else {
                    RichText::new("Discard")
                };
                let discard = ui.add_sized(vec2(132.0, 28.0), Button::new(text));
                if discard.on_hover_text("Deletes it, after asking once more").clicked() {
                    if sure {
                        action = Some(Action::Discard(id.clone()));
                    }
                    *asked = Some(id.clone());
                }
            });
        });
    });
    action
}

/// Its name, age, size and file.
fn description(ui: &mut Ui, lost: &LostDocument) {
    ui.add(Label::new(RichText::new(&lost.backup.name).strong()).truncate());
    let marks = lost.marks.len();
    let marks = if marks == 1 { "1 mark".to_owned() } else { format!("{marks} marks") };
    let [width, height] = lost.backup.document.size;
    let age = lost.when.elapsed().unwrap_or_default();
    ui.label(RichText::new(format!("{}, {marks} on {width} × {height} px", ago(age))).small());
    let from = match &lost.backup.path {
        Some(path) if lost.file_is_gone => format!("{} (the file no longer exists)", path.display()),
        Some(path) => path.display().to_string(),
        None => "Never saved to a file".to_owned(),
    };
    ui.add(Label::new(RichText::new(&from).small().weak()).truncate()).on_hover_text(&from);
    if lost.file_is_newer {
        let colour = Palette::current(ui.visuals()).wrong;
        let text = "The file is newer than this";
        ui.label(RichText::new(text).small().color(colour));
    }
}

fn sketch(ui: &mut Ui, lost: &LostDocument) {
    let (room, response) = ui.allocate_exact_size(SKETCH.into(), Sense::hover());
    let name = format!("Sketch of {}", lost.backup.name);
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
    small_sketch::paint(ui, room, lost.backup.document.size, &lost.marks);
}

/// An age in words.
fn ago(age: Duration) -> String {
    let minutes = age.as_secs() / 60;
    let (number, unit) = match minutes {
        0 => return "Less than a minute ago".to_owned(),
        1..60 => (minutes, "minute"),
        60..1440 => (minutes / 60, "hour"),
        _ => (minutes / 1440, "day"),
    };
    format!("{number} {unit}{} ago", if number == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_are_told_in_the_largest_whole_unit() {
        let told = |seconds| ago(Duration::from_secs(seconds));
        assert_eq!(told(59), "Less than a minute ago");
        assert_eq!(told(60), "1 minute ago");
        assert_eq!(told(7200), "2 hours ago");
        assert_eq!(told(90_000), "1 day ago");
    }
}
