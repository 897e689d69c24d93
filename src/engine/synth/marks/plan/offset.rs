//! Differences between asked and grown attributes, and the corrections of questions for them.

use crate::attributes::{Attributes, Spots, Stripes};
use crate::marks::{axial, turn};
use crate::rd::Scatter;

/// Above this aspect a spot counts as having no direction.
const DIRECTED: f64 = 0.8;

/// Difference between asked and grown attributes, or the scatter of the difference.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Offset {
    /// Difference of ln area, or of ln width.
    pub size: f64,
    /// Difference of ln spacing, or of ln wavelength where that is free.
    pub spacing: f64,
    /// Difference of −ln aspect.
    pub elongation: f64,
    /// Difference of the direction, degrees.
    pub turn: f64,
}

impl From<Scatter> for Offset {
    fn from(Scatter { size, spacing, elongation, direction }: Scatter) -> Self {
        Self { size, spacing, elongation, turn: direction }
    }
}

impl Offset {
    pub(crate) fn zip(self, other: Self, with: impl Fn(f64, f64) -> f64) -> Self {
        Self {
            size: with(self.size, other.size),
            spacing: with(self.spacing, other.spacing),
            elongation: with(self.elongation, other.elongation),
            turn: with(self.turn, other.turn),
        }
    }

    /// `self` + `share` · `other`.
    #[must_use]
    pub fn plus(self, share: f64, other: Self) -> Self {
        self.zip(other, |a, b| a + share * b)
    }

    /// Whether all parts are below `tolerated`.
    pub(crate) fn within(self, tolerated: Self) -> bool {
        let Self { size, spacing, elongation, turn } =
            self.zip(tolerated, |offset, tolerated| f64::from(u8::from(offset.abs() <= tolerated)));
        size * spacing * elongation * turn > 0.0
    }

    /// The difference from the asked to the grown attributes.
    #[must_use]
    pub fn between(asked: &Attributes, got: &Attributes) -> Self {
        match (asked, got) {
            (Attributes::Spots(asked), Attributes::Spots(got)) => Self {
                size: libm::log(got.area / asked.area),
                spacing: asked.spacing.zip(got.spacing).map_or(0.0, |(asked, got)| libm::log(got / asked)),
                elongation: libm::log(asked.aspect / got.aspect),
                turn: if asked.aspect < DIRECTED { turn(got.angle, asked.angle) } else { 0.0 },
            },
            (Attributes::Stripes(asked), Attributes::Stripes(got)) => Self {
                size: libm::log(got.width / asked.width),
                spacing: asked
                    .wavelength
                    .zip(got.wavelength)
                    .map_or(0.0, |(asked, got)| libm::log(got / asked)),
                turn: turn(got.angle, asked.angle),
                ..Self::default()
            },
            _ => Self::default(),
        }
    }

    /// The `attributes` plus this offset times `share`; the aspect of spots is at most 1.
    #[must_use]
    pub fn applied(&self, share: f64, attributes: &Attributes) -> Attributes {
        let (size, turned) = (libm::exp(share * self.size), share * self.turn);
        match attributes {
            Attributes::Spots(spots) => Attributes::Spots(Spots {
                area: spots.area * size,
                aspect: (spots.aspect * libm::exp(-share * self.elongation)).min(1.0),
                angle: axial(spots.angle + turned),
                spacing: spots.spacing.map(|spacing| spacing * libm::exp(share * self.spacing)),
            }),
            Attributes::Stripes(stripes) => Attributes::Stripes(Stripes {
                width: stripes.width * size,
                angle: axial(stripes.angle + turned),
                wavelength: stripes.wavelength.map(|wavelength| wavelength * libm::exp(share * self.spacing)),
            }),
        }
    }
}

/// The result of the probes for one question.
#[derive(Clone, Debug, Default)]
pub struct Correction {
    /// Patches that were grown to find it.
    pub growths: usize,
    /// The offset to subtract from the question.
    pub offset: Offset,
}

impl Correction {
    /// The correction in words; `None` if there was none.
    #[must_use]
    pub fn note(&self) -> Option<String> {
        let Offset { size, spacing, elongation, turn } = self.offset;
        let percent = |ln: f64| 100.0 * libm::expm1(ln);
        (self.growths > 0).then(|| {
            format!(
                "parameters corrected by {} growth{} of a patch, which was off by {:+.1} % in size, {:+.1} % in \
                 spacing, {:+.1} % in aspect and {turn:+.1}°",
                self.growths,
                if self.growths == 1 { "" } else { "s" },
                percent(size),
                percent(spacing),
                percent(-elongation)
            )
        })
    }
}
