//! Random sketches like those that are drawn by hand: a few marks in each quarter of the canvas, whose size and direction change steadily
//! across it.

use std::f64::consts::TAU;

use super::dice::Dice;
use super::kind::Kind;
use crate::attributes::Spread;
use crate::colour::PRESETS;
use crate::document::{
    Colours, Document, GapChoice, Layer, LayerOptions, SpreadChoice, Stroke, SystemChoice,
};
use crate::marks::Ellipse;

/// Distance from one mark to the next, px; at most this share of the side.
const SPACING: Distances = Distances { range: [18.0, 60.0], widest: 0.22 };
const SPACING_OF_AREAS: Distances = Distances { range: [22.0, 66.0], widest: 0.26 };
const SPACING_OF_LINES: Distances = Distances { range: [14.0, 48.0], widest: 0.19 };
/// Area ÷ spacing². Irregular spots have no other than this, nearly.
const PACKING: [f64; 2] = [0.08, 0.18];
const PACKING_OF_IRREGULAR: [f64; 2] = [0.19, 0.23];
const PACKING_OF_PATCHES: [f64; 2] = [0.3, 0.55];
/// Minor ÷ major radius.
const ASPECT: [f64; 2] = [0.35, 1.0];
const ASPECT_OF_IRREGULAR: [f64; 2] = [0.55, 1.0];
const ASPECT_OF_AREAS: [f64; 2] = [0.5, 1.0];
/// Width ÷ period of stripes, and their least width, px.
const DUTY: [f64; 2] = [0.3, 0.6];
const THINNEST: f64 = 4.0;
/// Width of the lines between cells, px.
const GAP: [f64; 2] = [2.5, 7.5];
/// The most by which spots vary.
const SPREAD: Spread = Spread { area: 0.25, angle: 8.0, aspect: 0.0, spacing: 0.12 };
/// From the middle of the canvas to those of its quarters, along x and along y, the logarithm of lengths changes by this at most, and
/// directions by this, degrees.
const GROWING: f64 = 0.1;
const TURNING: f64 = 10.0;
/// Errors of drawing: of radii and widths as a share, of angles in degrees, of places as a share of the spacing.
const RADIUS: f64 = 0.06;
const ANGLE: f64 = 4.0;
const PLACE: f64 = 0.06;
/// Corners of an outline, and by how much they are off its ellipse, as a share of the radius.
const CORNERS: usize = 16;
const RAGGED: f64 = 0.12;

/// How far apart marks are, px; at most a share of the side.
#[derive(Clone, Copy)]
struct Distances {
    range: [f64; 2],
    widest: f64,
}

/// What is drawn at each place: changes linearly with the place.
struct Field {
    spacing: f64,
    angle: f64,
    /// Changes of log spacing and of the angle along x and y, from the middle of the canvas to those of its quarters.
    growing: [f64; 2],
    turning: [f64; 2],
    side: f64,
}

impl Field {
    fn random(dice: &mut Dice, Distances { range: [least, most], widest }: Distances, side: f64) -> Self {
        Self {
            spacing: dice.log_between([least, most.min(side * widest).max(least)]),
            angle: dice.between([0.0, 180.0]),
            growing: [0, 1].map(|_| dice.off(GROWING)),
            turning: [0, 1].map(|_| dice.off(TURNING)),
            side,
        }
    }

    /// The middles of the quarters of the canvas.
    fn quarters(&self) -> [[f64; 2]; 4] {
        [[0.25, 0.25], [0.75, 0.25], [0.25, 0.75], [0.75, 0.75]]
            .map(|place| place.map(|along| along * self.side))
    }

    /// Spacing and angle at a place.
    fn at(&self, place: [f64; 2]) -> (f64, f64) {
        let from_middle = place.map(|along| 4.0 * along / self.side - 2.0);
        let sum = |slope: [f64; 2]| slope[0] * from_middle[0] + slope[1] * from_middle[1];
        (self.spacing * libm::exp(sum(self.growing)), self.angle + sum(self.turning))
    }
}

/// A random document of this kind on a square canvas of `side` px; it may have no room for its marks.
///
/// Each quarter is a region, whose marks say what grows there. Irregular spots have free marks: they are corrected by a growth for each
/// region, which takes longer than the texture.
pub fn sketch(kind: Kind, side: u32, dice: &mut Dice) -> Document {
    let (strokes, options, system) = drawn(kind, f64::from(side), dice);
    let colours = Colours::from(&PRESETS[dice.below(PRESETS.len())].set.gradient());
    let layer = Layer { name: kind.name().to_owned(), system, strokes, options, ..Layer::default() };
    let document = Document::new([side, side]).with_seed(dice.seed()).with_layer(layer.with_colours(colours));
    if kind == Kind::IrregularSpots { document } else { document.with_regions([2, 2]) }
}

/// The system of this name, which exists.
fn system(name: &str) -> SystemChoice {
    SystemChoice::named(name).unwrap_or_default()
}

/// Strokes, options and system of a kind.
fn drawn(kind: Kind, side: f64, dice: &mut Dice) -> (Vec<Stroke>, LayerOptions, SystemChoice) {
    let mut options = LayerOptions::default();
    match kind {
        Kind::Spots => {
            let packing = dice.log_between(PACKING);
            let aspect = dice.between(ASPECT);
            options.spread = SpreadChoice::Given(spread(dice));
            (
                ellipses(dice, (side, SPACING), (packing, aspect), Stroke::Ellipse),
                options,
                system("meinhardt-spots"),
            )
        }
        Kind::IrregularSpots => {
            options.irregular = dice.between([0.3, 1.0]);
            options.spread = SpreadChoice::Given(Spread::ZERO);
            let packing = dice.log_between(PACKING_OF_IRREGULAR);
            let aspect = dice.between(ASPECT_OF_IRREGULAR);
            (
                ellipses(dice, (side, SPACING), (packing, aspect), Stroke::Ellipse),
                options,
                system("turing-spots"),
            )
        }
        Kind::Patches => {
            let packing = dice.between(PACKING_OF_PATCHES);
            let aspect = dice.between(ASPECT_OF_AREAS);
            // Corners take numbers of their own, while `dice` lays the ellipses.
            let mut corners = Dice::of_item(dice.seed(), 0, 0);
            let ragged = corners.between([0.02, RAGGED]);
            let outline = |spot| outline(&spot, ragged, &mut corners);
            (ellipses(dice, (side, SPACING_OF_AREAS), (packing, aspect), outline), options, system("patches"))
        }
        Kind::Cells => {
            options.gap = GapChoice::Given(dice.between(GAP));
            let aspect = dice.between(ASPECT_OF_AREAS);
            // Cells fill the canvas: only the spacing and the form of the ellipses say how large they are.
            (
                ellipses(dice, (side, SPACING_OF_AREAS), (0.6, aspect), Stroke::Ellipse),
                options,
                system("cells"),
            )
        }
        Kind::Stripes => (lines(dice, side), options, SystemChoice::Stripes),
        Kind::PairStripes => (lines(dice, side), options, system("pair-stripes")),
        Kind::Stucco => {
            options.decay = dice.between([0.2, 0.85]);
            (lines(dice, side), options, system("stucco"))
        }
    }
}

/// How much the spots of a sketch vary.
fn spread(dice: &mut Dice) -> Spread {
    let mut up_to = |most: f64| dice.between([0.0, most]);
    Spread {
        area: up_to(SPREAD.area),
        angle: up_to(SPREAD.angle),
        aspect: SPREAD.aspect,
        spacing: up_to(SPREAD.spacing),
    }
}

/// Groups of three ellipses this far apart, of this area ÷ spacing² and aspect.
fn ellipses(
    dice: &mut Dice,
    (side, spacings): (f64, Distances),
    (packing, aspect): (f64, f64),
    mut stroke: impl FnMut(Ellipse) -> Stroke,
) -> Vec<Stroke> {
    let field = Field::random(dice, spacings, side);
    let mut strokes = Vec::new();
    for middle in field.quarters() {
        let (spacing, angle) = field.at(middle);
        let turned = dice.between([0.0, TAU]);
        for corner in 0..3 {
            let (s, c) = libm::sincos(turned + TAU * f64::from(corner) / 3.0);
            // The corners of a triangle are spacing ÷ √3 from its middle.
            let from_middle = [c, s].map(|along| (along / 3.0_f64.sqrt() + dice.off(PLACE)) * spacing);
            let center = [middle[0] + from_middle[0], middle[1] + from_middle[1]];
            let area = packing * spacing * spacing * libm::exp(dice.off(2.0 * RADIUS));
            let aspect = (aspect + dice.off(RADIUS)).clamp(ASPECT[0], 1.0);
            strokes.push(stroke(Ellipse::from_area(center, area, aspect, angle + dice.off(ANGLE))));
        }
    }
    strokes
}

/// An outline around an ellipse.
fn outline(ellipse: &Ellipse, ragged: f64, dice: &mut Dice) -> Stroke {
    let (s, c) = libm::sincos(ellipse.angle.to_radians());
    let corners: Vec<[f64; 2]> = (0..CORNERS)
        .map(|corner| {
            let (sin, cos) = libm::sincos(TAU * corner as f64 / CORNERS as f64);
            let off = 1.0 + dice.off(ragged);
            let [along, across] = [off * ellipse.radii[0] * cos, off * ellipse.radii[1] * sin];
            [ellipse.center[0] + along * c - across * s, ellipse.center[1] + along * s + across * c]
        })
        .collect();
    Stroke::outline(corners)
}

/// Groups of two lines side by side.
fn lines(dice: &mut Dice, side: f64) -> Vec<Stroke> {
    let field = Field::random(dice, SPACING_OF_LINES, side);
    let duty = dice.between(DUTY);
    let mut strokes = Vec::new();
    for middle in field.quarters() {
        let (period, angle) = field.at(middle);
        let length = period * dice.between([1.5, 2.0]);
        let (s, c) = libm::sincos((angle + dice.off(ANGLE)).to_radians());
        for row in [-0.5, 0.5] {
            let across = (row + dice.off(PLACE)) * period;
            let width = (duty * period * libm::exp(dice.off(RADIUS))).max(THINNEST);
            let at = |along: f64| [middle[0] + along * c - across * s, middle[1] + along * s + across * c];
            strokes.push(Stroke::line(at(-0.5 * length), at(0.5 * length), width));
        }
    }
    strokes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sketches_of_all_kinds_are_valid_documents_and_most_differ() {
        for kind in Kind::ALL {
            let mut seeds = std::collections::BTreeSet::new();
            for index in 0..40 {
                let document = sketch(kind, 256, &mut Dice::of_item(1, index, 0));
                let valid = document.check("x");
                assert!(valid.is_ok(), "{} {index}: {}", kind.name(), valid.unwrap_err());
                seeds.insert(document.seed);
            }
            assert_eq!(seeds.len(), 40);
        }
    }
}
