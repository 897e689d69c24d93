//! Makes a document from a photograph, with its marks, regions and colours.

use std::io::{BufRead, Seek};
use std::path::{Path, PathBuf};

use crate::attributes::{Attributes, Spots, Spread};
use crate::document::{
    AreaKind, Colours, Document, DocumentError, Finishing, FlowChoice, Layer, LayerMap, LayerOptions, MapKey,
    MapSource, RaggedChoice, Rosettes, SpreadChoice, SystemChoice, ToneImage, limits,
};
use crate::finish;
use crate::marks::{Line, Mark};
use crate::measure::Picture;
use crate::photo::{
    DENSE, FoundLayer, GroundColours, Hair, Limits, Neither, Reading, Tone, Wanted, ground_colours, hair,
    sketch,
};
use crate::synth::import::measured_picture::{
    Framing, MeasureError, OpenedPicture, ReadPicture, open_stream,
};
use crate::synth::import::svg::stroke;
use crate::synth::marks::plan::raggedness::sigma_of;

/// The reason why a photograph did not become a document.
#[derive(Debug, thiserror::Error)]
pub enum PhotoImportError {
    /// The picture cannot be read, or shows neither spots nor stripes.
    #[error(transparent)]
    Picture(#[from] MeasureError),
    /// The picture shows marks that do not form a texture; they can be taken nevertheless.
    #[error("{0}; or take what was found with --take-it")]
    Neither(MeasureError),
    /// The photograph has more px than a document.
    #[error("{path}: has {}×{} px; allowed: sides of at most {most} px; take a part of it with --crop", size[0], size[1], most = limits::MAX_SIDE)]
    Size {
        /// The file.
        path: PathBuf,
        /// Width and height, px.
        size: [usize; 2],
    },
    /// No mark is whole and of a size that a document may hold.
    #[error("{path}: no mark is whole; allowed: a larger part of the pattern")]
    NoMarks {
        /// The file.
        path: PathBuf,
    },
    /// The document that was made is not valid.
    #[error(transparent)]
    Document(#[from] DocumentError),
}

/// Options for a photograph.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PhotoOptions {
    /// The part of it that is read, and which colours are the marks.
    pub framing: Framing,
    /// Regions and layers.
    pub wanted: Wanted,
    /// Whether the marks are taken even if they do not form a texture.
    pub take_it: bool,
    /// The finish of the document; that of fur has the direction of the hair in the photograph, if it has one.
    pub finish: Option<finish::Kind>,
}

/// A document made of a photograph.
#[derive(Clone, Debug)]
pub struct ImportedPhoto {
    /// The document.
    pub document: Document,
    /// `spots` or `stripes`.
    pub kind: &'static str,
    /// Number of marks that were found, by layer; the document has fewer, which represent them.
    pub found: Vec<usize>,
    /// The area between the sizes of spots of two layers, px².
    pub between: Option<f64>,
    /// The reason why it is not a texture, if its marks were taken nevertheless.
    pub neither: Option<Neither>,
    /// Notes on how it was read.
    pub notes: Vec<String>,
    /// A summary, such as `spots: 114 found, 21 drawn in 1 layer and 3 × 1 regions on 768 × 288 px`.
    pub summary: String,
}

/// Makes a document of the photograph in a stream, named like the file `path`. At most `free` bytes of memory may be used.
///
/// # Errors
/// [`PhotoImportError`].
pub fn import_photo(
    stream: impl BufRead + Seek,
    path: &Path,
    options: &PhotoOptions,
    free: Option<f64>,
) -> Result<ImportedPhoto, PhotoImportError> {
    let limits = Limits { among_specks: options.take_it, ..options.framing.limits };
    let framing = Framing { limits, ..options.framing };
    let opened = open_stream(stream, path, free)?;
    let read = opened.read(path, &framing)?;
    let read = if options.take_it { read } else { read.texture(path).map_err(PhotoImportError::Neither)? };
    import_read(&read, &opened, path, options)
}

/// Makes a document from the marks that were read in the photograph `path`, even if they do not form a texture.
///
/// # Errors
/// [`PhotoImportError`].
pub fn import_read(
    read: &ReadPicture,
    opened: &OpenedPicture,
    path: &Path,
    options: &PhotoOptions,
) -> Result<ImportedPhoto, PhotoImportError> {
    let neither = read.reading.neither;
    let (mut document, found, between) = document(read, &options.wanted, path)?;
    let mut notes = read.notes.clone();
    if let Some(kind) = options.finish {
        let flow = if kind == finish::Kind::Fur {
            let raster = opened.framed(path, &options.framing)?;
            flow(hair(&raster, &read.reading, FlowChoice::HEAD_TO_TAIL), document.size, &mut notes)
        } else {
            FlowChoice::Usual
        };
        document.finish = Some(Finishing { flow, ..finish::Finish::new(kind).into() });
    }
    let kind = match read.reading.picture {
        Picture::Spots { .. } => "spots",
        Picture::Stripes { .. } => "stripes",
    };
    let summary = summary(&document, kind, &found, neither);
    Ok(ImportedPhoto { document, kind, found, between, neither, notes, summary })
}

/// The direction of hair in a document of this size; `notes` get what was found.
fn flow(hair: Option<Hair>, size: [u32; 2], notes: &mut Vec<String>) -> FlowChoice {
    match hair {
        None => {
            notes.push("no direction of hair was found in the fine detail".to_owned());
            FlowChoice::Usual
        }
        Some(Hair::Angle(angle)) => {
            notes.push(format!("hair lies at {angle:.0}°, or the other way round"));
            FlowChoice::Angle((10.0 * angle).round() / 10.0)
        }
        Some(Hair::Lines(lines)) => {
            notes.push(format!("hair lies along {} lines, or the other way round", lines.len()));
            let line = |[from, to]: [[f64; 2]; 2]| stroke(&Mark::Line(Line { from, to, width: 0.0 }), size);
            FlowChoice::Strokes(lines.into_iter().filter_map(line).collect())
        }
    }
}

fn document(
    read: &ReadPicture,
    wanted: &Wanted,
    path: &Path,
) -> Result<(Document, Vec<usize>, Option<f64>), PhotoImportError> {
    if read.size.iter().any(|side| *side > limits::MAX_SIDE as usize) {
        return Err(PhotoImportError::Size { path: path.to_owned(), size: read.size });
    }
    let size = read.size.map(|side| side as u32);
    let sketch = sketch(&read.reading, read.size, wanted);
    let made = sketch.layers.iter().map(|found| (layer(found, size), found.found));
    let (layers, found): (Vec<Layer>, Vec<usize>) =
        made.filter(|(layer, _)| !layer.strokes.is_empty()).unzip();
    if layers.is_empty() {
        return Err(PhotoImportError::NoMarks { path: path.to_owned() });
    }
    let name = path.file_stem().map(|stem| stem.to_string_lossy().chars().take(limits::MAX_NAME).collect());
    let regions = sketch.regions.map(|regions| regions.map(|count| count as u32));
    let mut document =
        Document { name: name.unwrap_or_default(), size, regions, layers, ..Document::default() };
    document.dpi = read.dpi.unwrap_or(document.dpi);
    name_dense(&mut document, &read.reading);
    if let (Some(found), Some(layer)) = (ground_colours(&read.reading), document.layers.last_mut()) {
        vary_ground(layer, &found);
    }
    document.check(&path.display().to_string())?;
    Ok((document, found, sketch.between))
}

/// Sets the system of layers of rosettes, and of those whose spots are too dense for reaction and diffusion, if the few drawn spots do
/// not show the density.
fn name_dense(document: &mut Document, reading: &Reading) {
    let Picture::Spots { .. } = reading.picture else { return };
    let is_dense = reading.ink() > DENSE && document.areas(0).is_none();
    if document.layers.len() == 1 && (is_dense || reading.rosettes.is_some()) {
        document.layers[0].system = SystemChoice::Of(AreaKind::Patches.description());
    }
}

/// Gives the ground of `layer`, which paints it, the two colours that were found, and their places.
fn vary_ground(layer: &mut Layer, found: &GroundColours) {
    let px = found.places.iter().map(|place| (255.0 * place.clamp(0.0, 1.0)).round() as u8);
    let (Some(image), Some(colours)) = (ToneImage::new(found.size, px.collect()), &mut layer.colours) else {
        return;
    };
    let [first, second] = found.ends;
    for stop in colours.stops.iter_mut().filter(|stop| stop.at < 0.5) {
        stop.colour = first;
    }
    colours.ground = second;
    let source = MapSource::Image { image, factor: false };
    layer.maps.set(MapKey::Ground, Some(LayerMap { source, range: [0.0, 1.0] }));
}

fn layer(found: &FoundLayer, size: [u32; 2]) -> Layer {
    let strokes = found.marks.iter().filter_map(|mark| stroke(mark, size)).collect();
    let colours = (!found.tones.is_empty())
        .then(|| Colours::new(found.tones.iter().map(|Tone { at, colour }| (*at, *colour))));
    let options = LayerOptions {
        ragged: ragged(found),
        spread: found.spread.map_or(SpreadChoice::Drawn, |spread| SpreadChoice::Given(limited(&spread))),
        rosette: found
            .rosettes
            .map(|rosettes| Rosettes { width: rosettes.width.map(|px| hundredths(px.max(2.0))), ..rosettes }),
        ..LayerOptions::default()
    };
    Layer { name: found.name.to_owned(), strokes, colours, options, ..Layer::default() }
}

/// A spread within the allowed range.
fn limited(spread: &Spread) -> Spread {
    Spread {
        area: hundredths(spread.area.min(limits::SPREAD_AREA.high)),
        angle: hundredths(spread.angle.min(limits::SPREAD_ANGLE.high)),
        aspect: hundredths(spread.aspect.min(limits::SPREAD_ASPECT.high)),
        spacing: hundredths(spread.spacing.min(limits::SPREAD_SPACING.high)),
    }
}

fn hundredths(value: f64) -> f64 {
    (100.0 * value).round() / 100.0
}

/// The raggedness that marks are to have: that of the marks that were found, limited to the allowed range.
fn ragged(found: &FoundLayer) -> RaggedChoice {
    let ellipses = found.marks.iter().filter_map(|mark| match mark {
        Mark::Ellipse(ellipse) => Some(*ellipse),
        _ => None,
    });
    let mean = Spots::measure(&ellipses.collect::<Vec<_>>());
    let (Some(mean), Some(raggedness)) = (mean, found.raggedness) else { return RaggedChoice::Drawn };
    let sigma = sigma_of(&Attributes::Spots(mean), raggedness).min(limits::RAGGED.high);
    RaggedChoice::Given(hundredths(sigma))
}

/// The marks that were found, in words.
fn summary(document: &Document, kind: &str, found: &[usize], neither: Option<Neither>) -> String {
    let drawn: usize = document.layers.iter().map(|layer| layer.strokes.len()).sum();
    let layers = if document.layers.len() == 1 { "layer" } else { "layers" };
    let regions = match document.regions {
        Some([columns, rows]) => format!("{columns} × {rows} regions"),
        None => "free marks".to_owned(),
    };
    let [width, height] = document.size;
    let neither = neither.map_or_else(String::new, |why| format!("; taken although {why}"));
    format!(
        "{kind}: {} found, {drawn} drawn in {} {layers}, {regions}, on {width} × {height} px{neither}",
        found.iter().sum::<usize>(),
        document.layers.len(),
    )
}
