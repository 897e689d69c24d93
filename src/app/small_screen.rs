//! Small screens, such as those of phones: sketch and texture lie one above the other, the column on the right is folded, and dialogs
//! can be scrolled. A window on a desktop is as small only where the interface is scaled up.

use egui::{Context, Frame, Id, Modal, ModalResponse, Rect, ScrollArea, Ui, Vec2, vec2};

/// The width below which a screen is small, points.
const SMALL: f32 = 600.0;
/// The width below which sketch, texture and the column on the right have no room beside each other, points: the smallest
/// window of an interface that is not scaled has more.
const NARROW: f32 = 740.0;
/// The height below which dialogs can be scrolled, points.
const LOW: f32 = 470.0;
/// The part of the width and height of a small screen that a dialog leaves free, points.
const AROUND: f32 = 20.0;
/// The largest margin within a dialog on a small screen, points.
const MARGIN: i8 = 8;
/// The part of the screen's width and height that a dialog of full size leaves free, margins included, points.
const AROUND_LARGE: f32 = 92.0;
/// The share of a dialog's height that its choices take on a small screen; the preview has the rest.
const CHOICES: f32 = 0.55;
/// Space between the two parts of a dialog, points.
const GAP: f32 = 18.0;

/// Whether the screen is small.
#[must_use]
pub fn is_small(ctx: &Context) -> bool {
    ctx.content_rect().width() < SMALL
}

/// Whether the column on the right is folded: on a narrow screen, where a button in the status line shows it.
#[must_use]
pub fn is_narrow(ctx: &Context) -> bool {
    ctx.content_rect().width() < NARROW
}

/// Whether dialogs can be scrolled.
fn is_tight(ctx: &Context) -> bool {
    is_small(ctx) || ctx.content_rect().height() < LOW
}

/// Sets the width of a dialog; it is less where the screen is narrower.
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
    let margin = if is_tight(ctx) { margin.min(MARGIN) } else { margin };
    let modal = Modal::new(Id::unique(id)).frame(Frame::window(&ctx.global_style()).inner_margin(margin));
    if !is_tight(ctx) {
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
pub fn dialog_size(ctx: &Context, largest: [f32; 2]) -> Vec2 {
    let around = if is_small(ctx) { AROUND + 2.0 * f32::from(MARGIN) } else { AROUND_LARGE };
    (ctx.content_rect().size() - Vec2::splat(around)).min(largest.into())
}

/// The two parts of a dialog: its choices, `column` points wide where there is room, and beside or below them the
/// preview.
#[must_use]
pub fn parts(ctx: &Context, all: Rect, column: f32) -> [Rect; 2] {
    if is_small(ctx) {
        let (above, below) = all.split_top_bottom_at_fraction(CHOICES);
        return [above, Rect::from_min_max(below.min + vec2(0.0, GAP / 2.0), below.max)];
    }
    let left = Rect::from_min_size(all.min, vec2(column, all.height()));
    [left, Rect::from_min_max(all.min + vec2(column + GAP, 0.0), all.max)]
}
