//! The use of a picture that is chosen in the window.

use crate::document::{Labels, Layer, LayerMap, MapKey, Points, Progression, ToneImage};
use crate::editor::edit::Edit;
use crate::editor::session::Session;

/// The part of a layer that follows a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureUse {
    /// Which points of a field are dark.
    PointLabels,
    /// Along which direction the distances and probabilities of points change.
    PointProgression,
    /// How an attribute of the active layer varies.
    Map(MapKey),
    /// The tone of the lowest layer, or of the one that has a tone already.
    Tone,
}

impl PictureUse {
    /// The change that lets layer number `index` follow the picture; `None` where the layer is no longer a field of
    /// points, or no longer exists.
    #[must_use]
    pub fn edit(self, session: &Session, index: usize, image: ToneImage) -> Option<Edit> {
        let layer = session.document().layers.get(index);
        let points = || layer.and_then(Layer::point_field);
        Some(match self {
            Self::PointLabels => {
                let points = points()?;
                let passes = match points.labels {
                    Labels::Image { passes, .. } => passes,
                    _ => Labels::PASSES,
                };
                Edit::LayerPoints(index, Points { labels: Labels::Image { image, passes }, ..points })
            }
            Self::PointProgression => {
                Edit::LayerPoints(index, Points { progression: Progression::Image(image), ..points()? })
            }
            Self::Map(key) => {
                let mut maps = layer?.maps.clone();
                maps.set(key, Some(LayerMap::picture(key, image)));
                Edit::LayerMaps(index, Box::new(maps))
            }
            Self::Tone => Edit::Drive(image),
        })
    }
}
