//! The report of a layer that a picture or Turing's growth drives.

use crate::document::Tone;
use crate::synth::report::{GrowthReport, ToneReport};
use crate::synth::tone::grown::{GrownTone, ToneErrors};

/// The report of a layer driven by `tone`.
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

/// The report of Turing's growth; `None` for other systems.
#[must_use]
pub fn growth_report(grown: &GrownTone) -> Option<GrowthReport> {
    let least = grown.plan.growth.iter().copied().reduce(f32::min)?;
    let most = grown.plan.growth.iter().copied().reduce(f32::max)?;
    Some(GrowthReport { range: [least, most], wavelength: grown.plan.wavelength, ink: grown.ink })
}
