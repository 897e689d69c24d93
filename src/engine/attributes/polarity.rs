//! Which of the two phases of a texture of stripes a system grows as its lines: the stripes, or the gaps between them.

use super::{Attributes, Stripes};

/// Stripes that cover more of their period than this are the gaps between lines.
const HALF: f64 = 0.5;
/// A mean duty counts as one half up to this much above it: rounding errors do not decide.
const ROUNDING: f64 = 1e-6;

/// Whether the stripes of a layer are lines that grow, or the gaps between such lines.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Polarity {
    /// Stripes are the lines.
    #[default]
    Positive,
    /// Stripes are the gaps between the lines: they cover more than half.
    Negative,
}

impl Polarity {
    /// The polarity of stripes with this duty cycle (width ÷ period) in the mean.
    #[must_use]
    pub fn of_duty(duty: f64) -> Self {
        if duty > HALF + ROUNDING { Self::Negative } else { Self::Positive }
    }

    /// The lines that have to grow for these marks. Negative: stripes that ask for less than half of their period get half of
    /// it, at their width.
    #[must_use]
    pub fn lines(self, marks: &Attributes) -> Attributes {
        match (self, marks) {
            (Self::Negative, Attributes::Stripes(stripes)) => {
                let most = stripes.width / HALF;
                let wavelength = stripes.wavelength.map(|wavelength| wavelength.min(most));
                Attributes::Stripes(Stripes { wavelength, ..*stripes }.gaps())
            }
            _ => *marks,
        }
    }

    /// The marks that such lines make.
    #[must_use]
    pub fn marks(self, lines: &Attributes) -> Attributes {
        match (self, lines) {
            (Self::Negative, Attributes::Stripes(lines)) => Attributes::Stripes(lines.gaps()),
            _ => *lines,
        }
    }

    /// Whether a duty is on the other side of one half, so that stripes of this polarity cannot have it.
    #[must_use]
    pub fn excludes(self, duty: f64) -> bool {
        match self {
            Self::Positive => duty > HALF + ROUNDING,
            Self::Negative => duty < HALF - ROUNDING,
        }
    }
}

impl Stripes {
    /// The gaps between these stripes: of the same period and direction.
    #[must_use]
    pub fn gaps(&self) -> Self {
        let width = self.wavelength.map_or(self.width, |wavelength| wavelength - self.width);
        Self { width, ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDE: Stripes = Stripes { width: 16.0, angle: 20.0, wavelength: Some(24.0) };

    #[test]
    fn lines_in_the_gaps_of_wide_stripes_have_their_period_and_direction() {
        let lines = Polarity::of_duty(WIDE.duty()).lines(&Attributes::Stripes(WIDE));
        assert_eq!(lines, Attributes::Stripes(Stripes { width: 8.0, ..WIDE }));
        assert_eq!(WIDE.gaps().gaps(), WIDE);
    }

    #[test]
    fn stripes_up_to_half_their_period_are_lines_themselves() {
        for duty in [0.2, 0.5, 5.0 / (5.0 / 0.5)] {
            assert_eq!(Polarity::of_duty(duty), Polarity::Positive);
        }
        assert_eq!(Polarity::Positive.lines(&Attributes::Stripes(WIDE)), Attributes::Stripes(WIDE));
    }

    #[test]
    fn among_wide_stripes_thin_ones_keep_their_width_and_cover_half() {
        let thin = Stripes { width: 6.0, wavelength: Some(20.0), ..WIDE };
        let lines = Polarity::Negative.lines(&Attributes::Stripes(thin));
        assert_eq!(lines, Attributes::Stripes(Stripes { width: 6.0, wavelength: Some(12.0), ..WIDE }));
        assert!(Polarity::Negative.excludes(thin.duty()) && Polarity::Positive.excludes(WIDE.duty()));
        assert!(!Polarity::Negative.excludes(WIDE.duty()) && !Polarity::Positive.excludes(thin.duty()));
    }
}
