//! What was drawn stays where it was drawn: drawn spots are among those that grow, and the others grow around them.
//!
//! ```text
//!  drawn ellipses ─▶ those that can stand (rd: standing) ─▶ Kept: place and how it differs from its region
//!                                                             │ laid first, parameters of its own (spread)
//!  what has grown ◀───────────────────────────────────────────┘
//! ```

use serde::Serialize;

use super::plan::Plan;
use super::spread::{ASPECTS, Draw, most, own, wanted};
use crate::attributes::Attributes;
use crate::attributes::regions::Layout;
use crate::field::resample::Spline;
use crate::field::{Edges, Field};
use crate::marks::{Ellipse, Line, Mark, turn};
use crate::measure::Spot;
use crate::rd::{self, Hindrance, System, standing};

/// A drawn mark that grows where it was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kept {
    /// As it was drawn, on the canvas that is grown, px.
    pub drawn: Ellipse,
    /// How it differs from what its region has on the mean.
    pub draw: Draw,
}

/// The share of its radius √(r₁r₂) by which a kept mark may be off.
pub const OFF: f64 = 0.25;
/// Nearer to each other than this, in pitches, two spots merge: so much, and so much more for each unit of area ÷ spacing².
/// Of nine pairs among others at 0.05, 0.12, 0.2 none merged at 0.47, 0.63, 0.74 pitches; some did at –, 0.58, 0.68.
const NEAREST: [f64; 2] = [0.42, 1.65];
/// The same of Turing's, which push harder: of 36 such pairs 14 lost a spot at 0.7, two at 0.8 spacings.
const TURING: f64 = 0.88;
/// area ÷ spacing² of spots as near as they come.
const PACKED: f64 = 0.22;
/// A single spot may differ by this many of the standard deviations that spots bear: as much as the drawn ones do.
const DEVIATIONS: f64 = 2.45;

impl Kept {
    /// What `drawn` is among the spots of `plan`.
    fn of(plan: &Plan, drawn: Ellipse) -> Self {
        let wanted = wanted(plan, drawn.center);
        let most = most(plan.system, &wanted);
        let larger = 1.0 + DEVIATIONS * most.area;
        let rounder = DEVIATIONS * most.aspect;
        let turned = (DEVIATIONS * most.angle).min(90.0);
        let mean = match plan.map.region(plan.map.region_of(drawn.center)).filled {
            Attributes::Spots(mean) => mean,
            Attributes::Stripes(_) => wanted,
        };
        let bounds = [ASPECTS[0] - wanted.aspect, ASPECTS[1] - wanted.aspect].map(|b| b.clamp(-rounder, rounder));
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
    pub fn laid(&self, plan: &Plan, pitch: &[f64]) -> rd::Kept {
        let (_, own) = own(plan, self.drawn.center, pitch, &self.draw);
        let at = [0, 1].map(|axis| {
            let end = plan.grid[axis] as f64 * (1.0 - 1e-12);
            (self.drawn.center[axis] / plan.cell[axis]).clamp(0.0, end)
        });
        let wanted = wanted(plan, self.drawn.center);
        let packing = wanted.spacing.map_or(PACKED, |spacing| self.draw.area * wanted.area / (spacing * spacing));
        let near =
            if plan.system == System::TuringSpots { TURING } else { NEAREST[0] + NEAREST[1] * packing };
        rd::Kept { at, own, near }
    }
}

/// How far the grown spot that is nearest to each kept mark of `plan` is from it, ÷ its radius.
#[must_use]
pub fn off(plan: &Plan, spots: &[Spot]) -> Vec<f64> {
    let layout = plan.map.layout();
    let distance = |a: [f64; 2], b: [f64; 2]| {
        let [x, y] = apart(a, b, layout);
        (x * x + y * y).sqrt()
    };
    let nearest = |kept: &Kept| {
        let at = seen(&kept.drawn, layout);
        let distances = spots.iter().map(|spot| distance(spot.ellipse.center, at));
        distances.fold(f64::INFINITY, f64::min) / kept.radius()
    };
    plan.kept.iter().map(nearest).collect()
}

/// The way from `b` to `a`, px; on a tile the shortest.
pub fn apart(a: [f64; 2], b: [f64; 2], layout: &Layout) -> [f64; 2] {
    [0, 1].map(|axis| {
        let (way, side) = (a[axis] - b[axis], layout.size[axis]);
        if layout.edges == Edges::Wrap { way - side * (way / side).round() } else { way }
    })
}

/// The centre of what of an ellipse is seen on the canvas.
pub fn seen(ellipse: &Ellipse, layout: &Layout) -> [f64; 2] {
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
    let on = |point: &[f64; 2]| {
        layout.edges == Edges::Wrap || (0..2).all(|axis| (0.0..=layout.size[axis]).contains(&point[axis]))
    };
    let all = (0..RINGS).flat_map(|ring| (0..POINTS).map(move |k| (ring, k)));
    let inside: Vec<[f64; 2]> = all.map(|(ring, k)| point(ring, k)).filter(on).collect();
    let mean = |axis: usize| inside.iter().map(|point| point[axis]).sum::<f64>() / inside.len() as f64;
    if inside.is_empty() { ellipse.center } else { [mean(0), mean(1)] }
}

/// Keeps in `plan` those of `marks` that can be, and says of the others why not.
pub fn keep(plan: &mut Plan, marks: &[Mark]) {
    let layout = *plan.map.layout();
    let ellipses = marks.iter().filter_map(|mark| match mark {
        Mark::Ellipse(ellipse) => Some(*ellipse),
        Mark::Line(_) => None,
    });
    if plan.system == System::MeinhardtStripes {
        let lines = marks.iter().filter_map(|mark| match mark {
            Mark::Ellipse(_) => None,
            Mark::Line(line) => Some(*line),
        });
        plan.crests = lines.collect();
        return;
    }
    let drawn: Vec<Kept> = ellipses.map(|ellipse| Kept::of(plan, ellipse)).collect();
    let pitch = vec![1.0; layout.len()];
    let laid: Vec<rd::Kept> = drawn.iter().map(|kept| kept.laid(plan, &pitch)).collect();
    let standing = standing(plan.system, &plan.maps(&pitch), layout.edges, &laid);
    let mut counts = vec![Counts::default(); layout.len()];
    for (kept, stands) in drawn.into_iter().zip(standing) {
        let count = &mut counts[layout.index(layout.region_of(kept.drawn.center))];
        count.drawn += 1;
        match stands {
            Ok(()) => plan.kept.push(kept),
            Err(Hindrance::Taken) => count.taken += 1,
            Err(Hindrance::Neighbour) => count.neighbour += 1,
        }
    }
    for (remarks, counts) in plan.remarks.iter_mut().zip(&counts) {
        remarks.extend(counts.note());
    }
}

/// How many marks of a region grew where they were drawn, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Stayed {
    /// Drawn marks of the region.
    pub drawn: usize,
    /// Those that were kept.
    pub kept: usize,
    /// Of these, how many are off by more than [`OFF`].
    pub moved: usize,
    /// The farthest that a kept one is off, ÷ its radius √(r₁r₂).
    pub farthest: f64,
}

impl Stayed {
    /// What there is to say.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let Self { kept, moved, farthest, .. } = self;
        (*moved > 0).then(|| {
            format!(
                "{moved} of {kept} kept marks grew more than a quarter of their radius from where they were drawn, the \
                 farthest {farthest:.1} radii: near an edge they are drawn to it, near others pushed away"
            )
        })
    }
}

/// How the kept marks of `plan` came out among the grown `spots`, by region.
#[must_use]
pub fn stayed(plan: &Plan, spots: &[Spot]) -> Vec<Stayed> {
    let layout = plan.map.layout();
    let drawn = plan.map.regions().map(|(_, region)| Stayed { drawn: region.marks, ..Stayed::default() });
    let mut stayed: Vec<Stayed> = drawn.collect();
    for (kept, off) in plan.kept.iter().zip(off(plan, spots)) {
        let one = &mut stayed[layout.index(layout.region_of(kept.drawn.center))];
        one.kept += 1;
        one.moved += usize::from(off > OFF);
        one.farthest = one.farthest.max(off);
    }
    stayed
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
            (self.taken, "on a mark of a layer beneath, or too near", "on marks of a layer beneath, or too near"),
        ];
        let lost: usize = reasons.iter().map(|(n, ..)| n).sum();
        let said: Vec<String> = reasons
            .iter()
            .filter(|(n, ..)| *n > 0)
            .map(|(n, one, more)| if *n == 1 { format!("1 stands {one}") } else { format!("{n} stand {more}") })
            .collect();
        let kept = self.drawn - lost;
        (lost > 0).then(|| format!("{kept} of {} drawn marks kept: {}", self.drawn, said.join(", ")))
    }
}

/// The share of each kept line of `plan` that lies in a stripe of `pattern`.
#[must_use]
pub fn covered(plan: &Plan, pattern: &Field) -> Vec<f64> {
    const POINTS: usize = 64;
    let surface = Spline::new(pattern);
    let layout = plan.map.layout();
    let share = |line: &Line| {
        let points = (0..POINTS).map(|k| {
            let t = (k as f64 + 0.5) / POINTS as f64;
            [0, 1].map(|axis| line.from[axis] + t * (line.to[axis] - line.from[axis]))
        });
        let on = |point: &[f64; 2]| {
            layout.edges == Edges::Wrap || (0..2).all(|axis| (0.0..=layout.size[axis]).contains(&point[axis]))
        };
        let points: Vec<[f64; 2]> = points.filter(on).collect();
        let covered = points.iter().filter(|point| surface.at(**point) >= 0.5).count();
        covered as f64 / points.len().max(1) as f64
    };
    plan.crests.iter().map(share).collect()
}
