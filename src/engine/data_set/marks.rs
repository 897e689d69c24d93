//! The marks of a grown pattern, one by one: which px belong to which, and what each of them measures.

use super::kind::Kind;
use crate::attributes::{Attribute, AttributeMap, Attributes, axial_mean};
use crate::grid::{Field, UnionFind};
use crate::marks::Ellipse;
use crate::measure::{Directions, Spot, spots};
use crate::synth::pattern::{EDGE, PatternRows};

/// Marks are told apart on samples so many times finer than px along each side; odd, so that one is in the middle of each px.
const FINER: usize = 3;
/// px of a mark at which what is asked for is averaged: one out of so many.
const SAMPLED: usize = 16;

/// One mark, measured where the pattern is above ½.
#[derive(Clone, Debug, PartialEq)]
pub struct LabelledMark {
    /// Its value in the picture of marks: 1, 2, …
    pub label: u16,
    /// Area, centre (px), and aspect and direction of the ellipse with its second moments.
    pub ellipse: Ellipse,
    /// Twice its area ÷ its outline, px, without the outline along the border.
    pub width: f64,
    /// Its direction, degrees in [0, 180): that of the ellipse; of stripes the mean of the directions along it.
    pub angle: f64,
    /// Whether no border cuts it.
    pub whole: bool,
    /// What the sketch asks for at its centre; of stripes the mean along it.
    pub asked: Attributes,
}

/// The marks of a pattern, and for each px of a canvas of `side` px the label of its mark, 0 = none.
pub(super) fn marks(
    pattern: &dyn PatternRows,
    side: usize,
    kind: Kind,
    map: &AttributeMap,
) -> (Vec<u16>, Vec<LabelledMark>) {
    let field = pattern.field(side, side);
    let fine = pattern.field(FINER * side, FINER * side);
    let regions = Regions::new(&fine);
    let found = spots(&field, EDGE);
    let labels = regions.labels_of(&found);
    let px = |index: usize| {
        let [x, y] = [index % side, index / side].map(|along| along * FINER + FINER / 2);
        labels[regions.of[y * FINER * side + x] as usize]
    };
    let mask: Vec<u16> = (0..side * side).map(px).collect();
    let mut marks: Vec<LabelledMark> =
        found.iter().enumerate().map(|(index, spot)| mark(index, spot, map)).collect();
    if kind.is_striped() {
        along_stripes(&mut marks, &mask, &field, map);
    }
    (mask, marks)
}

fn mark(index: usize, spot: &Spot, map: &AttributeMap) -> LabelledMark {
    LabelledMark {
        // More than 65,535 marks are not told apart.
        label: (index + 1).min(usize::from(u16::MAX)) as u16,
        ellipse: spot.ellipse,
        width: 2.0 * spot.ellipse.area() / spot.contour.max(f64::MIN_POSITIVE),
        angle: spot.ellipse.major_angle(),
        whole: spot.whole,
        asked: map.at(spot.ellipse.center),
    }
}

/// Takes the means along the marks for what is asked, and for their directions.
fn along_stripes(marks: &mut [LabelledMark], mask: &[u16], field: &Field, map: &AttributeMap) {
    let side = field.width;
    let wavelength = marks.first().and_then(|mark| mark.asked.distance()).unwrap_or(20.0);
    let directions = Directions::measure(field, wavelength);
    let px_at = |[x, y]: [f64; 2]| (y as usize).min(side - 1) * side + (x as usize).min(side - 1);
    let places = directions.at_places(|at| (usize::from(mask[px_at(at)]), [1.0, 0.0]));
    let angles = directions.means(&places, marks.len() + 1);
    let mut asked: Vec<Vec<Attributes>> = vec![Vec::new(); marks.len() + 1];
    for (index, label) in mask.iter().enumerate().filter(|(_, label)| **label > 0) {
        let [x, y] = [index % side, index / side];
        if (x + 3 * y).is_multiple_of(SAMPLED) {
            asked[usize::from(*label)].push(map.at([x as f64 + 0.5, y as f64 + 0.5]));
        }
    }
    for mark in marks {
        let label = usize::from(mark.label);
        mark.angle = angles[label].unwrap_or(mark.angle);
        mark.asked = mean(&asked[label]).unwrap_or(mark.asked);
    }
}

/// The mean of what stripes are asked for; `None` without any.
fn mean(all: &[Attributes]) -> Option<Attributes> {
    let Attributes::Stripes(first) = all.first()? else { return None };
    let of = |attribute| {
        let values = all.iter().filter_map(|one| one.get(attribute));
        values.sum::<f64>() / all.len() as f64
    };
    let (angle, _) = axial_mean(all.iter().map(|one| (one.angle(), 1.0))).unwrap_or((first.angle, 0.0));
    let wavelength = first.wavelength.map(|_| of(Attribute::Wavelength));
    Some(Attributes::Stripes(crate::attributes::Stripes { width: of(Attribute::Width), angle, wavelength }))
}

/// Connected samples above the edge level.
struct Regions {
    /// Region 1, 2, … of each sample; 0 = below.
    of: Vec<u32>,
    /// Area, px², and centre, px, of each region; of region 0 nothing.
    seen: Vec<(f64, [f64; 2])>,
}

impl Regions {
    /// Samples are connected if they share a side, or if they touch at a corner about which the mean of four is above the level: as
    /// in [`crate::measure::census`].
    fn new(fine: &Field) -> Self {
        let (width, values) = (fine.width, &fine.values);
        let mut sets = UnionFind::new(values.len());
        let inside = |index: usize| values[index] >= EDGE;
        for index in 0..values.len() {
            let (left, up) = (!index.is_multiple_of(width), index >= width);
            if inside(index) {
                if left && inside(index - 1) {
                    sets.join(index as u32 - 1, index as u32, [0, 0]);
                }
                if up && inside(index - width) {
                    sets.join((index - width) as u32, index as u32, [0, 0]);
                }
            }
            if left && up {
                let four = [index, index - 1, index - width, index - width - 1];
                let is_bridge = four.iter().map(|one| values[*one]).sum::<f32>() >= 4.0 * EDGE;
                for [a, b] in [[four[0], four[3]], [four[1], four[2]]] {
                    if is_bridge && inside(a) && inside(b) {
                        sets.join(a as u32, b as u32, [0, 0]);
                    }
                }
            }
        }
        let mut regions = Self { of: vec![0; values.len()], seen: vec![(0.0, [0.0; 2])] };
        let cell = fine.cell[0] * fine.cell[1];
        let mut name = vec![0; values.len()];
        for index in (0..values.len()).filter(|index| inside(*index)) {
            let root = sets.find(index as u32).0 as usize;
            if name[root] == 0 {
                name[root] = regions.seen.len() as u32;
                regions.seen.push((0.0, [0.0; 2]));
            }
            regions.of[index] = name[root];
            let (area, sum) = &mut regions.seen[name[root] as usize];
            *area += cell;
            let at = [index % width, index / width];
            *sum = [0, 1].map(|axis| sum[axis] + cell * (at[axis] as f64 + 0.5) * fine.cell[axis]);
        }
        regions.seen.iter_mut().skip(1).for_each(|(area, sum)| *sum = sum.map(|along| along / *area));
        regions
    }

    /// The label of each region: that of the spot with nearly its centre and area, 0 for specks.
    fn labels_of(&self, spots: &[Spot]) -> Vec<u16> {
        let label = |(area, center): &(f64, [f64; 2])| {
            let apart = |spot: &Spot| {
                let to = spot.ellipse.center;
                let moved = libm::hypot(to[0] - center[0], to[1] - center[1]);
                moved + (spot.ellipse.area().sqrt() - area.sqrt()).abs()
            };
            let all = spots.iter().enumerate().map(|(index, spot)| (apart(spot), index));
            let nearest = all.min_by(|a, b| a.0.total_cmp(&b.0));
            let found = nearest.filter(|(apart, _)| *apart < 1.0 + 0.05 * area.sqrt());
            found.map_or(0, |(_, index)| (index + 1).min(usize::from(u16::MAX)) as u16)
        };
        self.seen.iter().enumerate().map(|(region, seen)| if region == 0 { 0 } else { label(seen) }).collect()
    }
}
