//! What a picture that is chosen in the window is for.

use crate::document::{Labels, Layer, LayerMap, MapKey, Points, Progression, ToneImage};
use crate::editor::edit::Edit;

/// What of the active layer follows the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureUse {
    /// Which points of a field are dark.
    PointLabels,
    /// Along which way the distances and probabilities of points go.
    PointProgression,
    /// How an attribute varies.
    Map(MapKey),
}

impl PictureUse {
    /// What makes layer number `index`, `layer`, follow the picture.
    ///
    /// # Errors
    /// Why it cannot, in a sentence.
    pub fn edit(self, index: usize, layer: &Layer, image: ToneImage) -> Result<Edit, &'static str> {
        const NO_POINTS: &str = "The layer is no longer a field of points: choose that system first.";
        let points = || layer.point_field().ok_or(NO_POINTS);
        Ok(match self {
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
                let mut maps = layer.maps.clone();
                maps.set(key, Some(LayerMap::picture(key, image)));
                Edit::LayerMaps(index, maps)
            }
        })
    }
}
