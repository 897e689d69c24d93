//! Sketches of scattered ellipses: at random places, or arranged in rows, rings, clusters or arrays.

use std::f64::consts::{PI, TAU};

use dapple_engine::marks::Ellipse;

use super::super::dice::Dice;
use super::SIDE;
use super::geometry::{outline, turned, well_apart};

/// Area of a mark, px².
const AREA: [f64; 2] = [60.0, 1_500.0];
/// Marks of a sketch.
const MARKS: [usize; 2] = [8, 30];
/// Attempts to find a place for a mark.
const PLACES: usize = 400;
/// Errors like those of drawing by hand: of radii a tenth, of directions in degrees.
const RADIUS: f64 = 0.1;
const ANGLE: f64 = 8.0;

/// How a sketch is drawn.
#[derive(Clone, Copy)]
pub struct Rules {
    /// Minor ÷ major radius.
    pub aspect: [f64; 2],
    /// Whether outlines are kept apart, and on the canvas.
    pub apart: bool,
    /// Whether the marks of every third sketch are arranged in a figure.
    pub arranged: bool,
}

/// How sizes, shapes and directions vary over a sketch.
struct Hand {
    area: f64,
    sizes: Sizes,
    aspect: f64,
    aspects: [f64; 2],
    direction: Direction,
}

enum Sizes {
    /// All sizes are similar.
    Alike,
    /// The area grows by this factor from one side to the other, along this direction.
    Graded(f64, f64),
    /// One in three is larger by this factor.
    Two(f64),
    /// Any size between the smallest and the largest allowed.
    Any,
}

enum Direction {
    /// One direction for all marks, degrees.
    Common(f64),
    /// A constant angle, degrees, to the direction towards this point.
    About([f64; 2], f64),
    /// Each mark has its own direction.
    Any,
}

/// A place to draw a mark; `None` = anywhere.
type Place = Option<[f64; 2]>;

/// The marks of sketch `index`.
pub fn draw(dice: &mut Dice, index: u64, rules: Rules) -> Vec<Ellipse> {
    loop {
        let hand = hand(dice, rules.aspect);
        // In every fourth sketch, some marks are cut by the border.
        let cut = dice.chance(0.25);
        let places = if rules.arranged && index % 3 == 2 {
            arranged(dice, &hand, index / 3)
        } else {
            vec![None; dice.whole(MARKS)]
        };
        let mut marks: Vec<Ellipse> = Vec::new();
        for place in places {
            let tries = if place.is_some() { 1 } else { PLACES };
            let fits = |mark: &Ellipse| {
                !rules.apart || on_canvas(mark, cut) && marks.iter().all(|other| well_apart(mark, other))
            };
            let mark = (0..tries).map(|_| hand.mark(dice, place)).find(fits);
            marks.extend(mark);
        }
        if (MARKS[0]..=MARKS[1]).contains(&marks.len()) {
            return marks;
        }
    }
}

/// Whether a mark is on the canvas: its whole outline or, where marks may be `cut`, more than half of it.
fn on_canvas(mark: &Ellipse, cut: bool) -> bool {
    let on = |point: [f64; 2]| point.iter().all(|x| (0.0..=SIDE).contains(x));
    if cut {
        let half = 0.5 * mark.radii[0].min(mark.radii[1]);
        return mark.center.iter().all(|x| (half..=SIDE - half).contains(x));
    }
    outline(mark).into_iter().all(on)
}

fn hand(dice: &mut Dice, aspect: [f64; 2]) -> Hand {
    let sizes = match dice.whole([0, 7]) {
        0..=3 => Sizes::Alike,
        4 | 5 => Sizes::Graded(dice.between([2.0, 6.0]), dice.between([0.0, TAU])),
        6 => Sizes::Two(dice.between([3.0, 8.0])),
        _ => Sizes::Any,
    };
    let direction = match dice.whole([0, 3]) {
        0 | 1 => Direction::Common(dice.between([0.0, 180.0])),
        2 => Direction::About(
            [0, 1].map(|_| dice.between([0.3, 0.7]) * SIDE),
            90.0 * dice.whole([0, 1]) as f64,
        ),
        _ => Direction::Any,
    };
    Hand { area: dice.log_between(AREA), sizes, aspect: dice.between(aspect), aspects: aspect, direction }
}

impl Hand {
    fn mark(&self, dice: &mut Dice, place: Place) -> Ellipse {
        let center = place.unwrap_or_else(|| [dice.between([0.0, SIDE]), dice.between([0.0, SIDE])]);
        let area = match self.sizes {
            Sizes::Alike => self.area,
            Sizes::Graded(factor, along) => {
                let at = [center[0] / SIDE - 0.5, center[1] / SIDE - 0.5];
                self.area * libm::exp(libm::log(factor) * turned(at, -along)[0])
            }
            Sizes::Two(factor) => self.area * if dice.chance(1.0 / 3.0) { factor } else { 1.0 },
            Sizes::Any => dice.log_between(AREA),
        };
        let wider = [0, 1].map(|_| 1.0 + dice.off(RADIUS));
        let aspect = (self.aspect * wider[0] / wider[1]).clamp(self.aspects[0], self.aspects[1]);
        let area = (area * wider[0] * wider[1]).clamp(AREA[0], AREA[1]);
        let angle = match self.direction {
            Direction::Common(angle) => angle,
            Direction::About(point, turn) => {
                libm::atan2(center[1] - point[1], center[0] - point[0]).to_degrees() + turn
            }
            Direction::Any => dice.between([0.0, 180.0]),
        };
        Ellipse::from_area(center, area, aspect, (angle + dice.off(ANGLE)).rem_euclid(180.0))
    }

    /// The largest diameter that its marks are likely to have.
    fn reach(&self) -> f64 {
        let larger = match self.sizes {
            Sizes::Alike => 1.0,
            Sizes::Graded(factor, _) => factor.sqrt(),
            Sizes::Two(factor) => factor,
            Sizes::Any => 1.0,
        };
        2.0 * ((self.area * larger).min(AREA[1]) / (PI * self.aspect)).sqrt()
    }
}

/// Places in rows, a ring, clusters or an array, with errors like those of drawing by hand.
fn arranged(dice: &mut Dice, hand: &Hand, which: u64) -> Vec<Place> {
    let step = (hand.reach() * dice.between([1.5, 2.5])).max(30.0);
    let middle = [0, 1].map(|_| SIDE * dice.between([0.42, 0.58]));
    let turn = dice.between([0.0, TAU]);
    let places: Vec<[f64; 2]> = match which % 4 {
        0 => {
            let gap = step * dice.between([1.0, 2.5]);
            lattice(dice.whole([4, 10]), dice.whole([2, 3]), [step, gap])
        }
        1 => {
            let count = dice.whole([8, 16]);
            let radius = step * count as f64 / TAU;
            let inner = dice.chance(0.5);
            let circle = |count: usize, radius: f64| {
                (0..count).map(move |k| turned([radius, 0.0], TAU * k as f64 / count as f64))
            };
            let within = if inner { count / 2 } else { 0 };
            circle(count, radius).chain(circle(within, 0.5 * radius)).collect()
        }
        2 => {
            let clusters = lattice(2, 2, [4.0 * step; 2]);
            let around = |[x, y]: [f64; 2]| {
                let places = lattice(3, 2, [0.8 * step; 2]);
                places.into_iter().map(move |[dx, dy]| [x + dx, y + dy])
            };
            clusters.into_iter().flat_map(around).collect()
        }
        _ => lattice(dice.whole([3, 6]), dice.whole([3, 5]), [step; 2]),
    };
    let upright = which % 8 >= 4;
    let at = |place: [f64; 2], dice: &mut Dice| {
        let [x, y] = if upright { place } else { turned(place, turn) };
        Some([middle[0] + x + dice.off(0.06 * step), middle[1] + y + dice.off(0.06 * step)])
    };
    places.into_iter().map(|place| at(place, dice)).collect()
}

/// `columns` × `rows` places about the origin.
fn lattice(columns: usize, rows: usize, step: [f64; 2]) -> Vec<[f64; 2]> {
    let at = |k: usize, n: usize| k as f64 - 0.5 * (n as f64 - 1.0);
    (0..columns * rows)
        .map(|k| [at(k % columns, columns) * step[0], at(k / columns, rows) * step[1]])
        .collect()
}
