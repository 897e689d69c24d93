//! Why there is no sketch, in words without the options of the command line.

use crate::document::{limits, with_causes};
use crate::synth::import::measured_picture::MeasureError;
use crate::synth::import::photo::PhotoImportError;

/// Why a photograph cannot be read, without the options of the command line.
#[must_use]
pub fn refused(error: &MeasureError) -> String {
    match error {
        MeasureError::Blank { contrast, .. } => {
            format!(
                "The colours of marks and ground are too similar to tell them apart: they differ by \
                 {contrast:.3} (in OKLab)."
            )
        }
        MeasureError::Neither { reason, .. } => format!("Neither spots nor stripes: {reason}."),
        other => other.to_string(),
    }
}

/// Why there is no sketch of what was found.
#[must_use]
pub fn no_sketch(error: &PhotoImportError) -> String {
    match error {
        PhotoImportError::Size { size, .. } => format!(
            "The photograph has {} × {} px, a document at most {} on a side: drag the corners to a smaller part.",
            size[0],
            size[1],
            limits::MAX_SIDE
        ),
        PhotoImportError::NoMarks { .. } => {
            "The border cuts every mark, so that none can be drawn. Use a larger part of the pattern."
                .to_owned()
        }
        other => with_causes(other),
    }
}
