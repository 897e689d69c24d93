//! How well pinned marks stayed where they were drawn.

use serde::Serialize;

use crate::attributes::regions::RegionGrid;
use crate::grid::Field;
use crate::grid::resample::Spline;
use crate::marks::Path;
use crate::measure::Spot;
use crate::synth::grow::refine::Measured;
use crate::synth::plan::laid_out::Plan;
use crate::synth::plan::pinned_marks::{PinnedMark, displacement, visible_center};

/// The share of its radius √(r₁r₂) by which a pinned spot may be off.
const OFF: f64 = 0.25;
/// The share of a pinned line that is to lie in a stripe.
const COVERED: f64 = 0.9;

/// How many marks of a region grew where they were drawn, and how well.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Stayed {
    /// Drawn marks of the region.
    pub drawn: usize,
    /// Those that were pinned.
    pub kept: usize,
    /// Of these, how many are off: spots by more than a quarter of their radius √(r₁r₂), lines of which less than nine
    /// tenths lie in a stripe.
    pub off: usize,
    /// The farthest that a kept spot is off, ÷ its radius, infinite where no spot grew; of lines the largest share that
    /// lies in no stripe.
    pub farthest: f64,
}

impl Stayed {
    fn count(&mut self, far: f64, allowed: f64) {
        self.kept += 1;
        self.off += usize::from(far > allowed);
        self.farthest = self.farthest.max(far);
    }

    /// A note on lines or spots that are off.
    #[must_use]
    pub fn note(&self, lines: bool) -> Option<String> {
        let Self { kept, off, farthest, .. } = self;
        (*off > 0).then(|| match lines {
            true => format!(
                "more than a tenth of {off} of {kept} drawn lines lies outside of stripes, at most {:.0} %: lines closer to \
                 others than the stripes' period, or oblique to them, cannot all be kept",
                100.0 * farthest
            ),
            false if farthest.is_infinite() => format!("{kept} drawn marks were to be kept, but nothing grew there"),
            false => format!(
                "{off} of {kept} kept marks grew more than a quarter of their radius from where they were drawn, the \
                 farthest {farthest:.1} radii: closed edges attract marks near them, and close neighbours repel each other"
            ),
        })
    }
}

/// How well the pinned marks of `plan` stayed, by region: spots in what was `measured`, lines in the `pattern` of stripes.
/// Empty where none was pinned.
#[must_use]
pub fn stayed(plan: &Plan, measured: &Measured, pattern: &dyn Fn() -> Field) -> Vec<Stayed> {
    let (spots, lines) = (plan.pinned_spots(), plan.pinned_lines());
    if spots.is_empty() && lines.is_empty() {
        return Vec::new();
    }
    let layout = plan.lookup.map.layout();
    let regions = plan.lookup.map.regions();
    let mut stayed: Vec<Stayed> =
        regions.map(|(_, region)| Stayed { drawn: region.marks, ..Stayed::default() }).collect();
    let region = |center| layout.index(layout.region_of(center));
    match measured {
        Measured::Spots { marks, .. } => {
            for (pinned, distance) in spots.iter().zip(distances(spots, layout, marks)) {
                stayed[region(pinned.drawn.center)].count(distance, OFF);
            }
        }
        Measured::Stripes(_) => {
            for (line, covered) in lines.iter().zip(covered(lines, layout, &pattern())) {
                stayed[region(line.center())].count(1.0 - covered, 1.0 - COVERED);
            }
        }
    }
    stayed
}

/// The distance from each pinned mark to the nearest of the grown `spots`, ÷ its radius.
#[must_use]
pub fn distances(pinned: &[PinnedMark], layout: &RegionGrid, spots: &[Spot]) -> Vec<f64> {
    let distance = |a: [f64; 2], b: [f64; 2]| {
        let [x, y] = displacement(a, b, layout);
        (x * x + y * y).sqrt()
    };
    let nearest = |pinned: &PinnedMark| {
        let at = visible_center(&pinned.drawn, layout);
        let distances = spots.iter().map(|spot| distance(spot.ellipse.center, at));
        distances.fold(f64::INFINITY, f64::min) / pinned.radius()
    };
    pinned.iter().map(nearest).collect()
}

/// The share of each of these paths (px) that lies in a stripe of `pattern`.
#[must_use]
pub fn covered(paths: &[Path], layout: &RegionGrid, pattern: &Field) -> Vec<f64> {
    const POINTS: usize = 64;
    let surface = Spline::new(pattern);
    let share = |path: &Path| {
        let points = path.samples(POINTS).into_iter().map(|sample| sample.point);
        let on = |point: &[f64; 2]| layout.bounds().contains(*point);
        let points: Vec<[f64; 2]> = points.filter(on).collect();
        let covered = points.iter().filter(|point| surface.at(**point) >= 0.5).count();
        covered as f64 / points.len().max(1) as f64
    };
    paths.iter().map(share).collect()
}
