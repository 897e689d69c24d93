//! The plan of a sweep: `plan.json` is the plan of `training/`; users can write their own.
//!
//! ```text
//!  plan.json ─▶ parsed, checked (`read_plan.rs`) ─▶ sets ─▶ run 0, 1, … of each: its seed and its parameters (`draw.rs`)
//! ```

use serde::{Deserialize, Serialize};

use crate::swept::Swept;

/// The plan of `training/`.
pub const BUILT_IN: &str = include_str!("../plan.json");
/// Runs that a set may have.
pub const MOST_RUNS: u64 = 1_000_000;

/// What is swept.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plan {
    format: String,
    version: u64,
    /// The sets, in the order in which they are run.
    pub sets: Vec<Set>,
}

/// Runs that make one file of a training set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Set {
    /// The name of its files: that of the system, or beginning with it and a hyphen.
    pub name: String,
    /// The system.
    pub system: Swept,
    /// Its purpose.
    pub why: String,
    /// The number of simulations.
    pub runs: u64,
    /// The seed of run 0; that of run i is i more. A run does not depend on the number of runs.
    pub seed: u64,
    /// How much each run grows.
    pub patch: Size,
    /// What is varied.
    pub sweep: Sweep,
}

/// How much one run grows.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Size {
    /// Spots that the patch is made for, or wavelengths along its side.
    pub grown: f64,
    /// The least number of whole spots or wavelengths; runs with fewer are rejected.
    pub least: f64,
    /// `spots` or `wavelengths`.
    pub unit: String,
    /// The reason for this size.
    pub why: String,
}

/// The quantities that are varied. Those that a system does not have are left out. For systems of pairs these are the
/// quantities that are drawn for a run.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// Area of the spots, by the scaling law.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area: Option<Range>,
    /// Width of the stripes or lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<Range>,
    /// Diffusion rate of one chemical ÷ that of the other.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ratio: Option<Range>,
    /// Level at which a mark has its edge, as a share of the peak.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub level: Option<Range>,
    /// Minor ÷ major axis of the tensor.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stretch: Option<Range>,
    /// Direction of the long axis of the tensor; for pairs, the first direction.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub direction: Option<Range>,
    /// Number of directions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub directions: Option<Range>,
    /// Width ÷ period.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub duty: Option<Range>,
    /// Width ÷ period of the other directions.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub others: Option<Range>,
    /// Period of the other directions ÷ that of the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unequal: Option<Range>,
    /// Angle between two directions, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub between: Option<Range>,
    /// Length of the lines of a maze ÷ their period.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub long: Option<Range>,
    /// Decay of stucco.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub decay: Option<Range>,
    /// √area of a cell ÷ the width of the lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sparse: Option<Range>,
    /// Minor ÷ major axis of a cell.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub aspect: Option<Range>,
}

/// The range of one quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Range {
    /// Lowest and highest value.
    pub range: [f64; 2],
    /// The unit of both.
    pub unit: String,
    /// How values are distributed between them.
    pub scale: Scale,
    /// Only for a level where the ratio varies too: the share of the runs in which the level varies, with the ratio at
    /// its lowest. In the other runs the ratio varies, with the level at its highest.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub share: Option<f64>,
    /// The reason for this range.
    pub why: String,
}

/// How values are distributed over a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Evenly in the logarithm.
    Log,
    /// Evenly in 1/x.
    Reciprocal,
}

/// A problem as text that is safe in a message: it quotes what a file holds, which may be long and may contain control
/// characters.
pub fn shown(problem: &str) -> String {
    // The length counts bytes as they are shown: an escaped byte takes six.
    const LONGEST: usize = 800;
    let mut shown = String::new();
    for c in problem.chars() {
        if shown.len() > LONGEST {
            shown.push('…');
            break;
        }
        if c.is_control() { shown.extend(c.escape_unicode()) } else { shown.push(c) }
    }
    shown
}

impl Plan {
    /// The plan that has only this set.
    pub fn only(&self, set: &Set) -> Self {
        Self { sets: vec![set.clone()], ..self.clone() }
    }
}
