//! Rosettes: blotches that stand in rings around a plain or tinted centre, as on a leopard.
//!
//! The ink is closed by discs of several radii. At the one at which most of it stands in rings (compact groups with ground inside
//! that is deeper than the gaps between their blotches), these groups are the marks, and how many blotches they have is counted.

pub mod centres;
mod closed;
mod groups;

use groups::{Group, Ink};

use crate::grid::Field;
use crate::grid::distance::{length, nearest};
use crate::points::rosettes::{Rosettes, rosettes};

/// Radii of the discs, cells.
const REACHES: [f32; 11] = [0.7, 1.2, 1.7, 2.2, 2.8, 3.4, 4.2, 5.2, 6.5, 8.0, 10.0];
/// Fewest whole rings.
const RINGS: usize = 8;
/// Least share of the ink of whole groups that is in rings.
const SHARE: f64 = 0.5;
/// Least fill of a ring: that of an ellipse is 1, that of two rings side by side about 0.8.
const FILL: f64 = 0.82;
/// Least depth of the ground inside a ring, in radii of the disc and in cells.
const HOLE: [f32; 2] = [1.5, 1.5];
/// Most of a ring that is ink.
const MOST_INK: f64 = 0.92;
/// Least share of a solid one that is ink.
const SOLID: f64 = 0.85;
/// How many larger discs than the best one are tried.
const LARGER: usize = 2;
/// Least area of a mark that is no ring, in that of a mean ring: smaller ones are parts of rings.
const SMALLEST: f64 = 0.25;
/// The radius of the disc that fills the dents of outlines: in depths of a blotch, and at least in radii of the disc that closes rings,
/// since it sinks into gaps that are hardly narrower than itself.
const DENT: [f64; 2] = [1.0, 2.0];
/// Distance from the ink within which ground may be that of a gap, cells, and how much it counts: grown rosettes 7 and 8 px deep are read
/// within 12 %, photographed ones within 10 % (tests); counted whole, they were read 13 % too deep.
const GAP: f64 = 2.0;
const GAP_SHARE: f64 = 0.25;
/// The value of outlines at their edges, and the one outside and between groups that touch.
const OUTLINE: f32 = 0.5;
const BELOW: f32 = 0.45;
/// Most blotches of a ring.
const MOST_PARTS: usize = 12;
/// Quantiles of the numbers of blotches that are the least and the greatest one.
const PARTS: [f64; 2] = [0.1, 0.9];
/// Share of the rings that have as many dots as the greatest number.
const DOTTED: f64 = 0.95;
/// Halvings of the range of widths.
const HALVINGS: usize = 9;
/// The narrowest and the widest blotches that are tried, in √area of a mean rosette.
const WIDTHS: [f64; 2] = [0.05, 0.5];

/// The rosettes of a photograph.
#[derive(Clone, Debug)]
pub struct FoundRosettes {
    /// What they are like.
    pub like: Rosettes,
    /// Their blotches, and the level of the edges of these.
    pub ink: Field,
    /// That level.
    pub level: f32,
    /// For each cell the number of the rosette in which it is ground, from 1; 0 elsewhere.
    pub centres: Vec<u32>,
}

/// The rosettes above `level` in `field`, and their outlines: 1 inside, with edges at ½. `None` if the blotches stand in no rings.
#[must_use]
pub fn found(field: &Field, level: f32) -> Option<(FoundRosettes, Field)> {
    let ink = Ink::new(field, level)?;
    if ink.blotches() < RINGS {
        return None;
    }
    let (mut rings, others, reach) = rings(&ink)?;
    let like = like(&rings, &others);
    let rough = width(field, level, &rings, &like);
    let sizes: Vec<usize> = rings.iter().map(|ring| ring.cells.len()).collect();
    // Between the round corners of two blotches an outline is dented.
    let mut cells: Vec<&mut Vec<usize>> = rings.iter_mut().map(|ring| &mut ring.cells).collect();
    let disc = (DENT[0] * rough / field.cell[0]).max(DENT[1] * f64::from(reach));
    closed::close(&mut cells, disc as f32, [field.width, field.height]);
    let width = width(field, level, &rings, &like);
    let outlines = outlines(field, level, &rings, &others);
    let mut centres = vec![0; field.values.len()];
    for (number, ring) in rings.iter().enumerate() {
        for cell in ring.cells[..sizes[number]].iter().filter(|cell| !ink.holds(**cell)) {
            centres[*cell] = number as u32 + 1;
        }
    }
    let like = Rosettes { width: Some(width), ..like };
    Some((FoundRosettes { like, ink: field.clone(), level, centres }, outlines))
}

/// The rings of blotches, the other groups that are large enough to be marks, or cut by the border, and the radius of the disc that closes
/// most rings, cells. `None` if they are few.
///
/// Each ring is found with the smallest disc that closes it, so that it is not joined to others beside it; but with no disc much larger
/// than the one that finds most of them, as a large one joins any marks.
fn rings(ink: &Ink) -> Option<(Vec<Group>, Vec<Group>, f32)> {
    let none = vec![false; ink.cells()];
    let scores = REACHES.map(|reach| score(&ink.groups(reach, &none), reach));
    let best = (0..REACHES.len()).max_by(|a, b| scores[*a].total_cmp(&scores[*b]))?;
    if scores[best] < SHARE {
        return None;
    }
    let mut taken = none;
    let mut rings: Vec<Group> = Vec::new();
    for reach in REACHES.into_iter().take(best + 1 + LARGER) {
        let found = ink.groups(reach, &taken).into_iter().filter(|group| is_ring(group, reach));
        let found: Vec<Group> = found.collect();
        found.iter().flat_map(|ring| &ring.cells).for_each(|cell| taken[*cell] = true);
        rings.extend(found);
    }
    let usual = rings.iter().map(|ring| ring.cells.len()).sum::<usize>() as f64 / rings.len().max(1) as f64;
    let is_large = |group: &Group| !group.whole || group.cells.len() as f64 >= SMALLEST * usual;
    let others = ink.groups(REACHES[best], &taken).into_iter().filter(is_large).collect();
    (rings.len() >= RINGS).then_some((rings, others, REACHES[best]))
}

/// Whether a group is a ring around ground that is deeper than the gaps of its outline.
fn is_ring(group: &Group, reach: f32) -> bool {
    group.whole
        && group.hole > (HOLE[0] * reach).max(HOLE[1])
        && (group.ink as f64) < MOST_INK * group.cells.len() as f64
        && group.fill > FILL
        && group.blotches <= MOST_PARTS
}

/// The share of the ink of whole groups that is in rings.
fn score(groups: &[Group], reach: f32) -> f64 {
    let ink = |group: &Group| group.ink as f64;
    let all: f64 = groups.iter().filter(|group| group.whole).map(ink).sum();
    let rings: f64 = groups.iter().filter(|group| is_ring(group, reach)).map(ink).sum();
    if all > 0.0 { rings / all } else { 0.0 }
}

/// The groups with what they enclose, with edges at ½.
fn outlines(field: &Field, level: f32, rings: &[Group], others: &[Group]) -> Field {
    let mut values: Vec<f32> = field.values.iter().map(|value| (value - level + 0.5).min(BELOW)).collect();
    let mut owners = vec![0_usize; values.len()];
    for (number, group) in rings.iter().chain(others).enumerate() {
        for cell in &group.cells {
            let own = field.values[*cell] - level + 0.5;
            // Edges of the ink stay where they are.
            values[*cell] = if own > 0.5 { own } else { 1.0 };
            owners[*cell] = number + 1;
        }
    }
    // Groups side by side stay apart.
    for cell in 0..values.len() {
        let beside = [(cell + 1, (cell + 1) % field.width != 0), (cell + field.width, true)];
        let beside = beside.iter().filter(|(other, is_beside)| *is_beside && *other < owners.len());
        let is_between = |(other, _): &(usize, bool)| owners[*other] > 0 && owners[*other] != owners[cell];
        if owners[cell] > 0 && beside.clone().any(is_between) {
            values[cell] = BELOW;
        }
    }
    Field { values, ..field.clone() }
}

/// What these rings are like, but for the depth of their blotches.
fn like(rings: &[Group], others: &[Group]) -> Rosettes {
    let mut parts: Vec<usize> = rings.iter().map(|ring| ring.blotches.max(1)).collect();
    let mut dots: Vec<usize> = rings.iter().map(|ring| ring.dots).collect();
    parts.sort_unstable();
    dots.sort_unstable();
    let at = |all: &[usize], share: f64| all[((all.len() - 1) as f64 * share).round() as usize] as u32;
    let is_solid = |group: &&Group| group.whole && group.ink as f64 >= SOLID * group.cells.len() as f64;
    let solid = others.iter().filter(is_solid).count() as f64;
    let solid = solid / (solid + rings.len() as f64);
    let solid = (100.0 * solid).round() / 100.0;
    let usual = Rosettes::default();
    Rosettes { parts: PARTS.map(|share| at(&parts, share)), dots: at(&dots, DOTTED).min(6), solid, ..usual }
}

/// The depth of blotches with which rosettes in the outlines of the `rings` have as much ground inside as these, px. Gaps between
/// blotches count a quarter: blur fills them, so that blotches would come out too deep if they counted, and too shallow if not.
fn width(field: &Field, level: f32, rings: &[Group], like: &Rosettes) -> f64 {
    let outlines = outlines(field, level, rings, &[]);
    let wanted = ground_in(&outlines, field, level);
    let side = (rings.iter().map(|ring| ring.cells.len()).sum::<usize>() as f64 / rings.len() as f64).sqrt();
    let mut range = WIDTHS.map(|width| width * side * field.cell[0]);
    for _ in 0..HALVINGS {
        let middle = (range[0] * range[1]).sqrt();
        let tried = rosettes(&outlines, &Rosettes { width: Some(middle), solid: 0.0, ..*like }, 1);
        range[usize::from(ground_in(&outlines, &tried, OUTLINE) < wanted)] = middle;
    }
    (range[0] * range[1]).sqrt()
}

/// How many cells within `outlines` are not ink above `level`; those that may be in gaps count less.
fn ground_in(outlines: &Field, ink: &Field, level: f32) -> f64 {
    let grid = ink.grid();
    let is_ink: Vec<bool> = ink.values.iter().map(|value| *value > level).collect();
    let Some(to_ink) = nearest(&is_ink, &grid) else { return 0.0 };
    let is_ground = |cell: &usize| outlines.values[*cell] > OUTLINE && !is_ink[*cell];
    let share = |cell: usize| if length(to_ink[cell], &grid) > GAP * grid.cell[0] { 1.0 } else { GAP_SHARE };
    (0..is_ink.len()).filter(is_ground).map(share).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Edges;

    /// Ellipses of radii 20 and 17 px, 56 px apart, as marks with edges at ½.
    fn patches() -> Field {
        Field::from_fn([448, 448], [1.0; 2], Edges::Closed, |at| {
            let [x, y] = at.map(|along| along.rem_euclid(56.0) - 28.0);
            (0.5 + 5.0 * (1.0 - (x / 20.0).hypot(y / 17.0))).clamp(0.0, 1.0) as f32
        })
    }

    #[test]
    fn rosettes_are_found_with_their_parts_and_the_depth_of_their_blotches() {
        let patches = patches();
        for (parts, width, dots) in [([3, 3], 8.0, 0), ([5, 5], 7.0, 0), ([4, 6], 8.0, 2)] {
            let asked = Rosettes { parts, solid: 0.25, width: Some(width), dots, tint: 0.0 };
            let grown = rosettes(&patches, &asked, 3);
            let (found, outlines) = found(&grown, 0.5).expect("rosettes");
            let got = found.like;
            assert!(got.parts[0].abs_diff(parts[0]) <= 1 && got.parts[1].abs_diff(parts[1]) <= 1, "{got:?}");
            assert!((got.width.unwrap() / width - 1.0).abs() < 0.12, "{got:?}");
            assert!(
                (got.solid - 0.25).abs() < 0.15 && got.dots <= dots && (dots > 0) == (got.dots > 0),
                "{got:?}"
            );
            let inside = |field: &Field| field.values.iter().filter(|value| **value > 0.5).count() as f64;
            let area = inside(&outlines) / inside(&patches);
            assert!((area - 1.0).abs() < 0.06, "{area}");
        }
    }

    #[test]
    fn spots_that_stand_side_by_side_are_no_rosettes() {
        assert!(found(&patches(), 0.5).is_none());
        let rows = Field::from_fn([300, 300], [1.0; 2], Edges::Closed, |at| {
            let [x, y] = at.map(|along| along.rem_euclid(15.0) - 7.5);
            (0.5 + 0.5 * (6.0 - x.hypot(y))).clamp(0.0, 1.0) as f32
        });
        assert!(found(&rows, 0.5).is_none());
    }
}
