//! Small screens, such as those of phones: sketch and texture lie one above the other, the column on the right is folded, and dialogs
//! can be scrolled. A window on a desktop is never so small.

use egui::{Context, Frame, Id, Modal, ModalResponse, Rect, ScrollArea, Ui, pos2, vec2};

/// The width below which a screen is small, points.
const SMALL: f32 = 600.0;
/// What a dialog leaves of the width and height of a small screen, points.
const AROUND: f32 = 20.0;
/// Share of a dialog's height that its choices have on a small screen; what they make has the rest.
const CHOICES: f32 = 0.55;
/// Between the two parts of a dialog, points.
const GAP: f32 = 18.0;

/// Whether the screen is small.
#[must_use]
pub fn is_small(ctx: &Context) -> bool {
    ctx.content_rect().width() < SMALL
}

/// Sets the width of a dialog: less where the screen has less.
pub fn fit_width(ui: &mut Ui, width: f32) {
    let widest = if is_small(ui.ctx()) { ui.available_width() } else { f32::INFINITY };
    ui.set_width(width.min(widest));
}

/// Shows a dialog over the window.
pub fn dialog<R>(
    ctx: &Context,
    id: &str,
    margin: i8,
    content: impl FnOnce(&mut Ui) -> R,
) -> ModalResponse<R> {
    let margin = if is_small(ctx) { margin.min(8) } else { margin };
    let modal = Modal::new(Id::unique(id)).frame(Frame::window(&ctx.global_style()).inner_margin(margin));
    if !is_small(ctx) {
        return modal.show(ctx, content);
    }
    let room = ctx.content_rect().size() - vec2(AROUND, AROUND) - 2.0 * vec2(margin.into(), margin.into());
    modal.show(ctx, |ui| {
        ui.set_max_size(room);
        ScrollArea::both().max_width(room.x).max_height(room.y).show(ui, content).inner
    })
}

/// The size of a dialog that fills the screen, at most `largest`.
#[must_use]
pub fn dialog_size(ctx: &Context, largest: [f32; 2]) -> egui::Vec2 {
    let around = if is_small(ctx) { vec2(AROUND + 16.0, AROUND + 16.0) } else { vec2(92.0, 92.0) };
    (ctx.content_rect().size() - around).min(largest.into())
}

/// The parts of a dialog: its choices, `column` wide where there is room, and beside or beneath them what they make.
#[must_use]
pub fn parts(ctx: &Context, all: Rect, column: f32) -> [Rect; 2] {
    if is_small(ctx) {
        let (above, below) = all.split_top_bottom_at_fraction(CHOICES);
        return [above, Rect::from_min_max(below.min + vec2(0.0, GAP / 2.0), below.max)];
    }
    let left = Rect::from_min_size(all.min, vec2(column, all.height()));
    [left, Rect::from_min_max(all.min + vec2(column + GAP, 0.0), all.max)]
}

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

    /// What lies behind the bars: one ground where they are beside each other, so that no seam is seen.
    #[must_use]
    pub fn grounds(&self) -> Vec<Rect> {
        let [first, second] = self.bars;
        if first.top() == second.top() { vec![first.union(second)] } else { self.bars.to_vec() }
    }

    /// The line between sketch and texture.
    #[must_use]
    pub fn line(&self) -> [egui::Pos2; 2] {
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
