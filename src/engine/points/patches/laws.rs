//! Rules of the claims for given shapes: fitted to 768² px tiles of patches of 1,500 px² with coverages of .15–.72, aspects of
//! .4–1, σ of 0–1 and 12–100 points in each patch (two seeds each, `facts.md` U).
//!
//! ```text
//! raggedness = R₀ + E(σ, dense)·(k ÷ 24)^(.65·(1 − dense))·(1 − .23·(1 − aspect)),  R₀ = 1.137 − .1·log₁₀(k ÷ 24)
//! λ²(measured) = (c·λ)² + n²,  λ = −ln aspect,  c = 1 − .55·σ,  n = .09 + .38·σ
//! ```
//! where E is read from the table `EXCESS`, k is the number of points in a patch, and dense rises from 0 at a coverage of .15 to 1
//! at .55.

use super::{Patches, Wanted};
use crate::attributes::Spread;

/// The largest coverage: beyond it patches find no room, however fine the points.
const MOST_COVERAGE: f64 = 0.8;

/// The rules by which a patch claims points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// σ: standard deviation of the logarithm of the cost of a point.
    pub sigma: f64,
    /// Aspect of the metric, 0..1.
    pub aspect: f64,
}

/// Factor of the number of points from the rule for room (see [`Wanted::points`]): with .7 and a coverage of .6 every tenth ragged
/// patch finds no room; with 1 hardly any, at 1.4 times the time.
const ROOM: f64 = 0.8;

/// σ, and the increase of raggedness over σ = 0 with 24 points in a patch: for patches that are far apart, and for dense ones,
/// which have no room for long fringes.
const EXCESS: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [0.05, 0.027, 0.027],
    [0.1, 0.1, 0.099],
    [0.2, 0.35, 0.278],
    [0.3, 0.6, 0.43],
    [0.45, 0.905, 0.585],
    [0.7, 1.3, 0.72],
    [1.0, 1.55, 0.83],
];
/// Coverages for which the two columns hold.
const COVERAGES: [f64; 2] = [0.15, 0.55];
/// Raggedness at σ = 0 with 24 points in a patch, caused by the corners of the cells.
const SMOOTHEST: f64 = 1.137;
/// Decrease of that raggedness for ten times as many points: 1.16 with 12, 1.10 with 48.
const SMOOTHER: f64 = 0.1;
/// Exponent of the number of points in the excess: 1.5 times the excess for twice as many points.
const BY_POINTS: f64 = 0.65;
/// Relative decrease of the excess for long patches, at an aspect of 0.
const BY_ASPECT: f64 = 0.23;
/// n: −ln of the mean aspect of patches in a round metric, at σ = 0 and its increase with σ: .914, .89, .81, .715 at σ 0, .1, .3,
/// .7.
const UNROUND: [f64; 2] = [0.09, 0.38];
/// Relative loss of −ln aspect at σ = 1: an aspect of .4 becomes .457 at σ = .3, .5–.54 at .7.
const LOST: f64 = 0.55;
/// The least share of the wanted −ln aspect in the metric: in a round metric patches would have no common direction. Aspects are at
/// most .03 too low by it.
const DIRECTED: f64 = 0.5;
/// The least aspect of the metric: patches of few points cannot be longer.
const NARROWEST: f64 = 0.15;

/// Coefficient of variation of the areas of equal patches: .09–.13 were measured at coverages of .3–.6.
const UNEQUAL: f64 = 0.1;

/// The variation of patches for which no variation is wanted, except in their spacing. Shape and direction are one vector −ln
/// aspect · (cos 2θ, sin 2θ), whose noise is n.
#[must_use]
pub fn own_spread(wanted: &Wanted, detail: f64) -> Spread {
    let noise = UNROUND[0] + UNROUND[1] * wanted.sigma(detail);
    let long = -libm::log(wanted.aspect.clamp(0.01, 0.99));
    let angle = (0.5 * noise / long).to_degrees();
    Spread { area: UNEQUAL, angle, aspect: noise * wanted.aspect, spacing: 0.0 }
}

/// The terms of raggedness = smoothest + scale · E(σ).
struct Excess {
    smoothest: f64,
    scale: f64,
    /// σ, E.
    table: [[f64; 2]; EXCESS.len()],
}

impl Wanted {
    /// The share of the plane that the patches cover, 0..1: a hexagonal lattice has 2 ÷ √3 points in a square whose side is the
    /// spacing.
    #[must_use]
    pub fn coverage(&self) -> f64 {
        self.area * 2.0 / (3f64.sqrt() * self.spacing * self.spacing)
    }

    /// The spacing, px, at which patches of `area` px² have this coverage.
    #[must_use]
    pub fn spacing_of_coverage(area: f64, coverage: f64) -> f64 {
        (area * 2.0 / (3f64.sqrt() * coverage)).sqrt()
    }

    /// Number of points in a patch for a wanted `detail`: more than the detail if patches are so dense that the light points
    /// between them would leave them no room.
    ///
    /// A patch of k points is a disc with the radius R = √(k ÷ π) of their distances. With one row of light points between two
    /// patches, and as much lost to chance, its share is (R ÷ (R + 1))² of the plane; .8 of that k is enough.
    ///
    /// If patches are wanted smoother than `detail` points make them, the number follows from R₀.
    #[must_use]
    pub fn points(&self, detail: f64) -> f64 {
        let side = self.coverage().clamp(0.0, MOST_COVERAGE).sqrt();
        let radius = side / (1.0 - side);
        let room = ROOM * std::f64::consts::PI * radius * radius;
        let smooth = Patches::DETAIL * libm::pow(10.0, (SMOOTHEST - self.raggedness) / SMOOTHER);
        room.max(detail).max(smooth).clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL)
    }

    /// The rules for the wanted aspect and raggedness with `detail` points in a patch; the nearest ones if they cannot be reached.
    #[must_use]
    pub fn shape(&self, detail: f64) -> Shape {
        let sigma = self.sigma(detail);
        let wanted = -libm::log(self.aspect.clamp(0.01, 1.0));
        let unround = UNROUND[0] + UNROUND[1] * sigma;
        let stretch = (wanted * wanted - unround * unround).max(0.0).sqrt() / (1.0 - LOST * sigma);
        let stretch = stretch.max(DIRECTED * wanted);
        Shape { sigma, aspect: libm::exp(-stretch).max(NARROWEST) }
    }

    /// The raggedness of patches that grow with this σ and `detail` points in each.
    #[must_use]
    pub fn raggedness_of(&self, sigma: f64, detail: f64) -> f64 {
        let Excess { smoothest, scale, table } = self.excess(detail);
        let mut excess = table[table.len() - 1][1];
        for [[low, from], [high, to]] in table.windows(2).map(|pair| [pair[0], pair[1]]) {
            if sigma < high {
                excess = from + (to - from) * ((sigma - low) / (high - low)).max(0.0);
                break;
            }
        }
        smoothest + scale * excess
    }

    /// The reachable raggedness nearest to the wanted one, with `detail` points in a patch, or more if patches are to be smoother.
    #[must_use]
    pub fn nearest_raggedness(&self, detail: f64) -> f64 {
        let smoothest = self.raggedness_of(0.0, detail);
        if self.raggedness < smoothest {
            return self.raggedness.max(self.raggedness_of(0.0, Patches::MOST_DETAIL)).min(smoothest);
        }
        self.raggedness_of(self.sigma(detail), detail)
    }

    /// The value of σ for the wanted raggedness.
    fn sigma(&self, detail: f64) -> f64 {
        let Excess { smoothest, scale, table } = self.excess(detail);
        let wanted = (self.raggedness - smoothest) / scale;
        for [[low, from], [high, to]] in table.windows(2).map(|pair| [pair[0], pair[1]]) {
            if wanted < to {
                return low + (high - low) * ((wanted - from) / (to - from)).max(0.0);
            }
        }
        table[table.len() - 1][0]
    }

    /// The contribution of σ to the raggedness for this coverage, aspect and number of points.
    fn excess(&self, detail: f64) -> Excess {
        let points = detail.clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL) / Patches::DETAIL;
        let [open, full] = COVERAGES;
        let share = ((self.coverage() - open) / (full - open)).clamp(0.0, 1.0);
        // Room shrinks faster for denser patches: at .4 the excess is midway.
        let dense = share * share;
        Excess {
            smoothest: SMOOTHEST - SMOOTHER * libm::log10(points),
            scale: libm::pow(points, BY_POINTS * (1.0 - dense)) * (1.0 - BY_ASPECT * (1.0 - self.aspect)),
            table: EXCESS.map(|[sigma, open, full]| [sigma, open + dense * (full - open)]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PATCH: Wanted = Wanted {
        area: 1500.0,
        spacing: 80.0,
        aspect: 0.7,
        angle: 0.0,
        raggedness: 1.4,
        spread: Spread::ZERO,
    };

    #[test]
    fn coverage_and_spacing_are_inverse_functions() {
        for coverage in [0.15, 0.4, 0.7] {
            let wanted = Wanted { spacing: Wanted::spacing_of_coverage(1500.0, coverage), ..PATCH };
            assert!((wanted.coverage() - coverage).abs() < 1e-12);
        }
    }

    #[test]
    fn dense_patches_get_finer_points_and_others_the_detail() {
        let points = |coverage: f64| {
            let spacing = Wanted::spacing_of_coverage(PATCH.area, coverage);
            Wanted { spacing, ..PATCH }.points(24.0)
        };
        assert_eq!((points(0.2), points(0.5)), (24.0, 24.0));
        assert!((points(0.7) - 66.4).abs() < 1.0 && points(0.95) <= Patches::MOST_DETAIL);
    }

    #[test]
    fn more_raggedness_needs_more_noise_and_more_points_need_less() {
        let sigma = |raggedness, detail| Wanted { raggedness, ..PATCH }.shape(detail).sigma;
        assert_eq!((sigma(1.0, 24.0), sigma(9.0, 24.0)), (0.0, 1.0));
        let rising: Vec<f64> = [1.15, 1.2, 1.4, 1.8, 2.2].map(|raggedness| sigma(raggedness, 24.0)).to_vec();
        assert!(rising.is_sorted_by(|a, b| a < b), "{rising:?}");
        for (raggedness, detail) in [(1.2, 24.0), (1.5, 48.0), (1.9, 24.0)] {
            let back = PATCH.raggedness_of(sigma(raggedness, detail), detail);
            assert!((back - raggedness).abs() < 1e-9, "{back}");
        }
        assert!(sigma(1.6, 48.0) < sigma(1.6, 24.0) && sigma(1.6, 24.0) < sigma(1.6, 12.0));
    }

    #[test]
    fn ragged_patches_need_a_longer_metric_and_round_ones_a_round_one() {
        let aspect = |aspect, raggedness| Wanted { aspect, raggedness, ..PATCH }.shape(24.0).aspect;
        assert!(aspect(0.95, 1.2) > 0.97 && aspect(0.95, 1.2) < 1.0 && aspect(1.0, 1.2) == 1.0);
        assert!(aspect(0.4, 2.0) < aspect(0.4, 1.2) && aspect(0.4, 1.2) <= 0.42);
    }
}
