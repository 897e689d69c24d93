//! A logarithmic axis.

/// A logarithmic scale along a side of a plot.
pub struct Axis {
    /// ln of the lowest and the highest number shown.
    span: [f64; 2],
    /// The places of these two numbers, px.
    px: [f64; 2],
}

impl Axis {
    /// An axis over those of the `values` that are above 0, with a `margin` on both sides, as a share of their span.
    pub fn over(values: impl Iterator<Item = f64>, px: [f64; 2], margin: f64) -> Self {
        let logs = values.filter(|value| *value > 0.0).map(libm::log);
        let [low, high] =
            logs.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
        // There is only one number, or none.
        let [low, high] = if low < high { [low, high] } else { [low.min(0.0) - 1.0, high.max(0.0) + 1.0] };
        let margin = margin * (high - low);
        Self { span: [low - margin, high + margin], px }
    }

    /// The position of `value`, px; the lower end for values that are not above 0.
    pub fn at(&self, value: f64) -> f64 {
        let [low, high] = self.span;
        let share = if value > 0.0 { ((libm::log(value) - low) / (high - low)).max(0.0) } else { 0.0 };
        self.px[0] + share * (self.px[1] - self.px[0])
    }

    /// Round numbers for labels: 1, 2, 5 of each decade where there are few decades, else 1.
    pub fn ticks(&self) -> Vec<f64> {
        let decades = (self.span[1] - self.span[0]) / libm::log(10.0);
        let digits: &[f64] = if decades < 2.2 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let first = (self.span[0] / libm::log(10.0)).floor() as i32;
        (first..first + 12)
            // A negative power is computed as a quotient, which gives 0.001 instead of 0.0010000000000000002.
            .flat_map(|power| {
                digits.iter().map(move |digit| match power {
                    0.. => digit * libm::pow(10.0, f64::from(power)),
                    _ => digit / libm::pow(10.0, f64::from(-power)),
                })
            })
            .filter(|tick| (self.span[0]..=self.span[1]).contains(&libm::log(*tick)))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_decades_have_the_same_length() {
        let axis = Axis::over([1.0, 100.0].into_iter(), [0.0, 200.0], 0.0);
        assert_eq!([1.0, 10.0, 100.0, 0.0].map(|x| axis.at(x).round()), [0.0, 100.0, 200.0, 0.0]);
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let ticks = |low, high| Axis::over([low, high].into_iter(), [0.0, 1.0], 0.0).ticks();
        assert_eq!(ticks(0.015, 1.5), [0.02, 0.05, 0.1, 0.2, 0.5, 1.0]);
        assert_eq!(ticks(0.0015, 150.0), [0.01, 0.1, 1.0, 10.0, 100.0]);
    }

    #[test]
    fn a_single_number_has_a_position() {
        let axis = Axis::over([3.0].into_iter(), [0.0, 1.0], 0.1);
        assert!((0.0..=1.0).contains(&axis.at(3.0)));
        assert!(Axis::over(std::iter::empty(), [0.0, 1.0], 0.1).at(3.0).is_finite());
    }
}
