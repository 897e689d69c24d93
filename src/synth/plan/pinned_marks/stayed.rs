//! How well kept marks stayed where they were drawn.

use serde::Serialize;

use crate::attributes::regions::RegionGrid;
use crate::grid::resample::Spline;
use crate::grid::{Edges, Field};
use crate::marks::{Ellipse, Line};
use crate::measure::Spot;
use crate::synth::grow::refine::Measured;
use crate::synth::plan::Plan;
use crate::synth::plan::pinned_marks::Kept;

/// The share of its radius √(r₁r₂) by which a kept spot may be off.
const OFF: f64 = 0.25;
/// The share of a kept line that is to lie in a stripe.
const COVERED: f64 = 0.9;

/// How many marks of a region grew where they were drawn, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Stayed {
    /// Drawn marks of the region.
    pub drawn: usize,
    /// Those that were kept.
    pub kept: usize,
    /// Of these, how many are off: spots by more than a quarter of their radius √(r₁r₂), lines of which less than nine
    /// tenths lie in a stripe.
    pub off: usize,
    /// The farthest that a kept spot is off, ÷ its radius; of lines the largest share that lies in no stripe.
    pub farthest: f64,
}

impl Stayed {
    fn count(&mut self, far: f64, allowed: f64) {
        self.kept += 1;
        self.off += usize::from(far > allowed);
        self.farthest = self.farthest.max(far);
    }

    /// What there is to say, of lines or of spots.
    #[must_use]
    pub fn note(&self, lines: bool) -> Option<String> {
        let Self { kept, off, farthest, .. } = self;
        (*off > 0).then(|| match lines {
            true => format!(
                "of {off} of {kept} drawn lines more than a tenth lies in no stripe, of one {:.0} %: lines nearer to \
                 others than the stripes' period, or oblique to these, cannot all be kept",
                100.0 * farthest
            ),
            false => format!(
                "{off} of {kept} kept marks grew more than a quarter of their radius from where they were drawn, the \
                 farthest {farthest:.1} radii: edges draw marks that are near to themselves, near neighbours push"
            ),
        })
    }
}

/// How the kept marks of `plan` came out, by region: in what was `measured`, or in the `pattern` of stripes. Empty where
/// none was to be kept.
#[must_use]
pub fn stayed(plan: &Plan, measured: &Measured, pattern: &dyn Fn() -> Field) -> Vec<Stayed> {
    if plan.kept.is_empty() && plan.crests.is_empty() {
        return Vec::new();
    }
    let layout = plan.map.layout();
    let drawn = plan.map.regions().map(|(_, region)| Stayed { drawn: region.marks, ..Stayed::default() });
    let mut stayed: Vec<Stayed> = drawn.collect();
    let region = |center| layout.index(layout.region_of(center));
    match measured {
        Measured::Spots { marks, .. } => {
            for (kept, off) in plan.kept.iter().zip(off(plan, marks)) {
                stayed[region(kept.drawn.center)].count(off, OFF);
            }
        }
        Measured::Stripes(_) => {
            for (line, covered) in plan.crests.iter().zip(covered(plan, &pattern())) {
                stayed[region(line.center())].count(1.0 - covered, 1.0 - COVERED);
            }
        }
    }
    stayed
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
pub fn apart(a: [f64; 2], b: [f64; 2], layout: &RegionGrid) -> [f64; 2] {
    [0, 1].map(|axis| {
        let (way, side) = (a[axis] - b[axis], layout.size[axis]);
        if layout.edges == Edges::Wrap { way - side * (way / side).round() } else { way }
    })
}

/// The centre of what of an ellipse is seen on the canvas.
pub fn seen(ellipse: &Ellipse, layout: &RegionGrid) -> [f64; 2] {
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
