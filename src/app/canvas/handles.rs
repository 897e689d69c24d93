//! The handles of the selected marks: resize, turn, move an end.

use egui::{CursorIcon, Pos2, Rect, Vec2, vec2};

use super::view::{View, corners};
use crate::editor::selection::Place;
use crate::editor::session::Session;
use crate::editor::shape;
use crate::marks::{Ellipse, Line, Mark, Path};

/// The pointer picks a handle within this distance, points: half the width of a fingertip.
const REACH: f32 = 9.0;
/// Distance of the handle for turning from the mark, points.
const OFF: f32 = 22.0;
/// Smallest distance of a handle from the centre, points: small marks must stay easy to grab.
const NEAR: f32 = 20.0;

/// A handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Handle {
    /// The end of a radius of a single ellipse: index of the radius, side (±1).
    Radius(usize, f64),
    /// One end of a single line.
    End(usize),
    /// A point of a single path.
    Point(usize),
    /// The side of a single line: its width.
    Width,
    /// A corner of the box around several marks, or around a path: (±1, ±1).
    Corner(Vec2),
    /// The handle for turning.
    Turn,
}

/// The handles of the selected marks, and their positions on the screen.
#[must_use]
pub fn handles(session: &Session, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let marks: Vec<(Place, Mark)> = session.selected().collect();
    match &marks[..] {
        [] => Vec::new(),
        [(_, Mark::Ellipse(ellipse))] => of_ellipse(ellipse, view, room),
        [(_, Mark::Line(line))] => of_line(line, view, room),
        [(_, Mark::Path(path))] => {
            let mut handles = of_points(path, view, room);
            handles.extend(of_frame(&marks, view, room));
            handles
        }
        many => of_frame(many, view, room),
    }
}

fn of_frame(marks: &[(Place, Mark)], view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let Some(around) = frame(marks, view, room) else { return Vec::new() };
    let turn = around.center_top() - vec2(0.0, OFF);
    let mut handles: Vec<_> =
        corners(around).into_iter().map(|(side, at)| (Handle::Corner(side), at)).collect();
    handles.push((Handle::Turn, turn));
    handles
}

fn of_points(path: &Path, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let points = path.points.iter().enumerate();
    points.map(|(index, point)| (Handle::Point(index), view.to_screen(room, *point))).collect()
}

/// The box around several marks on the screen.
#[must_use]
pub fn frame(marks: &[(Place, Mark)], view: &View, room: Rect) -> Option<Rect> {
    let [low, high] = shape::extent(marks.iter().map(|(_, mark)| mark))?;
    Some(Rect::from_min_max(view.to_screen(room, low), view.to_screen(room, high)).expand(4.0))
}

fn of_ellipse(ellipse: &Ellipse, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let center = view.to_screen(room, ellipse.center);
    let along = Vec2::angled(ellipse.angle.to_radians() as f32);
    let reach = ellipse.radii.map(|radius| (radius as f32 * view.zoom).max(NEAR));
    vec![
        (Handle::Turn, center + along * (reach[0] + OFF)),
        (Handle::Radius(0, 1.0), center + along * reach[0]),
        (Handle::Radius(0, -1.0), center - along * reach[0]),
        (Handle::Radius(1, 1.0), center + along.rot90() * reach[1]),
        (Handle::Radius(1, -1.0), center - along.rot90() * reach[1]),
    ]
}

fn of_line(line: &Line, view: &View, room: Rect) -> Vec<(Handle, Pos2)> {
    let center = view.to_screen(room, line.center());
    let along = Vec2::angled(line.angle().to_radians() as f32);
    let ends = [line.from, line.to].map(|end| view.to_screen(room, end));
    let out = ends.map(|end| {
        let away = end - center;
        if away.length() < NEAR { center + NEAR * away.normalized() } else { end }
    });
    let side = (0.5 * line.width as f32 * view.zoom).max(NEAR);
    vec![
        (Handle::End(0), out[0]),
        (Handle::End(1), out[1]),
        (Handle::Width, center + along.rot90() * side),
        (Handle::Turn, out[1] + (out[1] - center).normalized() * OFF),
    ]
}

/// The handle at a position on the screen.
#[must_use]
pub fn at(handles: &[(Handle, Pos2)], pointer: Pos2) -> Option<Handle> {
    let near = handles.iter().map(|(handle, place)| (*handle, place.distance(pointer)));
    near.filter(|(_, distance)| *distance <= REACH)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(handle, _)| handle)
}

/// The point of a mark that a handle moves; `None` for handles that do not move a point.
#[must_use]
pub fn end_of(handle: Handle, marks: &[(Place, Mark)]) -> Option<[f64; 2]> {
    match (handle, marks) {
        (Handle::End(end), [(_, Mark::Line(line))]) => Some(if end == 0 { line.from } else { line.to }),
        (Handle::Point(index), [(_, Mark::Path(path))]) => path.points.get(index).copied(),
        _ => None,
    }
}

/// The pointer's shape over a handle.
#[must_use]
pub fn cursor(handle: Handle) -> CursorIcon {
    match handle {
        Handle::Turn => CursorIcon::Alias,
        Handle::End(_) | Handle::Point(_) => CursorIcon::Crosshair,
        Handle::Corner(side) if side.x * side.y < 0.0 => CursorIcon::ResizeNeSw,
        Handle::Corner(_) => CursorIcon::ResizeNwSe,
        Handle::Radius(..) | Handle::Width => CursorIcon::Grab,
    }
}

/// `marks` after `handle` was dragged from `from` to `to`, px. `even` (Shift) keeps the proportions, or turns in steps
/// of 15°.
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
        Handle::Radius(axis, side) => each(&|mark| radius(mark, (axis, side), [from, to], even)),
        Handle::End(end) => each(&|mark| line_end(mark, end, [from, to], even)),
        Handle::Point(index) => each(&|mark| path_point(mark, index, [from, to])),
        Handle::Width => each(&|mark| width(mark, [from, to])),
        Handle::Corner(side) => {
            // The opposite corner keeps its place.
            let side = [f64::from(side.x), f64::from(side.y)];
            let center = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
            let half = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]));
            let pivot = [0, 1].map(|axis| center[axis] - side[axis] * half[axis]);
            let along = |p: [f64; 2]| {
                (0..2).map(|axis| (p[axis] - pivot[axis]) * side[axis] * half[axis]).sum::<f64>()
            };
            let factor = (along(to) / along(from).max(1e-9)).clamp(0.05, 50.0);
            each(&|mark| shape::scaled(mark, factor, pivot))
        }
        Handle::Turn => {
            let pivot = match marks {
                [(_, mark)] => shape::center(mark),
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

/// The step of angles with Shift, degrees.
const STEP: f64 = 15.0;

fn radius(mark: &Mark, (axis, side): (usize, f64), [from, to]: [[f64; 2]; 2], even: bool) -> Mark {
    let Mark::Ellipse(mut ellipse) = *mark else { return mark.clone() };
    let along = |point| side * shape::into_frame(point, ellipse.center, ellipse.angle)[axis];
    let radius = (ellipse.radii[axis] + along(to) - along(from)).max(shape::SMALLEST);
    let factor = radius / ellipse.radii[axis];
    ellipse.radii[axis] = radius;
    if even {
        ellipse.radii[1 - axis] *= factor;
    }
    Mark::Ellipse(ellipse)
}

fn line_end(mark: &Mark, end: usize, [from, to]: [[f64; 2]; 2], even: bool) -> Mark {
    let Mark::Line(mut line) = *mark else { return mark.clone() };
    let [fixed, free] = if end == 0 { [line.to, line.from] } else { [line.from, line.to] };
    let to = [0, 1].map(|axis| free[axis] + to[axis] - from[axis]);
    let to = if even { straightened(fixed, to) } else { to };
    *(if end == 0 { &mut line.from } else { &mut line.to }) = to;
    Mark::Line(line)
}

fn path_point(mark: &Mark, index: usize, [from, to]: [[f64; 2]; 2]) -> Mark {
    let mut mark = mark.clone();
    if let Mark::Path(path) = &mut mark
        && let Some(point) = path.points.get_mut(index)
    {
        *point = [0, 1].map(|axis| point[axis] + to[axis] - from[axis]);
    }
    mark
}

fn width(mark: &Mark, [from, to]: [[f64; 2]; 2]) -> Mark {
    let Mark::Line(line) = *mark else { return mark.clone() };
    let across = |point| shape::into_frame(point, line.center(), line.angle())[1];
    Mark::Line(Line { width: (line.width + 2.0 * (across(to) - across(from))).max(shape::SMALLEST), ..line })
}

/// `to`, turned around `from` to the nearest step of 15°.
#[must_use]
pub fn straightened(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let angle = ((y.atan2(x).to_degrees() / STEP).round() * STEP).to_radians();
    let length = x.hypot(y);
    [from[0] + length * angle.cos(), from[1] + length * angle.sin()]
}
