//! The selected transition: a Bezier curve with two handles.

use egui::{
    Button, CursorIcon, Pos2, Rect, RichText, Sense, Shape, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2,
};

use super::bar::{gradient, line, transition};
use super::grip::{arrows, deleted, rounded};
use super::{ColourPanel, Drag};
use crate::app::icons::Icon;
use crate::app::panels::form::heading;
use crate::app::theme::Palette;
use crate::colour::Bend;
use crate::document::{Colours, limits};

/// Preset curves.
const KINDS: [(&str, [f64; 4]); 5] = [
    ("Straight", [0.0, 0.0, 1.0, 1.0]),
    ("Slow start", [0.42, 0.0, 1.0, 1.0]),
    ("Slow end", [0.0, 0.0, 0.58, 1.0]),
    ("Slow start and end", [0.42, 0.0, 0.58, 1.0]),
    ("Late and steep", [0.9, 0.0, 0.9, 0.3]),
];
/// Height of the plot, width of the strips along it, and the space around them, points.
const HEIGHT: f32 = 112.0;
const STRIP: f32 = 9.0;
const SPACE: f32 = 7.0;

/// Shows it; dragging a handle changes it.
pub fn curve(ui: &mut Ui, panel: &mut ColourPanel, colours: &mut Colours) {
    panel.retain_existing(colours);
    let gap = panel.gap;
    heading(ui, &transition(gap));
    let mut bend = colours.bend(gap);
    let before = bend;
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
        let icon = if panel.unfolded { Icon::Unfolded } else { Icon::Folded };
        let fold = icon.sized_button(ui, "Bend by hand", panel.unfolded, vec2(30.0, 24.0));
        if fold.on_hover_text("Two handles to bend the transition by hand").clicked() {
            panel.unfolded = !panel.unfolded;
            panel.shows_plot = panel.unfolded;
        }
    });
    if panel.unfolded {
        plot(ui, panel, colours, gap, &mut bend);
    }
    if bend != before {
        colours.set_bend(gap, bend);
    }
}

/// The plot of the transition with its two handles.
fn plot(ui: &mut Ui, panel: &mut ColourPanel, colours: &Colours, gap: usize, bend: &mut [f64; 4]) {
    let (all, _) =
        ui.allocate_exact_size(vec2(ui.available_width(), HEIGHT + STRIP + 2.0 * SPACE), Sense::hover());
    if std::mem::take(&mut panel.shows_plot) {
        ui.scroll_to_rect(all.expand2(vec2(0.0, 14.0)), None);
    }
    let room = Rect::from_min_max(
        pos2(all.left() + SPACE + STRIP + 3.0, all.top() + SPACE),
        pos2(all.right() - SPACE, all.top() + SPACE + HEIGHT),
    );
    let range = panel
        .drag
        .as_ref()
        .filter(|drag| drag.stop.is_none())
        .map_or_else(|| range(*bend), |drag| drag.range);
    strips(ui, colours, gap, room, range);
    paint(ui, room, *bend, range);
    for handle in 0..2 {
        self::handle(ui, panel, colours, bend, handle, room, range);
    }
    let [x1, y1, x2, y2] = *bend;
    let numbers = RichText::new(format!("{x1:.2}, {y1:.2}, {x2:.2}, {y2:.2}")).small().weak();
    ui.label(numbers).on_hover_text("Positions of the two handles, x and y, as in CSS cubic-bezier()");
}

/// Smallest and largest y of the plot: 0, 1 and the handles, with a margin.
fn range([_, y1, _, y2]: [f64; 4]) -> [f64; 2] {
    [y1.min(y2).min(0.0) - 0.04, y1.max(y2).max(1.0) + 0.04]
}

/// A point of the curve on the screen.
fn place(room: Rect, [x, y]: [f64; 2], [low, high]: [f64; 2]) -> Pos2 {
    let y = (y - low) / (high - low);
    pos2(room.left() + x as f32 * room.width(), room.bottom() - y as f32 * room.height())
}

/// Strips of colour that explain the axes: below the plot the colours of the transition, on the left an even mix of its
/// two colours.
fn strips(ui: &Ui, colours: &Colours, gap: usize, room: Rect, range: [f64; 2]) {
    let painter = ui.painter();
    let [from, to] = [gap, gap + 1].map(|stop| colours.stops[stop]);
    let below = Rect::from_min_size(pos2(room.left(), room.bottom() + 3.0), vec2(room.width(), STRIP));
    gradient(painter, below, &colours.gradient(), [from.at, to.at]);
    let mut even = Colours { stops: vec![from, to], ..Colours::new([]) };
    (even.stops[0].at, even.stops[1].at) = (0.0, 1.0);
    let even = even.gradient();
    let [top, bottom] = [1.0, 0.0].map(|y| place(room, [0.0, y], range).y);
    let rows = (bottom - top).round().max(1.0) as usize;
    let values = (0..rows).map(|row| 1.0 - (row as f32 + 0.5) / rows as f32);
    for (row, colour) in even.rgbas(values).into_iter().enumerate() {
        let [above, under] = [row, row + 1].map(|i| top + (bottom - top) * i as f32 / rows as f32);
        let left = room.left() - STRIP - 3.0;
        let rect = Rect::from_min_max(pos2(left, above), pos2(left + STRIP, under));
        painter.rect_filled(rect, 0.0, super::shown(colour));
    }
}

fn paint(ui: &Ui, room: Rect, bend: [f64; 4], range: [f64; 2]) {
    let palette = Palette::current(ui.visuals());
    let painter = ui.painter();
    painter.rect_filled(room, 0.0, ui.visuals().extreme_bg_color);
    painter.rect_stroke(room, 0.0, Stroke::new(1.0, palette.border), StrokeKind::Outside);
    for y in [0.0, 1.0] {
        painter.hline(room.x_range(), place(room, [0.0, y], range).y, Stroke::new(1.0, palette.grid));
    }
    let ends = [place(room, [0.0, 0.0], range), place(room, [1.0, 1.0], range)];
    painter.extend(Shape::dashed_line(&ends, Stroke::new(1.0, palette.grid), 4.0, 4.0));
    let curve = line(room, Bend(bend), range);
    ui.painter_at(room.expand(1.0)).add(Shape::line(curve, Stroke::new(2.0, ui.visuals().text_color())));
    let [x1, y1, x2, y2] = bend;
    for (end, handle) in ends.into_iter().zip([[x1, y1], [x2, y2]]) {
        painter.line_segment([end, place(room, handle, range)], Stroke::new(1.4, palette.accent));
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
    range: [f64; 2],
) {
    let [x, y] = [bend[2 * handle], bend[2 * handle + 1]];
    let at = place(room, [x, y], range);
    let id = ui.scope_id().with(("handle", handle));
    let response = ui.interact(Rect::from_center_size(at, vec2(18.0, 18.0)), id, Sense::click_and_drag());
    let name = if handle == 0 { "First handle" } else { "Second handle" };
    response.widget_info(|| WidgetInfo::slider(true, y, name));
    if response.clicked() || response.drag_started() {
        response.request_focus();
    }
    let [mut x, mut y] = [x, y];
    if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.dragged()) {
        if response.drag_started() || panel.drag.is_none() {
            let origin = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
            let offset = [origin.x - at.x, origin.y - at.y];
            panel.drag = Some(Drag { before: colours.clone(), stop: None, offset, range });
        }
        if let Some(drag) = &panel.drag {
            let [dx, dy] = drag.offset;
            x = f64::from((pointer.x - dx - room.left()) / room.width());
            let up = f64::from((room.bottom() - pointer.y + dy) / room.height());
            y = range[0] + up * (range[1] - range[0]);
        }
    }
    if response.drag_stopped() {
        panel.drag = None;
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
    let palette = Palette::current(ui.visuals());
    let at = place(room, [bend[2 * handle], bend[2 * handle + 1]], range);
    if response.has_focus() {
        ui.painter().circle_filled(at, 9.0, palette.accent_pale);
    }
    let radius = if response.hovered() || response.dragged() { 6.0 } else { 5.0 };
    ui.painter().circle(at, radius, ui.visuals().extreme_bg_color, Stroke::new(2.0, palette.accent));
    if !response.dragged() {
        response.on_hover_cursor(CursorIcon::Grab).on_hover_text(format!(
            "{name} at {x:.2}, {y:.2}: drag it to bend the transition. To the right: the pattern value; up: the share of the \
             second colour. Keys: arrows (with Shift by more), Delete makes it straight"
        ));
    }
}
