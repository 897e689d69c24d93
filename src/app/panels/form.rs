//! Parts that the tabs share: headings, rows of a name and a value, preset line widths.

use egui::{Button, Grid, Rect, RichText, Ui, vec2};

use crate::editor::units::Ruler;

/// Preset widths of lines, px: evenly spaced over the widths whose stripes grow within seconds.
const WIDTHS: [f64; 4] = [4.0, 8.0, 12.0, 16.0];

/// A heading.
pub fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(8.0);
    ui.label(RichText::new(text).strong());
}

/// Rows of a name and a value.
pub fn rows(ui: &mut Ui, id: &str, add: impl FnOnce(&mut Ui)) {
    Grid::new(id).num_columns(2).min_col_width(72.0).spacing(vec2(10.0, 7.0)).show(ui, add);
}

/// A button for each preset width; the button shows a line of that width. Returns whether one was clicked.
pub fn presets(ui: &mut Ui, width: &mut f64, ruler: Ruler) -> bool {
    let mut changed = false;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for preset in WIDTHS {
            let chosen = (*width - preset).abs() < 0.05;
            let size = vec2(46.0, 26.0);
            let button = ui.add_sized(size, Button::new("").selected(chosen));
            let colour = if chosen {
                ui.visuals().selection.stroke.color
            } else {
                ui.style().interact(&button).text_color()
            };
            let bar = Rect::from_center_size(button.rect.center(), vec2(26.0, preset as f32));
            ui.painter().rect_filled(bar, 2.0, colour);
            let name = format!("{} wide", ruler.rough(preset));
            let button = button.accessible_name(&name);
            if button.on_hover_text(&name).clicked() {
                *width = preset;
                changed = true;
            }
        }
    });
    changed
}
