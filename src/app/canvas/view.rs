//! The view: which part of the canvas is shown, and how large.

use egui::{Pos2, Rect, Vec2, pos2, vec2};

/// Smallest and largest zoom, points per px.
const ZOOM: [f32; 2] = [0.02, 64.0];
/// The share of the available space that a fitted canvas takes.
const FIT: f32 = 0.92;

/// Which part of the canvas is shown, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The point of the canvas that is shown in the centre, px.
    pub center: [f64; 2],
    /// Points of the screen per px of the canvas.
    pub zoom: f32,
    /// Whether the view is fitted, so that the whole canvas stays visible.
    pub fitted: bool,
}

impl Default for View {
    fn default() -> Self {
        Self { center: [256.0, 256.0], zoom: 1.0, fitted: true }
    }
}

impl View {
    /// Shows a whole canvas of `size` px in `room`.
    pub fn fit(&mut self, size: [u32; 2], room: Rect) {
        let size = size.map(f64::from);
        self.center = [0.5 * size[0], 0.5 * size[1]];
        let zoom = (room.width() / size[0] as f32).min(room.height() / size[1] as f32) * FIT;
        self.zoom = zoom.clamp(ZOOM[0], ZOOM[1]);
        self.fitted = true;
    }

    /// The screen position of a point of the canvas, px, that is shown in `room`.
    #[must_use]
    pub fn to_screen(self, room: Rect, point: [f64; 2]) -> Pos2 {
        let by = [0, 1].map(|axis| (point[axis] - self.center[axis]) as f32 * self.zoom);
        room.center() + vec2(by[0], by[1])
    }

    /// The point of the canvas, px, at the screen position `at`.
    #[must_use]
    pub fn to_canvas(self, room: Rect, at: Pos2) -> [f64; 2] {
        let by = (at - room.center()) / self.zoom;
        [self.center[0] + f64::from(by.x), self.center[1] + f64::from(by.y)]
    }

    /// The canvas as a rectangle on the screen.
    #[must_use]
    pub fn paper(self, room: Rect, size: [u32; 2]) -> Rect {
        Rect::from_min_max(self.to_screen(room, [0.0; 2]), self.to_screen(room, size.map(f64::from)))
    }

    /// Moves the view by a vector, points.
    pub fn pan(&mut self, by: Vec2) {
        self.center[0] -= f64::from(by.x / self.zoom);
        self.center[1] -= f64::from(by.y / self.zoom);
        self.fitted = false;
    }

    /// Zooms by `factor` about the screen position `anchor`.
    pub fn zoom_at(&mut self, room: Rect, anchor: Pos2, factor: f32) {
        let before = self.to_canvas(room, anchor);
        self.zoom = (self.zoom * factor).clamp(ZOOM[0], ZOOM[1]);
        let after = self.to_canvas(room, anchor);
        self.center = [0, 1].map(|axis| self.center[axis] + before[axis] - after[axis]);
        self.fitted = false;
    }

    /// Shows one px of the canvas as one px of the screen.
    pub fn actual_size(&mut self, pixels_per_point: f32) {
        self.zoom = 1.0 / pixels_per_point;
        self.fitted = false;
    }
}

/// The corners of a rectangle: (±1, ±1) and the position.
#[must_use]
pub fn corners(rect: Rect) -> [(Vec2, Pos2); 4] {
    [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| {
        let half = 0.5 * rect.size();
        (vec2(x, y), pos2(rect.center().x + x * half.x, rect.center().y + y * half.y))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROOM: Rect = Rect { min: Pos2 { x: 100.0, y: 50.0 }, max: Pos2 { x: 700.0, y: 450.0 } };

    #[test]
    fn zooming_keeps_the_point_under_the_pointer() {
        let mut view = View::default();
        view.fit([512, 512], ROOM);
        let before = view.to_canvas(ROOM, pos2(150.0, 333.0));
        view.zoom_at(ROOM, pos2(150.0, 333.0), 3.7);
        let after = view.to_canvas(ROOM, pos2(150.0, 333.0));
        assert!((before[0] - after[0]).abs() < 1e-3 && (before[1] - after[1]).abs() < 1e-3);
    }

    #[test]
    fn a_fitted_canvas_is_visible_as_a_whole() {
        let mut view = View::default();
        view.fit([768, 288], ROOM);
        assert!(ROOM.contains_rect(view.paper(ROOM, [768, 288])));
    }
}
