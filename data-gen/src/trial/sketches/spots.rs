//! Spots, drawn by hand.

use std::f64::consts::TAU;

use dapple::document::Ellipse;
use dapple::document::Stroke;
use dapple_engine::attributes::regions::RegionGrid;
use dapple_engine::attributes::spacing::mean_spacing;

use super::super::dice::Dice;
use super::ranges::{AREA, ASPECT, FACTOR, LOOSER, PACKING, TURN};
use super::rectangle;

/// Number of spots in a region.
const MARKS: [usize; 2] = [5, 12];
/// Errors like those of drawing by hand: of radii up to a tenth, of angles in degrees, of places as a share of the
/// spacing.
const RADIUS: f64 = 0.1;
const ANGLE: f64 = 8.0;
const PLACE: f64 = 0.15;
/// The part of a range that is aimed at, because measuring the sketch adds scatter.
const AIMED: f64 = 0.9;
/// Arrangements that are tried in a region.
const TRIES: usize = 20;
/// Spots are drawn so far apart that spots larger by this factor would not touch.
const ROOM: f64 = 1.05;

/// The attributes that are aimed at in a region.
struct Aim {
    area: f64,
    aspect: f64,
    angle: f64,
    spacing: f64,
}

/// The spots of a sketch; `None` where there is no room for them.
pub fn draw(dice: &mut Dice, layout: &RegionGrid) -> Option<Vec<Stroke>> {
    let mut all: Vec<Ellipse> = Vec::new();
    for (index, aim) in aims(dice, layout).iter().enumerate() {
        let corner = rectangle(layout, index);
        let marks = (0..TRIES).find_map(|_| region(dice, aim, corner, &all))?;
        all.extend(marks);
    }
    Some(all.into_iter().map(Stroke::Ellipse).collect())
}

fn aims(dice: &mut Dice, layout: &RegionGrid) -> Vec<Aim> {
    let [area, packing] = [dice.log_between(AREA), dice.log_between(PACKING)];
    let [aspect, angle] = [dice.between(ASPECT), dice.between([0.0, 180.0])];
    let larger = dice.by_region(layout, AIMED * libm::log(FACTOR));
    let looser = dice.by_region(layout, AIMED * libm::log(LOOSER));
    let rounder = dice.by_region(layout, 0.2);
    let turned = dice.by_region(layout, AIMED * TURN);
    let aim = |k: usize| {
        let area = area * libm::exp(larger[k]);
        Aim {
            area,
            aspect: (aspect + rounder[k]).clamp(ASPECT[0], ASPECT[1]),
            angle: angle + turned[k],
            spacing: (area / (packing * libm::exp(looser[k]))).sqrt(),
        }
    };
    (0..layout.len()).map(aim).collect()
}

/// Spots in a region with this corner and size, which do not touch those that are already there.
fn region(
    dice: &mut Dice,
    aim: &Aim,
    (corner, size): ([f64; 2], [f64; 2]),
    there: &[Ellipse],
) -> Option<Vec<Ellipse>> {
    let places = arrangement(dice, aim)?;
    let margin = 0.5 * (aim.area / std::f64::consts::PI).sqrt();
    let mut shift = [0.0; 2];
    for axis in 0..2 {
        let (low, high) = places.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
            (low.min(place[axis]), high.max(place[axis]))
        });
        let spare = size[axis] - 2.0 * margin - (high - low);
        if spare < 0.0 {
            return None;
        }
        shift[axis] = corner[axis] + margin - low + dice.between([0.0, spare]);
    }
    let mut marks: Vec<Ellipse> = Vec::new();
    for [x, y] in places {
        let drawn = Ellipse::from_area([x + shift[0], y + shift[1]], aim.area, aim.aspect, 0.0);
        let radii = drawn.radii.map(|radius| radius * (1.0 + dice.off(RADIUS)));
        let mark = Ellipse { radii, angle: (aim.angle + dice.off(ANGLE)).rem_euclid(180.0), ..drawn };
        if there.iter().chain(&marks).any(|other| touch(&mark, other)) {
            return None;
        }
        marks.push(mark);
    }
    Some(marks)
}

/// Places at the spacing that is aimed at: neighbours on a jittered hexagonal lattice, stretched along elongated spots
/// so that these do not touch.
fn arrangement(dice: &mut Dice, aim: &Aim) -> Option<Vec<[f64; 2]>> {
    const REACH: i32 = 5;
    let count = dice.whole(MARKS);
    let turn = dice.between([0.0, TAU]);
    let middle = [dice.off(0.5), dice.off(0.5)];
    let mut lattice = Vec::new();
    for row in -REACH..=REACH {
        for column in -REACH..=REACH {
            let (row, column) = (f64::from(row), f64::from(column));
            lattice.push([column + 0.5 * row - middle[0], 0.75f64.sqrt() * row - middle[1]]);
        }
    }
    lattice.sort_by(|a, b| (a[0] * a[0] + a[1] * a[1]).total_cmp(&(b[0] * b[0] + b[1] * b[1])));
    let longer = 1.0 / aim.aspect.sqrt().sqrt();
    let places: Vec<[f64; 2]> = lattice[..count]
        .iter()
        .map(|[x, y]| {
            let (radius, way) = (PLACE * dice.between([0.0, 1.0]).sqrt(), dice.between([0.0, TAU]));
            let place = turned([x + radius * libm::cos(way), y + radius * libm::sin(way)], turn);
            turned([place[0] * longer, place[1] / longer], aim.angle.to_radians())
        })
        .collect();
    let scale = aim.spacing / mean_spacing(&places)?;
    Some(places.into_iter().map(|place| place.map(|x| scale * x)).collect())
}

fn turned([x, y]: [f64; 2], by: f64) -> [f64; 2] {
    let (c, s) = (libm::cos(by), libm::sin(by));
    [c * x - s * y, s * x + c * y]
}

/// Whether two spots nearly touch: a point of the outline of one, or its centre, is inside the other.
fn touch(a: &Ellipse, b: &Ellipse) -> bool {
    const POINTS: u32 = 32;
    let apart = [a.center[0] - b.center[0], a.center[1] - b.center[1]];
    let reach = ROOM * (a.radii[0].max(a.radii[1]) + b.radii[0].max(b.radii[1]));
    if apart[0] * apart[0] + apart[1] * apart[1] > reach * reach {
        return false;
    }
    let inside = |point: [f64; 2]| {
        let [x, y] = turned([point[0] - b.center[0], point[1] - b.center[1]], -b.angle.to_radians());
        let [x, y] = [x / (ROOM * b.radii[0]), y / (ROOM * b.radii[1])];
        x * x + y * y <= 1.0
    };
    let outline = (0..POINTS).map(|k| {
        let t = TAU * f64::from(k) / f64::from(POINTS);
        let point = [ROOM * a.radii[0] * libm::cos(t), ROOM * a.radii[1] * libm::sin(t)];
        let [x, y] = turned(point, a.angle.to_radians());
        [a.center[0] + x, a.center[1] + y]
    });
    std::iter::once(a.center).chain(outline).any(inside)
}
