//! Which rules of the claims give which shapes.

use super::{Patches, Wanted};

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
    /// A patch of k points is a disc of R = √(k ÷ π) of their distances. With one row of light points between, a row for two
    /// patches, it has the share (R ÷ (R + 1))² of the plane with all that is lost to chance.
    #[must_use]
    pub fn points(&self, detail: f64) -> f64 {
        let side = self.coverage().clamp(0.0, MOST_COVERAGE).sqrt();
        let radius = side / (1.0 - side);
        (std::f64::consts::PI * radius * radius).max(detail).clamp(Patches::LEAST_DETAIL, Patches::MOST_DETAIL)
    }

    /// The rules that give the wanted aspect and raggedness with `detail` points a patch.
    #[must_use]
    pub fn shape(&self, _detail: f64) -> Shape {
        Shape { sigma: 0.1, aspect: self.aspect }
    }
}
