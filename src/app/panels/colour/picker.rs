//! The colour picker: saturation and brightness above, hue and opacity below; by pointer and arrow keys; numbers in three
//! colour models.

use egui::ecolor::{Hsva, HsvaGamma};
use egui::{
    Color32, DragValue, Pos2, Rect, Sense, Shape, Stroke, StrokeKind, Ui, Vec2, WidgetInfo, epaint::Mesh,
    pos2, vec2,
};

use super::ColourPanel;
use super::grip::arrows;
use super::hex_field::hex_field;
use crate::app::checkerboard;
use crate::app::theme::Palette;
use crate::app::units::number_field;
use crate::colour::ColourModel;
use crate::document::Stop;

/// Shows the picker. `fresh`: a key has just opened it, so it takes the keyboard focus.
pub fn picker(ui: &mut Ui, panel: &mut ColourPanel, stop: &mut Stop, fresh: bool) {
    ui.set_width(200.0);
    pads(ui, &mut panel.hsv, &mut stop.colour, fresh);
    opacity(ui, stop);
    fields(ui, panel, &mut stop.colour);
    hex_field(ui, panel, stop, "Picked colour in hexadecimal digits");
}

/// The opacity of the stop, as a pad and as a number.
fn opacity(ui: &mut Ui, stop: &mut Stop) {
    let [red, green, blue] = stop.colour;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let size = vec2(130.0, 20.0);
        checkerboard::paint(ui.painter(), Rect::from_min_size(ui.cursor().min, size));
        let before = f32::from(stop.alpha) / 255.0;
        let faded = |x: f32, _| Color32::from_rgba_unmultiplied(red, green, blue, (255.0 * x).round() as u8);
        let [shown, _] = pad(ui, "Opacity", size, [before, 0.5], [24, 1], false, faded);
        if shown != before {
            stop.alpha = (255.0 * shown).round() as u8;
        }
        let mut percent = 100.0 * f64::from(stop.alpha) / 255.0;
        let field = DragValue::new(&mut percent).range(0.0..=100.0).speed(0.5).max_decimals(0);
        let field = ui.add_sized(vec2(64.0, 22.0), number_field(field, " %"));
        if field.accessible_name("Opacity in per cent").on_hover_text("0 = transparent").changed() {
            stop.alpha = (2.55 * percent).round() as u8;
        }
    });
}

/// The three coordinates of the colour as numbers, in the model that is chosen.
fn fields(ui: &mut Ui, panel: &mut ColourPanel, colour: &mut [u8; 3]) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (model, name) in ColourModel::ALL {
            ui.selectable_value(&mut panel.model, model, name);
        }
    });
    let model = panel.model;
    // The typed numbers are kept: hue and chroma of a gray would be lost otherwise, and rounding to 8 bits would change
    // the other numbers.
    let known = panel.typed.filter(|(of, by, _)| of == colour && *by == model);
    let mut values = known.map_or_else(|| model.of(*colour), |(_, _, values)| values);
    let mut has_changed = false;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (value, coordinate) in values.iter_mut().zip(model.coordinates()) {
            let field = DragValue::new(value)
                .range(0.0..=coordinate.most)
                .clamp_existing_to_range(false)
                .speed(coordinate.most / 400.0);
            let field = number_field(field.max_decimals(coordinate.decimals), coordinate.unit);
            let field = ui.add_sized(vec2(64.0, 22.0), field.prefix(format!("{} ", coordinate.letter)));
            has_changed |= field.accessible_name(coordinate.name).on_hover_text(coordinate.name).changed();
        }
    });
    if has_changed {
        *colour = model.colour(values);
        panel.typed = Some((*colour, model, values));
    }
}

fn pads(ui: &mut Ui, known: &mut Option<([u8; 3], HsvaGamma)>, colour: &mut [u8; 3], fresh: bool) {
    let found = known.filter(|(of, _)| of == colour).map(|(_, hsv)| hsv);
    let mut hsv = found.unwrap_or_else(|| HsvaGamma::from(Hsva::from_srgb(*colour)));
    hsv.a = 1.0;
    let before = hsv;
    let hue = hsv.h;
    let at = |s, v| Color32::from(HsvaGamma { h: hue, s, v, a: 1.0 });
    let [s, v] =
        pad(ui, "Saturation and brightness", vec2(200.0, 124.0), [hsv.s, hsv.v], [20, 14], fresh, at);
    (hsv.s, hsv.v) = (s, v);
    let rainbow = |h, _| Color32::from(HsvaGamma { h, s: 1.0, v: 1.0, a: 1.0 });
    let [h, _] = pad(ui, "Hue", vec2(200.0, 20.0), [hsv.h, 0.5], [48, 1], false, rainbow);
    hsv.h = h;
    if hsv != before {
        let [red, green, blue, _] = Color32::from(hsv).to_array();
        *colour = [red, green, blue];
    }
    *known = Some((*colour, hsv));
}

/// A field of colours, and a position in it: 0..1 to the right and upwards.
fn pad(
    ui: &mut Ui,
    name: &str,
    size: Vec2,
    [mut x, mut y]: [f32; 2],
    [columns, rows]: [usize; 2],
    fresh: bool,
    colour: impl Fn(f32, f32) -> Color32,
) -> [f32; 2] {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let label = format!("{name}, {:.0} %", 100.0 * x);
    response.widget_info(|| WidgetInfo::slider(true, f64::from(x), &label));
    if fresh {
        response.request_focus();
    }
    if let Some(at) = response.interact_pointer_pos() {
        x = ((at.x - rect.left()) / rect.width()).clamp(0.0, 1.0);
        y = ((rect.bottom() - at.y) / rect.height()).clamp(0.0, 1.0);
    }
    let [right, up] = arrows(ui, &response);
    let flat = rows == 1;
    x = (x + 0.01 * right as f32).clamp(0.0, 1.0);
    y = if flat { 0.5 } else { (y + 0.01 * up as f32).clamp(0.0, 1.0) };
    ui.painter().add(Shape::mesh(field(rect, [columns, rows], &colour)));
    let palette = Palette::current(ui.visuals());
    let border = if response.has_focus() {
        Stroke::new(2.0, palette.accent)
    } else {
        Stroke::new(1.0, palette.border)
    };
    ui.painter().rect_stroke(rect, 0.0, border, StrokeKind::Outside);
    let at = pos2(rect.left() + x * rect.width(), rect.bottom() - y * rect.height());
    ui.painter().circle(at, 6.0, colour(x, y), Stroke::new(2.0, Color32::WHITE));
    ui.painter().circle_stroke(at, 7.5, Stroke::new(1.0, Color32::BLACK));
    response.on_hover_text(format!("{name}; keys: arrows, with Shift by more"));
    [x, y]
}

/// The colours at the nodes of a grid; the graphics card interpolates between them.
fn field(rect: Rect, [columns, rows]: [usize; 2], colour: &impl Fn(f32, f32) -> Color32) -> Mesh {
    let mut mesh = Mesh::default();
    for row in 0..=rows {
        for column in 0..=columns {
            let (x, y) = (column as f32 / columns as f32, row as f32 / rows as f32);
            let at: Pos2 = pos2(rect.left() + x * rect.width(), rect.bottom() - y * rect.height());
            mesh.colored_vertex(at, colour(x, y));
        }
    }
    let wide = columns as u32 + 1;
    for row in 0..rows as u32 {
        for column in 0..columns as u32 {
            let a = row * wide + column;
            mesh.add_triangle(a, a + 1, a + wide);
            mesh.add_triangle(a + wide, a + 1, a + wide + 1);
        }
    }
    mesh
}
