//! The marks of a photograph, in numbers.

use super::rosettes::{self, FoundRosettes};
use super::segmentation::{Segmentation, segment};
use super::verdict::{self, CONTRAST, Neither};
use super::{Raster, smallest, watershed};
use crate::grid::Field;
use crate::measure::{Census, Picture, Spot, census, census_of_at_least, check_picture, picture_of};

/// The marks of a photograph.
#[derive(Clone, Debug)]
pub struct Reading {
    /// Ink and ground; spots that touch are cut apart. Of rosettes, what their outlines enclose is ink.
    pub segmentation: Segmentation,
    /// The rosettes that the marks are; `None` if their marks are solid.
    pub rosettes: Option<FoundRosettes>,
    /// Spots or stripes, and their attributes; spots that are no ellipses with their raggedness.
    pub picture: Picture,
    /// The separate marks, also those cut by the border.
    pub spots: Vec<Spot>,
    /// Least area of a mark, px².
    pub least: f64,
    /// The reason why it is not a texture, if it is none.
    pub neither: Option<Neither>,
}

impl Reading {
    /// The share of the picture that is marks, 0..1.
    #[must_use]
    pub fn ink(&self) -> f64 {
        let Segmentation { field, level, .. } = &self.segmentation;
        let marks = field.values.iter().filter(|value| **value > *level).count();
        marks as f64 / field.values.len().max(1) as f64
    }

    /// The threshold of the edges of the ink, between 0 (ground) and 1 (marks).
    #[must_use]
    pub fn level(&self) -> f32 {
        self.rosettes.as_ref().map_or(self.segmentation.level, |rosettes| rosettes.level)
    }
}

/// Allowed thresholds: beyond, only the noise of ground or marks is visible.
pub const LEVELS: [f32; 2] = [0.05, 0.95];

/// Limits for marks; by default they follow from the photograph.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Limits {
    /// The threshold of the marks' edges, between 0 (ground) and 1 (marks); `None` = near the value at which the photograph changes
    /// most.
    pub level: Option<f32>,
    /// The area of the smallest mark, px²; `None` = 5 % of the usual one.
    pub smallest: Option<f64>,
    /// Whether many specks beside the marks are accepted, and not taken for noise.
    pub among_specks: bool,
}

/// Reads a photograph, see [`segment`].
///
/// # Errors
/// There are no marks at all. If there are marks that do not form a texture, [`Reading::neither`] gives the reason.
pub fn read(raster: &Raster, invert: bool) -> Result<Reading, Neither> {
    // This call is never cancelled.
    let segmentation = segment(raster, invert, &|_| true).ok_or(Neither::Noise)?;
    read_segmented(segmentation, &Limits::default())
}

/// Reads the marks of a segmentation.
///
/// # Errors
/// Those of [`read`].
pub fn read_segmented(mut segmentation: Segmentation, limits: &Limits) -> Result<Reading, Neither> {
    if segmentation.contrast <= 0.0 {
        return Err(Neither::Contrast { contrast: 0.0 });
    }
    segmentation.level = limits.level.unwrap_or(segmentation.level);
    if let Some(least) = limits.smallest {
        smallest::remove_below(&mut segmentation.field, segmentation.level, least);
    }
    if segmentation.is_pattern { pattern(segmentation, limits) } else { photograph(segmentation, limits) }
}

fn photograph(mut segmentation: Segmentation, limits: &Limits) -> Result<Reading, Neither> {
    let (picture, census) = marks(&mut segmentation, limits)?;
    if let Some(reading) = of_rosettes(&segmentation, &picture, &census, limits) {
        return Ok(reading);
    }
    let picture = verdict::with_raggedness(picture, &segmentation.field, segmentation.level, &census.spots);
    let neither = verdict::check(&segmentation, &picture, &census.spots).err();
    Ok(Reading { segmentation, rosettes: None, picture, spots: census.spots, least: census.least, neither })
}

/// The rosettes of a segmentation, if its marks stand in rings.
fn of_rosettes(
    segmentation: &Segmentation,
    picture: &Picture,
    blotches: &Census,
    limits: &Limits,
) -> Option<Reading> {
    let is_other = match picture {
        Picture::Spots { .. } => verdict::are_ellipses(&blotches.spots),
        Picture::Stripes { got, .. } => verdict::have_direction(got),
    };
    if is_other {
        return None;
    }
    let mut ink = segmentation.field.clone();
    // Blotches that hair joins look like bands, which have not been cut apart.
    watershed::cut_apart(&mut ink, segmentation.level);
    let (rosettes, field) = rosettes::found(&ink, segmentation.level)?;
    let mut segmentation = Segmentation { field, level: OUTLINE, ..segmentation.clone() };
    let census = counted(&segmentation.field, OUTLINE, limits);
    let picture = picture_of(&segmentation.field, OUTLINE, &census)?;
    let Picture::Spots { got, .. } = picture else { return None };
    segmentation.wavelength = got.spacing.unwrap_or(segmentation.wavelength);
    let picture = picture.with_raggedness(&segmentation.field, OUTLINE);
    let neither = verdict::check_tones(&segmentation).err();
    let (spots, least) = (census.spots, census.least);
    Some(Reading { segmentation, rosettes: Some(rosettes), picture, spots, least, neither })
}

/// The threshold of the outlines of rosettes.
const OUTLINE: f32 = 0.5;

fn pattern(segmentation: Segmentation, limits: &Limits) -> Result<Reading, Neither> {
    let Segmentation { field, level, .. } = &segmentation;
    let census = counted(field, *level, limits);
    let picture = picture_of(field, *level, &census).ok_or(Neither::Noise)?;
    if let Some(reading) = of_rosettes(&segmentation, &picture, &census, limits) {
        return Ok(reading);
    }
    let picture = verdict::with_raggedness(picture, field, *level, &census.spots);
    let wavelength = match picture {
        Picture::Spots { got, .. } => got.spacing.unwrap_or_else(|| 2.0 * got.area.sqrt()),
        Picture::Stripes { got, .. } => got.wavelength,
    };
    let neither = check_picture(field, *level, &picture).err().map(Neither::NotTexture);
    let segmentation = Segmentation { wavelength, ..segmentation };
    Ok(Reading { segmentation, rosettes: None, picture, spots: census.spots, least: census.least, neither })
}

/// The marks above `level`.
fn counted(field: &Field, level: f32, limits: &Limits) -> Census {
    match limits.smallest {
        // Smaller regions are known to be no marks: even many such specks do not turn the others into noise.
        Some(least) => Census { specks: 0, ..census_of_at_least(field, level, least) },
        None if limits.among_specks => Census { specks: 0, ..census(field, level) },
        None => census(field, level),
    }
}

/// The marks of a segmentation; spots that touch are cut apart in it.
fn marks(segmentation: &mut Segmentation, limits: &Limits) -> Result<(Picture, Census), Neither> {
    let level = segmentation.level;
    let none = if segmentation.contrast < CONTRAST {
        Neither::Contrast { contrast: segmentation.contrast }
    } else {
        Neither::Noise
    };
    let whole = counted(&segmentation.field, level, limits);
    let picture = picture_of(&segmentation.field, level, &whole).ok_or(none)?;
    let is_spotted = matches!(picture, Picture::Spots { .. });
    if !is_spotted || watershed::cut_apart(&mut segmentation.field, level) == 0 {
        return Ok((picture, whole));
    }
    if let Some(least) = limits.smallest {
        smallest::remove_below(&mut segmentation.field, level, least);
    }
    let apart = counted(&segmentation.field, level, limits);
    let picture = picture_of(&segmentation.field, level, &apart).ok_or(none)?;
    Ok((picture, apart))
}
