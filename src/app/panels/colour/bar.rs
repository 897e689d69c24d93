//! The bar: all colours from ground to mark, the transitions above it, the stops below.

use egui::{
    Align2, Color32, CursorIcon, FontId, Id, Key, Painter, Rect, Response, Role, Sense, Shape, Stroke,
    StrokeKind, Ui, WidgetInfo, epaint::Mesh, pos2, vec2,
};

use super::grip::{arrows, deleted, rounded};
use super::{ColourPanel, Drag, shown, stop_menu};
use crate::app::checkerboard;
use crate::app::theme::Palette;
use crate::colour::{Bend, Gradient};
use crate::document::Colours;

/// Heights, points: the transitions, the bar, the stops, the labels.
const HEIGHTS: [f32; 4] = [26.0, 26.0, 22.0, 13.0];
/// Half a stop's width, points: the bar ends this far from the panel's edge.
const HALF: f32 = 8.0;
/// A stop that is dragged farther from the bar than this is removed, points.
const OFF: f32 = 44.0;

/// Shows the bar; stops are added, dragged and removed.
pub fn bar(ui: &mut Ui, panel: &mut ColourPanel, colours: &mut Colours) {
    let (all, _) = ui.allocate_exact_size(vec2(ui.available_width(), HEIGHTS.iter().sum()), Sense::hover());
    let mut top = all.top();
    let [transitions, bar, stops, labels] = HEIGHTS.map(|height| {
        let rect = Rect::from_min_max(pos2(all.left() + HALF, top), pos2(all.right() - HALF, top + height));
        top += height;
        rect
    });
    self::transitions(ui, panel, colours, transitions);
    self::stops(ui, panel, colours, stops, bar);
    add(ui, panel, colours, bar);
    let painter = ui.painter().clone();
    gradient(&painter, bar, &colours.gradient(), [0.0, 1.0]);
    painter.rect_stroke(bar, 0.0, ui.visuals().widgets.noninteractive.bg_stroke, StrokeKind::Outside);
    let font = FontId::proportional(10.5);
    let weak = ui.visuals().weak_text_color();
    for (at, text, align) in [
        (0.0, "ground", Align2::LEFT_TOP),
        (0.5, "edge", Align2::CENTER_TOP),
        (1.0, "middle", Align2::RIGHT_TOP),
    ] {
        painter.text(pos2(x_of(labels, at), labels.top()), align, text, font.clone(), weak);
    }
}

/// The x of a pattern value.
fn x_of(rect: Rect, at: f64) -> f32 {
    rect.left() + at as f32 * rect.width()
}

/// Paints the colours of pattern values `from` to `to` from left to right.
pub fn gradient(painter: &Painter, rect: Rect, gradient: &Gradient, [from, to]: [f64; 2]) {
    if !gradient.is_opaque() {
        checkerboard::paint(painter, rect);
    }
    let columns = rect.width().round().max(1.0) as usize;
    let mut mesh = Mesh::default();
    let value = |column: usize| (from + (to - from) * (column as f64 + 0.5) / columns as f64) as f32;
    for (column, colour) in gradient.rgbas((0..columns).map(value)).into_iter().enumerate() {
        let [left, right] =
            [column, column + 1].map(|i| rect.left() + rect.width() * i as f32 / columns as f32);
        mesh.add_colored_rect(
            Rect::from_min_max(pos2(left, rect.top()), pos2(right, rect.bottom())),
            shown(colour),
        );
    }
    painter.add(Shape::mesh(mesh));
}

/// The curves above the bar, each over its transition; a click selects one.
fn transitions(ui: &Ui, panel: &mut ColourPanel, colours: &Colours, rect: Rect) {
    let palette = Palette::current(ui.visuals());
    for gap in 0..colours.stops.len() - 1 {
        let [left, right] = [gap, gap + 1].map(|stop| x_of(rect, colours.stops[stop].at));
        let room = Rect::from_min_max(pos2(left, rect.top()), pos2(right, rect.bottom()));
        let response = ui.interact(room, ui.scope_id().with(("way", gap)), Sense::click());
        let name = transition(gap);
        response.widget_info(|| WidgetInfo::selected(Role::Button, true, panel.gap == gap, &name));
        if response.clicked() {
            panel.gap = gap;
        }
        let chosen = panel.gap == gap;
        let painter = ui.painter_at(room.expand(1.0));
        if chosen || response.hovered() {
            let strength = if chosen { 0.45 } else { 0.2 };
            painter.rect_filled(room, 0.0, palette.accent_pale.gamma_multiply(strength));
        }
        if response.has_focus() {
            painter.rect_stroke(room, 0.0, Stroke::new(1.5, palette.accent), StrokeKind::Inside);
        }
        let colour = if chosen { palette.accent } else { ui.visuals().weak_text_color() };
        let bend = Bend(colours.bend(gap));
        let room = room.shrink2(vec2(0.0, 4.0));
        painter.add(Shape::line(line(room, bend, [0.0, 1.0]), Stroke::new(1.4, colour)));
        response.on_hover_text(format!("{name}: click to bend it below"));
    }
}

/// The name of a transition.
pub fn transition(gap: usize) -> String {
    format!("Transition from stop {} to {}", gap + 1, gap + 2)
}

/// Paints a bend as a line across `rect`; y goes from `low` at the bottom to `high` at the top.
pub fn line(rect: Rect, bend: Bend, [low, high]: [f64; 2]) -> Vec<egui::Pos2> {
    let steps = (rect.width() / 2.0).clamp(2.0, 120.0) as usize;
    (0..=steps)
        .map(|i| {
            let x = i as f64 / steps as f64;
            let y = (bend.ease(x) - low) / (high - low);
            pos2(rect.left() + x as f32 * rect.width(), rect.bottom() - y as f32 * rect.height())
        })
        .collect()
}

/// The bar itself: a click adds a stop there, Enter adds one in the middle of the selected transition.
fn add(ui: &Ui, panel: &mut ColourPanel, colours: &mut Colours, rect: Rect) {
    let response = ui.interact(rect, ui.scope_id().with("bar"), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, "Add a stop"));
    let focused = response.has_focus();
    if response.clicked() && panel.drag.is_none() {
        let midpoint = || {
            let at = |stop: usize| colours.stops.get(stop).map(|stop| stop.at);
            0.5 * (at(panel.gap).unwrap_or(0.0) + at(panel.gap + 1).unwrap_or(1.0))
        };
        let pointer =
            response.interact_pointer_pos().filter(|_| !focused || response.is_pointer_button_down_on());
        let pointer =
            pointer.or_else(|| ui.input(|input| input.pointer.any_click()).then(|| response.hover_pos())?);
        let at = pointer.map_or_else(midpoint, |at| f64::from((at.x - rect.left()) / rect.width()));
        let index = colours.insert(rounded(at));
        panel.choose(index, colours);
        ui.memory_mut(|memory| memory.request_focus(stop_id(ui, index)));
    }
    if focused {
        let accent = Palette::current(ui.visuals()).accent;
        ui.painter().rect_stroke(rect.expand(2.0), 2.0, Stroke::new(1.5, accent), StrokeKind::Outside);
    }
    response
        .on_hover_cursor(CursorIcon::Copy)
        .on_hover_text("Click to add a stop here. Enter adds one in the middle of the selected transition");
}

fn stop_id(ui: &Ui, index: usize) -> Id {
    ui.scope_id().with(("stop", index))
}

/// The stops below the bar.
fn stops(ui: &Ui, panel: &mut ColourPanel, colours: &mut Colours, rect: Rect, bar: Rect) {
    // While a stop is dragged, all stops keep the order and the names that they had before the drag.
    let drag = panel.drag.as_ref().and_then(|drag| Some((&drag.before, drag.stop?)));
    let (seen, moved) = drag.map_or((colours.clone(), None), |(before, stop)| (before.clone(), Some(stop)));
    let count = seen.stops.len();
    // The selected stop is drawn last.
    let order = (0..count).filter(|i| *i != panel.stop).chain([panel.stop]).filter(|i| *i < count);
    let order: Vec<usize> = if moved.is_some() { (0..count).collect() } else { order.collect() };
    for index in order {
        let stop = seen.stops[index];
        let mut x = x_of(rect, stop.at);
        let room = Rect::from_min_max(pos2(x - HALF, rect.top()), pos2(x + HALF, rect.bottom()));
        let response = ui.interact(room, stop_id(ui, index), Sense::click_and_drag());
        let name = format!("Stop {} of {count}, {}", index + 1, stop.hex());
        response.widget_info(|| WidgetInfo::slider(true, stop.at, &name));
        let mut off = false;
        if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.dragged()) {
            if response.drag_started() || moved != Some(index) {
                let offset = [ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer).x - x, 0.0];
                panel.drag =
                    Some(Drag { before: colours.clone(), stop: Some(index), offset, range: [0.0; 2] });
                response.request_focus();
            }
            if let Some(drag) = &panel.drag {
                x = (pointer.x - drag.offset[0]).clamp(rect.left(), rect.right());
                off = count > 1 && (pointer.y - bar.center().y).abs() > OFF;
                let at = rounded(f64::from((x - rect.left()) / rect.width()));
                colours.clone_from(&drag.before);
                if off {
                    colours.remove(index);
                } else {
                    panel.stop = colours.shift(index, at);
                }
                panel.gap = panel.stop.min(colours.stops.len().saturating_sub(2));
            }
        }
        if response.drag_stopped() && moved == Some(index) {
            panel.drag = None;
            let chosen = panel.stop.min(colours.stops.len() - 1);
            panel.choose(chosen, colours);
            ui.memory_mut(|memory| memory.request_focus(stop_id(ui, chosen)));
        }
        if panel.drag.is_none() && moved.is_none() {
            respond(ui, panel, colours, index, &response);
            stop_menu::stop_menu(&response, panel, colours, index);
        }
        let chosen = moved.map_or(panel.stop == index, |moved| moved == index);
        if !off {
            paint(ui, pos2(x, rect.top()), shown(stop.rgba()), chosen, response.has_focus());
        }
        let help = "Drag along the bar to move it, off the bar to remove it. Keys: arrows move it (with Shift by more), \
                    Delete removes it, Enter opens the picker";
        if moved.is_none() {
            response.on_hover_text(format!("{name} at {:.3}\n{help}", stop.at));
        } else if off && chosen {
            response.on_hover_cursor(CursorIcon::NoDrop);
        }
    }
}

/// Clicks and keys on a stop.
fn respond(ui: &Ui, panel: &mut ColourPanel, colours: &mut Colours, index: usize, response: &Response) {
    if response.clicked() || response.gained_focus() {
        panel.choose(index, colours);
        response.scroll_to_me(None);
    }
    if response.clicked() {
        response.request_focus();
    }
    let enter = response.has_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    panel.open_picker |= enter || response.double_clicked();
    let [x, y] = arrows(ui, response);
    if x + y != 0.0 {
        let at = rounded(colours.stops[index].at + 0.01 * (x + y));
        let moved = colours.shift(index, at);
        panel.choose(moved, colours);
        ui.memory_mut(|memory| memory.request_focus(stop_id(ui, moved)));
    }
    if deleted(ui, response) && colours.remove(index) {
        let next = index.min(colours.stops.len() - 1);
        panel.choose(next, colours);
        ui.memory_mut(|memory| memory.request_focus(stop_id(ui, next)));
    }
}

/// A stop: its colour in a shape with a tip at its position.
fn paint(ui: &Ui, tip: egui::Pos2, colour: Color32, chosen: bool, focused: bool) {
    let palette = Palette::current(ui.visuals());
    let shape = |half: f32, top: f32, height: f32| {
        vec![
            pos2(tip.x, tip.y + top),
            pos2(tip.x + half, tip.y + 6.0),
            pos2(tip.x + half, tip.y + height),
            pos2(tip.x - half, tip.y + height),
            pos2(tip.x - half, tip.y + 6.0),
        ]
    };
    let border = if chosen { palette.accent } else { ui.visuals().widgets.noninteractive.fg_stroke.color };
    let painter = ui.painter();
    if focused {
        painter.add(Shape::convex_polygon(shape(8.5, -3.0, 21.0), palette.accent_pale, Stroke::NONE));
    }
    if !colour.is_opaque() {
        let square = Rect::from_min_max(tip + vec2(-6.0, 6.0), tip + vec2(6.0, 18.0));
        checkerboard::paint(painter, square);
    }
    let width = if chosen { 2.0 } else { 1.0 };
    painter.add(Shape::convex_polygon(shape(6.0, 0.5, 18.0), colour, Stroke::new(width, border)));
}
