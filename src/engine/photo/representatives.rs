//! The few spots that represent many in a sketch.
//!
//! Of all groups of a spot and its nearest neighbours, the one is taken whose attributes are closest to those of the region. It is
//! then moved, rotated and resized until they are equal.

use crate::attributes::Spots;
use crate::attributes::spacing::mean_spacing;
use crate::grid::{Bounds as Canvas, Edges};
use crate::marks::{Ellipse, axial, turn};

/// Spots of a group: one and those around it in a hexagonal pattern.
const GROUP: usize = 7;
/// Most groups that are compared: among a hundred one is typical.
const GROUPS: usize = 100;
/// Rounds of corrections: each leaves less than a tenth of the error.
const ROUNDS: usize = 4;
/// Least distance of spots from the border of their region, as a share of its sides.
const INSET: f64 = 0.02;
/// Distance to which spots are moved apart, px: at 2 the spots that are kept are separate, and moves fall short a little. Not
/// tuned.
const APART: f64 = 3.0;
/// Rounds in which they are moved apart. Not tuned: the last ones hardly move any.
const PARTED: usize = 20;
/// Largest aspect: an ellipse of aspect 1 has no direction that could be rotated.
const ROUND: f64 = 0.999;

/// A rectangle of the canvas, px.
#[derive(Clone, Copy, Debug)]
pub struct Bounds {
    /// Upper left corner.
    pub low: [f64; 2],
    /// Lower right corner.
    pub high: [f64; 2],
}

/// Up to seven ellipses in `bounds` with the attributes `wanted`, shaped like some of `spots`.
#[must_use]
pub fn representatives(spots: &[Ellipse], wanted: &Spots, bounds: Bounds) -> Vec<Ellipse> {
    let group = if spots.len() <= GROUP { spots.to_vec() } else { most_typical(spots, wanted) };
    adjusted(group, wanted, bounds)
}

/// The group with the least difference from the wanted properties.
fn most_typical(spots: &[Ellipse], wanted: &Spots) -> Vec<Ellipse> {
    let groups = spots.iter().step_by(spots.len().div_ceil(GROUPS)).map(|center| {
        let far = |spot: &Ellipse| {
            let [x, y] = [0, 1].map(|k| spot.center[k] - center.center[k]);
            x * x + y * y
        };
        let order = |a: &Ellipse, b: &Ellipse| far(a).total_cmp(&far(b));
        let mut near = spots.to_vec();
        near.select_nth_unstable_by(GROUP - 1, order);
        near.truncate(GROUP);
        near.sort_by(order);
        near
    });
    let scored = groups.map(|group| (difference(&group, wanted), group));
    scored.min_by(|a, b| a.0.total_cmp(&b.0)).map_or_else(Vec::new, |(_, group)| group)
}

/// Sum of squares of the differences in a group's attributes: in the logarithms of area and spacing, in the aspect, and in the
/// angle, weighted by how much the shape has a direction.
fn difference(group: &[Ellipse], wanted: &Spots) -> f64 {
    let Some(found) = Spots::measure(group) else { return f64::INFINITY };
    let ratio = |found: f64, wanted: f64| libm::log(found / wanted);
    let spacing = found.spacing.zip(wanted.spacing).map_or(0.0, |(found, wanted)| ratio(found, wanted));
    let turned = turn(found.angle, wanted.angle).to_radians() * (1.0 - wanted.aspect);
    let parts = [ratio(found.area, wanted.area), spacing, found.aspect - wanted.aspect, turned];
    parts.iter().map(|part| part * part).sum()
}

/// The spots of `group`, changed to have exactly the `wanted` mean attributes.
fn adjusted(mut group: Vec<Ellipse>, wanted: &Spots, bounds: Bounds) -> Vec<Ellipse> {
    for _ in 0..ROUNDS {
        let Some(found) = Spots::measure(&group) else { return group };
        let turned = axial(wanted.angle - found.angle);
        for spot in &mut group {
            let area = spot.area() * wanted.area / found.area;
            let aspect = (spot.aspect() * wanted.aspect / found.aspect).min(ROUND);
            *spot = Ellipse::from_area(spot.center, area, aspect, axial(spot.major_angle() + turned));
        }
        let centers: Vec<[f64; 2]> = group.iter().map(|spot| spot.center).collect();
        let scale = mean_spacing(&centers).zip(wanted.spacing).map_or(1.0, |(found, wanted)| wanted / found);
        let middle =
            [0, 1].map(|k| centers.iter().map(|center| center[k]).sum::<f64>() / centers.len() as f64);
        for spot in &mut group {
            spot.center = [0, 1].map(|k| middle[k] + scale * (spot.center[k] - middle[k]));
        }
        inside(&mut group, bounds);
    }
    part(&mut group);
    inside(&mut group, bounds);
    group
}

/// Moves overlapping spots apart; a few dense ones overlap after their distances have been adjusted.
fn part(group: &mut [Ellipse]) {
    let canvas = Canvas { size: [f64::MAX; 2], edges: Edges::Closed };
    for _ in 0..PARTED {
        for one in 0..group.len() {
            for other in 0..one {
                let missing = APART - group[one].gap_to(&group[other], &canvas);
                let way = [0, 1].map(|axis| group[one].center[axis] - group[other].center[axis]);
                let length = libm::hypot(way[0], way[1]);
                if missing <= 0.0 || length == 0.0 {
                    continue;
                }
                let by = way.map(|along| 0.5 * missing * along / length);
                group[one].center = [0, 1].map(|axis| group[one].center[axis] + by[axis]);
                group[other].center = [0, 1].map(|axis| group[other].center[axis] - by[axis]);
            }
        }
    }
}

/// Moves the group into the bounds as a whole; spots that do not fit are put on the bounds.
fn inside(group: &mut [Ellipse], bounds: Bounds) {
    for k in 0..2 {
        let inset = INSET * (bounds.high[k] - bounds.low[k]);
        let (low, high) = (bounds.low[k] + inset, bounds.high[k] - inset);
        let least = group.iter().map(|spot| spot.center[k]).fold(f64::INFINITY, f64::min);
        let most = group.iter().map(|spot| spot.center[k]).fold(f64::NEG_INFINITY, f64::max);
        let shift = (low - least).max(0.0) + (high - most).min(0.0);
        group.iter_mut().for_each(|spot| spot.center[k] = (spot.center[k] + shift).clamp(low, high));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn seven_spots_have_the_attributes_of_all() {
        let spot = |k: usize| {
            let vary = |by: usize| ((k * by) % 100) as f64 / 100.0 - 0.5;
            let place = [
                30.0 * (k % 8) as f64 + 20.0 + 6.0 * vary(37),
                30.0 * (k / 8) as f64 + 20.0 + 6.0 * vary(53),
            ];
            Ellipse::from_area(
                place,
                200.0 * (1.0 + 0.4 * vary(29)),
                0.5 + 0.2 * vary(71),
                40.0 + 30.0 * vary(17),
            )
        };
        let spots: Vec<Ellipse> = (0..64).map(spot).collect();
        let wanted = Spots::measure(&spots).unwrap();
        let bounds = Bounds { low: [0.0; 2], high: [260.0; 2] };
        let seven = representatives(&spots, &wanted, bounds);
        assert_eq!(seven.len(), 7);
        let found = Spots::measure(&seven).unwrap();
        assert!((found.area / wanted.area - 1.0).abs() < 1e-3, "{found:?} {wanted:?}");
        assert!(
            (found.spacing.unwrap() / wanted.spacing.unwrap() - 1.0).abs() < 1e-3,
            "{found:?} {wanted:?}"
        );
        assert!((found.aspect - wanted.aspect).abs() < 1e-3 && turn(found.angle, wanted.angle).abs() < 0.5);
    }

    #[test]
    fn few_spots_all_stay_and_inside_their_region() {
        let spots = [[10.0, 10.0], [50.0, 12.0]].map(|center| Ellipse::from_area(center, 90.0, 0.8, 0.0));
        let wanted = Spots { spacing: Some(70.0), ..Spots::measure(&spots).unwrap() };
        let bounds = Bounds { low: [0.0; 2], high: [60.0, 40.0] };
        let found = representatives(&spots, &wanted, bounds);
        assert!(
            found.len() == 2 && found.iter().all(|spot| (0.0..=60.0).contains(&spot.center[0])),
            "{found:?}"
        );
    }
}
