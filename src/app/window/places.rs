//! Where sketch and texture are shown: beside each other, one over the other, or, on a small screen, one above the other.

use egui::{Context, Pos2, Rect, pos2};

use crate::app::small_screen::is_small;

/// Height of the bars above sketch and texture, points.
const BAR: f32 = 38.0;

/// Where sketch and texture are shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Places {
    /// The bars above them.
    pub bars: [Rect; 2],
    /// Sketch and texture.
    pub rooms: [Rect; 2],
}

impl Places {
    /// In `all`; `over`: one over the other.
    #[must_use]
    pub fn new(ctx: &Context, all: Rect, over: bool) -> Self {
        Self::below_bars(ctx, all, over, BAR)
    }

    /// In `all`, without bars above them.
    #[must_use]
    pub fn without_bars(ctx: &Context, all: Rect, over: bool) -> Self {
        Self::below_bars(ctx, all, over, 0.0)
    }

    fn below_bars(ctx: &Context, all: Rect, over: bool, height: f32) -> Self {
        let bar = |room: Rect| room.split_top_bottom_at_y(room.top() + height);
        if !is_small(ctx) {
            let (head, body) = bar(all);
            let ((left, right), halves) = (halves(head), halves(body));
            let rooms = if over { [body; 2] } else { [halves.0, halves.1] };
            return Self { bars: [left, right], rooms };
        }
        if over {
            let (first, below) = bar(all);
            let (second, body) = bar(below);
            return Self { bars: [first, second], rooms: [body; 2] };
        }
        let (above, below) = all.split_top_bottom_at_fraction(0.5);
        let [(first, sketch), (second, texture)] = [bar(above), bar(below)];
        Self { bars: [first, second], rooms: [sketch, texture] }
    }

    /// The backgrounds behind the bars: a single one where the bars are side by side, so that no seam is visible
    /// between them.
    #[must_use]
    pub fn grounds(&self) -> Vec<Rect> {
        let [first, second] = self.bars;
        if first.top() == second.top() { vec![first.union(second)] } else { self.bars.to_vec() }
    }

    /// The line between sketch and texture.
    #[must_use]
    pub fn line(&self) -> [Pos2; 2] {
        let [sketch, texture] = self.rooms;
        if texture.top() > sketch.top() {
            [pos2(sketch.left(), sketch.bottom()), sketch.max]
        } else {
            [pos2(sketch.right(), sketch.top()), sketch.max]
        }
    }
}

fn halves(rect: Rect) -> (Rect, Rect) {
    rect.split_left_right_at_fraction(0.5)
}
