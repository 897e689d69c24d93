//! The report of a layer that a picture drives, or a growth.

use crate::document::Tone;
use crate::synth::report::{GrowthReport, ToneReport};
use crate::synth::tone::grown::{GrownTone, ToneErrors};

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
