//! The choices of an export.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::document::Document;
use crate::editor::units::Units;
use crate::export::Format;
use crate::export::maps::Surface;
use crate::export::motion::Kind;
use crate::export::outline::svg::Unit;
use crate::export::outline::{Ends, Hatch, Smallest, Style};
use crate::export::picture::QUALITY;
use crate::synth::render::clip::{Clip, FASTEST_GIF, RATES};
use crate::synth::render::painting::usual_relief;

/// The kind of an export.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ExportKind {
    /// A picture.
    #[default]
    Picture,
    /// A set of maps in a folder.
    Material,
    /// The outlines of the marks.
    Outlines,
    /// A film.
    Film,
}

/// The content of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PictureContent {
    /// The colours.
    #[default]
    Texture,
    /// The pattern: 0 = ground, ½ = a mark's edge.
    Pattern,
    /// The label of each px: the layer whose mark covers it.
    Labels,
    /// The concentrations of all chemicals.
    Concentrations,
}

/// The size of an export.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// The canvas to grow, px, with marks of unchanged size; `None` = the canvas of the document.
    pub canvas: Option<[u32; 2]>,
    /// Px of the picture per px of the canvas, along each side.
    pub scale: u32,
}

impl Default for Size {
    fn default() -> Self {
        Self { canvas: None, scale: 1 }
    }
}

impl Size {
    /// Width and height of the picture of `document`, px.
    #[must_use]
    pub fn in_px(&self, document: &Document) -> [u64; 2] {
        self.canvas.unwrap_or(document.size).map(|side| u64::from(side) * u64::from(self.scale))
    }

    /// The canvas that is grown, where it is not the document's.
    #[must_use]
    pub fn other(&self, document: &Document) -> Option<[u32; 2]> {
        self.canvas.filter(|canvas| *canvas != document.size)
    }
}

/// How a picture is written.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Picture {
    /// What it shows.
    pub shows: PictureContent,
    /// Its format.
    pub format: Format,
    /// Whether colours have 16 bit per channel, instead of 8.
    pub deep: bool,
    /// Whether the ground is transparent.
    pub transparent: bool,
    /// Quality of a JPEG, 1 to 100.
    pub quality: u8,
    /// Whether a PNG holds the document.
    pub document: bool,
}

/// How a material is written.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Material {
    /// Height of the marks above the ground by layer, px; the last value holds for all further layers. It was chosen for a texture
    /// of [`Self::finish`].
    pub relief: Vec<f64>,
    /// The name of the finish that the relief was chosen for; empty for none.
    #[serde(default)]
    pub finish: String,
    /// Roughness of the ground, then of the marks by layer.
    pub roughness: Vec<f64>,
    /// Whether colours have 16 bit per channel, instead of 8.
    pub deep: bool,
    /// Whether the ground is transparent.
    pub transparent: bool,
}

/// How outlines are written. Lengths are in `units`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outlines {
    /// Whether the format is DXF, instead of SVG.
    pub dxf: bool,
    /// The pattern value of the contours.
    pub level: f64,
    /// The unit of lengths.
    pub units: Units,
    /// Whether areas are filled.
    pub fill: bool,
    /// Whether there are strokes along the contours.
    pub stroke: bool,
    /// Whether areas are hatched.
    pub hatch: bool,
    /// Spacing of the hatch.
    pub spacing: f64,
    /// Direction of the hatch, degrees.
    pub angle: f64,
    /// Width of strokes.
    pub pen: f64,
    /// Islands and holes that are narrower are left out.
    pub width: f64,
    /// Islands and holes of a smaller area are left out.
    pub area: f64,
    /// Whether strokes end at the edge of the canvas, instead of running along it.
    pub cut: bool,
    /// Whether paths are ordered to shorten the travel of the pen.
    pub ordered: bool,
    /// Whether an SVG has a rectangle in the colour of the ground beneath them.
    #[serde(default)]
    pub ground: bool,
}

/// How a film is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Its format.
    pub kind: Kind,
    /// Whether the document changes into another one, instead of growing.
    pub change: bool,
    /// The other document.
    pub to: Option<PathBuf>,
    /// Length, size and speed.
    pub clip: Clip,
}

/// All choices.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// The kind of an export.
    pub what: ExportKind,
    /// The size; films have their own.
    pub size: Size,
    /// The only layer of the pattern or the outlines; `None` = all.
    pub layer: Option<usize>,
    /// A picture.
    pub picture: Picture,
    /// A material.
    pub material: Material,
    /// Outlines.
    pub outlines: Outlines,
    /// A film.
    pub film: Film,
}

impl Default for Choices {
    fn default() -> Self {
        Self {
            what: ExportKind::Picture,
            size: Size::default(),
            layer: None,
            picture: Picture {
                shows: PictureContent::Texture,
                format: Format::Png,
                deep: false,
                transparent: false,
                quality: QUALITY,
                document: true,
            },
            material: Material {
                relief: Surface::default().relief,
                finish: String::new(),
                roughness: vec![0.8, 0.5],
                deep: false,
                transparent: false,
            },
            outlines: Outlines {
                dxf: false,
                level: 0.5,
                units: Units::Mm,
                fill: true,
                stroke: false,
                hatch: false,
                spacing: 1.0,
                angle: 45.0,
                pen: 0.3,
                width: 0.0,
                area: 0.0,
                cut: false,
                ordered: true,
                ground: false,
            },
            film: Film { kind: Kind::Gif, change: false, to: None, clip: Clip::default() },
        }
    }
}

impl Choices {
    /// A picture as `dapple grow -o OUT.png` writes it.
    #[must_use]
    pub fn plain(size: Size) -> Self {
        Self { size, ..Self::default() }
    }

    /// The ending of the file's name; `None` where a folder is written.
    #[must_use]
    pub fn ending(&self) -> Option<&'static str> {
        match self.what {
            ExportKind::Picture => {
                let fits = Format::ENDINGS.iter().find(|(_, format)| *format == self.picture.format);
                Some(fits.map_or("png", |(ending, _)| *ending))
            }
            ExportKind::Material => None,
            ExportKind::Outlines => Some(if self.outlines.dxf { "dxf" } else { "svg" }),
            ExportKind::Film => match self.film.kind {
                Kind::Gif => Some("gif"),
                Kind::Apng => Some("apng"),
                Kind::Folder => None,
            },
        }
    }

    /// Changes choices that exclude each other.
    pub fn make_consistent(&mut self) {
        let picture = &mut self.picture;
        if !picture.format.holds(picture.content()) {
            picture.format =
                if picture.shows == PictureContent::Concentrations { Format::Exr } else { Format::Png };
        }
        picture.transparent &= picture.format.has_opacity();
        picture.deep &= picture.format.is_deep();
        let outlines = &mut self.outlines;
        if !(outlines.fill || outlines.stroke || outlines.hatch) {
            outlines.fill = true;
        }
        outlines.cut &= !outlines.fill;
        let fastest = if self.film.kind == Kind::Gif { FASTEST_GIF } else { *RATES.end() };
        self.film.clip.fps = self.film.clip.fps.clamp(1, fastest);
    }
}

impl Material {
    /// The relief of `document`: the chosen one, unless it was chosen for another finish. Then it is the usual one of its finish.
    #[must_use]
    pub fn relief_of(&self, document: &Document) -> Vec<f64> {
        if self.finish == finish_name(document) { self.relief.clone() } else { usual_relief(document) }
    }

    /// Sets the relief of the layer `index` of `document`.
    pub fn set_relief(&mut self, document: &Document, index: usize, relief: f64) {
        let mut values = self.relief_of(document);
        put(&mut values, index, relief);
        (self.relief, self.finish) = (values, finish_name(document).to_owned());
    }

    /// Sets the roughness of the ground (0) or of a layer (its index + 1).
    pub fn set_roughness(&mut self, index: usize, roughness: f64) {
        put(&mut self.roughness, index, roughness);
    }
}

fn finish_name(document: &Document) -> &'static str {
    document.finish.as_ref().map_or("", |finish| finish.finish.kind.name())
}

/// Sets a value; the last one holds for all before it that are missing.
fn put(values: &mut Vec<f64>, index: usize, value: f64) {
    while values.len() <= index {
        values.push(values.last().copied().unwrap_or_default());
    }
    values[index] = value;
}

/// Largest relief, px.
pub const RELIEF: f64 = 1e4;

/// The formats of pictures, in the order of the dialog.
pub const FORMATS: [Format; 5] = [Format::Png, Format::Tiff, Format::Exr, Format::Jpeg, Format::Webp];
/// The kinds of films.
pub const KINDS: [Kind; 3] = [Kind::Gif, Kind::Apng, Kind::Folder];

impl Picture {
    /// What its format must be able to hold.
    #[must_use]
    pub fn content(&self) -> crate::export::Content {
        use crate::export::Content;
        match self.shows {
            PictureContent::Texture => Content::Colours,
            PictureContent::Pattern => Content::Numbers,
            PictureContent::Labels => Content::Labels,
            PictureContent::Concentrations => Content::Channels,
        }
    }
}

impl Outlines {
    /// The unit of the file's lengths, with `dpi` px per inch.
    #[must_use]
    pub fn unit(&self, dpi: f64) -> Unit {
        match self.units {
            Units::Px => Unit::Px,
            Units::Mm => Unit::Mm { dpi },
        }
    }

    /// The style, lengths in px.
    #[must_use]
    pub fn style(&self, dpi: f64) -> Style {
        let px = 1.0 / self.unit(dpi).per_px();
        let spacing = (self.spacing * px).max(Hatch::FINEST);
        Style {
            fill: self.fill,
            stroke: self.stroke,
            hatch: self.hatch.then_some(Hatch { spacing, angle: self.angle }),
            pen: self.pen * px,
            ends: if self.cut { Ends::Cut } else { Ends::Closed },
            ordered: self.ordered,
        }
    }

    /// The limits below which islands and holes are left out, px.
    #[must_use]
    pub fn smallest(&self, dpi: f64) -> Smallest {
        let px = 1.0 / self.unit(dpi).per_px();
        Smallest { width: self.width * px, area: self.area * px * px }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{Finish, FinishKind, Finishing, FlowChoice};

    fn of(kind: FinishKind) -> Document {
        let finish = Finish { size: 10.0, ..Finish::new(kind) };
        let finish = Some(Finishing { finish, flow: FlowChoice::Usual });
        Document { finish, ..Document::default() }
    }

    #[test]
    fn the_relief_follows_the_material_until_it_is_set_for_it() {
        let mut material = Choices::default().material;
        assert_eq!(material.relief_of(&Document::default()), [6.0]);
        assert_eq!(material.relief_of(&of(FinishKind::Fur)), [0.0]);
        assert_eq!(material.relief_of(&of(FinishKind::Leather)), [6.0]);
        material.set_relief(&of(FinishKind::Fur), 1, 2.5);
        assert_eq!(material.relief_of(&of(FinishKind::Fur)), [0.0, 2.5]);
        // What was set for fur holds for fur.
        assert_eq!(material.relief_of(&Document::default()), [6.0]);
        assert_eq!(material.relief_of(&of(FinishKind::Cloth)), [0.0]);
    }
}
