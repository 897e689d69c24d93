//! Pieces of stripes, drawn by hand.

use dapple::document::Line;
use dapple::document::Stroke;
use dapple_engine::attributes::regions::RegionGrid;

use super::super::dice::Dice;
use super::ranges::{FACTOR, TURN, WIDTH};
use super::rectangle;

/// Number of lines in a region.
const LINES: [usize; 2] = [3, 6];
/// Their length as a share of the region's shorter side.
const LENGTH: [f64; 2] = [0.3, 0.7];
/// Distance from one line to the next, in widths.
const APART: [f64; 2] = [1.8, 2.6];
/// Errors like those of drawing by hand: of widths up to a tenth, of angles in degrees.
const WIDER: f64 = 0.1;
const ANGLE: f64 = 5.0;
/// The part of a range that is aimed at, because measuring the sketch adds scatter.
const AIMED: f64 = 0.9;
/// The least width of a region, in stripe widths: four stripes. Fewer would show neither width nor direction.
const ROOM: f64 = 8.0;

/// The lines of a sketch; `None` where there is no room for them.
pub fn draw(dice: &mut Dice, layout: &RegionGrid) -> Option<Vec<Stroke>> {
    let [width, angle] = [dice.log_between(WIDTH), dice.between([0.0, 180.0])];
    let wider = dice.by_region(layout, AIMED * libm::log(FACTOR));
    let turned = dice.by_region(layout, AIMED * TURN);
    let mut strokes = Vec::new();
    for k in 0..layout.len() {
        let (corner, size) = rectangle(layout, k);
        let (width, angle) = (width * libm::exp(wider[k]), angle + turned[k]);
        let side = size[0].min(size[1]);
        if side < ROOM * width {
            return None;
        }
        for line in region(dice, width, angle, side) {
            let [from, to] = [line.from, line.to]
                .map(|[x, y]| [corner[0] + 0.5 * size[0] + x, corner[1] + 0.5 * size[1] + y]);
            let inside = |p: [f64; 2]| (0..2).all(|axis| p[axis] >= 0.0 && p[axis] <= layout.size[axis]);
            if !(inside(from) && inside(to)) {
                return None;
            }
            strokes.push(Stroke::Line(Line { from, to, ..line }));
        }
    }
    Some(strokes)
}

/// Lines side by side about the origin of a region with this shorter side.
fn region(dice: &mut Dice, width: f64, angle: f64, side: f64) -> Vec<Line> {
    let most = LINES[1].min((side / (APART[1] * width)) as usize).max(LINES[0]);
    let count = dice.whole([LINES[0], most]);
    let apart = width * dice.between(APART);
    (0..count)
        .map(|k| {
            let length = side * dice.between(LENGTH);
            let across = (k as f64 - 0.5 * (count as f64 - 1.0)) * apart + dice.off(0.15 * apart);
            let along = dice.off(0.1 * side);
            let unit = |degrees: f64| [libm::cos(degrees.to_radians()), libm::sin(degrees.to_radians())];
            let [[c, s], [ex, ey]] = [unit(angle), unit(angle + dice.off(ANGLE))];
            let middle = [along * c - across * s, along * s + across * c];
            let end = |half: f64| [middle[0] + half * ex, middle[1] + half * ey];
            let width = width * (1.0 + dice.off(WIDER));
            Line { from: end(-0.5 * length), to: end(0.5 * length), width }
        })
        .collect()
}
