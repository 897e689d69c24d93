//! The short way from a document to a file: [`Document::grow`] and [`Grown::save`].

use std::path::Path;

use crate::document::embedded::{MAX_SCALE, embedded};
use crate::document::{Document, Extent};
use crate::export::outline::svg::{self, Sheet, Unit};
use crate::export::outline::{self, Smallest, dxf};
use crate::export::{self, ExportError, Stopped, has_ending};
use crate::grid::Field;
use crate::synth::error::GrowError;
use crate::synth::growth::{Grown, Growth};
use crate::synth::layer::GrownLayer;
use crate::synth::layer_report::report;
use crate::synth::options::Options;
use crate::synth::render::outlining::{Outlining, outlines};
use crate::synth::render::painting::{Channel, Painting, Style};
use crate::synth::report::Report;
use crate::synth::watch::Watch;

impl Document {
    /// Grows the document from the built-in training sets.
    ///
    /// ```no_run
    /// use dapple::Document;
    ///
    /// Document::read("zebra.dapple")?.grow()?.save("zebra.png")?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// The document is not valid (see [`Document::check`]), cannot be grown, or does not fit into memory.
    pub fn grow(&self) -> Result<Grown, GrowError> {
        self.grow_with(&Options::default())
    }

    /// Grows the document with other options: another size of the canvas, progress, cancelling.
    ///
    /// ```
    /// use dapple::document::{Document, Layer, Stroke};
    /// use dapple::{Options, Watch};
    ///
    /// let spot = Stroke::ellipse([32.0, 32.0], [9.0, 6.0], 30.0);
    /// let document = Document::new([64, 64]).with_layer(Layer::new([spot]));
    /// let watch = Watch { progress: &|stage, share| println!("{stage:?} {share:.2}"), ..Watch::NONE };
    /// let grown = document.grow_with(&Options { size: Some([96, 64]), watch, ..Options::default() })?;
    /// assert_eq!(grown.size, [96, 64]);
    /// # Ok::<(), dapple::GrowError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Document::grow`]; and where the growth was cancelled.
    pub fn grow_with(&self, options: &Options) -> Result<Grown, GrowError> {
        self.check(options.source)?;
        Growth::begin(self, options, None).run()
    }
}

impl Grown {
    /// Writes the texture to a file, or leaves what was there: never half of it.
    ///
    /// The ending of `path` says what is written: a picture (`.png`, `.tif`, `.exr`, `.jpg`, `.webp`) of the canvas' size,
    /// or outlines of the marks (`.svg`, `.dxf`) in mm by the document's dpi. A PNG holds the document, so that dapple
    /// reads it back.
    ///
    /// # Errors
    /// Another ending, a canvas that the format cannot hold, or a file that cannot be written.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), ExportError> {
        self.save_scaled(path, 1)
    }

    /// As [`Grown::save`], with `scale` times the px along each side: the same texture, finer. A scale outside of 1 to 64
    /// is taken as the nearest of these.
    ///
    /// # Errors
    /// As [`Grown::save`].
    pub fn save_scaled(&self, path: impl AsRef<Path>, scale: u32) -> Result<(), ExportError> {
        let (path, scale) = (path.as_ref(), scale.clamp(1, MAX_SCALE));
        if outline::FORMATS.iter().any(|ending| has_ending(path, ending)) {
            return self.save_outlines(path, scale);
        }
        let painting = self.painting(scale);
        let style = self.style(scale);
        painting.prepare(path, Channel::Texture, &style, &Watch::NONE)?.keep()
    }

    /// The texture ready to be painted, with `scale` times the px along each side.
    #[must_use]
    pub fn painting(&self, scale: u32) -> Painting<'_> {
        Painting::new(&self.document, self, scale as usize)
    }

    /// The colours of the canvas: red, green, blue a px, row by row from the top; what is transparent is over white.
    #[must_use]
    pub fn rgb(&self) -> Vec<u8> {
        self.painting(1).rgb()
    }

    /// The pattern of layer `index` (0 = the lowest) at the canvas' size: 0 = ground, 0.5 = a mark's edge, 1 = its centre.
    #[must_use]
    pub fn pattern(&self, index: usize) -> Option<Field> {
        let [width, height] = self.size.map(|side| side as usize);
        self.layers.get(index).map(|layer| GrownLayer::pattern(layer).field(width, height))
    }

    /// What was asked, looked up and found, by layer and region. `seconds` is 0: time is not measured here.
    #[must_use]
    pub fn report(&self) -> Report {
        report(&self.document, &self.document.name, self, 0.0)
    }

    /// How the picture is written that is `scale` times as large as the canvas.
    fn style(&self, scale: u32) -> Style {
        let mut document = self.document.clone();
        document.growth.refine = self.settings.refine.unwrap_or(document.growth.refine);
        let extent = Extent { size: self.settings.size, scale };
        let dpi = document.dpi * f64::from(scale);
        Style { dpi, texts: embedded(&document, extent), ..Style::default() }
    }

    fn save_outlines(&self, path: &Path, scale: u32) -> Result<(), ExportError> {
        let size = self.size.map(|side| side as usize * scale as usize);
        let unit = Unit::Mm { dpi: self.document.dpi * f64::from(scale) };
        let smallest = Smallest { width: 0.0, area: 0.0 };
        let wanted = Outlining { size, level: 0.5, only: None, smallest, style: outline::Style::default() };
        let cancelled = |_: Stopped| ExportError::Cancelled { path: path.to_owned() };
        let (groups, _) = outlines(&self.document, self, &wanted, &Watch::NONE).map_err(cancelled)?;
        let size = size.map(|side| side as f64);
        let sheet = Sheet {
            title: self.document.name.clone(),
            size,
            unit,
            stroke_width: unit.stroke(),
            ground: None,
        };
        export::save(path, |out| {
            if has_ending(path, "dxf") {
                dxf::write(out, size, unit, &groups)?;
            } else {
                svg::write(out, &sheet, &groups)?;
            }
            Ok(())
        })
    }
}
