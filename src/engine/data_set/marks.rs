//! The marks of a grown pattern, one by one: which px belong to which, and what each of them measures.

use std::ops::Range;

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
    let mask = regions.mask(&regions.labels_of(&found), side);
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

/// Neighbouring samples of a row above the edge level.
struct Run {
    row: usize,
    along: Range<usize>,
    /// Its region: 1, 2, …
    region: usize,
}

/// Connected samples above the edge level.
struct Regions {
    runs: Vec<Run>,
    /// Area, px², and centre, px, of each region; of region 0 nothing.
    seen: Vec<(f64, [f64; 2])>,
}

impl Regions {
    /// Samples are connected if they share a side, or if they touch at a corner about which the mean of four is above the level: as
    /// in [`crate::measure::census`].
    fn new(fine: &Field) -> Self {
        let values = &fine.values;
        let (mut sets, mut runs) = (UnionFind::default(), Vec::<Run>::new());
        let mut above = 0..0;
        for (row, line) in values.chunks_exact(fine.width).enumerate() {
            let first = runs.len();
            for along in runs_of(line) {
                let own = sets.add();
                above.start +=
                    runs[above.clone()].iter().take_while(|run| run.along.end < along.start).count();
                for other in above.clone().take_while(|other| runs[*other].along.start <= along.end) {
                    let beside = &runs[other].along;
                    let corner = beside.start.max(along.start);
                    // Runs that overlap, or whose ends touch at the corner left of a sample.
                    if corner < beside.end.min(along.end)
                        || is_bridge(values, row * fine.width + corner, fine.width)
                    {
                        sets.join(other as u32, own, [0, 0]);
                    }
                }
                runs.push(Run { row, along, region: 0 });
            }
            above = first..runs.len();
        }
        let mut regions = Self { runs, seen: vec![(0.0, [0.0; 2])] };
        regions.add_up(&mut sets, fine.cell);
        regions
    }

    /// Numbers the regions of the runs that were joined in `sets`, and adds up samples of `cell` px.
    fn add_up(&mut self, sets: &mut UnionFind, cell: [f64; 2]) {
        for index in 0..self.runs.len() {
            // The lowest run stands for a set, so it comes first.
            let root = sets.find(index as u32).0 as usize;
            if root == index {
                self.runs[index].region = self.seen.len();
                self.seen.push((0.0, [0.0; 2]));
            }
            let region = self.runs[root].region;
            let run = &mut self.runs[index];
            run.region = region;
            let own = run.along.len() as f64 * cell[0] * cell[1];
            let middle = [0.5 * (run.along.start + run.along.end) as f64, run.row as f64 + 0.5];
            let (area, sum) = &mut self.seen[region];
            *area += own;
            *sum = [0, 1].map(|axis| sum[axis] + own * middle[axis] * cell[axis]);
        }
        self.seen.iter_mut().skip(1).for_each(|(area, sum)| *sum = sum.map(|along| along / *area));
    }

    /// For each px of a canvas of `side` px the label of its region, of those of all regions: that of the sample in its middle.
    fn mask(&self, labels: &[u16], side: usize) -> Vec<u16> {
        let mut mask = vec![0; side * side];
        for run in self.runs.iter().filter(|run| run.row % FINER == FINER / 2) {
            let first = run.row / FINER * side;
            let [start, end] = [run.along.start, run.along.end].map(|along| (along + FINER / 2) / FINER);
            mask[first + start..first + end].fill(labels[run.region]);
        }
        mask
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

/// The runs of samples of a row that are above the edge level, from left to right.
fn runs_of(line: &[f32]) -> impl Iterator<Item = Range<usize>> {
    let next_from = |from: usize, inside: bool| {
        line[from..].iter().position(|value| (*value >= EDGE) == inside).map(|steps| from + steps)
    };
    let mut from = 0;
    std::iter::from_fn(move || {
        let start = next_from(from, true)?;
        from = next_from(start, false).unwrap_or(line.len());
        Some(start..from)
    })
}

/// Whether the mean of the four samples about the upper left corner of a sample is above the level.
fn is_bridge(values: &[f32], index: usize, width: usize) -> bool {
    [index, index - 1, index - width, index - width - 1].map(|one| values[one]).iter().sum::<f32>()
        >= 4.0 * EDGE
}
