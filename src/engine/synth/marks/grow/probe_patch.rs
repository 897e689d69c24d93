//! A seamless square patch grown from one set of parameters, for training rows, probes and comparisons.

use crate::attributes::spacing::{mean_length, neighbours};
use crate::attributes::{Attributes, Spots, Stripes, axial_mean};
use crate::grid::{Edges, Field};
use crate::learn::{self, InCells};
use crate::measure::{self, Reason, Spot};
use crate::rd::{ParameterField, Parameters, System};
use crate::synth::marks::grow::engine::Engine;
use crate::synth::watch::{Cancelled, Watch};

/// Values of a marks field: 0 on the ground, 1 in the middle of a mark.
const RANGE: [f32; 2] = [0.0, 1.0];

/// A patch to be grown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProbePatch {
    /// The system.
    pub system: System,
    /// Its parameters, in cells.
    pub parameters: learn::Parameters,
    /// Spots that the patch holds, or wavelengths along a side.
    pub extent: f64,
    /// Seed of the initial conditions.
    pub seed: u64,
}

/// Measurements of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Whole spots, or wavelengths along a side.
    pub extent: f64,
    /// Coefficient of variation of the area, or coherence.
    pub evenness: f64,
    /// Means over the patch.
    pub attributes: InCells<Attributes>,
}

impl ProbePatch {
    /// Cells along a side.
    #[must_use]
    pub fn side(&self) -> usize {
        let spacing = self.system.spacing(&self.simulated());
        let side = match self.system {
            system if system.is_striped() => self.extent * spacing,
            // A hexagonal lattice has 2/√3 points a squared spacing.
            _ => (self.extent * 0.75f64.sqrt()).sqrt() * spacing,
        };
        (side.ceil() as usize).max(8)
    }

    fn simulated(&self) -> Parameters {
        let p = &self.parameters;
        Parameters {
            rate: p.rate as f32,
            ratio: p.ratio.unwrap_or(1.0) as f32,
            stretch: p.stretch as f32,
            direction: p.direction as f32,
            pitch: 1.0,
        }
    }

    /// Grows it. Returns the marks as a share of the local peak, and whether they settled within their time.
    ///
    /// # Errors
    /// [`Cancelled`].
    pub fn grow(&self, watch: &Watch) -> Result<(Field, bool), Cancelled> {
        let mut engine = self.engine();
        let settled = engine.settle(watch)?;
        Ok((engine.marks(), settled))
    }

    /// Its growth, of which nothing is done yet.
    #[must_use]
    pub fn engine(&self) -> Engine {
        let side = self.side();
        let maps = ParameterField::uniform([side, side], Edges::Wrap, self.simulated());
        Engine::from_maps(self.system, maps, self.seed)
    }

    /// Measures the result of [`Self::grow`].
    ///
    /// # Errors
    /// The reason why it is not a texture.
    pub fn measure(&self, marks: &Field) -> Result<Sample, Reason> {
        match self.system {
            system if system.is_striped() => stripes(system, marks),
            _ => spots(marks, self.parameters.level.unwrap_or(0.5)),
        }
    }

    /// Measures the result of [`Self::grow`] if it is suitable as training data: settled, with at least `least` whole spots or
    /// wavelengths.
    ///
    /// # Errors
    /// The reason why it is not a texture. A pattern that diverged or vanished is reported as such, whether it settled or not.
    pub fn judge(&self, marks: &Field, settled: bool, least: f64) -> Result<Sample, Reason> {
        measure::check_formed(marks, RANGE)?;
        if !settled {
            return Err(Reason::Unsettled);
        }
        let sample = self.measure(marks)?;
        let extent = sample.extent;
        match self.system {
            _ if extent >= least => Ok(sample),
            system if system.is_striped() => Err(Reason::TooFewStripes { wavelengths: extent, least }),
            _ => Err(Reason::TooFew { marks: extent as usize, least: least.ceil() as usize }),
        }
    }
}

/// Means over the whole spots of a patch.
fn spots(marks: &Field, level: f64) -> Result<Sample, Reason> {
    let census = measure::census(marks, level as f32);
    measure::check_spot_texture(marks, &census, RANGE)?;
    let whole: Vec<&Spot> = census.spots.iter().filter(|spot| spot.whole).collect();
    let n = whole.len() as f64;
    let mean = |value: &dyn Fn(&Spot) -> f64| whole.iter().map(|spot| value(spot)).sum::<f64>() / n;
    let area = mean(&|spot| spot.ellipse.area());
    let variance = mean(&|spot| (spot.ellipse.area() - area) * (spot.ellipse.area() - area));
    let centers: Vec<[f64; 2]> = whole.iter().map(|spot| spot.ellipse.center).collect();
    let weighted = whole.iter().map(|spot| (spot.ellipse.major_angle(), 1.0 - spot.ellipse.aspect()));
    let spots = Spots {
        area,
        aspect: mean(&|spot| spot.ellipse.aspect()),
        angle: axial_mean(weighted).map_or(0.0, |(angle, _)| angle),
        spacing: mean_length(&neighbours(&centers, Some(marks.extent()))),
    };
    Ok(Sample { extent: n, evenness: variance.sqrt() / area, attributes: InCells(Attributes::Spots(spots)) })
}

/// Means over a patch of stripes.
fn stripes(system: System, marks: &Field) -> Result<Sample, Reason> {
    let found = measure::stripes(marks, 0.5);
    measure::check_stripe_texture(marks, found.as_ref(), RANGE)?;
    let found = found.ok_or(Reason::TooFewStripes { wavelengths: 0.0, least: 1.0 })?;
    Ok(Sample {
        extent: marks.extent()[0] / found.wavelength,
        evenness: found.coherence,
        attributes: InCells(Attributes::Stripes(Stripes {
            width: found.width,
            angle: found.angle,
            wavelength: system.description().free_spacing.then_some(found.wavelength),
        })),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPOTS: learn::Parameters =
        learn::Parameters { rate: 3.0, ratio: Some(15.0), stretch: 0.6, direction: 30.0, level: Some(0.5) };

    #[test]
    fn a_patch_holds_as_many_spots_as_asked() {
        let patch = ProbePatch { system: System::MEINHARDT_SPOTS, parameters: SPOTS, extent: 24.0, seed: 3 };
        let (marks, settled) = patch.grow(&Watch::NONE).unwrap();
        let sample = patch.measure(&marks).unwrap();
        assert!(settled && (sample.extent - 24.0).abs() <= 1.0, "{sample:?}");
    }

    #[test]
    fn a_patch_without_a_pattern_gives_no_sample() {
        let flat = Field::flat(40, 40, Edges::Wrap, 0.4);
        let patch = ProbePatch { system: System::MEINHARDT_SPOTS, parameters: SPOTS, extent: 9.0, seed: 1 };
        assert!(matches!(patch.measure(&flat), Err(Reason::NoPattern { .. })));
        let patch = ProbePatch { system: System::MEINHARDT_STRIPES, ..patch };
        assert!(matches!(patch.measure(&flat), Err(Reason::NoPattern { .. })));
    }
}
