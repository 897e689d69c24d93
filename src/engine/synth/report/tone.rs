//! The report of a layer that a picture drives, or a growth.

use serde::Serialize;

use crate::document::Tone;
use crate::synth::grow::tone::{GrownTone, ToneErrors};

/// How near a layer is to the picture that drives it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToneReport {
    /// Width and height of the picture, px.
    pub image: [usize; 2],
    /// What follows it.
    pub drives: Vec<&'static str>,
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// The correlation of ink and tone, both blurred by half a wavelength and by one; `None` of an even tone.
    pub correlation: [Option<f64>; 2],
    /// Their mean absolute difference, as a share of ink.
    pub difference: [f64; 2],
    /// The median turn of the lines from the directions wanted where these are clear, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub direction: Option<f64>,
}

/// What Turing's growth has made.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GrowthReport {
    /// The lowest and the highest growth.
    pub range: [f32; 2],
    /// The usual distance from one mark to the next, px.
    pub wavelength: f64,
    /// The share of the canvas that is ink, 0..1.
    pub ink: f64,
}

/// The report of what has grown by `tone`.
#[must_use]
pub fn tone_report(tone: &Tone, grown: &GrownTone) -> Option<ToneReport> {
    let ToneErrors { correlation, difference, direction } = grown.measured.clone()?;
    Some(ToneReport {
        image: tone.image.size(),
        drives: tone.drives.names(),
        wavelength: grown.plan.wavelength,
        correlation,
        difference,
        direction,
    })
}

/// The report of a growth; `None` of other systems.
#[must_use]
pub fn growth_report(grown: &GrownTone) -> Option<GrowthReport> {
    let least = grown.plan.growth.iter().copied().reduce(f32::min)?;
    let most = grown.plan.growth.iter().copied().reduce(f32::max)?;
    Some(GrowthReport { range: [least, most], wavelength: grown.plan.wavelength, ink: grown.ink })
}
