//! What a picture that is chosen in the window is for.

use crate::document::{Labels, Points, Progression, ToneImage};

/// What of the active layer follows the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureUse {
    /// Which points of a field are dark.
    PointLabels,
    /// Along which way the distances and probabilities of points go.
    PointProgression,
}

impl PictureUse {
    /// These points with the picture.
    #[must_use]
    pub fn points(self, points: Points, image: ToneImage) -> Points {
        match self {
            Self::PointLabels => {
                let passes = match points.labels {
                    Labels::Image { passes, .. } => passes,
                    _ => Labels::PASSES,
                };
                Points { labels: Labels::Image { image, passes }, ..points }
            }
            Self::PointProgression => Points { progression: Progression::Image(image), ..points },
        }
    }
}
