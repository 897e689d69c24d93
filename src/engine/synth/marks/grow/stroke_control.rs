//! Stripes along drawn strokes are moved back to them while they form.
//!
//! Stripes around a centre drift outwards or inwards, and where stripes join, others are pushed aside. Each stroke is sampled, and
//! the nearest crest across it is moved back, a little at a time. Where stripes are the gaps between lines, the crests are those of
//! the lines on either side of the stroke.

use rayon::prelude::*;

use crate::attributes::regions::RegionGrid;
use crate::attributes::{Attributes, Polarity};
use crate::grid::resample::Spline;
use crate::grid::{Edges, Field};
use crate::marks::Path;
use crate::rd::{LocalWarp, ParameterField};
use crate::synth::marks::plan::laid_out::Plan;

/// Samples in a period along a stroke.
const SAMPLES: f64 = 3.0;
/// Points in a period at which a crest is searched across a stroke.
const POINTS: i32 = 16;
/// A crest farther away than this number of points belongs to another stripe.
const FARTHEST: i32 = 7;
/// Least height of a crest, relative to that of an undisturbed stripe.
const CREST: f32 = 0.3;
/// Crests closer than this, in periods, are not moved.
const NEAR: f64 = 0.01;
/// The farthest that crests are moved at once, in periods.
const STEP: f64 = 0.08;

/// The intended places of the stripes along the strokes of a plan.
#[derive(Clone, Debug)]
pub struct StrokeControl {
    layout: RegionGrid,
    samples: Vec<Sample>,
}

/// A place where a crest should be.
#[derive(Clone, Copy, Debug)]
struct Sample {
    /// The place on the drawn stroke, px.
    place: [f64; 2],
    /// Unit vector across the stroke.
    normal: [f64; 2],
    /// Period of the stripes there, px.
    period: f64,
}

impl StrokeControl {
    /// `None` where no stroke is pinned.
    #[must_use]
    pub fn new(plan: &Plan) -> Option<Self> {
        let layout = *plan.lookup.map.layout();
        let polarity = plan.lookup.polarity;
        let period = |point: [f64; 2]| match polarity.lines(&plan.lookup.map.at(point)) {
            Attributes::Stripes(stripes) => stripes.wavelength.unwrap_or(2.0 * stripes.width),
            Attributes::Spots(_) => f64::NAN,
        };
        let sides: &[f64] = match polarity {
            Polarity::Positive => &[0.0],
            Polarity::Negative => &[-0.5, 0.5],
        };
        let of_path = |path: &Path| {
            let count = (SAMPLES * path.length() / period(path.center())).ceil().clamp(2.0, 500.0) as usize;
            let samples = path.samples(count).into_iter().flat_map(|sample| {
                let (s, c) = libm::sincos(sample.direction.to_radians());
                let (normal, period) = ([-s, c], period(sample.point));
                sides.iter().map(move |side| {
                    let place = [0, 1].map(|axis| sample.point[axis] + side * period * normal[axis]);
                    Sample { place, normal, period }
                })
            });
            samples.collect::<Vec<_>>()
        };
        let on = |sample: &Sample| layout.bounds().contains(sample.place);
        let samples: Vec<Sample> = plan.pinned_lines().iter().flat_map(of_path).filter(on).collect();
        (!samples.is_empty()).then_some(Self { layout, samples })
    }

    /// Warps that move the crests in `field`, grown in `maps`, towards the strokes; none where no crest has to move.
    #[must_use]
    pub fn warps(&self, field: &Field, maps: &ParameterField) -> Vec<LocalWarp> {
        let surface = Spline::new(field);
        let cells = [0, 1].map(|axis| self.layout.size[axis] / maps.domain.size[axis] as f64);
        let warp = |sample: &Sample| {
            let off = sample.crest(&surface)?;
            let crest = self.inside([0, 1].map(|axis| sample.place[axis] + off * sample.normal[axis]))?;
            let missed = off / sample.period;
            let by = if missed.abs() < NEAR { 0.0 } else { -missed.clamp(-STEP, STEP) * sample.period };
            let at = [0, 1].map(|axis| crest[axis] / cells[axis]);
            let by = [0, 1].map(|axis| by * sample.normal[axis] / cells[axis]);
            Some(LocalWarp { at, own: maps.at(at), by })
        };
        let warps: Vec<LocalWarp> = self.samples.par_iter().filter_map(warp).collect();
        if warps.iter().all(|warp| warp.by == [0.0; 2]) { Vec::new() } else { warps }
    }

    /// A point on the canvas, px; `None` for a point beyond a closed edge.
    fn inside(&self, point: [f64; 2]) -> Option<[f64; 2]> {
        let bounds = self.layout.bounds();
        match bounds.edges {
            Edges::Wrap => Some(bounds.inside(point)),
            Edges::Closed => bounds.contains(point).then_some(point),
        }
    }
}

impl Sample {
    /// Distance of the nearest crest across the stroke, px; `None` if there is none.
    fn crest(&self, surface: &Spline) -> Option<f64> {
        let step = self.period / f64::from(POINTS);
        let height = |point: i32| {
            let off = f64::from(point) * step;
            surface.at([0, 1].map(|axis| self.place[axis] + off * self.normal[axis]))
        };
        let heights: Vec<f32> = (-FARTHEST - 1..=FARTHEST + 1).map(height).collect();
        let crest = |(index, three): (usize, &[f32])| {
            let [before, here, after] = [three[0], three[1], three[2]];
            if here < CREST || here < before || here <= after {
                return None;
            }
            // The vertex of the parabola through the three values.
            let top = 0.5 * f64::from(before - after) / f64::from(before - 2.0 * here + after);
            Some((index as f64 - f64::from(FARTHEST) + top) * step)
        };
        let crests = heights.windows(3).enumerate().filter_map(crest);
        crests.min_by(|a, b| a.abs().total_cmp(&b.abs()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Domain, Grid};

    #[test]
    fn the_nearest_crest_is_found_across_a_stroke() {
        // Stripes of 12 px along y, with a crest at x = 30.
        let grid = Grid { size: [60, 40], cell: [1.0, 1.0], edges: Edges::Closed };
        let height = |cell: usize| {
            let [x, _] = grid.center_px(cell);
            (0.5 + 0.5 * libm::cos((x - 30.0) * std::f64::consts::TAU / 12.0)) as f32
        };
        let surface = Spline::new(&Field::new(&grid, (0..grid.cells()).map(height).collect()));
        for off in [-4.0, -1.5, 0.0, 0.7, 3.0] {
            let sample = Sample { place: [30.0 - off, 20.0], normal: [1.0, 0.0], period: 12.0 };
            let found = sample.crest(&surface).expect("a crest");
            assert!((found - off).abs() < 0.06, "{off} {found}");
        }
        let flat = Spline::new(&Field::new(&grid, vec![0.2; grid.cells()]));
        assert_eq!(Sample { place: [30.0, 20.0], normal: [1.0, 0.0], period: 12.0 }.crest(&flat), None);
    }
}
