//! What shall be exported, and how; what of it is remembered.

use std::path::PathBuf;

use crate::app::units::Units;
use crate::document::Document;
use crate::export::Format;
use crate::export::motion::Kind;
use crate::export::outline::svg::Unit;
use crate::export::outline::{Ends, Hatch, Smallest, Style};
use crate::export::picture::QUALITY;
use crate::synth::render::clip::{Clip, FASTEST_GIF, RATES};

/// What is written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum What {
    /// A picture.
    #[default]
    Picture,
    /// A set of maps in a folder.
    Material,
    /// The outlines of the marks.
    Outlines,
    /// A clip.
    Film,
}

/// What a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Shows {
    /// The colours.
    #[default]
    Texture,
    /// 0 = ground, ½ = a mark's edge.
    Pattern,
    /// Which layer's mark covers a px.
    Labels,
    /// All chemicals.
    Concentrations,
}

/// How large the export shall be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// More texture with features of the same size, px; `None` = the canvas.
    pub canvas: Option<[u32; 2]>,
    /// The same texture with so many times the px along each side.
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
    pub fn of(&self, document: &Document) -> [u64; 2] {
        self.canvas.unwrap_or(document.size).map(|side| u64::from(side) * u64::from(self.scale))
    }

    /// The canvas that is grown, where it is not the document's.
    #[must_use]
    pub fn other(&self, document: &Document) -> Option<[u32; 2]> {
        self.canvas.filter(|canvas| *canvas != document.size)
    }
}

/// How a picture is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picture {
    /// What it shows.
    pub shows: Shows,
    /// Its format.
    pub format: Format,
    /// 16 bit a colour?
    pub deep: bool,
    /// Can one see through the ground?
    pub transparent: bool,
    /// Quality of a JPEG, 1 to 100.
    pub quality: u8,
    /// Does a PNG hold the document?
    pub document: bool,
}

/// How a material is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// How far marks stand above the ground, px, by layer; the last for all further ones.
    pub relief: Vec<f64>,
    /// Roughness of the ground, then of the marks by layer.
    pub roughness: Vec<f64>,
    /// 16 bit a colour?
    pub deep: bool,
    /// Can one see through the ground?
    pub transparent: bool,
}

/// How outlines are written. Lengths are in `units`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outlines {
    /// DXF instead of SVG?
    pub dxf: bool,
    /// The pattern value that they follow.
    pub level: f64,
    /// In what.
    pub units: Units,
    /// Areas?
    pub fill: bool,
    /// Strokes?
    pub stroke: bool,
    /// Parallel strokes?
    pub hatch: bool,
    /// Their distance.
    pub spacing: f64,
    /// Their direction, degrees.
    pub angle: f64,
    /// Width of strokes.
    pub pen: f64,
    /// The narrowest island or hole.
    pub width: f64,
    /// The smallest.
    pub area: f64,
    /// Are strokes cut at the canvas' edge?
    pub cut: bool,
    /// Is a short way looked for?
    pub ordered: bool,
}

/// How a film is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    /// Its kind.
    pub kind: Kind,
    /// Does the document become another, instead of growing?
    pub change: bool,
    /// The other document.
    pub to: Option<PathBuf>,
    /// How long, how large, how fast.
    pub clip: Clip,
}

/// All choices.
#[derive(Clone, Debug, PartialEq)]
pub struct Choices {
    /// What is written.
    pub what: What,
    /// How large; films have sides of their own.
    pub size: Size,
    /// The layer that pattern or outlines are of alone.
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
            what: What::Picture,
            size: Size::default(),
            layer: None,
            picture: Picture {
                shows: Shows::Texture,
                format: Format::Png,
                deep: false,
                transparent: false,
                quality: QUALITY,
                document: true,
            },
            material: Material {
                relief: vec![6.0],
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

    /// The ending of its file; `None` = a folder.
    #[must_use]
    pub fn ending(&self) -> Option<&'static str> {
        match self.what {
            What::Picture => {
                let fits = Format::ENDINGS.iter().find(|(_, format)| *format == self.picture.format);
                Some(fits.map_or("png", |(ending, _)| *ending))
            }
            What::Material => None,
            What::Outlines => Some(if self.outlines.dxf { "dxf" } else { "svg" }),
            What::Film => match self.film.kind {
                Kind::Gif => Some("gif"),
                Kind::Apng => Some("apng"),
                Kind::Folder => None,
            },
        }
    }

    /// Takes only what goes together.
    pub fn settle(&mut self) {
        let picture = &mut self.picture;
        if !picture.format.holds(picture.content()) {
            picture.format = if picture.shows == Shows::Concentrations { Format::Exr } else { Format::Png };
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

/// px of relief at most.
pub const RELIEF: f64 = 1e4;

/// The formats of pictures, in the order of the dialog.
pub const FORMATS: [Format; 5] = [Format::Png, Format::Tiff, Format::Exr, Format::Jpeg, Format::Webp];
/// The kinds of films.
pub const KINDS: [Kind; 3] = [Kind::Gif, Kind::Apng, Kind::Folder];

impl Picture {
    /// What its format must be fit for.
    #[must_use]
    pub fn content(&self) -> crate::export::Content {
        use crate::export::Content;
        match self.shows {
            Shows::Texture => Content::Colours,
            Shows::Pattern => Content::Numbers,
            Shows::Labels => Content::Labels,
            Shows::Concentrations => Content::Channels,
        }
    }
}

impl Outlines {
    /// In what the file's lengths are, with `dpi` px an inch.
    #[must_use]
    pub fn unit(&self, dpi: f64) -> Unit {
        match self.units {
            Units::Px => Unit::Px,
            Units::Mm => Unit::Mm { dpi },
        }
    }

    /// How they are drawn, lengths in px.
    #[must_use]
    pub fn style(&self, dpi: f64) -> Style {
        let px = 1.0 / self.unit(dpi).per_px();
        let spacing = (self.spacing * px).max(Hatch::FINEST);
        Style {
            fill: self.fill,
            stroke: self.stroke,
            hatch: self.hatch.then_some(Hatch { spacing, angle: self.angle }),
            ends: if self.cut { Ends::Cut } else { Ends::Closed },
            ordered: self.ordered,
        }
    }

    /// What is left out, px.
    #[must_use]
    pub fn smallest(&self, dpi: f64) -> Smallest {
        let px = 1.0 / self.unit(dpi).per_px();
        Smallest { width: self.width * px, area: self.area * px * px }
    }
}
