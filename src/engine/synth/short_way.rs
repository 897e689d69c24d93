//! Short calls from a document to a grown texture: [`Document::grow`], [`Grown::rgb`].

use std::io::Write;

use crate::document::embedded::embedded;
use crate::document::{Document, Extent};
use crate::export::Stopped;
use crate::export::outline::svg::{self, Sheet, Unit};
use crate::export::outline::{self, Smallest, dxf};
use crate::grid::Field;
use crate::synth::error::GrowError;
use crate::synth::growth::{Grown, Growth};
use crate::synth::layer::GrownLayer;
use crate::synth::layer_report::report;
use crate::synth::options::Options;
use crate::synth::render::outlining::{Outlining, outlines};
use crate::synth::render::painting::{Painting, Style};
use crate::synth::report::Report;
use crate::synth::warped::warped;
use crate::synth::watch::Watch;

impl Document {
    /// Grows the document from the built-in training sets.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let spot = Stroke::ellipse([32.0, 32.0], [9.0, 6.0], 30.0);
    /// let grown = Document::new([64, 64]).with_layer(Layer::new([spot])).grow()?;
    /// assert_eq!(grown.rgb().len(), 3 * 64 * 64);
    /// # Ok::<(), dapple_engine::synth::GrowError>(())
    /// ```
    ///
    /// # Errors
    /// The document is not valid (see [`Document::check`]), or cannot be grown.
    pub fn grow(&self) -> Result<Grown, GrowError> {
        self.grow_with(&Options::default())
    }

    /// Grows the document with other options: another size of the canvas, progress, cancelling.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    /// use dapple_engine::synth::{Options, Watch};
    ///
    /// let spot = Stroke::ellipse([32.0, 32.0], [9.0, 6.0], 30.0);
    /// let document = Document::new([64, 64]).with_layer(Layer::new([spot]));
    /// let watch = Watch { progress: &|stage, share| println!("{stage:?} {share:.2}"), ..Watch::NONE };
    /// let grown = document.grow_with(&Options { size: Some([96, 64]), watch, ..Options::default() })?;
    /// assert_eq!(grown.size, [96, 64]);
    /// # Ok::<(), dapple_engine::synth::GrowError>(())
    /// ```
    ///
    /// # Errors
    /// Those of [`Document::grow`]; or the growth does not fit into the memory that may be used, or was cancelled.
    pub fn grow_with(&self, options: &Options) -> Result<Grown, GrowError> {
        self.check(options.source)?;
        Growth::begin(self, options, None).run()
    }
}

impl Grown {
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

    /// The pattern of layer `index` (0 = the lowest) at the canvas' size, bent by the warp of the document: 0 = ground, 0.5 = a mark's
    /// edge, 1 = its centre.
    #[must_use]
    pub fn pattern(&self, index: usize) -> Option<Field> {
        let [width, height] = self.size.map(|side| side as usize);
        let pattern = GrownLayer::pattern(self.layers.get(index)?);
        let pattern = warped(&self.document, self.size.map(f64::from), vec![pattern]).pop()?;
        Some(pattern.field(width, height))
    }

    /// The report of the growth, by layer and region. `seconds` is 0: time is not measured here.
    #[must_use]
    pub fn report(&self) -> Report {
        report(&self.document, &self.document.name, self, 0.0)
    }

    /// The style of a picture that is `scale` times as large as the canvas.
    #[must_use]
    pub fn style(&self, scale: u32) -> Style {
        let mut document = self.document.clone();
        document.growth.refine = self.settings.refine.unwrap_or(document.growth.refine);
        let extent = Extent { size: self.settings.size, scale };
        let dpi = document.dpi * f64::from(scale);
        Style { dpi, texts: embedded(&document, extent), ..Style::default() }
    }

    /// Writes the outlines of the marks, with `scale` times the px along each side, in mm by the document's dpi: as DXF, or else as
    /// SVG.
    ///
    /// # Errors
    /// `out` cannot be written to.
    pub fn write_outlines(&self, mut out: impl Write, as_dxf: bool, scale: u32) -> Result<(), Stopped> {
        let size = self.size.map(|side| side as usize * scale as usize);
        let unit = Unit::Mm { dpi: self.document.dpi * f64::from(scale) };
        let smallest = Smallest { width: 0.0, area: 0.0 };
        let wanted = Outlining { size, level: 0.5, only: None, smallest, style: outline::Style::default() };
        let (groups, _) = outlines(&self.document, self, &wanted, &Watch::NONE)?;
        let size = size.map(|side| side as f64);
        if as_dxf {
            return Ok(dxf::write(&mut out, size, unit, &groups)?);
        }
        let title = self.document.name.clone();
        let sheet = Sheet { title, size, unit, stroke_width: unit.stroke(), ground: None };
        Ok(svg::write(&mut out, &sheet, &groups)?)
    }
}
