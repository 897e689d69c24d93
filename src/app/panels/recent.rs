//! The menu of recent documents: for each a small sketch, its name and its folder.

use std::path::{Path, PathBuf};

use egui::{Align2, Color32, Rect, Response, Role, Sense, TextStyle, Ui, WidgetInfo, pos2, vec2};

use crate::app::action::Action;
use crate::app::small_sketch;
use crate::editor::recent_sketches::RecentSketches;

/// Width and height of an entry, points.
const ROW: egui::Vec2 = vec2(300.0, 42.0);
/// Width and height of a small sketch, points.
const SKETCH: egui::Vec2 = vec2(48.0, 36.0);

/// Shows the menu of these documents, the latest first.
pub fn recent(ui: &mut Ui, paths: &[PathBuf], sketches: &RecentSketches, actions: &mut Vec<Action>) {
    if !sketches.is_busy() && paths.iter().any(|path| sketches.of(path).is_none()) {
        actions.push(Action::ReadRecent);
    }
    for path in paths {
        if entry(ui, path, sketches).on_hover_text(path.display().to_string()).clicked() {
            actions.push(Action::OpenFile(path.clone()));
            ui.close();
        }
    }
    ui.separator();
    if ui.button("Clear this list").clicked() {
        actions.push(Action::ForgetRecent);
        ui.close();
    }
}

fn entry(ui: &mut Ui, path: &Path, sketches: &RecentSketches) -> Response {
    let (rect, response) = ui.allocate_exact_size(ROW, Sense::click());
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().unwrap_or(Path::new("")).display().to_string();
    let known = sketches.of(path);
    let is_gone = matches!(known, Some(None));
    let below = if is_gone { format!("cannot be read: {folder}") } else { folder };
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, format!("{name}, {below}")));
    let visuals = *ui.style().interact(&response);
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 4.0, visuals.weak_bg_fill);
    }
    let sketch = Rect::from_min_size(rect.min + vec2(3.0, 3.0), SKETCH);
    if let Some(Some(known)) = known {
        small_sketch::paint(ui, sketch, known.size, &known.marks);
    }
    let left = sketch.right() + 8.0;
    let room = Rect::from_min_max(pos2(left, rect.top()), pos2(rect.right() - 4.0, rect.bottom()));
    let weak = ui.visuals().weak_text_color();
    let colour = if is_gone { weak } else { visuals.text_color() };
    line(ui, room, rect.top() + 13.0, &name, &TextStyle::Button, colour);
    line(ui, room, rect.bottom() - 12.0, &below, &TextStyle::Small, weak);
    response
}

/// A line of text from the left end of `room`. Where it is too long, its beginning is left out: the end of a folder tells more.
fn line(ui: &Ui, room: Rect, y: f32, text: &str, style: &TextStyle, colour: Color32) {
    let font = style.resolve(ui.style());
    let width = |text: &str| ui.painter().layout_no_wrap(text.to_owned(), font.clone(), colour).size().x;
    let mut shown = text.to_owned();
    while width(&shown) > room.width() && shown.chars().count() > 2 {
        shown = std::iter::once('…').chain(shown.chars().skip(2)).collect();
    }
    ui.painter().text(pos2(room.left(), y), Align2::LEFT_CENTER, shown, font, colour);
}
