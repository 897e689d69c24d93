//! Other methods from attributes to parameters, for comparison.

use super::answer::checked;
use super::training_set::Regressions;
use super::{AskError, InCells, Parameters, TrainingSet};
use crate::attributes::Attributes;

/// A method from attributes to parameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// The parameters of the nearest row.
    NearestNeighbour,
    /// The laws of scale in closed form, their constants fitted to the rows: `scale_law.rs`.
    ScaleLaw,
    /// [`TrainingSet::ask`].
    LocalRegression,
}

impl Method {
    /// All, the simplest first.
    pub const ALL: [Self; 3] = [Self::NearestNeighbour, Self::ScaleLaw, Self::LocalRegression];

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::NearestNeighbour => "nearest neighbour",
            Self::ScaleLaw => "scale law",
            Self::LocalRegression => "LWR",
        }
    }
}

impl TrainingSet {
    /// The parameters that `method` gives for `wanted` (angles any finite degrees).
    ///
    /// # Errors
    /// Those of [`Self::ask`].
    pub fn by(&self, method: Method, wanted: &InCells<Attributes>) -> Result<Parameters, AskError> {
        let wanted = checked(wanted)?;
        match (method, &self.map, &wanted) {
            (Method::ScaleLaw, Regressions::Spots(map), Attributes::Spots(spots)) => {
                Ok(self.law().spots(map.map(spots.aspect).log_density(spots), spots))
            }
            (Method::ScaleLaw, Regressions::Stripes(_), Attributes::Stripes(stripes)) => {
                Ok(self.law().stripes(stripes))
            }
            (Method::NearestNeighbour, Regressions::Spots(map), Attributes::Spots(spots)) => {
                Ok(map.map(spots.aspect).nearest(spots))
            }
            (Method::NearestNeighbour, Regressions::Stripes(map), Attributes::Stripes(stripes)) => {
                Ok(map.nearest(stripes))
            }
            // This call refuses attributes of the other kind, too.
            _ => Ok(self.ask(&InCells(wanted))?.parameters),
        }
    }
}
