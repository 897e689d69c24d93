//! Laws of scale in closed form, with constants fitted to the rows.
//!
//! ```text
//! spots    A/L² = C e^(S (l₀ − l)) / R      rate·A = K e^(S (l₀ − l)) / R      stretch = aspect   φ = θ
//! stripes  rate·W² = K                      stretch = that of the rows                            φ = θ
//! lines    W/λ = C / R                      rate·W² = K / R^P      stretch = that of the rows     φ = θ
//! ```
//!
//! A area, L spacing, W width, λ wavelength, R ratio, l level, φ direction, θ angle. `facts.md` A (area = K·g/ka), B (both tables
//! are proportional to 1/R within 7 % from 12 to 60, and areas to e^(2.85 (½ − l)) from level ½ to 0.2), C (wavelength ∝ √D). A
//! density is reached by the ratio down to the rows' lowest ratio, beyond it by the level. C and K are the rows' means.
//! `rd::meinhardt_lines`: the width of lines is proportional to R^−0.37, their distance to R^0.55.

use super::{Parameters, Row};
use crate::attributes::system::Scaling;
use crate::attributes::{Attributes, Spots, Stripes};

/// The laws with their constants.
#[derive(Clone, Copy, Debug)]
pub(super) struct Law {
    /// P and S.
    scaling: Scaling,
    /// ln K.
    size: f64,
    /// ln C.
    density: f64,
    /// Whether stripes have a ratio.
    lines: bool,
    /// The lowest ratio of the rows; R is 1 if they have none.
    ratio: f64,
    /// The levels of the rows.
    levels: Option<Levels>,
    /// Mean of the rows' stretch, for stripes.
    stretch: f64,
}

/// The highest level of some rows (l₀), and the lowest.
#[derive(Clone, Copy, Debug)]
struct Levels {
    high: f64,
    low: f64,
}

impl Law {
    /// The laws with the constants that fit `rows` best.
    pub fn fitted(scaling: Scaling, rows: &[Row]) -> Self {
        let n = rows.len().max(1) as f64;
        let mean = |value: &dyn Fn(&Row) -> f64| rows.iter().map(value).sum::<f64>() / n;
        let ratio = rows.iter().filter_map(|row| row.parameters.ratio).fold(f64::INFINITY, f64::min);
        let levels = rows.iter().filter_map(|row| row.parameters.level).fold(None, |levels, level| {
            let Levels { high, low } = levels.unwrap_or(Levels { high: level, low: level });
            Some(Levels { high: f64::max(high, level), low: f64::min(low, level) })
        });
        let lowered =
            |p: &Parameters| levels.zip(p.level).map_or(0.0, |(of, l)| scaling.level * (of.high - l));
        let over_ratio =
            |row: &Row| libm::log(row.parameters.ratio.unwrap_or(1.0)) - lowered(&row.parameters);
        let size = mean(&|row| {
            let rate = libm::log(row.parameters.rate);
            match row.attributes.0 {
                Attributes::Spots(spots) => rate + libm::log(spots.area) + scaling.ratio * over_ratio(row),
                Attributes::Stripes(stripes) => {
                    rate + 2.0 * libm::log(stripes.width) + scaling.ratio * over_ratio(row)
                }
            }
        });
        let density = mean(&|row| match row.attributes.0 {
            Attributes::Spots(Spots { area, spacing: Some(spacing), .. }) => {
                libm::log(area) - 2.0 * libm::log(spacing) + over_ratio(row)
            }
            Attributes::Stripes(Stripes { width, wavelength: Some(wavelength), .. }) => {
                libm::log(width / wavelength) + over_ratio(row)
            }
            _ => 0.0,
        });
        let stretch = mean(&|row| row.parameters.stretch);
        let lines = ratio.is_finite();
        Self { scaling, size, density, lines, ratio: if lines { ratio } else { 1.0 }, levels, stretch }
    }

    /// Parameters for spots whose ln(A/L²) is `density`; `None` if the system determines it.
    pub fn spots(&self, density: Option<f64>, spots: &Spots) -> Parameters {
        let lowest = libm::log(self.ratio);
        let ratio = density.map_or(lowest, |density| (self.density - density).max(lowest));
        // The part of the density that the lowest ratio does not reach.
        let missing = density.map_or(0.0, |density| density - (self.density - ratio)).max(0.0);
        let level = self.levels.map(|of| (of.high - missing / self.scaling.level).max(of.low));
        let lowered =
            self.levels.zip(level).map_or(0.0, |(of, level)| self.scaling.level * (of.high - level));
        Parameters {
            rate: libm::exp(self.size - self.scaling.ratio * ratio + lowered) / spots.area,
            ratio: Some(libm::exp(ratio)),
            stretch: spots.aspect,
            direction: spots.angle,
            level,
        }
    }

    /// Parameters for stripes.
    pub fn stripes(&self, stripes: &Stripes) -> Parameters {
        let ratio = self.lines.then(|| (self.density - libm::log(stripes.duty())).max(libm::log(self.ratio)));
        let size = self.size - self.scaling.ratio * ratio.unwrap_or(0.0);
        Parameters {
            rate: libm::exp(size) / (stripes.width * stripes.width),
            ratio: ratio.map(libm::exp),
            stretch: self.stretch,
            direction: stripes.angle,
            level: None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::laws::{EXACT, MEINHARDT, STRIPES, meinhardt_by_level, size_by_level, stripes};
    use super::*;
    use crate::learn::InCells;

    #[test]
    fn the_constants_of_rows_that_follow_a_law_are_found() {
        let rows = meinhardt_by_level(400, EXACT);
        let law = Law::fitted(MEINHARDT.scaling, &rows);
        for row in &rows {
            let InCells(Attributes::Spots(spots)) = row.attributes else { panic!() };
            let density = spots.spacing.map(|spacing| libm::log(spots.area / (spacing * spacing)));
            let (found, own) = (law.spots(density, &spots), row.parameters);
            // The law of the rows has a term for small spots, which is 6 % at 20 cells.
            assert!((found.rate / own.rate - 1.0).abs() < 0.08, "{found:?} {own:?}");
            assert!((found.ratio.unwrap() / own.ratio.unwrap() - 1.0).abs() < 0.03);
            assert!((found.level.unwrap() - own.level.unwrap()).abs() < 0.015);
        }
        assert!((size_by_level(0.3) - libm::exp(0.2 * MEINHARDT.scaling.level)).abs() < 0.03);
    }

    #[test]
    fn stripes_have_one_constant() {
        let law = Law::fitted(STRIPES.scaling, &stripes(100, EXACT));
        let found = law.stripes(&Stripes { width: 10.0, angle: 33.0, wavelength: None });
        assert!((found.rate - 0.65).abs() < 0.04, "{found:?}");
        assert_eq!((found.direction, found.stretch), (33.0, 0.5));
    }
}
