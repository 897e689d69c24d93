//! Drawn marks that stay where they were drawn: they are among those that grow, and the others grow around them.
//!
//! ```text
//!  ellipses ─▶ those that find room (rd: placeable) ─▶ PinnedMark: place, and how it deviates from its region
//!                                                        │  placed first, in parameters of its own (spread),
//!                                                        │  brought back while it forms (grow: position control)
//!  lines ────▶ guide lines of the noise that stripes begin from ─▶ grown ─▶ how well they stayed (report)
//! ```

use crate::attributes::Attributes;
use crate::attributes::regions::RegionGrid;
use crate::marks::{Ellipse, Path, turn};
use crate::rd::{self, GuideLine, Hindrance, placeable};
use crate::synth::plan::layer_lookup::Lookup;
use crate::synth::plan::one_spot::{Deviation, own_parameters};
use crate::synth::plan::spread_limits::{ASPECTS, most};

/// A drawn spot that stays where it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PinnedMark {
    /// As it was drawn, on the canvas that is grown, px.
    pub drawn: Ellipse,
    /// How it deviates from the mean of its region.
    pub deviation: Deviation,
}

/// area ÷ spacing² of spots as near as they come.
const PACKED: f64 = 0.22;
/// A single spot may differ by this many of the standard deviations that spots bear: as much as the drawn ones do.
const DEVIATIONS: f64 = 2.45;

impl PinnedMark {
    /// The spot `drawn` among those of `lookup`.
    fn new(lookup: &Lookup, drawn: Ellipse) -> Self {
        let wanted = lookup.spots_at(drawn.center);
        let place = lookup.map.region_of(drawn.center);
        let mut most = most(lookup.system, &wanted);
        if lookup.map.spread_is_given() {
            // The spread that was asked for limits the drawn spots, too.
            most = most.with(&lookup.map.region(place).spread, f64::min);
        }
        let larger = 1.0 + DEVIATIONS * most.area;
        let rounder = DEVIATIONS * most.aspect;
        let turned = (DEVIATIONS * most.angle).min(90.0);
        let mean = match lookup.map.region(place).filled {
            Attributes::Spots(mean) => mean,
            Attributes::Stripes(_) => wanted,
        };
        let bounds =
            [ASPECTS[0] - wanted.aspect, ASPECTS[1] - wanted.aspect].map(|b| b.clamp(-rounder, rounder));
        let deviation = Deviation {
            area: (drawn.area() / mean.area).clamp(1.0 / larger, larger),
            aspect: (drawn.aspect() - mean.aspect).clamp(bounds[0].min(0.0), bounds[1].max(0.0)),
            turn: turn(drawn.major_angle(), mean.angle).clamp(-turned, turned),
        };
        Self { drawn, deviation }
    }

    /// √(r₁r₂), px.
    #[must_use]
    pub fn radius(&self) -> f64 {
        (self.drawn.radii[0] * self.drawn.radii[1]).sqrt()
    }

    /// The spot with the room that it takes among the others; `pitch` is by region.
    #[must_use]
    pub fn among_others(&self, lookup: &Lookup, pitch: &[f64]) -> rd::PinnedSpot {
        let (_, own) = own_parameters(lookup, self.drawn.center, pitch, &self.deviation);
        let at = [0, 1].map(|axis| {
            let end = lookup.grid.size[axis] as f64 * (1.0 - 1e-12);
            (self.drawn.center[axis] / lookup.grid.cell[axis]).clamp(0.0, end)
        });
        rd::PinnedSpot { at, own, near: nearest(lookup, self.drawn.center) }
    }
}

/// How near another spot may stand to one like those wanted at a place (px), in pitches.
fn nearest(lookup: &Lookup, px: [f64; 2]) -> f64 {
    let wanted = lookup.spots_at(px);
    let pitch = lookup.px_a_cell() * lookup.system.spacing(&lookup.lattice.at(px).parameters(1.0));
    let spacing = wanted.spacing.unwrap_or((wanted.area / PACKED).sqrt());
    let [least, by_density] = lookup.system.definition().spots.map_or([0.0; 2], |spots| spots.merging);
    let share = least + by_density * wanted.area.sqrt() / spacing;
    share * spacing / pitch
}

/// Those of `ellipses` (px) that find room beside the `obstacles`, and a remark a region on those that do not.
pub(super) fn pin_spots(
    lookup: &Lookup,
    obstacles: &[bool],
    ellipses: &[Ellipse],
) -> (Vec<PinnedMark>, Vec<Option<String>>) {
    let layout = *lookup.map.layout();
    let drawn: Vec<PinnedMark> = ellipses.iter().map(|ellipse| PinnedMark::new(lookup, *ellipse)).collect();
    let pitch = vec![1.0; layout.len()];
    let among: Vec<rd::PinnedSpot> = drawn.iter().map(|mark| mark.among_others(lookup, &pitch)).collect();
    let room = placeable(lookup.system, &lookup.maps(&pitch, obstacles), &among);
    let mut counts = vec![Counts::default(); layout.len()];
    let mut pinned = Vec::with_capacity(drawn.len());
    for (mark, room) in drawn.into_iter().zip(room) {
        let count = &mut counts[layout.index(layout.region_of(mark.drawn.center))];
        count.drawn += 1;
        match room {
            Ok(()) => pinned.push(mark),
            Err(Hindrance::Obstacle) => count.taken += 1,
            Err(Hindrance::Neighbour) => count.neighbour += 1,
        }
    }
    (pinned, counts.iter().map(Counts::note).collect())
}

/// The segments of `paths` (px) as guide lines of the noise that stripes begin from, on a canvas of `size` px.
#[must_use]
pub fn guide_lines(paths: &[Path], size: [f64; 2]) -> Vec<GuideLine> {
    let share = |end: [f64; 2]| [0, 1].map(|axis| end[axis] / size[axis]);
    let segments = paths.iter().flat_map(Path::segments);
    segments.map(|line| GuideLine { from: share(line.from), to: share(line.to) }).collect()
}

/// Marks of a region: how many were drawn, and how many find no room, by reason.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    drawn: usize,
    taken: usize,
    neighbour: usize,
}

impl Counts {
    /// A remark on those that find no room.
    fn note(&self) -> Option<String> {
        let reasons = [
            (
                self.neighbour,
                "closer to another than such spots can be",
                "closer to others than such spots can be",
            ),
            (
                self.taken,
                "on a mark of a layer beneath, or too close to one",
                "on marks of a layer beneath, or too close to one",
            ),
        ];
        let lost: usize = reasons.iter().map(|(n, ..)| n).sum();
        let parts: Vec<String> = reasons
            .iter()
            .filter(|(n, ..)| *n > 0)
            .map(|(n, one, more)| if *n == 1 { format!("1 is {one}") } else { format!("{n} are {more}") })
            .collect();
        let kept = self.drawn - lost;
        (lost > 0).then(|| format!("{kept} of {} drawn marks kept: {}", self.drawn, parts.join(", ")))
    }
}

/// The vector from `b` to `a`, px; on a tile the shortest.
#[must_use]
pub fn displacement(a: [f64; 2], b: [f64; 2], layout: &RegionGrid) -> [f64; 2] {
    layout.bounds().shortest([a[0] - b[0], a[1] - b[1]])
}

/// The centre of the part of an ellipse that lies on the canvas, px.
#[must_use]
pub fn visible_center(ellipse: &Ellipse, layout: &RegionGrid) -> [f64; 2] {
    const RINGS: usize = 12;
    const POINTS: usize = 48;
    let [s, c] = [libm::sin, libm::cos].map(|f| f(ellipse.angle.to_radians()));
    let point = |ring: usize, k: usize| {
        // Rings of equal area.
        let radius = ((ring as f64 + 0.5) / RINGS as f64).sqrt();
        let way = std::f64::consts::TAU * k as f64 / POINTS as f64;
        let [along, across] =
            [ellipse.radii[0] * radius * libm::cos(way), ellipse.radii[1] * radius * libm::sin(way)];
        [ellipse.center[0] + along * c - across * s, ellipse.center[1] + along * s + across * c]
    };
    let on = |point: &[f64; 2]| layout.bounds().contains(*point);
    let all = (0..RINGS).flat_map(|ring| (0..POINTS).map(move |k| (ring, k)));
    let inside: Vec<[f64; 2]> = all.map(|(ring, k)| point(ring, k)).filter(on).collect();
    let mean = |axis: usize| inside.iter().map(|point| point[axis]).sum::<f64>() / inside.len() as f64;
    if inside.is_empty() { ellipse.center } else { [mean(0), mean(1)] }
}
