//! Measures a picture: whether it shows spots or stripes, their attributes, and the reason if it shows neither.
//!
//! Both measuring and importing use this room, so that they find equal numbers.

use std::borrow::Cow;
use std::io::{BufRead, Seek};
use std::path::{Path, PathBuf};

use image::DynamicImage;

use crate::colour::Gradient;
use crate::document::{Colours, Document, embedded};
use crate::grid::{Edges, Field};
use crate::measure::{Picture, otsu_threshold, patches};
use crate::photo::{self, Corners, Crop, Limits, Neither, Raster, Reading, Segmentation};
use crate::points::rosettes::Rosettes;
use crate::synth::memory;
use crate::synth::pattern::EDGE;

/// The reason why a picture could not be read.
#[derive(Debug, thiserror::Error)]
pub enum MeasureError {
    /// The file cannot be read.
    #[error("{path}: cannot be read as a picture: {}", one_line(source))]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: photo::PictureError,
    },
    /// The picture has more px than fit into memory.
    #[error(
        "{path}: {}×{} px need about {:.1} GB of memory to be measured, {:.1} GB are free; allowed: a smaller part of it",
        size[0], size[1], needed / 1e9, free / 1e9
    )]
    TooLarge {
        /// The file.
        path: PathBuf,
        /// Width and height, px.
        size: [usize; 2],
        /// Bytes needed.
        needed: f64,
        /// Bytes free.
        free: f64,
    },
    /// The part to be read is not in it.
    #[error(
        "{path}: --crop: found {},{},{},{}; allowed: a part of its {}×{} px",
        crop.from[0], crop.from[1], crop.size[0], crop.size[1], size[0], size[1]
    )]
    Crop {
        /// The file.
        path: PathBuf,
        /// The part.
        crop: Crop,
        /// Width and height of the picture, px.
        size: [usize; 2],
    },
    /// The corners do not enclose a part of the picture.
    #[error(
        "{path}: --corners: allowed: four corners inside of its {}×{} px that bulge outwards, from the upper left one clockwise",
        size[0], size[1]
    )]
    Corners {
        /// The file.
        path: PathBuf,
        /// Width and height of the picture, px.
        size: [usize; 2],
    },
    /// The picture has no contrast.
    #[error(
        "{path}: neither spots nor stripes: marks and ground differ by {contrast:.3} in OKLab; allowed: a picture with more contrast, or --crop to where the marks are"
    )]
    Blank {
        /// The file.
        path: PathBuf,
        /// Their difference.
        contrast: f64,
    },
    /// The picture has contrast but no marks, or marks that do not form a texture.
    #[error("{path}: neither spots nor stripes: {reason}{}", remedy(reason))]
    Neither {
        /// The file.
        path: PathBuf,
        /// Why.
        reason: Neither,
    },
}

/// A remedy that may help against a reason.
fn remedy(reason: &Neither) -> &'static str {
    match reason {
        Neither::Noise | Neither::Shapes { .. } | Neither::NoDirection { .. } => {
            "; try --invert, or --crop to the pattern"
        }
        Neither::Contrast { .. } | Neither::Uneven { .. } | Neither::NotTexture(_) => {
            "; try --crop to the pattern"
        }
        Neither::TooFewSpots { .. } => "",
    }
}

/// The part of a picture that is read, and which of its colours are the marks.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Framing {
    /// Whether the colour that covers more is the marks.
    pub invert: bool,
    /// The part that is read; `None` = all.
    pub crop: Option<Crop>,
    /// Four corners of a flat object in the picture (before it is cropped), which are mapped to a rectangle.
    pub corners: Option<Corners>,
    /// Limits for the size of marks.
    pub limits: Limits,
    /// Whether it is read as an ordinary picture even if it looks like a pattern of dapple.
    pub no_pattern: bool,
}

/// A picture file that was decoded.
#[derive(Debug)]
pub struct OpenedPicture {
    /// Its px.
    pub raster: Raster,
    /// The gradient that it was painted with, if it states it.
    gradient: Option<Gradient>,
    /// The pattern that it holds, if it is one.
    pattern: Option<Tones>,
    /// Whether dapple wrote it, by the document in it.
    is_ours: bool,
    /// Notes on the conversion.
    notes: Vec<String>,
}

/// A picture in which marks and ground have been separated.
#[derive(Clone, Debug)]
pub struct SegmentedPicture {
    /// Width and height of what was read, px.
    pub size: [usize; 2],
    /// px an inch, if the file states it.
    pub dpi: Option<f64>,
    /// Notes on how it was read.
    pub notes: Vec<String>,
    segmentation: Segmentation,
}

/// A picture that was read.
#[derive(Clone, Debug)]
pub struct ReadPicture {
    /// Width and height of what was read, px.
    pub size: [usize; 2],
    /// px an inch, if the file states it.
    pub dpi: Option<f64>,
    /// The content of the picture.
    pub reading: Reading,
    /// Notes on how it was read: a range that was stretched, a picture that is taken for a pattern.
    pub notes: Vec<String>,
}

/// Measurements of a picture.
#[derive(Clone, Debug)]
pub struct MeasuredPicture {
    /// Its marks.
    pub picture: Picture,
    /// Notes on how it was read, see [`ReadPicture::notes`].
    pub notes: Vec<String>,
}

/// Most bytes per px in memory while a picture is decoded and rotated. Measured for a JPEG of 24 Mpx: 6.
const BYTES_PER_PX: f64 = 16.0;

/// The decoder's message on one line: some end with a line break or quote control characters of the file.
fn one_line(error: &photo::PictureError) -> String {
    let shown = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    error.to_string().trim_end().chars().map(shown).collect()
}

/// Measures the marks in the part of a picture that `framing` names. Messages call it `path`. At most `free` bytes of memory may be
/// used, here and in all later steps.
///
/// # Errors
/// It cannot be read as a picture, or has neither spots nor stripes.
pub fn measure_stream(
    stream: impl BufRead + Seek,
    path: &Path,
    framing: &Framing,
    free: Option<f64>,
) -> Result<MeasuredPicture, MeasureError> {
    let ReadPicture { reading, notes, .. } = read_stream(stream, path, framing, free)?.texture(path)?;
    let Reading { picture, segmentation, .. } = reading;
    Ok(MeasuredPicture { picture: picture.with_raggedness(&segmentation.field, segmentation.level), notes })
}

/// Measures the patches in a picture, with outlines of any shape, in the part that `framing` names.
///
/// # Errors
/// It cannot be read as a picture, has too little contrast, or no patch is whole.
pub fn measure_patches(
    stream: impl BufRead + Seek,
    path: &Path,
    framing: &Framing,
    free: Option<f64>,
) -> Result<MeasuredPicture, MeasureError> {
    let segmented = open_stream(stream, path, free)?.segmented(path, framing, &|_| true)?;
    let Some(SegmentedPicture { mut segmentation, notes, .. }) = segmented else {
        return Err(neither(path, Neither::Noise));
    };
    if !segmentation.is_pattern && segmentation.contrast < photo::CONTRAST {
        return Err(neither(path, Neither::Contrast { contrast: segmentation.contrast }));
    }
    let level = segmentation.level;
    if let Some(least) = framing.limits.smallest {
        photo::remove_below(&mut segmentation.field, level, least);
    }
    let found = patches(&segmentation.field, level);
    let picture = found.ok_or_else(|| neither(path, Neither::TooFewSpots { marks: 0 }))?;
    Ok(MeasuredPicture { picture, notes })
}

impl ReadPicture {
    /// This picture if it is a texture.
    ///
    /// # Errors
    /// [`MeasureError::Neither`]; `path` is the picture's name in messages.
    pub fn texture(self, path: &Path) -> Result<Self, MeasureError> {
        self.reading
            .neither
            .map_or(Ok(self), |reason| Err(MeasureError::Neither { path: path.to_owned(), reason }))
    }
}

/// Reads what a picture shows, even if it is no texture.
///
/// # Errors
/// It cannot be read as a picture, or has no marks at all.
pub fn read_stream(
    stream: impl BufRead + Seek,
    path: &Path,
    framing: &Framing,
    free: Option<f64>,
) -> Result<ReadPicture, MeasureError> {
    open_stream(stream, path, free)?.read(path, framing)
}

/// Decodes a picture.
///
/// # Errors
/// It cannot be read as a picture, or is too large.
pub fn open_stream(
    mut stream: impl BufRead + Seek,
    path: &Path,
    free: Option<f64>,
) -> Result<OpenedPicture, MeasureError> {
    let unreadable = |source| MeasureError::Unreadable { path: path.to_owned(), source };
    // The head of a damaged file can give any size: check it before allocating.
    let size = photo::size(&mut stream).map_err(unreadable)?;
    if let Err(error) = memory::check_picture(size, BYTES_PER_PX, free) {
        let memory::TooLargePicture { size, needed, free } = error;
        return Err(MeasureError::TooLarge { path: path.to_owned(), size, needed, free });
    }
    let document = document_in(&mut stream);
    let gradient = document.as_ref().and_then(painted_with);
    let mut decoded = photo::decode(&mut stream).map_err(unreadable)?;
    let pattern = pattern_of_gray(&decoded.image, document.is_some());
    let notes = std::mem::take(&mut decoded.notes);
    let ground = gradient.as_ref().map(|gradient| gradient.colour(0.0));
    let raster = Raster::opaque(decoded, ground);
    Ok(OpenedPicture { raster, gradient, pattern, is_ours: document.is_some(), notes })
}

impl OpenedPicture {
    /// Reads what the part that `framing` names shows, even if it is no texture.
    ///
    /// # Errors
    /// The part is not in the picture, or has no marks at all.
    pub fn read(&self, path: &Path, framing: &Framing) -> Result<ReadPicture, MeasureError> {
        // This call is never cancelled.
        let segmented = self.segmented(path, framing, &|_| true)?;
        let Some(segmented) = segmented else { return Err(neither(path, Neither::Noise)) };
        segmented.read(path, &framing.limits)
    }

    /// Separates marks and ground in the part that is read. Between its steps it calls `goes_on` with the share that is done; the
    /// result is `None` if that returns false. [`Framing::limits`] are not used.
    ///
    /// # Errors
    /// The part is not in the picture.
    pub fn segmented(
        &self,
        path: &Path,
        framing: &Framing,
        goes_on: &(dyn Fn(f64) -> bool + Sync),
    ) -> Result<Option<SegmentedPicture>, MeasureError> {
        let raster = self.framed(path, framing)?;
        let whole = framing.crop.is_none() && framing.corners.is_none();
        let mut notes = self.notes.clone();
        let pattern = self.pattern.clone().filter(|_| whole && !framing.no_pattern);
        if pattern.is_some() && !self.is_ours {
            notes.push(AS_PATTERN.to_owned());
        }
        let pattern = pattern.or_else(|| {
            let gradient = self.gradient.as_ref().filter(|_| whole)?;
            pattern_of_colours(&raster, gradient)
        });
        let segmentation = match pattern {
            Some(Tones { field, level }) => {
                let Tones { field, level } = with_smaller_marks(field, level, framing.invert);
                Some(photo::known(field, level, Some(&raster)))
            }
            None => photo::segment(&raster, framing.invert, goes_on),
        };
        let (size, dpi) = (raster.size, raster.dpi);
        Ok(segmentation.map(|segmentation| SegmentedPicture { size, dpi, notes, segmentation }))
    }

    /// The part that is read, as a rectangle.
    ///
    /// # Errors
    /// It is not in the picture.
    pub fn framed(&self, path: &Path, framing: &Framing) -> Result<Cow<'_, Raster>, MeasureError> {
        let mut raster = Cow::Borrowed(&self.raster);
        if let Some(corners) = framing.corners {
            let size = raster.size;
            let inside =
                |corner: &[f64; 2]| (0..2).all(|axis| (0.0..=size[axis] as f64).contains(&corner[axis]));
            if !corners.are_convex() || !corners.0.iter().all(inside) {
                return Err(MeasureError::Corners { path: path.to_owned(), size });
            }
            raster = Cow::Owned(corners.flattened(&raster));
        }
        let Some(crop) = framing.crop else { return Ok(raster) };
        let size = raster.size;
        let cropped = raster.cropped(crop).map(Cow::Owned);
        cropped.ok_or_else(|| MeasureError::Crop { path: path.to_owned(), crop, size })
    }
}

impl SegmentedPicture {
    /// Reads what it shows, even if it is no texture; `path` is its name in messages.
    ///
    /// # Errors
    /// It has no marks at all.
    pub fn read(self, path: &Path, limits: &Limits) -> Result<ReadPicture, MeasureError> {
        let reading = photo::read_segmented(self.segmentation, limits);
        let reading = reading.map_err(|reason| neither(path, reason))?;
        let mut notes = self.notes;
        notes.extend(reading.rosettes.as_ref().map(|rosettes| in_words(&rosettes.like)));
        Ok(ReadPicture { size: self.size, dpi: self.dpi, reading, notes })
    }
}

/// What the rosettes of a picture are like.
fn in_words(like: &Rosettes) -> String {
    let [least, most] = like.parts;
    let parts = if least == most { least.to_string() } else { format!("{least} to {most}") };
    let width = like.width.unwrap_or_default();
    let solid = 100.0 * like.solid;
    format!("the spots are rosettes of {parts} blotches about {width:.1} px deep; {solid:.0} % are solid")
}

fn neither(path: &Path, reason: Neither) -> MeasureError {
    match reason {
        Neither::Contrast { contrast } => MeasureError::Blank { path: path.to_owned(), contrast },
        reason => MeasureError::Neither { path: path.to_owned(), reason },
    }
}

/// A picture as numbers 0..1, and the threshold at the marks' edges.
#[derive(Clone, Debug)]
struct Tones {
    field: Field,
    level: f32,
}

fn on_px([width, height]: [usize; 2], values: Vec<f32>) -> Field {
    Field { width, height, cell: [1.0, 1.0], edges: Edges::Closed, values }
}

/// The note on a pattern whose file does not state that dapple wrote it.
const AS_PATTERN: &str = "gray of 16 bits from black to white was read as a pattern of dapple, with edges at half of white; with --no-pattern as any other picture";
/// Ground and the middle of marks of a pattern.
const BLACK: f32 = 0.1;
const WHITE: f32 = 0.9;

/// The pattern in a 16-bit gray picture, as `grow --pattern` writes it, with edges at 0.5. `None` for other pictures, and for
/// pictures that are not known to be dapple's and do not reach from black to white.
fn pattern_of_gray(image: &DynamicImage, is_ours: bool) -> Option<Tones> {
    let DynamicImage::ImageLuma16(pattern) = image else { return None };
    let size = [pattern.width() as usize, pattern.height() as usize];
    let field = on_px(size, pattern.as_raw().iter().map(|value| f32::from(*value) / 65535.0).collect());
    let [low, high] = span(&field)?;
    if !is_ours && (low > BLACK || high < WHITE) {
        return None;
    }
    let level = if low < EDGE && high > EDGE { EDGE } else { otsu_threshold(&field.values) };
    Some(Tones { field, level })
}

/// The pattern values for the colours of a picture that was painted with `gradient`.
fn pattern_of_colours(raster: &Raster, gradient: &Gradient) -> Option<Tones> {
    let field = on_px(raster.size, gradient.pattern_of(&raster.rgb)?);
    let [low, high] = span(&field)?;
    (low < EDGE && high > EDGE).then_some(Tones { field, level: EDGE })
}

/// A smaller range of values than this is not a pattern.
const MIN_SPAN: f32 = 0.05;

/// The lowest and the highest value; `None` if they hardly differ.
fn span(field: &Field) -> Option<[f32; 2]> {
    let low = field.values.iter().copied().fold(1.0, f32::min);
    let high = field.values.iter().copied().fold(0.0, f32::max);
    (high - low >= MIN_SPAN).then_some([low, high])
}

/// Inverts the values if otherwise the marks would cover more than the ground; with `invert`, if they would cover less.
fn with_smaller_marks(mut field: Field, level: f32, invert: bool) -> Tones {
    let above = field.values.iter().filter(|value| **value > level).count();
    let light = 2 * above <= field.values.len();
    if light != invert {
        return Tones { field, level };
    }
    field.values.iter_mut().for_each(|value| *value = 1.0 - *value);
    Tones { field, level: 1.0 - level }
}

/// The document in a PNG; `None` if it cannot be read: the picture is measured without it.
fn document_in(stream: &mut (impl BufRead + Seek)) -> Option<Document> {
    stream.rewind().ok()?;
    let (document, _) = embedded::in_stream(stream, "").ok()??;
    Some(document)
}

/// The colours of a document, if it has one layer.
fn painted_with(document: &Document) -> Option<Gradient> {
    let [layer] = &document.layers[..] else { return None };
    Some(layer.colours.clone().unwrap_or_else(|| Colours::default_for_layer(0)).gradient())
}

#[cfg(test)]
mod tests;
