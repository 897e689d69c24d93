//! What a picture that is chosen in the window is for.

use crate::document::{Labels, Layer, Points, Progression, ToneImage};
use crate::editor::edit::Edit;
use crate::editor::session::Session;

/// What follows the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureUse {
    /// Which points of a field are dark.
    PointLabels,
    /// Along which way the distances and probabilities of points go.
    PointProgression,
    /// The tone of the lowest layer, or of the one that has a tone already.
    Tone,
}

impl PictureUse {
    /// The change with which `layer` follows the picture; `None` where it no longer can.
    #[must_use]
    pub fn edit(self, session: &Session, layer: usize, image: ToneImage) -> Option<Edit> {
        if self == Self::Tone {
            return Some(Edit::Drive(image));
        }
        let points = session.document().layers.get(layer).and_then(Layer::point_field)?;
        Some(Edit::LayerPoints(layer, self.points(points, image)))
    }

    /// These points with the picture.
    fn points(self, points: Points, image: ToneImage) -> Points {
        match self {
            Self::PointLabels => {
                let passes = match points.labels {
                    Labels::Image { passes, .. } => passes,
                    _ => Labels::PASSES,
                };
                Points { labels: Labels::Image { image, passes }, ..points }
            }
            Self::PointProgression => Points { progression: Progression::Image(image), ..points },
            Self::Tone => points,
        }
    }
}
