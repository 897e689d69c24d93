//! The photograph with the marks that were found, the regions, and four corners that can be dragged.

use egui::{
    Color32, CursorIcon, Id, Key, Pos2, Rect, Role, Sense, Stroke, StrokeKind, TextureId, Ui, Vec2,
    WidgetInfo, pos2, vec2,
};

use crate::app::theme::Palette;
use crate::photo::Corners;

/// Side of the square around a corner in which the pointer picks the corner, points.
const REACH: f32 = 26.0;
/// Radius of a corner, points.
const RADIUS: f32 = 6.5;
/// Room around the photograph, points: half of a corner.
const MARGIN: f32 = 8.0;
/// Names of the corners.
const NAMES: [&str; 4] =
    ["Upper left corner", "Upper right corner", "Lower right corner", "Lower left corner"];
/// The line between the corners and that between regions, over any photograph.
const LIGHT: Color32 = Color32::from_rgb(0xff, 0xff, 0xff);
const SHADE: Color32 = Color32::from_rgba_premultiplied(0, 0, 0, 150);

/// The view.
#[derive(Default)]
pub struct View {
    /// Width and height of the photograph, px.
    pub size: [f64; 2],
    /// The corner that is dragged, the distance from its middle at which it was picked, and the present places of the
    /// corners.
    dragged: Option<(usize, Vec2, Corners)>,
    /// Where the photograph is on the screen.
    place: Option<Rect>,
}

impl View {
    /// Whether a corner is being dragged.
    #[must_use]
    pub fn is_dragged(&self) -> bool {
        self.dragged.is_some()
    }

    /// Where a corner is on the screen.
    #[must_use]
    pub fn corner(&self, corner: usize, corners: Option<Corners>) -> Pos2 {
        self.to_screen(corners.unwrap_or(self.whole()).0[corner])
    }

    /// The corners of the photograph itself.
    fn whole(&self) -> Corners {
        let [width, height] = self.size;
        Corners([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]])
    }

    fn to_screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        let place = self.place.unwrap_or(Rect::ZERO);
        place.min + vec2((x / self.size[0]) as f32, (y / self.size[1]) as f32) * place.size()
    }

    /// The place in the photograph, px; outside the photograph, the nearest place on its border.
    fn to_photo(&self, at: Pos2) -> [f64; 2] {
        let place = self.place.unwrap_or(Rect::ZERO);
        let share = (at - place.min) / place.size();
        [(f64::from(share.x), 0), (f64::from(share.y), 1)]
            .map(|(share, axis)| (share * self.size[axis]).clamp(0.0, self.size[axis]))
    }

    /// Shows it in `room`: the photograph, the marks with their opacity, the lines between regions.
    pub fn ui(
        &mut self,
        ui: &Ui,
        room: Rect,
        photo: TextureId,
        overlay: Option<(TextureId, f32)>,
        regions: Option<[u32; 2]>,
        corners: &mut Option<Corners>,
    ) {
        let room = room.shrink(MARGIN);
        let size = vec2(self.size[0] as f32, self.size[1] as f32);
        let scale = (room.width() / size.x).min(room.height() / size.y);
        let place = Rect::from_center_size(room.center(), size * scale);
        self.place = Some(place);
        let painter = ui.painter();
        let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
        painter.image(photo, place, whole, Color32::WHITE);
        if let Some((overlay, opacity)) = overlay {
            painter.image(overlay, place, whole, Color32::WHITE.gamma_multiply(opacity));
        }
        let border = Palette::current(ui.visuals()).border;
        painter.rect_stroke(place, 0.0, Stroke::new(1.0, border), StrokeKind::Outside);
        self.drag(ui, corners);
        let shown = self.dragged.map_or(corners.unwrap_or(self.whole()), |(.., corners)| corners);
        if let (Some(regions), None) = (regions, self.dragged) {
            self.region_lines(ui, shown, regions);
        }
        self.paint_corners(ui, shown, corners.is_some() || self.is_dragged());
    }

    /// Moves a corner that is dragged or pushed by the arrow keys.
    fn drag(&mut self, ui: &Ui, corners: &mut Option<Corners>) {
        let keeps_rectangle = ui.input(|input| input.modifiers.shift);
        for (index, name) in NAMES.into_iter().enumerate() {
            let now = corners.unwrap_or(self.whole());
            let at = self.to_screen(now.0[index]);
            let rect = Rect::from_center_size(at, Vec2::splat(REACH));
            let response = ui.interact(rect, Id::unique(("photo corner", index)), Sense::click_and_drag());
            response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name));
            // A drag is seen as one after the pointer has moved a little.
            let pressed = ui.input(|input| input.pointer.press_origin());
            if let (true, Some(pressed)) = (response.drag_started(), pressed) {
                self.dragged = Some((index, pressed - at, now));
            }
            if let (Some((dragged, off, last)), Some(pointer)) =
                (self.dragged, response.interact_pointer_pos())
                && dragged == index
            {
                let moved = moved(last, index, self.to_photo(pointer - off), keeps_rectangle);
                if moved.are_convex() && is_large(moved) {
                    self.dragged = Some((index, off, moved));
                }
            }
            if let (true, Some((dragged, _, moved))) = (response.drag_stopped(), self.dragged)
                && dragged == index
            {
                self.dragged = None;
                *corners = (moved != self.whole()).then_some(moved);
            }
            if response.has_focus() {
                self.push(ui, &response, index, corners);
            }
            response.on_hover_cursor(CursorIcon::Grab);
        }
    }

    /// Moves the corner with the keyboard focus by the arrow keys.
    fn push(&self, ui: &Ui, response: &egui::Response, index: usize, corners: &mut Option<Corners>) {
        let filter =
            egui::EventFilter { tab: false, horizontal_arrows: true, vertical_arrows: true, escape: false };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
        let (by, far) = ui.input(|input| {
            let pressed = |key| input.num_presses(key) as f64;
            let across = pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
            ([across, pressed(Key::ArrowDown) - pressed(Key::ArrowUp)], input.modifiers.shift)
        });
        if by == [0.0; 2] {
            return;
        }
        let step = if far { 10.0 } else { 1.0 };
        let now = corners.unwrap_or(self.whole());
        let to = [0, 1].map(|axis| (now.0[index][axis] + step * by[axis]).clamp(0.0, self.size[axis]));
        let moved = moved(now, index, to, false);
        if moved.are_convex() && is_large(moved) {
            *corners = (moved != self.whole()).then_some(moved);
        }
    }

    fn region_lines(&self, ui: &Ui, corners: Corners, [columns, rows]: [u32; 2]) {
        let project = corners.projection();
        let line = |from: [f64; 2], to: [f64; 2]| {
            let ends = [from, to].map(|end| self.to_screen(project(end)));
            ui.painter().line_segment(ends, Stroke::new(2.0, SHADE.gamma_multiply(0.7)));
            ui.painter().extend(egui::Shape::dashed_line(&ends, Stroke::new(1.0, LIGHT), 4.0, 5.0));
        };
        for column in 1..columns {
            let x = f64::from(column) / f64::from(columns);
            line([x, 0.0], [x, 1.0]);
        }
        for row in 1..rows {
            let y = f64::from(row) / f64::from(rows);
            line([0.0, y], [1.0, y]);
        }
    }

    fn paint_corners(&self, ui: &Ui, corners: Corners, framed: bool) {
        let colours = Palette::current(ui.visuals());
        let points = corners.0.map(|corner| self.to_screen(corner));
        let painter = ui.painter();
        if framed {
            painter.add(egui::Shape::closed_line(points.to_vec(), Stroke::new(3.0, SHADE)));
            painter.add(egui::Shape::closed_line(points.to_vec(), Stroke::new(1.4, LIGHT)));
        }
        for (index, at) in points.into_iter().enumerate() {
            let id = Id::unique(("photo corner", index));
            let response = ui.ctx().read_response(id);
            let is_marked = response.is_some_and(|response| response.hovered() || response.has_focus());
            let is_dragged = self.dragged.is_some_and(|(dragged, ..)| dragged == index);
            let fill = if is_marked || is_dragged { colours.accent } else { LIGHT };
            painter.circle(at, RADIUS + 1.5, SHADE, Stroke::NONE);
            painter.circle(at, RADIUS, fill, Stroke::NONE);
            painter.circle(
                at,
                2.5,
                if is_marked || is_dragged { LIGHT } else { colours.accent },
                Stroke::NONE,
            );
        }
    }
}

/// The corners after one was moved. As a rectangle, its neighbours move with it.
fn moved(corners: Corners, index: usize, to: [f64; 2], keeps_rectangle: bool) -> Corners {
    let mut moved = corners;
    moved.0[index] = to;
    if keeps_rectangle {
        // Upper left, upper right, lower right, lower left.
        moved.0[index ^ 1][1] = to[1];
        moved.0[3 - index][0] = to[0];
        let far = [moved.0[index ^ 1][0], moved.0[3 - index][1]];
        moved.0[index ^ 2] = far;
    }
    moved
}

/// The least length of a side, px: a shorter one shows no marks.
const SHORTEST: f64 = 16.0;

fn is_large(corners: Corners) -> bool {
    corners.size().into_iter().all(|side| side >= SHORTEST)
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHOLE: Corners = Corners([[0.0, 0.0], [80.0, 0.0], [80.0, 60.0], [0.0, 60.0]]);

    #[test]
    fn a_dragged_corner_moves_alone_or_takes_the_rectangle_along() {
        let free = moved(WHOLE, 1, [70.0, 10.0], false);
        assert_eq!(free.0, [[0.0, 0.0], [70.0, 10.0], [80.0, 60.0], [0.0, 60.0]]);
        for (index, wanted) in [
            (0, [[10.0, 12.0], [80.0, 12.0], [80.0, 60.0], [10.0, 60.0]]),
            (1, [[0.0, 12.0], [10.0, 12.0], [10.0, 60.0], [0.0, 60.0]]),
            (2, [[0.0, 0.0], [10.0, 0.0], [10.0, 12.0], [0.0, 12.0]]),
            (3, [[10.0, 0.0], [80.0, 0.0], [80.0, 12.0], [10.0, 12.0]]),
        ] {
            assert_eq!(moved(WHOLE, index, [10.0, 12.0], true).0, wanted, "{index}");
        }
        assert!(is_large(WHOLE) && !is_large(moved(WHOLE, 2, [10.0, 12.0], true)));
    }
}
