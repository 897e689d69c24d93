//! What a photograph shows, in numbers.

use super::lab::Lab;
use super::segmentation::{Segmentation, segment};
use super::verdict::{self, CONTRAST, Neither};
use super::{Raster, watershed};
use crate::grid::Field;
use crate::measure::{Picture, Spot, census, check_picture, picture_of};

/// What a photograph shows.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Ink and ground; spots that touch are cut apart.
    pub segmentation: Segmentation,
    /// Spots or stripes, and their attributes.
    pub picture: Picture,
    /// The separate marks, cut ones too.
    pub spots: Vec<Spot>,
    /// Why it is no texture, where it is none.
    pub neither: Option<Neither>,
}

/// Reads a photograph, see [`segment`].
///
/// # Errors
/// There are no marks at all. Where there are some that are no texture, [`Reading::neither`] says so.
pub fn read(raster: &Raster, invert: bool) -> Result<Reading, Neither> {
    let mut segmentation = segment(raster, invert);
    if segmentation.contrast <= 0.0 {
        return Err(Neither::Contrast { contrast: 0.0 });
    }
    let (picture, spots) = marks(&mut segmentation)?;
    let neither = verdict::check(&segmentation, &picture, &spots).err();
    Ok(Reading { segmentation, picture, spots, neither })
}

/// Reads a pattern whose level is known, such as one that dapple wrote; `raster` has its colours.
///
/// # Errors
/// As [`read`].
pub fn read_pattern(field: Field, level: f32, raster: Option<&Raster>) -> Result<Reading, Neither> {
    let lab = raster.map(|raster| Lab::of(raster, 1));
    let census = census(&field, level);
    let picture = picture_of(&field, level, &census).ok_or(Neither::Noise)?;
    let wavelength = match picture {
        Picture::Spots { got, .. } => got.spacing.unwrap_or_else(|| 2.0 * got.area.sqrt()),
        Picture::Stripes { got, .. } => got.wavelength,
    };
    let neither = check_picture(&field, level, &picture).err().map(Neither::NotTexture);
    let segmentation = Segmentation { field, level, wavelength, contrast: 1.0, uneven: 0.0, lab };
    Ok(Reading { segmentation, picture, spots: census.spots, neither })
}

/// The marks of a segmentation; spots that touch are cut apart in it.
fn marks(segmentation: &mut Segmentation) -> Result<(Picture, Vec<Spot>), Neither> {
    let level = segmentation.level;
    let none = if segmentation.contrast < CONTRAST {
        Neither::Contrast { contrast: segmentation.contrast }
    } else {
        Neither::Noise
    };
    let whole = census(&segmentation.field, level);
    let picture = picture_of(&segmentation.field, level, &whole).ok_or(none)?;
    let is_spotted = matches!(picture, Picture::Spots { .. });
    if !is_spotted || watershed::cut_apart(&mut segmentation.field, level) == 0 {
        return Ok((picture, whole.spots));
    }
    let apart = census(&segmentation.field, level);
    let picture = picture_of(&segmentation.field, level, &apart).ok_or(none)?;
    Ok((picture, apart.spots))
}
