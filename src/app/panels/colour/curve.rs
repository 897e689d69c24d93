//! The chosen way, large: a Bezier curve whose two handles bend it.

use egui::{
    Button, CursorIcon, Pos2, Rect, RichText, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

use super::bar::{gradient, line, way};
use super::grip::{arrows, deleted, rounded};
use super::{ColourPanel, Held};
use crate::app::panels::inspector::heading;
use crate::app::theme::Palette;
use crate::colour::Bend;
use crate::document::{Colours, limits};

/// Bends to choose.
const KINDS: [(&str, [f64; 4]); 5] = [
    ("Straight", [0.0, 0.0, 1.0, 1.0]),
    ("Slow start", [0.42, 0.0, 1.0, 1.0]),
    ("Slow end", [0.0, 0.0, 0.58, 1.0]),
    ("Slow start and end", [0.42, 0.0, 0.58, 1.0]),
    ("Late and sudden", [0.9, 0.0, 0.9, 0.3]),
];
/// Height of the picture, of the strips along it, and the space around, points.
const HEIGHT: f32 = 112.0;
const STRIP: f32 = 9.0;
const SPACE: f32 = 7.0;

/// Shows it and lets the hand bend it.
pub fn curve(ui: &mut Ui, panel: &mut ColourPanel, colours: &mut Colours) {
    panel.retain_existing(colours);
    let gap = panel.gap;
    heading(ui, &way(gap));
    let mut bend = colours.bend(gap);
    let before = bend;
    let (all, _) =
        ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT + STRIP + 2.0 * SPACE), Sense::hover());
    let room = Rect::from_min_max(
        pos2(all.left() + SPACE + STRIP + 3.0, all.top() + SPACE),
        pos2(all.right() - SPACE, all.top() + SPACE + HEIGHT),
    );
    let rise = panel
        .held
        .as_ref()
        .filter(|held| held.stop == usize::MAX)
        .map_or_else(|| rise(bend), |held| held.rise);
    strips(ui, colours, gap, room, rise);
    paint(ui, room, bend, rise);
    for handle in 0..2 {
        self::handle(ui, panel, colours, &mut bend, handle, room, rise);
    }
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 4.0;
        for (name, kind) in KINDS {
            let button = ui.add_sized(vec2(30.0, 24.0), Button::new("").selected(bend == kind));
            let small = Rect::from_center_size(button.rect.center(), vec2(16.0, 12.0));
            let colour = if bend == kind {
                ui.visuals().selection.stroke.color
            } else {
                ui.style().interact(&button).text_color()
            };
            ui.painter().add(Shape::line(line(small, Bend(kind), [0.0, 1.0]), Stroke::new(1.4, colour)));
            if button.accessible_name(name).on_hover_text(name).clicked() {
                bend = kind;
            }
        }
        let [x1, y1, x2, y2] = bend;
        let numbers = RichText::new(format!("{x1:.2} {y1:.2}\n{x2:.2} {y2:.2}")).small().weak();
        ui.label(numbers).on_hover_text("The two handles, x and y, as in CSS: cubic-bezier");
    });
    if bend != before {
        colours.set_bend(gap, bend);
    }
}

/// What the picture shows of y: the two colours, and handles beyond them.
fn rise([_, y1, _, y2]: [f64; 4]) -> [f64; 2] {
    [y1.min(y2).min(0.0) - 0.04, y1.max(y2).max(1.0) + 0.04]
}

/// Where a point of the curve lies.
fn place(room: Rect, [x, y]: [f64; 2], [low, high]: [f64; 2]) -> Pos2 {
    let y = (y - low) / (high - low);
    pos2(room.left() + x as f32 * room.width(), room.bottom() - y as f32 * room.height())
}

/// What the axes mean: beneath, the transition as it will be; at the left, the two colours mixed evenly.
fn strips(ui: &Ui, colours: &Colours, gap: usize, room: Rect, rise: [f64; 2]) {
    let painter = ui.painter();
    let [from, to] = [gap, gap + 1].map(|stop| colours.stops[stop]);
    let below = Rect::from_min_size(pos2(room.left(), room.bottom() + 3.0), vec2(room.width(), STRIP));
    gradient(painter, below, &colours.gradient(), [from.at, to.at]);
    let mut even = Colours { stops: vec![from, to], bends: Vec::new() };
    (even.stops[0].at, even.stops[1].at) = (0.0, 1.0);
    let even = even.gradient();
    let [top, bottom] = [1.0, 0.0].map(|y| place(room, [0.0, y], rise).y);
    let rows = (bottom - top).round().max(1.0) as usize;
    let values = (0..rows).map(|row| 1.0 - (row as f32 + 0.5) / rows as f32);
    for (row, colour) in even.colours(values).into_iter().enumerate() {
        let [above, under] = [row, row + 1].map(|i| top + (bottom - top) * i as f32 / rows as f32);
        let left = room.left() - STRIP - 3.0;
        let rect = Rect::from_min_max(pos2(left, above), pos2(left + STRIP, under));
        painter.rect_filled(rect, 0.0, super::shown(colour));
    }
}

fn paint(ui: &Ui, room: Rect, bend: [f64; 4], rise: [f64; 2]) {
    let palette = Palette::of(ui.visuals());
    let painter = ui.painter();
    painter.rect_filled(room, 0.0, ui.visuals().extreme_bg_color);
    painter.rect_stroke(room, 0.0, Stroke::new(1.0, palette.border), StrokeKind::Outside);
    for y in [0.0, 1.0] {
        painter.hline(room.x_range(), place(room, [0.0, y], rise).y, Stroke::new(1.0, palette.grid));
    }
    let ends = [place(room, [0.0, 0.0], rise), place(room, [1.0, 1.0], rise)];
    painter.extend(Shape::dashed_line(&ends, Stroke::new(1.0, palette.grid), 4.0, 4.0));
    let curve = line(room, Bend(bend), rise);
    ui.painter_at(room.expand(1.0)).add(Shape::line(curve, Stroke::new(2.0, ui.visuals().text_color())));
    let [x1, y1, x2, y2] = bend;
    for (end, handle) in ends.into_iter().zip([[x1, y1], [x2, y2]]) {
        painter.line_segment([end, place(room, handle, rise)], Stroke::new(1.4, palette.accent));
    }
}

/// One of the two handles.
fn handle(
    ui: &Ui,
    panel: &mut ColourPanel,
    colours: &Colours,
    bend: &mut [f64; 4],
    handle: usize,
    room: Rect,
    rise: [f64; 2],
) {
    let [x, y] = [bend[2 * handle], bend[2 * handle + 1]];
    let at = place(room, [x, y], rise);
    let id = ui.scope_id().with(("handle", handle));
    let response = ui.interact(Rect::from_center_size(at, vec2(18.0, 18.0)), id, Sense::click_and_drag());
    let name = if handle == 0 { "First handle" } else { "Second handle" };
    response.widget_info(|| WidgetInfo::slider(true, y, name));
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    let [mut x, mut y] = [x, y];
    if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.dragged()) {
        if response.drag_started() || panel.held.is_none() {
            let origin = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
            let grip = [origin.x - at.x, origin.y - at.y];
            panel.held = Some(Held { before: colours.clone(), stop: usize::MAX, grip, rise });
        }
        if let Some(held) = &panel.held {
            let [dx, dy] = held.grip;
            x = f64::from((pointer.x - dx - room.left()) / room.width());
            let up = f64::from((room.bottom() - pointer.y + dy) / room.height());
            y = rise[0] + up * (rise[1] - rise[0]);
        }
    }
    if response.drag_stopped() {
        panel.held = None;
    }
    if response.gained_focus() {
        response.scroll_to_me(None);
    }
    let [right, up] = arrows(ui, &response);
    (x, y) = (x + 0.01 * right, y + 0.01 * up);
    if deleted(ui, &response) {
        [x, y] = if handle == 0 { [0.0, 0.0] } else { [1.0, 1.0] };
    }
    bend[2 * handle] = rounded(x.clamp(limits::BEND_X.low, limits::BEND_X.high));
    bend[2 * handle + 1] = rounded(y.clamp(limits::BEND_Y.low, limits::BEND_Y.high));
    let palette = Palette::of(ui.visuals());
    let at = place(room, [bend[2 * handle], bend[2 * handle + 1]], rise);
    if response.has_focus() {
        ui.painter().circle_filled(at, 9.0, palette.accent_pale);
    }
    let radius = if response.hovered() || response.dragged() { 6.0 } else { 5.0 };
    ui.painter().circle(at, radius, ui.visuals().extreme_bg_color, Stroke::new(2.0, palette.accent));
    if !response.dragged() {
        response.on_hover_cursor(CursorIcon::Grab).on_hover_text(format!(
            "{name} at {x:.2}, {y:.2}: drag it to bend the transition. To the right: how far the pattern has come; up: how \
             far the colour. By key: arrows (Shift: further), Delete makes it straight"
        ));
    }
}
