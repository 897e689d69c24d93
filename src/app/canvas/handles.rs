//! The handles around what is selected: resize, turn, move an end.

use eframe::egui::{CursorIcon, Pos2, Rect, Vec2, vec2};

use super::view::{View, corners};
use crate::app::desk::Desk;
use crate::app::selection::Place;
use crate::app::shape;
use crate::marks::{Ellipse, Line, Mark};

/// How near the pointer must come to a handle, points. A fingertip's half width.
const REACH: f32 = 9.0;
/// How far the handle that turns stands off, points.
const OFF: f32 = 22.0;

/// A handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Handle {
    /// The end of one of a single ellipse's radii: which one, and on which side.
    Radius(usize, f64),
    /// One end of a single line.
    End(usize),
    /// The side of a single line: its width.
    Width,
    /// A corner of the box around several.
    Corner(Vec2),
    /// Turns.
    Turn,
}

/// The handles of what is selected, and where they are.
#[must_use]
pub fn handles(desk: &Desk, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let marks: Vec<(Place, Mark)> = desk.selected().collect();
    match &marks[..] {
        [] => Vec::new(),
        [(_, Mark::Ellipse(ellipse))] => of_ellipse(ellipse, view, room),
        [(_, Mark::Line(line))] => of_line(line, view, room),
        many => {
            let Some(around) = frame(many, view, room) else { return Vec::new() };
            let turn = around.center_top() - vec2(0.0, OFF);
            let mut handles: Vec<_> =
                corners(around).into_iter().map(|(side, at)| (Handle::Corner(side), at)).collect();
            handles.push((Handle::Turn, turn));
            handles
        }
    }
}

/// The box around several marks on the screen.
#[must_use]
pub fn frame(marks: &[(Place, Mark)], view: &View, room: Rect) -> Option<Rect> {
    let [low, high] = shape::extent(marks.iter().map(|(_, mark)| mark))?;
    Some(Rect::from_min_max(view.to_screen(room, low), view.to_screen(room, high)).expand(4.0))
}

fn of_ellipse(ellipse: &Ellipse, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let at =
        |x: f64, y: f64| view.to_screen(room, shape::out_of_frame([x, y], ellipse.center, ellipse.angle));
    let [a, b] = ellipse.radii;
    let center = view.to_screen(room, ellipse.center);
    let end = at(a, 0.0);
    let away = (end - center).normalized();
    vec![
        (Handle::Turn, end + away * OFF),
        (Handle::Radius(0, 1.0), end),
        (Handle::Radius(0, -1.0), at(-a, 0.0)),
        (Handle::Radius(1, 1.0), at(0.0, b)),
        (Handle::Radius(1, -1.0), at(0.0, -b)),
    ]
}

fn of_line(line: &Line, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let [from, to] = [line.from, line.to].map(|end| view.to_screen(room, end));
    let middle = view.to_screen(room, line.center());
    let across = (to - from).normalized().rot90();
    let half = 0.5 * line.width as f32 * view.zoom;
    vec![
        (Handle::End(0), from),
        (Handle::End(1), to),
        (Handle::Width, middle + across * half.max(10.0)),
        (Handle::Turn, to + (to - from).normalized() * OFF),
    ]
}

/// The handle at a place on the screen.
#[must_use]
pub fn at(handles: &[(Handle, Pos2)], pointer: Pos2) -> Option<Handle> {
    let near = handles.iter().map(|(handle, place)| (*handle, place.distance(pointer)));
    near.filter(|(_, distance)| *distance <= REACH)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(handle, _)| handle)
}

/// The pointer's shape over it.
#[must_use]
pub fn cursor(handle: Handle) -> CursorIcon {
    match handle {
        Handle::Turn => CursorIcon::Alias,
        Handle::End(_) => CursorIcon::Crosshair,
        Handle::Corner(side) if side.x * side.y < 0.0 => CursorIcon::ResizeNeSw,
        Handle::Corner(_) => CursorIcon::ResizeNwSe,
        Handle::Radius(..) | Handle::Width => CursorIcon::Grab,
    }
}

/// What becomes of `marks` when `handle` is dragged from `from` to `to`, px; `even` (Shift) keeps proportions, or
/// turns in steps of 15°.
#[must_use]
pub fn pulled(
    handle: Handle,
    marks: &[(Place, Mark)],
    [from, to]: [[f64; 2]; 2],
    even: bool,
) -> Vec<(Place, Mark)> {
    let each =
        |change: &dyn Fn(&Mark) -> Mark| marks.iter().map(|(place, mark)| (*place, change(mark))).collect();
    let [low, high] = shape::extent(marks.iter().map(|(_, mark)| mark)).unwrap_or_default();
    match handle {
        Handle::Radius(axis, _) => each(&|mark| radius(mark, axis, to, even)),
        Handle::End(end) => each(&|mark| line_end(mark, end, to, even)),
        Handle::Width => each(&|mark| width(mark, to)),
        Handle::Corner(side) => {
            // The opposite corner stays.
            let side = [f64::from(side.x), f64::from(side.y)];
            let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
            let half = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]));
            let pivot = [0, 1].map(|axis| middle[axis] - side[axis] * half[axis]);
            let along = |p: [f64; 2]| {
                (0..2).map(|axis| (p[axis] - pivot[axis]) * side[axis] * half[axis]).sum::<f64>()
            };
            let factor = (along(to) / along(from).max(1e-9)).clamp(0.05, 50.0);
            each(&|mark| shape::scaled(mark, factor, pivot))
        }
        Handle::Turn => {
            let pivot = match marks {
                [(_, mark)] => shape::middle(mark),
                _ => [0, 1].map(|axis| 0.5 * (low[axis] + high[axis])),
            };
            let towards = |p: [f64; 2]| (p[1] - pivot[1]).atan2(p[0] - pivot[0]).to_degrees();
            let mut by = towards(to) - towards(from);
            if even {
                by = (by / STEP).round() * STEP;
            }
            each(&|mark| shape::turned(mark, by, pivot))
        }
    }
}

/// Degrees that Shift keeps to.
const STEP: f64 = 15.0;

fn radius(mark: &Mark, axis: usize, to: [f64; 2], even: bool) -> Mark {
    let Mark::Ellipse(mut ellipse) = *mark else { return *mark };
    let at = shape::into_frame(to, ellipse.center, ellipse.angle);
    let radius = at[axis].abs().max(shape::SMALLEST);
    let factor = radius / ellipse.radii[axis];
    ellipse.radii[axis] = radius;
    if even {
        ellipse.radii[1 - axis] *= factor;
    }
    Mark::Ellipse(ellipse)
}

fn line_end(mark: &Mark, end: usize, to: [f64; 2], even: bool) -> Mark {
    let Mark::Line(mut line) = *mark else { return *mark };
    let fixed = if end == 0 { line.to } else { line.from };
    let to = if even { straightened(fixed, to) } else { to };
    *(if end == 0 { &mut line.from } else { &mut line.to }) = to;
    Mark::Line(line)
}

fn width(mark: &Mark, to: [f64; 2]) -> Mark {
    let Mark::Line(line) = *mark else { return *mark };
    let middle = line.center();
    let across = shape::into_frame(to, middle, line.angle())[1];
    Mark::Line(Line { width: 2.0 * across.abs().max(0.5 * shape::SMALLEST), ..line })
}

/// `to`, turned around `from` to the nearest step of 15°.
#[must_use]
pub fn straightened(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let angle = ((y.atan2(x).to_degrees() / STEP).round() * STEP).to_radians();
    let length = x.hypot(y);
    [from[0] + length * angle.cos(), from[1] + length * angle.sin()]
}
