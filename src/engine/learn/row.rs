//! One row of a training set: measured attributes and the parameters that were set.

use super::InCells;
use crate::attributes::Attributes;

/// Fewer rows do not determine a line in five dimensions and the scatter around it.
pub(super) const FEWEST_ROWS: usize = 30;

/// Parameters of a simulation, in units of its grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameters {
    /// Reaction rate ÷ √(Da·Db), 1/cell² (stripes: rate in the same units, 1/cell²).
    pub rate: f64,
    /// Db/Da, the ratio of the ranges of inhibitor and activator; `None` for stripes.
    pub ratio: Option<f64>,
    /// Minor ÷ major axis of the diffusion tensor, √(l₂/l₁), 0..1 (1 = isotropic).
    pub stretch: f64,
    /// The tensor's long axis, degrees in [0, 180).
    pub direction: f64,
    /// The share of the local peak that is a mark's edge, 0..1; `None` for stripes.
    pub level: Option<f64>,
}

impl Parameters {
    /// The parameters that apply, by name, in the order of the columns.
    #[must_use]
    pub fn named(&self) -> Vec<(&'static str, f64)> {
        [
            ("rate", Some(self.rate)),
            ("ratio", self.ratio),
            ("stretch", Some(self.stretch)),
            ("direction", Some(self.direction)),
            ("level", self.level),
        ]
        .into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
    }
}

/// One accepted run of `data-gen`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// The seed of the run.
    pub seed: u64,
    /// Size of the patch: number of spots, or for stripes the number of wavelengths across it.
    pub extent: f64,
    /// Evenness of the patch: coefficient of variation of the spots' areas, or coherence of the stripes.
    pub evenness: f64,
    /// The measured attributes; spots always with their spacing.
    pub attributes: InCells<Attributes>,
    /// The parameters that were set.
    pub parameters: Parameters,
}
