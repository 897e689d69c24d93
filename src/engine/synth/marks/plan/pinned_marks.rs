//! Drawn marks that stay where they were drawn: they are among those that grow, and the others grow around them.
//!
//! ```text
//!  ellipses ─▶ parameters of their own (drawn spots) ─▶ those that find room (rd: placeable) ─▶ PinnedMark
//!                                    │  placed first, in their own parameters (spread)
//!                                    │  brought back while they form (grow: position control)
//!                                    │  measured, and their parameters corrected (grow: pinned correction)
//!  lines ────▶ guide lines of the noise that stripes begin from ─▶ grown ─▶ how well they stayed (report)
//! ```

use crate::attributes::regions::RegionGrid;
use crate::grid::{Bounds, PointBuckets, turned};
use crate::marks::{Ellipse, Path};
use crate::rd::{self, GuideLine, Hindrance, placeable};
use crate::synth::marks::plan::drawn_spots::DrawnSpot;
use crate::synth::marks::plan::lattice::NodeOffset;
use crate::synth::marks::plan::layer_lookup::Lookup;
use crate::synth::marks::plan::one_spot::room_of;
use crate::synth::marks::plan::visible_part::VisiblePart;

/// A drawn spot that stays where it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinnedMark {
    /// Its index among the marks of its layer.
    pub mark: usize,
    /// The drawn ellipse, on the canvas that is grown, px.
    pub drawn: Ellipse,
    /// The part of it on the canvas.
    pub visible: VisiblePart,
    /// Difference between its own parameters and those looked up for its place.
    pub offset: NodeOffset,
}

/// area ÷ spacing² of spots at the highest density.
const PACKED: f64 = 0.22;

/// Least ratio of a drawn spot: with a smaller one it splits in two if it has room, as on one side of a close pair.
const LEAST_RATIO: f64 = 13.5;

/// Factor of the distance at which spots merge, if their outlines are well apart: their effect on each other is corrected while
/// they grow. Of 477 spots of 22 sketches the full distance excluded 26; with 0.8 to 0.86 of it 3 did not grow. If outlines nearly
/// touched, pairs merged with 0.9.
const WELL_APART: f64 = 0.83;

impl PinnedMark {
    fn new(lookup: &Lookup, drawn: &DrawnSpot) -> Self {
        let DrawnSpot { mark, ellipse, own } = *drawn;
        let around = lookup.lattice.at(ellipse.center);
        let mut offset = own.minus(&around);
        let ratio = around.ratio();
        offset[3] = offset[3].max(libm::log(LEAST_RATIO.min(ratio) / ratio));
        let visible = VisiblePart::new(&ellipse, lookup.map.layout());
        Self { mark, drawn: ellipse, visible, offset }
    }

    /// √(r₁r₂), px.
    #[must_use]
    pub fn radius(&self) -> f64 {
        (self.drawn.radii[0] * self.drawn.radii[1]).sqrt()
    }

    /// The spot with its room among the others; `pitch` is by region.
    #[must_use]
    pub fn among_others(&self, lookup: &Lookup, pitch: &[f64]) -> rd::PinnedSpot {
        let own = room_of(lookup, self.drawn.center, pitch, self.offset);
        let at = [0, 1].map(|axis| {
            let end = lookup.grid.size[axis] as f64 * (1.0 - 1e-12);
            (self.drawn.center[axis] / lookup.grid.cell[axis]).clamp(0.0, end)
        });
        let near = self.nearest(lookup, lookup.system.spacing(&own) / own.apart()) / own.apart();
        rd::PinnedSpot { at, own, near }
    }

    /// The least distance of another spot, in pitches of `pitch` cells, the room that it needs itself.
    fn nearest(&self, lookup: &Lookup, pitch: f64) -> f64 {
        let area = self.drawn.area();
        let spacing = (lookup.px_a_cell() * pitch).max((area / PACKED).sqrt());
        let merging = lookup.system.definition().spots.map(|spots| spots.merging).unwrap_or_default();
        (merging.least + merging.by_root_density * area.sqrt() / spacing).min(1.0)
    }
}

/// A drawn spot that is not grown where it was drawn, with the reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeftOut {
    /// Its index among the marks of its layer.
    pub mark: usize,
    /// The drawn ellipse, on the canvas that is grown, px.
    pub drawn: Ellipse,
    /// The reason.
    pub reason: Hindrance,
}

/// Whether the outlines of two ellipses are farther apart than a quarter of the mean of their diameters 2√(r₁r₂), along the
/// way from centre to centre.
fn is_well_apart(a: &Ellipse, b: &Ellipse, bounds: &Bounds) -> bool {
    let way = bounds.shortest([0, 1].map(|axis| b.center[axis] - a.center[axis]));
    let distance = (way[0] * way[0] + way[1] * way[1]).sqrt();
    let least = |ellipse: &Ellipse| 0.25 * (ellipse.radii[0] * ellipse.radii[1]).sqrt();
    let longest = |ellipse: &Ellipse| ellipse.radii[0].max(ellipse.radii[1]);
    let gap = least(a) + least(b);
    if distance - longest(a) - longest(b) > gap {
        return true;
    }
    let along_way = |ellipse: &Ellipse| {
        let [along, across] = turned(way, -ellipse.angle);
        let [r, q] = ellipse.radii;
        let [x, y] = [along / distance / r, across / distance / q];
        1.0 / (x * x + y * y).sqrt()
    };
    distance - along_way(a) - along_way(b) > gap
}

/// The drawn `spots` that find room beside the `obstacles`, and those that do not.
pub(super) fn pin_spots(
    lookup: &Lookup,
    obstacles: &[bool],
    spots: &[DrawnSpot],
) -> (Vec<PinnedMark>, Vec<LeftOut>) {
    let drawn: Vec<PinnedMark> = spots.iter().map(|spot| PinnedMark::new(lookup, spot)).collect();
    let pitch = vec![1.0; lookup.map.layout().len()];
    let bounds = lookup.map.layout().bounds();
    let places = PointBuckets::new(bounds, drawn.iter().map(|mark| mark.drawn.center).collect());
    let longest = |mark: &PinnedMark| mark.drawn.radii[0].max(mark.drawn.radii[1]);
    let longest_of_all = drawn.iter().map(longest).fold(0.0, f64::max);
    let among = |(index, mark): (usize, &PinnedMark)| {
        let mut among = mark.among_others(lookup, &pitch);
        let is_apart = |other: u32| {
            let other = other as usize;
            other == index || is_well_apart(&mark.drawn, &drawn[other].drawn, &bounds)
        };
        // Ellipses farther apart are well apart: the required gap is at most a quarter of both together.
        let farthest = 1.25 * (longest(mark) + longest_of_all);
        if places.within(mark.drawn.center, farthest).into_iter().all(is_apart) {
            among.near *= WELL_APART;
        }
        among
    };
    let among: Vec<rd::PinnedSpot> = drawn.iter().enumerate().map(among).collect();
    let room = placeable(lookup.system, &lookup.grid, obstacles, &among);
    let mut pinned = Vec::with_capacity(drawn.len());
    let mut left_out = Vec::new();
    for (mark, room) in drawn.into_iter().zip(room) {
        match room {
            Ok(()) => pinned.push(mark),
            Err(reason) => left_out.push(LeftOut { mark: mark.mark, drawn: mark.drawn, reason }),
        }
    }
    (pinned, left_out)
}

/// The segments of `paths` (px) as guide lines of the noise that stripes begin from, on a canvas of `size` px.
#[must_use]
pub fn guide_lines(paths: &[Path], size: [f64; 2]) -> Vec<GuideLine> {
    let share = |end: [f64; 2]| [0, 1].map(|axis| end[axis] / size[axis]);
    let segments = paths.iter().flat_map(Path::segments);
    segments.map(|line| GuideLine { from: share(line.from), to: share(line.to) }).collect()
}

/// The vector from `b` to `a`, px; on a tile the shortest one.
#[must_use]
pub fn displacement(a: [f64; 2], b: [f64; 2], layout: &RegionGrid) -> [f64; 2] {
    layout.bounds().shortest([a[0] - b[0], a[1] - b[1]])
}
