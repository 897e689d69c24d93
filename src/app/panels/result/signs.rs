//! A sign of each region's result in its corner, on sketch and texture.

use egui::{Painter, Rect, pos2, vec2};

use crate::app::canvas::view::View;
use crate::app::result::{self, Results, Verdict};
use crate::app::theme::Palette;
use crate::editor::session::Session;

/// Side of a sign, points.
const SIGN: f32 = 16.0;
/// Regions that are shown smaller than this get no sign, points.
const SMALLEST: f32 = 26.0;

/// Paints the signs of the active layer's regions, where the canvas is shown in `room`; those of misses only, unless `all`.
pub fn paint_signs(
    painter: &Painter,
    room: Rect,
    view: View,
    all: bool,
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
        region.verdict.paint(painter, Verdict::corner(rect, SIGN, 5.0), palette);
    }
}
