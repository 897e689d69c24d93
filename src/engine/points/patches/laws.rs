//! Which rules of the claims give which shapes: fitted to 768² px tiles of patches of 1,500 px² with coverages of .15–.72,
//! aspects of .4–1, σ of 0–1 and 12–100 points a patch (two seeds each, `facts.md` U).
//!
//! ```text
//! raggedness = R₀ + E(σ, dense)·(k ÷ 24)^(.65·(1 − dense))·(1 − .23·(1 − aspect)),  R₀ = 1.137 − .1·log₁₀(k ÷ 24)
//! λ²(measured) = (c·λ)² + n²,  λ = −ln aspect,  c = 1 − .55·σ,  n = .09 + .38·σ
//! ```
//! where E is read from the table `EXCESS`, k is the points a patch, and dense rises from 0 at a
//! coverage of .15 to 1 at .55.

use super::{Patches, Wanted};
use crate::attributes::Spread;

/// Beyond this patches find no room, however fine the points.
const MOST_COVERAGE: f64 = 0.8;

/// The rules by which a patch claims points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// σ: standard deviation of the logarithm of the cost of a point.
    pub sigma: f64,
    /// Aspect of the metric, 0..1.
    pub aspect: f64,
}

/// Share of the points that the law of rooms gives: with .7 and a coverage of .6 every tenth ragged patch finds no room, with 1 hardly
/// any, at 1.4 times the time.
const ROOM: f64 = 0.8;

/// σ, and the raggedness beyond that of σ = 0 with 24 points a patch: of patches that are far apart, and of dense ones, which
/// have no room for long fringes.
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
/// Coverages at which the two columns hold.
const COVERAGES: [f64; 2] = [0.15, 0.55];
/// Raggedness at σ = 0 with 24 points a patch: that of the corners of cells.
const SMOOTHEST: f64 = 1.137;
/// What a tenfold number of points takes from it: 1.16 with 12, 1.10 with 48.
const SMOOTHER: f64 = 0.1;
/// Growth of the excess with the number of points: 1.5 times for twice as many.
const BY_POINTS: f64 = 0.65;
/// What a long patch has less of it, at an aspect of 0.
const BY_ASPECT: f64 = 0.23;
/// n: −ln of the mean aspect of patches in a round metric, at σ = 0 and its growth with σ: .914, .89, .81, .715 at σ 0, .1, .3, .7.
const UNROUND: [f64; 2] = [0.09, 0.38];
/// How much of −ln aspect is lost at σ = 1: an aspect of .4 becomes .457 at σ = .3, .5–.54 at .7.
const LOST: f64 = 0.55;
/// Share of the wanted −ln aspect that the metric has at least: in a round one patches would have no direction in common, and
/// aspects are .03 too low at most.
const DIRECTED: f64 = 0.5;
/// The narrowest metric: patches of few points cannot be longer.
const NARROWEST: f64 = 0.15;

/// Coefficient of variation of the areas of equal patches: .09–.13 were measured at coverages of .3–.6.
const UNEQUAL: f64 = 0.1;

/// How much equal patches vary by themselves, except in their spacing. Shape and direction are one vector
/// −ln aspect · (cos 2θ, sin 2θ), whose noise is n.
#[must_use]
pub fn own_spread(wanted: &Wanted, detail: f64) -> Spread {
    let noise = UNROUND[0] + UNROUND[1] * wanted.sigma(detail);
    let long = -libm::log(wanted.aspect.clamp(0.01, 0.99));
    let angle = (0.5 * noise / long).to_degrees();
    Spread { area: UNEQUAL, angle, aspect: noise * wanted.aspect, spacing: 0.0 }
}

/// raggedness = smoothest + scale · E(σ).
struct Excess {
    smoothest: f64,
    scale: f64,
    /// σ, E.
    table: [[f64; 2]; EXCESS.len()],
}

impl Wanted {
    /// The share of the plane that the patches cover, 0..1: a hexagonal lattice has 2 ÷ √3 points in a squared spacing.
    #[must_use]
    pub fn coverage(&self) -> f64 {
        self.area * 2.0 / (3f64.sqrt() * self.spacing * self.spacing)
    }

    /// The spacing, px, at which patches of `area` px² cover this share of the plane.
    #[must_use]
    pub fn spacing_of_coverage(area: f64, coverage: f64) -> f64 {
        (area * 2.0 / (3f64.sqrt() * coverage)).sqrt()
    }

    /// Points a patch where `detail` is wanted: more where patches are so dense that the light points between them would leave
    /// them no room.
    ///
    /// A patch of k points is a disc of R = √(k ÷ π) of their distances. With one row of light points between two patches, and
    /// as much lost to chance, it has the share (R ÷ (R + 1))² of the plane; .8 of that k is enough.
    ///
    /// Patches that are wanted smoother than `detail` points make them get as many as R₀ says.
    #[must_use]
    pub fn points(&self, detail: f64) -> f64 {
        let side = self.coverage().clamp(0.0, MOST_COVERAGE).sqrt();
        let radius = side / (1.0 - side);
        let room = ROOM * std::f64::consts::PI * radius * radius;
        let smooth = Patches::DETAIL * libm::pow(10.0, (SMOOTHEST - self.raggedness) / SMOOTHER);
        room.max(detail).max(smooth).clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL)
    }

    /// The rules that give the wanted aspect and raggedness with `detail` points a patch; the nearest where none does.
    #[must_use]
    pub fn shape(&self, detail: f64) -> Shape {
        let sigma = self.sigma(detail);
        let wanted = -libm::log(self.aspect.clamp(0.01, 1.0));
        let unround = UNROUND[0] + UNROUND[1] * sigma;
        let stretch = (wanted * wanted - unround * unround).max(0.0).sqrt() / (1.0 - LOST * sigma);
        let stretch = stretch.max(DIRECTED * wanted);
        Shape { sigma, aspect: libm::exp(-stretch).max(NARROWEST) }
    }

    /// The raggedness of patches that grow with this σ and `detail` points a patch.
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

    /// The raggedness nearest to the wanted one that patches can have which are made from `detail` points, or from more where they are to
    /// be smoother.
    #[must_use]
    pub fn nearest_raggedness(&self, detail: f64) -> f64 {
        let smoothest = self.raggedness_of(0.0, detail);
        if self.raggedness < smoothest {
            return self.raggedness.max(self.raggedness_of(0.0, Patches::MOST_DETAIL)).min(smoothest);
        }
        self.raggedness_of(self.sigma(detail), detail)
    }

    /// σ for the wanted raggedness.
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

    /// What σ adds to the raggedness here.
    fn excess(&self, detail: f64) -> Excess {
        let points = detail.clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL) / Patches::DETAIL;
        let [open, full] = COVERAGES;
        let share = ((self.coverage() - open) / (full - open)).clamp(0.0, 1.0);
        // Room is lost faster the less there is: at .4 the excess is midway.
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
    fn coverage_and_spacing_are_each_other_s_reverse() {
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
    fn more_raggedness_takes_more_noise_and_more_points_take_less() {
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
