//! Cubic Bézier easing, as in CSS.
//!
//! The curve runs from (0, 0) to (1, 1) with the inner control points (x₁, y₁) and (x₂, y₂):
//!
//! x(t) = 3(1 − t)²t·x₁ + 3(1 − t)t²·x₂ + t³, and y(t) likewise.
//!
//! With x₁ and x₂ in 0..1, x increases with t, so each x has exactly one t and one y.
//!
//! CSS Easing Functions Level 1, § 2.2 (W3C).

/// The easing from one stop to the next: `[x1, y1, x2, y2]`.
///
/// `x1` and `x2` are in 0..1; `y1` and `y2` may be outside, then the colour overshoots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bend(pub [f64; 4]);

/// Linear: no easing.
impl Default for Bend {
    fn default() -> Self {
        Self([0.0, 0.0, 1.0, 1.0])
    }
}

impl Bend {
    /// The share of the second stop's colour (0 = the first stop's colour, 1 = the second's) at the share `x` of the way between
    /// their values. `x` is clamped to 0..1; a straight bend returns `x`.
    ///
    /// ```
    /// use dapple_engine::colour::Bend;
    ///
    /// let slow_start = Bend([0.42, 0.0, 1.0, 1.0]);
    /// assert!(slow_start.ease(0.5) < 0.4);
    /// assert!((slow_start.ease(1.0) - 1.0).abs() < 1e-9);
    /// ```
    #[must_use]
    pub fn ease(&self, x: f64) -> f64 {
        let [x1, y1, x2, y2] = self.0;
        let x = x.clamp(0.0, 1.0);
        if x == 0.0 || x == 1.0 || (x1 == y1 && x2 == y2) {
            return x;
        }
        Curve::through(y1, y2).at(Curve::through(x1.clamp(0.0, 1.0), x2.clamp(0.0, 1.0)).solve(x))
    }

    /// Whether it is linear.
    #[must_use]
    pub fn is_straight(&self) -> bool {
        let [x1, y1, x2, y2] = self.0;
        x1 == y1 && x2 == y2
    }

    /// The easing in the opposite direction.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let [x1, y1, x2, y2] = self.0;
        Self([1.0 - x2, 1.0 - y2, 1.0 - x1, 1.0 - y1])
    }

    /// Splits the easing at `x` into two that give the same colours, if a stop with the colour at `x` is inserted there.
    /// De Casteljau's construction at the t of `x`, each part scaled to 0..1; a part of constant value becomes straight. If x₁ is
    /// much larger than x₂, a part may have an x₁ or x₂ outside 0..1: [`Self::ease`] clamps it, and the part is slightly
    /// inaccurate.
    #[must_use]
    pub fn split(&self, x: f64) -> [Self; 2] {
        let [x1, y1, x2, y2] = self.0;
        if self.is_straight() {
            return [Self::default(); 2];
        }
        let t = Curve::through(x1.clamp(0.0, 1.0), x2.clamp(0.0, 1.0)).solve(x.clamp(0.0, 1.0));
        let cut = |p1: f64, p2: f64| {
            let between = |a: f64, b: f64| a + (b - a) * t;
            let (a, b, c) = (between(0.0, p1), between(p1, p2), between(p2, 1.0));
            let (ab, bc) = (between(a, b), between(b, c));
            let at = between(ab, bc);
            let (before, after) = (|p: f64| p / at, |p: f64| (p - at) / (1.0 - at));
            [[before(a), before(ab)], [after(bc), after(c)]]
        };
        let (xs, ys) = (cut(x1, x2), cut(y1, y2));
        [0, 1].map(|part| {
            let bend = [xs[part][0], ys[part][0], xs[part][1], ys[part][1]];
            if bend.iter().all(|p| p.is_finite()) { Self(bend) } else { Self::default() }
        })
    }

    /// One easing in place of two that meet at `[x, y]`, both in 0..1; the inverse of [`Self::split`]. If the two do not join
    /// smoothly, it starts as the first does and ends as the second does.
    #[must_use]
    pub fn joined(&self, next: &Self, [x, y]: [f64; 2]) -> Self {
        if self.is_straight() && next.is_straight() {
            return Self::default();
        }
        // The cut divides the line between its two neighbouring handles in the ratio t.
        let (before, after) = (x * (1.0 - self.0[2]), (1.0 - x) * next.0[0]);
        let t = if before + after > 0.0 { before / (before + after) } else { x };
        // Handles at the cut itself do not determine t: a handle is lengthened by a factor of at most twenty.
        let t = t.clamp(0.05, 0.95);
        let (first, last) =
            (|p: f64, at: f64| p * at / t, |p: f64, at: f64| 1.0 - (1.0 - p) * (1.0 - at) / (1.0 - t));
        Self([
            first(self.0[0], x).clamp(0.0, 1.0),
            first(self.0[1], y),
            last(next.0[2], x).clamp(0.0, 1.0),
            last(next.0[3], y),
        ])
    }
}

/// One coordinate of the curve in powers of t: c₃t³ + c₂t² + c₁t.
#[derive(Clone, Copy)]
struct Curve([f64; 3]);

impl Curve {
    /// The coordinate that starts at 0, ends at 1 and has the inner control values `p1` and `p2`.
    fn through(p1: f64, p2: f64) -> Self {
        let c1 = 3.0 * p1;
        let c2 = 3.0 * (p2 - p1) - c1;
        Self([c1, c2, 1.0 - c1 - c2])
    }

    fn at(self, t: f64) -> f64 {
        let [c1, c2, c3] = self.0;
        ((c3 * t + c2) * t + c1) * t
    }

    fn slope(self, t: f64) -> f64 {
        let [c1, c2, c3] = self.0;
        (3.0 * c3 * t + 2.0 * c2) * t + c1
    }

    /// The t in 0..1 at which an increasing curve has the value `x`: Newton's method, with bisection where a step would leave
    /// the bracket (the slope is 0 at an end if x₁ = 0 or x₂ = 1, and inside if x₁ = 1 and x₂ = 0).
    fn solve(self, x: f64) -> f64 {
        // 100 bisections alone would shrink the bracket below the resolution of f64; Newton needs 3 to 6 steps.
        const MOST_STEPS: usize = 100;
        // Two rounding errors of a number near 1: smaller differences of x are not significant.
        const NEAR_ENOUGH: f64 = 4.0 * f64::EPSILON;

        let [mut low, mut high] = [0.0, 1.0];
        let mut t = x;
        for _ in 0..MOST_STEPS {
            let over = self.at(t) - x;
            if over.abs() <= NEAR_ENOUGH {
                break;
            }
            if over > 0.0 {
                high = t;
            } else {
                low = t;
            }
            let newton = t - over / self.slope(t);
            t = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        }
        t
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Reference that follows the definition: Bernstein sums, and bisection to the last bit.
    fn by_bisection([x1, y1, x2, y2]: [f64; 4], x: f64) -> f64 {
        let bernstein = |p1: f64, p2: f64, t: f64| {
            3.0 * (1.0 - t).powi(2) * t * p1 + 3.0 * (1.0 - t) * t * t * p2 + t.powi(3)
        };
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..200 {
            let midpoint = 0.5 * (low + high);
            if bernstein(x1, x2, midpoint) < x { low = midpoint } else { high = midpoint }
        }
        bernstein(y1, y2, low)
    }

    #[test]
    fn the_named_css_easings_have_their_known_values() {
        // ease, ease-in, ease-out, ease-in-out at 0.25, 0.5, 0.75: by bisection in 50 decimal digits. Browsers solve to
        // about 1e-6 and give 0.80240338774 for the second.
        let known = [
            ([0.25, 0.1, 0.25, 1.0], [0.408_510_591_355, 0.802_403_387_585, 0.960_458_978_349]),
            ([0.42, 0.0, 1.0, 1.0], [0.093_464_650_719, 0.315_356_812_573, 0.621_861_869_175]),
            ([0.0, 0.0, 0.58, 1.0], [0.378_138_130_825, 0.684_643_187_427, 0.906_535_349_281]),
            ([0.42, 0.0, 0.58, 1.0], [0.129_161_931_047, 0.5, 0.870_838_068_953]),
        ];
        for (bend, values) in known {
            for (x, y) in [0.25, 0.5, 0.75].into_iter().zip(values) {
                assert!((Bend(bend).ease(x) - y).abs() < 2e-12, "{bend:?} at {x}: {}", Bend(bend).ease(x));
            }
        }
    }

    #[test]
    fn ends_and_straight_bends_are_unchanged() {
        for bend in [[0.0, 5.0, 1.0, -5.0], [1.0, 0.0, 0.0, 1.0], [0.3, 0.3, 0.9, 0.9]] {
            assert_eq!([-1.0, 0.0, 1.0, 2.0].map(|x| Bend(bend).ease(x)), [0.0, 0.0, 1.0, 1.0]);
        }
        assert_eq!(Bend::default().ease(0.1), 0.1);
    }

    #[test]
    fn the_steepest_bends_are_solved() {
        // x'(t) is 0 at an end, at both ends, or in the midpoint.
        for bend in [[0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 1.0, 1.0], [0.0, 0.3, 1.0, 0.7], [1.0, 0.0, 0.0, 1.0]] {
            for i in 1..1000 {
                let x = f64::from(i) / 1000.0;
                let (eased, slow) = (Bend(bend).ease(x), by_bisection(bend, x));
                // Around the centre of the last bend, t is only accurate to the cube root of the accuracy of x: 1e-5.
                assert!((eased - slow).abs() < 3e-5, "{bend:?} at {x}: {eased}, not {slow}");
            }
        }
    }

    #[test]
    fn a_straight_bend_stays_straight_when_split_and_joined() {
        let straight = Bend::default();
        assert_eq!(straight.split(0.3), [straight; 2]);
        assert_eq!(straight.joined(&straight, [0.3, 0.8]), straight);
        assert!(Bend([0.2, 0.2, 0.7, 0.7]).is_straight());
    }

    proptest! {
        #[test]
        fn a_split_bend_has_the_same_values(
            x1 in 0.0..=1.0, y1 in 0.0..=1.0, x2 in 0.0..=1.0, y2 in 0.0..=1.0, cut in 0.1..0.9, x in 0.0..=1.0,
        ) {
            let bend = Bend([x1, y1, x2, y2]);
            let y = bend.ease(cut);
            let [before, after] = bend.split(cut);
            let sound = |part: Bend| [0, 2].iter().all(|&i| (0.0..=1.0).contains(&part.0[i]));
            prop_assume!((0.02..0.98).contains(&y) && sound(before) && sound(after));
            let by_parts = if x < cut {
                y * before.ease(x / cut)
            } else {
                y + (1.0 - y) * after.ease((x - cut) / (1.0 - cut))
            };
            prop_assert!((by_parts - bend.ease(x)).abs() < 1e-4, "{bend:?} cut at {cut}, at {x}: {by_parts}");
        }

        #[test]
        fn joining_is_the_inverse_of_splitting(
            x1 in 0.0..=1.0, y1 in 0.0..=1.0, x2 in 0.0..=1.0, y2 in 0.0..=1.0, cut in 0.2..0.8,
        ) {
            let bend = Bend([x1, y1, x2, y2]);
            let y = bend.ease(cut);
            let [before, after] = bend.split(cut);
            // Where the curve has no slope at the cut, t is not determined.
            let smooth = cut * (1.0 - before.0[2]) > 1e-3 && (1.0 - cut) * after.0[0] > 1e-3;
            prop_assume!(smooth && (0.02..0.98).contains(&y));
            let joined = before.joined(&after, [cut, y]);
            let t = cut * (1.0 - before.0[2]) / (cut * (1.0 - before.0[2]) + (1.0 - cut) * after.0[0]);
            prop_assume!((0.05..0.95).contains(&t));
            for i in 0..=20 {
                let x = f64::from(i) / 20.0;
                prop_assert!((joined.ease(x) - bend.ease(x)).abs() < 1e-4, "{bend:?} cut at {cut}: {joined:?}");
            }
        }

        #[test]
        fn reversing_mirrors_the_easing(
            x1 in 0.0..=1.0, y1 in -1.0..=2.0, x2 in 0.0..=1.0, y2 in -1.0..=2.0, x in 0.0..=1.0,
        ) {
            let bend = Bend([x1, y1, x2, y2]);
            let back = 1.0 - bend.reversed().ease(1.0 - x);
            prop_assert!((back - bend.ease(x)).abs() < 1e-4, "{bend:?} at {x}: {back}");
        }

        #[test]
        fn easing_agrees_with_bisection(
            x1 in 0.0..=1.0, y1 in -2.0..=3.0, x2 in 0.0..=1.0, y2 in -2.0..=3.0, x in 0.0..=1.0,
        ) {
            let bend = [x1, y1, x2, y2];
            let (eased, slow) = (Bend(bend).ease(x), by_bisection(bend, x));
            prop_assert!((eased - slow).abs() < 1e-4, "{bend:?} at {x}: {eased}, not {slow}");
        }
    }
}
