//! Moving and scaling the reference picture with the tool *Select*, while it is not locked.

use egui::{CursorIcon, Pos2, Rect, Stroke, StrokeKind, vec2};

use super::Canvas;
use super::ink::Ink;
use super::reference::Part;
use super::tool::Tool;
use crate::app::theme::Palette;
use crate::editor::session::Session;

/// The pointer picks a corner within this distance, points.
const REACH: f32 = 10.0;

impl Canvas {
    /// The picture on the screen where it can be moved now.
    fn movable_reference(&self, room: Rect, session: &Session) -> Option<Rect> {
        let can_move = self.tool == Tool::Select && !self.reference.locked;
        self.reference.rect(self.view, room, session.document().size).filter(|_| can_move)
    }

    /// The part of the picture at a position on the screen, where the picture can be moved. A mark at that position
    /// takes precedence over the inside of the picture.
    pub(super) fn reference_part(&self, room: Rect, session: &Session, at: Pos2, reach: f64) -> Option<Part> {
        let rect = self.movable_reference(room, session)?;
        if let Some((sides, _)) = corners(rect).into_iter().find(|(_, corner)| corner.distance(at) <= REACH) {
            return Some(Part::Corner(sides));
        }
        let point = self.view.to_canvas(room, at);
        (rect.contains(at) && session.hit(point, reach).is_none()).then_some(Part::Whole)
    }

    /// Paints its frame and its corners, where it can be moved.
    pub(super) fn paint_reference_handles(&self, ink: &Ink, session: &Session, colours: &Palette) {
        let Some(rect) = self.movable_reference(ink.room, session) else { return };
        ink.dashed([rect.min, rect.max], Stroke::new(1.0, colours.edge));
        for (_, corner) in corners(rect) {
            let square = Rect::from_center_size(corner, vec2(9.0, 9.0));
            let stroke = Stroke::new(1.5, colours.edge);
            ink.painter.rect(square, 2.0, colours.paper, stroke, StrokeKind::Middle);
        }
    }
}

/// The corners of the picture: whether each is on the right, whether it is at the bottom, and its position.
fn corners(rect: Rect) -> [([bool; 2], Pos2); 4] {
    [
        ([false, false], rect.left_top()),
        ([true, false], rect.right_top()),
        ([true, true], rect.right_bottom()),
        ([false, true], rect.left_bottom()),
    ]
}

/// The pointer's shape over a part.
pub(super) fn cursor(part: Part) -> CursorIcon {
    match part {
        Part::Whole => CursorIcon::Move,
        Part::Corner([right, below]) if right == below => CursorIcon::ResizeNwSe,
        Part::Corner(_) => CursorIcon::ResizeNeSw,
    }
}
