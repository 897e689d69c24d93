//! A sign of each region's result: in its corner on the sketch, and beside the texture.

use egui::{Painter, Rect, pos2, vec2};

use crate::app::canvas::view::View;
use crate::app::result::{self, Results, Verdict};
use crate::app::theme::Palette;
use crate::editor::session::Session;

/// Side of a sign, points.
const SIGN: f32 = 16.0;
/// Regions that are shown smaller than this get no sign, points.
const SMALLEST: f32 = 26.0;

/// Space between two signs beside the texture, and between them and the texture, points.
const GAP: f32 = 2.0;

/// Where the signs are painted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Signs {
    /// In the corners of the regions.
    Corners,
    /// Beside the canvas, so that they hide nothing: to its right, else below it. The signs of a row of regions are side by side.
    Beside,
}

/// Paints the signs of the active layer's regions, where the canvas is shown in `room`; those of misses only, unless `all`.
pub fn paint_signs(
    painter: &Painter,
    room: Rect,
    view: View,
    (signs, all): (Signs, bool),
    (session, results): (&Session, &Results),
    palette: &Palette,
) {
    let Some(outcome) = results.outcome() else { return };
    let layer = result::finished_layer(session, session.active_layer);
    let Some(layer) = layer.and_then(|layer| outcome.layers.get(layer)) else { return };
    let [columns, rows] = outcome.grown.document.region_grid().map(|n| n as f32);
    let paper = view.paper(room, outcome.grown.size);
    let side = [paper.width() / columns, paper.height() / rows];
    if side[0].min(side[1]) < SMALLEST {
        return;
    }
    for region in layer.regions.iter().filter(|region| all || region.verdict == Verdict::Missed) {
        let [column, row] = region.report.place.map(|at| at as f32);
        let corner = paper.min + vec2(column * side[0], row * side[1]);
        let rect = Rect::from_min_max(corner, pos2(corner.x + side[0], corner.y + side[1]));
        let place = match signs {
            Signs::Corners => Some(Verdict::corner(rect, SIGN, 5.0)),
            Signs::Beside => beside(room, paper, rect, [column, row], [columns, rows]),
        };
        if let Some(place) = place {
            region.verdict.paint(painter, place, palette);
        }
    }
}

/// The square of the sign of a region, which is shown in `rect`, beside the canvas in `paper`; `None` where `room` has no
/// space for all signs.
fn beside(room: Rect, paper: Rect, rect: Rect, at: [f32; 2], count: [f32; 2]) -> Option<Rect> {
    let step = SIGN + GAP;
    let square = |x: f32, y: f32| Rect::from_min_size(pos2(x, y), vec2(SIGN, SIGN));
    let right = room.right() - paper.right() >= count[0] * step && paper.right() > room.left();
    let below = room.bottom() - paper.bottom() >= count[1] * step && paper.bottom() > room.top();
    if right {
        Some(square(paper.right() + GAP + at[0] * step, rect.top()))
    } else if below {
        Some(square(rect.right() - SIGN, paper.bottom() + GAP + at[1] * step))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_are_beside_the_canvas_in_the_order_of_its_regions_or_left_out() {
        let room = Rect::from_min_size(pos2(0.0, 0.0), vec2(200.0, 200.0));
        let [wide, high] =
            [[100.0, 190.0], [190.0, 100.0]].map(|[x, y]| Rect::from_min_size(room.min, vec2(x, y)));
        let of = |paper: Rect, at: [f32; 2]| {
            let side = 0.5 * paper.size();
            let rect = Rect::from_min_size(paper.min + vec2(at[0], at[1]) * side, side);
            beside(room, paper, rect, at, [2.0, 2.0])
        };
        for paper in [wide, high] {
            let places = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].map(|at| of(paper, at).unwrap());
            assert!(
                places.iter().all(|sign| room.contains_rect(*sign) && !paper.intersects(*sign)),
                "{places:?}"
            );
            assert!(places[0].left() < places[1].left() && places[0].top() < places[2].top());
        }
        assert_eq!(of(room, [0.0, 0.0]), None);
    }
}
