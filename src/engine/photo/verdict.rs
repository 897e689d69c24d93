//! Decides whether a picture is a texture of spots or stripes, and if not, why.

use super::Segmentation;
use crate::grid::Field;
use crate::measure::{NotTexture, Picture, Spot, StripeStatistics, check_picture};

/// The reason why a photograph shows neither spots nor stripes.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Neither {
    /// Marks and ground hardly differ.
    #[error("marks and ground differ by {contrast:.3} in OKLab, at least {CONTRAST} is needed")]
    Contrast {
        /// Their usual difference.
        contrast: f64,
    },
    /// No connected marks: noise.
    #[error("there are no marks, only noise")]
    Noise,
    /// Marks and ground do not have one tone each.
    #[error(
        "within marks and ground the tones differ by {uneven:.2} of the contrast, in a texture by at most {UNEVEN}"
    )]
    Uneven {
        /// Root mean square, as a share of the contrast.
        uneven: f64,
    },
    /// Too few whole spots.
    #[error(
        "{marks} whole spots are too few, at least {SPOTS} are needed; take a larger part of the pattern"
    )]
    TooFewSpots {
        /// Whole spots.
        marks: usize,
    },
    /// The spots are no ellipses.
    #[error(
        "the marks are not shaped like ellipses: they fill {fill:.3} of the ellipses fitted to them, smooth \
         spots at least {FILL}"
    )]
    Shapes {
        /// Mean over the whole ones.
        fill: f64,
    },
    /// Bands in all directions.
    #[error("the bands have no direction: coherence {coherence:.2}, of stripes at least {COHERENCE}")]
    NoDirection {
        /// Mean coherence.
        coherence: f64,
    },
    /// A reason that applies to any picture.
    #[error(transparent)]
    NotTexture(#[from] NotTexture),
}

/// Least difference of marks and ground, OKLab: below it compression produces spurious marks.
pub const CONTRAST: f64 = 0.04;
/// Most unevenness: see [`Neither::Uneven`].
const UNEVEN: f64 = 0.29;
/// Fewest whole spots.
const SPOTS: usize = 8;
/// Least mean fill of whole spots whose edges are smooth.
const FILL: f64 = 0.97;
/// Least mean fill and least mean raggedness of ragged spots: those of a hyena have 0.91 and 1.4 (1.33 if degraded); boxes and the
/// rosettes of a leopard have a raggedness of at most 1.22.
const RAGGED_FILL: f64 = 0.88;
const RAGGED: f64 = 1.28;
/// Least mean coherence of stripes.
const COHERENCE: f64 = 0.7;

/// Checks that the marks of a photograph form a texture.
///
/// # Errors
/// The first [`Neither`] that applies.
pub fn check(segmentation: &Segmentation, picture: &Picture, spots: &[Spot]) -> Result<(), Neither> {
    check_tones(segmentation)?;
    match picture {
        Picture::Spots { marks, raggedness, .. } => {
            if *marks < SPOTS {
                return Err(Neither::TooFewSpots { marks: *marks });
            }
            let fill = mean_fill(spots);
            if fill < FILL && !is_ragged(fill, *raggedness) {
                return Err(Neither::Shapes { fill });
            }
        }
        Picture::Stripes { got, .. } => {
            if !have_direction(got) {
                return Err(Neither::NoDirection { coherence: got.coherence });
            }
        }
    }
    Ok(check_picture(&segmentation.field, segmentation.level, picture)?)
}

/// Checks that marks and ground have one tone each.
///
/// # Errors
/// [`Neither::Contrast`] or [`Neither::Uneven`].
pub fn check_tones(segmentation: &Segmentation) -> Result<(), Neither> {
    let Segmentation { contrast, uneven, .. } = *segmentation;
    if contrast < CONTRAST {
        return Err(Neither::Contrast { contrast });
    }
    if uneven > UNEVEN {
        return Err(Neither::Uneven { uneven });
    }
    Ok(())
}

/// Whether stripes have a direction.
pub fn have_direction(stripes: &StripeStatistics) -> bool {
    stripes.coherence >= COHERENCE
}

/// Whether spots are ellipses.
pub fn are_ellipses(spots: &[Spot]) -> bool {
    mean_fill(spots) >= FILL
}

/// The measurements with the raggedness of spots that are no ellipses.
#[must_use]
pub fn with_raggedness(picture: Picture, field: &Field, level: f32, spots: &[Spot]) -> Picture {
    if are_ellipses(spots) { picture } else { picture.with_raggedness(field, level) }
}

fn is_ragged(fill: f64, raggedness: Option<f64>) -> bool {
    fill >= RAGGED_FILL && raggedness.is_some_and(|ragged| ragged >= RAGGED)
}

/// The mean fill of the whole spots.
pub fn mean_fill(spots: &[Spot]) -> f64 {
    let fills: Vec<f64> = spots.iter().filter(|spot| spot.whole).map(|spot| spot.fill).collect();
    fills.iter().sum::<f64>() / fills.len().max(1) as f64
}
