//! What was drawn stays where it was drawn: drawn marks are among those that grow, and the others grow around them.
//!
//! ```text
//!  ellipses ─▶ those that can stand (rd: placeable) ─▶ Kept: place, and how it differs from its region
//!                                                       │  laid first, in parameters of its own (spread),
//!                                                       │  brought back while it forms (aim)
//!  lines ────▶ crests of the noise that stripes begin from ─▶ grown ─▶ how well they stayed (stayed)
//! ```

mod stayed;

use crate::attributes::Attributes;
use crate::marks::{Ellipse, Line, Mark, turn};
use crate::rd::{self, GuideLine, Hindrance, System, placeable};
use crate::synth::plan::Plan;
use crate::synth::plan::spread::{ASPECTS, Draw, most, own, wanted};
pub use stayed::{Stayed, apart, covered, off, seen, stayed};

/// A drawn mark that grows where it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept {
    /// As it was drawn, on the canvas that is grown, px.
    pub drawn: Ellipse,
    /// How it differs from what its region has on the mean.
    pub draw: Draw,
}

/// Meinhardt's spots merge nearer to each other than d = N₀ + N₁ √(area ÷ spacing²) spacings. Of nine pairs among others,
/// round and long, along and across, all stayed two at 0.40, 0.50, 0.58, 0.64, 0.68 where area ÷ spacing² was 0.03, 0.08,
/// 0.12, 0.16, 0.2; by 0.02 nearer some merged, by 0.06 nearly all.
const NEAREST: [f64; 2] = [0.23, 1.02];
/// Turing's push harder: of 36 such pairs 20 lost a spot at 0.7 spacings, three at 0.8.
const TURING: f64 = 0.85;
/// area ÷ spacing² of spots as near as they come.
const PACKED: f64 = 0.22;
/// A single spot may differ by this many of the standard deviations that spots bear: as much as the drawn ones do.
const DEVIATIONS: f64 = 2.45;

impl Kept {
    /// What `drawn` is among the spots of `plan`.
    fn of(plan: &Plan, drawn: Ellipse) -> Self {
        let wanted = wanted(plan, drawn.center);
        let place = plan.map.region_of(drawn.center);
        let mut most = most(plan.system, &wanted);
        if plan.map.spread_is_given() {
            // Told how unlike spots are, those that were drawn are no more so.
            most = most.with(&plan.map.region(place).spread, f64::min);
        }
        let larger = 1.0 + DEVIATIONS * most.area;
        let rounder = DEVIATIONS * most.aspect;
        let turned = (DEVIATIONS * most.angle).min(90.0);
        let mean = match plan.map.region(place).filled {
            Attributes::Spots(mean) => mean,
            Attributes::Stripes(_) => wanted,
        };
        let bounds =
            [ASPECTS[0] - wanted.aspect, ASPECTS[1] - wanted.aspect].map(|b| b.clamp(-rounder, rounder));
        let draw = Draw {
            area: (drawn.area() / mean.area).clamp(1.0 / larger, larger),
            aspect: (drawn.aspect() - mean.aspect).clamp(bounds[0].min(0.0), bounds[1].max(0.0)),
            turn: turn(drawn.major_angle(), mean.angle).clamp(-turned, turned),
        };
        Self { drawn, draw }
    }

    /// √(r₁r₂), px.
    #[must_use]
    pub fn radius(&self) -> f64 {
        (self.drawn.radii[0] * self.drawn.radii[1]).sqrt()
    }

    /// As it is laid among the others.
    #[must_use]
    pub fn laid(&self, plan: &Plan, pitch: &[f64]) -> rd::PinnedSpot {
        let (_, own) = own(plan, self.drawn.center, pitch, &self.draw);
        let at = [0, 1].map(|axis| {
            let end = plan.grid[axis] as f64 * (1.0 - 1e-12);
            (self.drawn.center[axis] / plan.cell[axis]).clamp(0.0, end)
        });
        rd::PinnedSpot { at, own, near: nearest(plan, self.drawn.center) }
    }
}

/// How near another spot may stand to one like those wanted at a place (px), in pitches.
fn nearest(plan: &Plan, px: [f64; 2]) -> f64 {
    let wanted = wanted(plan, px);
    let pitch = plan.px_a_cell() * plan.system.spacing(&plan.lattice.at(px).parameters(1.0));
    let spacing = wanted.spacing.unwrap_or((wanted.area / PACKED).sqrt());
    let share = match plan.system {
        System::TuringSpots => TURING,
        _ => NEAREST[0] + NEAREST[1] * wanted.area.sqrt() / spacing,
    };
    share * spacing / pitch
}

/// Keeps in `plan` those of `marks` that can be, and says of the others why not.
pub fn keep(plan: &mut Plan, marks: &[Mark]) {
    let (mut ellipses, mut lines): (Vec<Ellipse>, Vec<Line>) = (Vec::new(), Vec::new());
    for mark in marks {
        match mark {
            Mark::Ellipse(ellipse) => ellipses.push(*ellipse),
            Mark::Line(line) => lines.push(*line),
        }
    }
    plan.crests = lines;
    keep_spots(plan, &ellipses);
}

fn keep_spots(plan: &mut Plan, ellipses: &[Ellipse]) {
    if ellipses.is_empty() {
        return;
    }
    let layout = *plan.map.layout();
    let drawn: Vec<Kept> = ellipses.iter().map(|ellipse| Kept::of(plan, *ellipse)).collect();
    let pitch = vec![1.0; layout.len()];
    let laid: Vec<rd::PinnedSpot> = drawn.iter().map(|kept| kept.laid(plan, &pitch)).collect();
    let standing = placeable(plan.system, &plan.maps(&pitch), &laid);
    let mut counts = vec![Counts::default(); layout.len()];
    for (kept, stands) in drawn.into_iter().zip(standing) {
        let count = &mut counts[layout.index(layout.region_of(kept.drawn.center))];
        count.drawn += 1;
        match stands {
            Ok(()) => plan.kept.push(kept),
            Err(Hindrance::Obstacle) => count.taken += 1,
            Err(Hindrance::Neighbour) => count.neighbour += 1,
        }
    }
    for (remarks, counts) in plan.remarks.iter_mut().zip(&counts) {
        remarks.extend(counts.note());
    }
}

/// The kept lines of `plan`.
#[must_use]
pub fn crests(plan: &Plan) -> Vec<GuideLine> {
    let size = plan.map.layout().size;
    let share = |end: [f64; 2]| [0, 1].map(|axis| end[axis] / size[axis]);
    plan.crests.iter().map(|line| GuideLine { from: share(line.from), to: share(line.to) }).collect()
}

/// Marks of a region: how many were drawn, and how many cannot be kept, by reason.
#[derive(Clone, Copy, Debug, Default)]
struct Counts {
    drawn: usize,
    taken: usize,
    neighbour: usize,
}

impl Counts {
    /// What there is to say.
    fn note(&self) -> Option<String> {
        let reasons = [
            (self.neighbour, "nearer to another than such spots can", "nearer to others than such spots can"),
            (
                self.taken,
                "on a mark of a layer beneath, or too near",
                "on marks of a layer beneath, or too near",
            ),
        ];
        let lost: usize = reasons.iter().map(|(n, ..)| n).sum();
        let said: Vec<String> = reasons
            .iter()
            .filter(|(n, ..)| *n > 0)
            .map(
                |(n, one, more)| {
                    if *n == 1 { format!("1 stands {one}") } else { format!("{n} stand {more}") }
                },
            )
            .collect();
        let kept = self.drawn - lost;
        (lost > 0).then(|| format!("{kept} of {} drawn marks kept: {}", self.drawn, said.join(", ")))
    }
}
