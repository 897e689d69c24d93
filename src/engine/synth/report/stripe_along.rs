//! The stripe that grew along a drawn line or path: its width, its direction, and the distance to the next ones.
//!
//! ```text
//!              normal                   width  = high − low
//!   ──── low ────│──── high ──── next   period = from the middle of the stripe to the middle of the next one
//!                sample
//! ```

use crate::attributes::moments::weighted_mean;
use crate::attributes::{Stripes, axial_mean};
use crate::grid::Bounds;
use crate::grid::resample::Spline;
use crate::marks::{Path, PathSample, turn};
use crate::synth::pattern::EDGE;

/// Samples along a line or path.
const SAMPLES: usize = 64;
/// Steps in a width at which an edge is searched across a stripe.
const STEPS: f64 = 8.0;
/// An edge farther away than this number of widths belongs to another stripe.
const WIDEST: f64 = 3.0;
/// Largest distance in which the next stripe is searched, in widths.
const FARTHEST: f64 = 12.0;

/// The stripe that is asked for by a single line or path.
#[must_use]
pub fn drawn_stripe(path: &Path) -> Stripes {
    let directions = path.samples(SAMPLES).into_iter().map(|sample| (sample.direction, 1.0));
    let angle = axial_mean(directions).map_or(0.0, |(angle, _)| angle);
    Stripes { width: path.width, angle, wavelength: None }
}

/// The stripe that grew along `path` (px) in the pattern `surface`; `None` if no sample lies in a stripe with both edges visible.
#[must_use]
pub fn stripe_along(path: &Path, surface: &Spline, bounds: Bounds) -> Option<Stripes> {
    let across = |sample: PathSample| Across::new(&sample, path.width, surface, bounds);
    let found: Vec<Option<Across>> = path.samples(SAMPLES).into_iter().map(across).collect();
    let widths = found.iter().flatten().map(|one| (one.edges[1] - one.edges[0], 1.0));
    let width = weighted_mean(widths)?;
    let turns = found.windows(2).filter_map(|pair| pair[0].as_ref()?.turn_to(pair[1].as_ref()?));
    let angle = (drawn_stripe(path).angle + weighted_mean(turns).unwrap_or(0.0)).rem_euclid(180.0);
    let periods = found.iter().flatten().flat_map(|one| one.periods.map(|period| period.map(|p| (p, 1.0))));
    let wavelength = weighted_mean(periods.flatten());
    Some(Stripes { width, angle, wavelength })
}

/// The stripe across a sample.
struct Across {
    sample: PathSample,
    /// The positions of its edges along the normal of the path, px; the first is negative.
    edges: [f64; 2],
    /// Distances from its middle to those of the next stripes on either side, px.
    periods: [Option<f64>; 2],
}

impl Across {
    /// `None` if the sample lies in no stripe, or too near to the border to see both edges.
    fn new(sample: &PathSample, width: f64, surface: &Spline, bounds: Bounds) -> Option<Self> {
        let ray = Ray { sample, width, surface, bounds };
        if !ray.is_in_stripe(0.0)? {
            return None;
        }
        let [low, high] = [-1.0, 1.0].map(|side| ray.change(0.0, side, WIDEST));
        let edges = [low?, high?];
        let middle = 0.5 * (edges[0] + edges[1]);
        let next = |side: f64, edge: f64| {
            let start = ray.change(edge + side * width / STEPS, side, FARTHEST)?;
            let end = ray.change(start + side * width / STEPS, side, WIDEST)?;
            Some((0.5 * (start + end) - middle).abs())
        };
        Some(Self { sample: *sample, edges, periods: [next(-1.0, edges[0]), next(1.0, edges[1])] })
    }

    /// The middle of the stripe, px.
    fn middle(&self) -> [f64; 2] {
        let off = 0.5 * (self.edges[0] + self.edges[1]);
        beside(&self.sample, off)
    }

    /// The angle of the stripe relative to the path from here to the `next` sample, degrees, with the length of that part as its
    /// weight.
    fn turn_to(&self, next: &Self) -> Option<(f64, f64)> {
        let angle = |[a, b]: [[f64; 2]; 2]| libm::atan2(b[1] - a[1], b[0] - a[0]).to_degrees();
        let drawn = [self.sample.point, next.sample.point];
        let length = (drawn[1][0] - drawn[0][0]).powi(2) + (drawn[1][1] - drawn[0][1]).powi(2);
        (length > 0.0).then(|| (turn(angle([self.middle(), next.middle()]), angle(drawn)), length))
    }
}

/// The point this far beside a sample, px.
fn beside(sample: &PathSample, off: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(sample.direction.to_radians());
    [sample.point[0] - off * s, sample.point[1] + off * c]
}

/// The pattern along the normal of a sample.
struct Ray<'a> {
    sample: &'a PathSample,
    /// Width of the line, px.
    width: f64,
    surface: &'a Spline,
    bounds: Bounds,
}

impl Ray<'_> {
    /// `None` beyond a closed border.
    fn height(&self, off: f64) -> Option<f32> {
        let point = beside(self.sample, off);
        self.bounds.contains(point).then(|| self.surface.at(self.bounds.inside(point)))
    }

    fn is_in_stripe(&self, off: f64) -> Option<bool> {
        Some(self.height(off)? >= EDGE)
    }

    /// The first place from `from` on, towards `side`, where a stripe begins or ends, at most `widths` widths away.
    fn change(&self, from: f64, side: f64, widths: f64) -> Option<f64> {
        let step = side * self.width / STEPS;
        let mut here = self.height(from)?;
        for k in 0..(widths * STEPS) as usize {
            let off = from + k as f64 * step;
            let there = self.height(off + step)?;
            if (here >= EDGE) != (there >= EDGE) {
                return Some(off + step * f64::from((EDGE - here) / (there - here)));
            }
            here = there;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Edges, Field, Grid};

    /// Stripes along y of this width and period, px, with the middle of one at x = 40.
    fn stripes(width: f64, period: f64) -> (Spline, Bounds) {
        let grid = Grid { size: [200, 100], cell: [1.0, 1.0], edges: Edges::Closed };
        let height = |cell: usize| {
            let off = (grid.center_px(cell)[0] - 40.0 + 0.5 * period).rem_euclid(period) - 0.5 * period;
            (0.5 + 0.1 * (0.5 * width - off.abs())).clamp(0.0, 1.0) as f32
        };
        let field = Field::new(&grid, (0..200 * 100).map(height).collect());
        (Spline::new(&field), Bounds { size: [200.0, 100.0], edges: Edges::Closed })
    }

    #[test]
    fn width_direction_and_period_are_those_of_the_stripe_that_grew() {
        let (surface, bounds) = stripes(9.0, 30.0);
        // The path is wider than the stripe, and rotated by 3°.
        let path = Path { points: vec![[39.0, 30.0], [41.0, 68.0]], width: 12.0 };
        let got = stripe_along(&path, &surface, bounds).expect("a stripe");
        assert!((got.width / 9.0 - 1.0).abs() < 0.01 && (got.angle - 90.0).abs() < 0.3, "{got:?}");
        assert!((got.wavelength.expect("others") / 30.0 - 1.0).abs() < 0.01, "{got:?}");
    }

    #[test]
    fn no_stripe_is_found_along_a_path_between_stripes() {
        let (surface, bounds) = stripes(9.0, 30.0);
        let path = Path { points: vec![[55.0, 30.0], [55.0, 70.0]], width: 9.0 };
        assert_eq!(stripe_along(&path, &surface, bounds), None);
    }
}
