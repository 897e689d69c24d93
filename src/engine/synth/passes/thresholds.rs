//! Thresholds for the last per cents of areas and widths. A threshold is the share of the peak at the edge of a mark; it has one
//! factor for each region of a canvas, or about each anchor of a surface.
//!
//! A secant method: d ln size / d ln threshold is known for each system, and measured more accurately in the first step.

/// Most steps. Two are usually enough: after them none of four regions of cheetah-run and zebra differed by more than 0.01 % (area)
/// or 0.06 % (width).
const ROUNDS: usize = 8;
/// Relative errors of areas and widths below this are not corrected: half the error of the measurement.
pub(super) const NEAR: f64 = 0.001;

/// A pattern whose thresholds can be moved.
pub trait Thresholds {
    /// The factors of the looked-up thresholds, by region.
    fn thresholds(&self) -> &[f64];

    /// The least and the largest factor that may be used. Beyond them the parameters are wrong, and a threshold would only hide
    /// that.
    fn range(&self) -> [f64; 2];

    /// d ln size / d ln threshold before any step, by region.
    fn slopes(&self) -> Vec<f64>;

    /// got ÷ wanted − 1 of area or width with these thresholds, by region; `None` where nothing is measured.
    fn size_errors(&self) -> &[Option<f64>];

    /// Changes the logarithms of the thresholds so that their means within the regions change by about `wanted`, and measures
    /// again. Returns the changes of these means.
    fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64>;
}

/// The changes in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// The largest relative error before.
    pub largest: f64,
    /// Number of regions, or spots, that were changed.
    pub count: usize,
}

/// Thresholds that are moved step by step.
pub struct Levelling {
    /// d ln size / d ln threshold, by region.
    slope: Vec<f64>,
    round: usize,
}

impl Levelling {
    /// The state before the first step.
    #[must_use]
    pub fn new(of: &impl Thresholds) -> Self {
        Self { slope: of.slopes(), round: 0 }
    }

    /// The share of the steps that are done, 0..1.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.round as f64 / ROUNDS as f64
    }

    /// Makes a step if one is needed. Returns what was moved, with the errors.
    pub fn advance(&mut self, of: &mut impl Thresholds) -> Option<Moved> {
        let sizes = || of.size_errors().iter().flatten().map(|error| error.abs());
        let is_near = sizes().all(|error| error < NEAR);
        if self.round == ROUNDS || is_near {
            return None;
        }
        let step = Moved { largest: sizes().fold(0.0, f64::max), count: sizes().count() };
        self.round += 1;
        let (slope, [least, largest]) = (&mut self.slope, of.range());
        let errors = of.size_errors().to_vec();
        let wanted = |((error, slope), factor): ((&Option<f64>, &f64), &f64)| {
            let step = -libm::log1p((*error)?) / slope;
            // At the end of the range a factor stays, and the regions around it must take this into account.
            (*factor != if step < 0.0 { least } else { largest }).then_some(step)
        };
        let wanted: Vec<Option<f64>> =
            errors.iter().zip(slope.iter()).zip(of.thresholds()).map(wanted).collect();
        let moved = of.step(&wanted);
        for ((slope, moved), (old, new)) in
            slope.iter_mut().zip(moved).zip(errors.iter().zip(of.size_errors()))
        {
            let (Some(old), Some(new)) = (old, new) else { continue };
            if moved.abs() > 1e-4 {
                let found = (libm::log1p(*new) - libm::log1p(*old)) / moved;
                // Marks across a border are measured in one region only; a slope of the wrong sign would diverge.
                let [low, high] = if *slope < 0.0 { [2.0, 0.5] } else { [0.5, 2.0] };
                *slope = found.clamp(low * *slope, high * *slope);
            }
        }
        Some(step)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sizes that are powers of their thresholds, in regions that do not touch.
    struct Powers {
        factors: Vec<f64>,
        errors: Vec<Option<f64>>,
    }

    impl Powers {
        /// The true slope is twice the given one.
        const SLOPE: f64 = -2.4;

        fn of(first: &[f64]) -> Self {
            Self { factors: vec![1.0; first.len()], errors: first.iter().map(|error| Some(*error)).collect() }
        }
    }

    impl Thresholds for Powers {
        fn thresholds(&self) -> &[f64] {
            &self.factors
        }

        fn range(&self) -> [f64; 2] {
            [0.6, 1.5]
        }

        fn slopes(&self) -> Vec<f64> {
            vec![0.5 * Self::SLOPE; self.factors.len()]
        }

        fn size_errors(&self) -> &[Option<f64>] {
            &self.errors
        }

        fn step(&mut self, wanted: &[Option<f64>]) -> Vec<f64> {
            let mut moved = Vec::new();
            for ((factor, error), wanted) in self.factors.iter_mut().zip(&mut self.errors).zip(wanted) {
                let before = *factor;
                *factor = (*factor * libm::exp(wanted.unwrap_or(0.0))).clamp(0.6, 1.5);
                let by = libm::log(*factor / before);
                *error = error.map(|error| (1.0 + error) * libm::exp(Self::SLOPE * by) - 1.0);
                moved.push(by);
            }
            moved
        }
    }

    fn levelled(first: &[f64]) -> (Powers, usize) {
        let mut powers = Powers::of(first);
        let mut levelling = Levelling::new(&powers);
        let mut rounds = 0;
        while levelling.advance(&mut powers).is_some() {
            rounds += 1;
        }
        (powers, rounds)
    }

    #[test]
    fn sizes_are_as_asked_after_few_steps_though_the_slope_is_not_well_known() {
        let (powers, rounds) = levelled(&[0.2, -0.15, 0.0]);
        assert!(powers.errors.iter().flatten().all(|error| error.abs() < NEAR) && rounds <= 3, "{rounds}");
    }

    #[test]
    fn small_errors_are_left_and_unreachable_sizes_end_at_the_range() {
        assert_eq!(levelled(&[0.5 * NEAR]).1, 0);
        let (powers, rounds) = levelled(&[9.0]);
        assert_eq!((powers.factors[0], rounds), (1.5, ROUNDS));
    }
}
