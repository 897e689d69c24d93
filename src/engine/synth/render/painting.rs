//! Grown layers → pictures of the texture, its pattern and its labels, for files and for the window.

mod concentrations;
mod fine;
mod finished;
mod flow;
mod lit;
mod material;
mod relief;

pub use concentrations::concentrations;
pub use flow::flow_of;
pub use material::{Making, plane, usual_relief};

use std::io::{Seek, Write};
use std::ops::Range;
use std::path::Path;

use rayon::prelude::*;

use crate::colour::{Gradient, Ground, Painted, Table, paint_rows, painter};
use crate::document::{Colours, Document, Layer, MapKey};
use crate::export::picture::{self, Encoding, QUALITY};
use crate::export::png::{Header, Samples};
use crate::export::web::Aside;
use crate::export::{Content, ExportError, Format, Stopped, exr};
use crate::grid::{Edges, Field, to_u16};
use crate::synth::drawn::is_replaced;
use crate::synth::drawn::maps::{ColourMap, PaintedMap};
use crate::synth::growth::{Grown, Snapshot};
use crate::synth::layer::GrownLayer;
use crate::synth::marks::grow::pattern::Pattern;
use crate::synth::marks::plan::Plan;
use crate::synth::pattern::EDGE;
use crate::synth::pattern::LayerPattern;
use crate::synth::profile::{Section, during};
use crate::synth::render::painting::finished::{Applied, encode};
use crate::synth::warped::warped;
use crate::synth::watch::{Stage, Watch};

/// Patterns and colours of all layers, for pictures of one size.
pub struct Painting<'a> {
    /// Width and height, px.
    pub size: [usize; 2],
    layers: Vec<LayerPattern<'a>>,
    tables: Vec<Table>,
    gradients: Vec<Gradient>,
    /// Variation of the places in the gradients.
    colour_maps: Vec<Option<ColourMap>>,
    /// The second colour of the ground of each layer, and its share at each place.
    grounds: Vec<Option<(Ground, PaintedMap)>>,
    /// Width and height of the canvas, px.
    canvas: [f64; 2],
    visible: Vec<bool>,
    /// Layers whose marks are replaced by those of the next one; they cover nothing.
    replaced: Vec<bool>,
    /// The finish of the document; none of a pattern that still grows, but for [`Self::with_finish`].
    finish: Option<Applied>,
}

impl<'a> Painting<'a> {
    /// The painting of the `grown` layers of `document`, with `scale` times the px along each side.
    #[must_use]
    pub fn new(document: &Document, grown: &'a Grown, scale: usize) -> Self {
        Self::sized(document, grown, grown.size.map(|side| side as usize * scale))
    }

    /// The painting of the `grown` layers of `document`, all or only its lowest ones, at `size` px.
    #[must_use]
    pub fn sized(document: &Document, grown: &'a Grown, size: [usize; 2]) -> Self {
        let layers = grown.layers.iter().take(document.layers.len());
        let canvas = grown.size.map(f64::from);
        let painting = Self::with(document, canvas, size, layers.map(GrownLayer::pattern).collect());
        Self { finish: Applied::of(document, canvas), ..painting }
    }

    /// A layer that still grows, on top of those that have `grown`, at `size` px.
    #[must_use]
    pub fn growing(document: &Document, snapshot: &Snapshot<'a>, size: [usize; 2]) -> Self {
        let mut layers: Vec<_> = snapshot.beneath.iter().map(GrownLayer::pattern).collect();
        layers.push((snapshot.growing.pattern)());
        let mut painting = Self::with(document, snapshot.growing.canvas, size, layers);
        // The growing layer is shown although the next one will replace it.
        let top = painting.layers.len() - 1;
        painting.visible[top] = document.layers[top].visible;
        painting
    }

    /// The concentration `marks` of one layer, in the colours of the lowest of `document`, at `size` px.
    #[must_use]
    pub fn from_marks(document: &Document, plan: &'a Plan, marks: Field, size: [usize; 2]) -> Self {
        let pattern = Pattern::new(&plan.lookup, &plan.levelled(marks));
        let canvas = plan.lookup.map.layout().size;
        Self::with(document, canvas, size, vec![Box::new(pattern)])
    }

    fn with(document: &Document, canvas: [f64; 2], size: [usize; 2], layers: Vec<LayerPattern<'a>>) -> Self {
        let gradients = document.layers.iter().enumerate().map(|(index, layer)| gradient_of(layer, index));
        let gradients: Vec<Gradient> = gradients.collect();
        let layers = warped(document, canvas, layers);
        Self {
            size,
            tables: gradients.iter().map(Gradient::table).collect(),
            grounds: (0..layers.len()).map(|index| ground_of(document, index, canvas)).collect(),
            gradients,
            colour_maps: (0..layers.len()).map(|index| ColourMap::of(document, index, canvas)).collect(),
            canvas,
            visible: document
                .layers
                .iter()
                .enumerate()
                .map(|(index, layer)| layer.visible && !is_replaced(document, index))
                .collect(),
            replaced: (0..document.layers.len()).map(|index| is_replaced(document, index)).collect(),
            layers,
            finish: None,
        }
    }

    /// The band of these rows, without the finish.
    #[must_use]
    pub fn band(&self, rows: Range<usize>) -> Band<'_> {
        self.band_at(rows, self.size)
    }

    /// The band of these rows of a picture of another size, without the finish.
    fn band_at(&self, rows: Range<usize>, [width, height]: [usize; 2]) -> Band<'_> {
        let field = |values: Vec<f32>| Field {
            width,
            height: rows.len(),
            cell: [1.0, 1.0],
            edges: Edges::Closed,
            values,
        };
        let layers = self.layers.iter();
        let patterns: Vec<Field> =
            layers.map(|layer| field(layer.rows(rows.clone(), width, height))).collect();
        let mut free = Vec::with_capacity(patterns.len());
        let mut left = vec![true; width * rows.len()];
        for (pattern, replaced) in patterns.iter().zip(&self.replaced) {
            free.push(left.clone());
            if *replaced {
                continue;
            }
            for (left, value) in left.iter_mut().zip(&pattern.values) {
                *left &= *value < EDGE;
            }
        }
        let grounds = self.grounds.iter().zip(&patterns);
        let grounds = grounds.map(|(ground, pattern)| {
            let map = &ground.as_ref()?.1;
            Some(self.each_px(pattern, rows.start, height, |_, point| map.at(point)))
        });
        let grounds = grounds.collect();
        let places = self.colour_maps.iter().zip(&patterns);
        let places = places.map(|(map, pattern)| {
            let map = map.as_ref()?;
            Some(self.each_px(pattern, rows.start, height, |value, point| map.place(value, point)))
        });
        Band { painting: self, width, places: places.collect(), grounds, patterns, free }
    }

    /// A number for each px of a `pattern`, from its value and its point, px of the canvas; the pattern begins at row `first` of a picture of
    /// `height` rows.
    fn each_px(
        &self,
        pattern: &Field,
        first: usize,
        height: usize,
        number: impl Fn(f32, [f64; 2]) -> f32 + Sync,
    ) -> Field {
        let [wide, high] = [self.canvas[0] / pattern.width as f64, self.canvas[1] / height as f64];
        let mut numbers = pattern.clone();
        numbers.values.par_chunks_mut(numbers.width.max(1)).enumerate().for_each(|(y, row)| {
            for (x, value) in row.iter_mut().enumerate() {
                let point = [(x as f64 + 0.5) * wide, ((first + y) as f64 + 0.5) * high];
                *value = number(*value, point);
            }
        });
        numbers
    }

    /// Whether no visible colour is transparent. A finish is opaque: transparent colours are painted over white.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.has_finish() || self.is_opaque_without_finish()
    }

    fn is_opaque_without_finish(&self) -> bool {
        let layers = self.gradients.iter().zip(&self.visible).take(self.layers.len());
        layers.clone().all(|(gradient, visible)| !visible || gradient.is_opaque())
            && (layers.clone().any(|(_, visible)| *visible)
                || self.gradients.last().is_none_or(Gradient::is_opaque))
    }

    /// The whole texture: red, green, blue a px, row by row from the top. Transparent parts are painted over white.
    #[must_use]
    pub fn rgb(&self) -> Vec<u8> {
        let mut rgb = vec![0; 3 * self.size[0] * self.size[1]];
        if let Some(finished) = self.finished() {
            encode(finished, 0, true, Samples::Rgb8, &mut rgb);
            return rgb;
        }
        let band = self.band(0..self.size[1]);
        if self.is_opaque() {
            band.paint(&mut rgb);
        } else {
            band.paint_fine(&fine::Colours::new(self, false), Samples::Rgb8, &mut rgb);
        }
        rgb
    }

    /// The whole texture: red, green, blue, alpha a px, row by row from the top.
    #[must_use]
    pub fn rgba(&self) -> Vec<u8> {
        self.rgba_rows(0..self.size[1])
    }

    /// Some of its rows: red, green, blue, alpha a px.
    #[must_use]
    pub fn rgba_rows(&self, rows: Range<usize>) -> Vec<u8> {
        let mut rgba = vec![0; 4 * self.size[0] * rows.len()];
        if let Some(finished) = self.finished() {
            encode(finished, rows.start * self.size[0], true, Samples::Rgba8, &mut rgba);
            return rgba;
        }
        self.band(rows).paint_fine(&fine::Colours::new(self, false), Samples::Rgba8, &mut rgba);
        rgba
    }

    /// Writes a picture of `channel` in a format that [holds](Style::check) it. A WebP is encoded `aside`.
    ///
    /// # Errors
    /// `out` cannot be written to; or it was cancelled.
    pub fn write(
        &self,
        out: impl Write + Seek,
        format: Format,
        channel: Channel,
        style: &Style,
        aside: Aside,
        watch: &Watch,
    ) -> Result<(), Stopped> {
        let step = |rows: &Range<usize>| {
            let done = rows.start as f64 / self.size[1] as f64;
            watch.step(Stage::Write, done).map_err(|_| Stopped::Cancelled)
        };
        if let (Format::Exr, Channel::Pattern(only)) = (format, channel) {
            return exr::write(out, self.size, &["Y".to_owned()], Some(style.dpi), |rows, planes| {
                step(&rows)?;
                self.band(rows).values(only, &mut planes[0]);
                Ok(())
            });
        }
        let samples = style.samples(format, channel, self.is_opaque());
        let texts = if format == Format::Png { &style.texts[..] } else { &[] };
        let header = Header { dpi: Some(style.dpi), texts, ..Header::new(self.size, samples) };
        // Plain opaque 8-bit colours are painted by a faster function.
        let fine = channel == Channel::Texture && (samples != Samples::Rgb8 || !self.is_opaque());
        let colours = fine.then(|| fine::Colours::new(self, style.transparent));
        let encoding = Encoding { quality: style.quality, aside };
        let finished = matches!(channel, Channel::Texture | Channel::Mask).then(|| self.finished()).flatten();
        picture::write(out, format, encoding, header, |rows, bytes| {
            step(&rows)?;
            // An empty range is only a test for cancelling.
            if rows.is_empty() {
                return Ok(());
            }
            if let Some(finished) = finished {
                let first = rows.start * self.size[0];
                match channel {
                    Channel::Mask => bytes.copy_from_slice(&finished.mask[first..first + bytes.len()]),
                    _ => encode(finished, first, true, samples, bytes),
                }
                return Ok(());
            }
            during(Section::Paint, || {
                let band = self.band(rows);
                match (channel, &colours) {
                    (Channel::Texture, None) => band.paint(bytes),
                    (Channel::Texture, Some(colours)) => band.paint_fine(colours, samples, bytes),
                    (Channel::Pattern(only), _) => band.pattern(only, bytes),
                    (Channel::Labels | Channel::Mask, _) => band.labels(bytes),
                }
            });
            Ok(())
        })
    }
}

/// Settings for writing a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Style {
    /// Resolution, px an inch.
    pub dpi: f64,
    /// Whether colours have 16 bits.
    pub deep: bool,
    /// Whether the ground is transparent.
    pub transparent: bool,
    /// Quality of a JPEG, 1 to 100.
    pub quality: u8,
    /// Texts stored in a PNG: [`crate::document::embedded::embedded`].
    pub texts: Vec<(&'static str, String)>,
}

impl Default for Style {
    fn default() -> Self {
        Self { dpi: 300.0, deep: false, transparent: false, quality: QUALITY, texts: Vec::new() }
    }
}

impl Style {
    /// Checks that a picture of `channel` and `size` px can be written in `format` and this style; messages call it `path`.
    ///
    /// # Errors
    /// What the format cannot hold, and the remedy.
    pub fn check(
        &self,
        path: &Path,
        format: Format,
        channel: Channel,
        size: [usize; 2],
    ) -> Result<(), ExportError> {
        let cannot = |what, allowed| ExportError::CannotHold { path: path.to_owned(), format, what, allowed };
        if channel == Channel::Texture && self.transparent && !format.has_opacity() {
            return Err(cannot("transparent ground", ".png, .tif, .exr, .webp"));
        }
        if channel == Channel::Texture && self.deep && !format.is_deep() && format != Format::Exr {
            return Err(cannot("16-bit colours", ".png, .tif; .exr has 32"));
        }
        if size.iter().any(|side| *side > format.max_side()) {
            return Err(ExportError::TooWide { path: path.to_owned(), size, format });
        }
        Ok(())
    }

    /// The samples of a format without opacity: transparent parts are painted over white.
    fn samples(&self, format: Format, channel: Channel, is_opaque: bool) -> Samples {
        match channel {
            Channel::Texture => {
                let has_opacity = self.transparent || (!is_opaque && format.has_opacity());
                Samples::colours(self.deep || format == Format::Exr, has_opacity)
            }
            Channel::Pattern(_) => Samples::Gray16,
            Channel::Labels | Channel::Mask => Samples::Gray8,
        }
    }
}

/// The content of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Channel {
    /// The texture: red, green, blue, 8 bit each.
    Texture,
    /// The pattern of one layer, or of the layer that is visible at each px: 16-bit gray.
    Pattern(Option<usize>),
    /// For each px, the layer whose mark covers it: 8 bit.
    Labels,
    /// For each px, the layer whose mark covers it after the finish: 8 bit. Without a finish the labels.
    Mask,
}

impl Channel {
    /// The kind of content of its pictures.
    #[must_use]
    pub fn content(self) -> Content {
        match self {
            Self::Texture => Content::Colours,
            Self::Pattern(_) => Content::Numbers,
            Self::Labels | Self::Mask => Content::Labels,
        }
    }
}

/// The colours of the layer with this index: its own, or the default set.
pub(super) fn gradient_of(layer: &Layer, index: usize) -> Gradient {
    let own = layer.colours.as_ref().map(Colours::painted);
    own.unwrap_or_else(|| Gradient::default_for_layer(index))
}

/// The second colour of the ground of the layer with this index, if it has one and a map of it.
fn ground_of(document: &Document, index: usize, canvas: [f64; 2]) -> Option<(Ground, PaintedMap)> {
    let map = PaintedMap::of(document, index, MapKey::Ground, canvas)?;
    let layer = &document.layers[index];
    Some((Ground::new(&gradient_of(layer, index), second_ground(layer)), map))
}

/// The second colour of the ground of a layer.
pub(in crate::synth) fn second_ground(layer: &Layer) -> [u8; 3] {
    layer.colours.as_ref().map_or(Colours::GROUND, |colours| colours.ground)
}

/// Some rows of the pictures.
pub struct Band<'a> {
    painting: &'a Painting<'a>,
    /// px of a row.
    width: usize,
    patterns: Vec<Field>,
    /// The place of each px in the gradient of the layer, if it differs from the pattern.
    places: Vec<Option<Field>>,
    /// The share of the second colour of the ground of the layer in each px, if it has one.
    grounds: Vec<Option<Field>>,
    /// For each layer, the cells where it was free to grow: outside the marks of the layers beneath.
    free: Vec<Vec<bool>>,
}

impl Band<'_> {
    /// The layers, with the places in their gradients for patterns.
    fn painted(&self) -> Vec<Painted<'_>> {
        let Painting { tables, visible, .. } = self.painting;
        let shown = self.patterns.iter().zip(&self.places);
        let shown = shown.map(|(pattern, places)| places.as_ref().unwrap_or(pattern));
        let grounds = self.painting.grounds.iter().zip(&self.grounds);
        let grounds = grounds.map(|(ground, shares)| Some((&ground.as_ref()?.0, shares.as_ref()?)));
        let layers = shown.zip(&self.free).zip(tables).zip(visible).zip(grounds);
        layers
            .map(|((((pattern, free), table), visible), ground)| Painted {
                pattern,
                free: Some(free),
                table,
                ground,
                visible: *visible,
            })
            .collect()
    }

    /// The colours: red, green, blue a px.
    pub fn paint(&self, rgb: &mut [u8]) {
        let rows = self.patterns.first().map_or(0, |pattern| pattern.height);
        paint_rows(&self.painted(), self.width, 0..rows, rgb);
    }

    /// The pattern of layer `only`, or of the layer that is visible at each px; 0 where there is none. 16 bits, big-endian.
    pub fn pattern(&self, only: Option<usize>, gray: &mut [u8]) {
        let painted = self.painted();
        for (px, two) in gray.chunks_exact_mut(2).enumerate() {
            let layer = only.or_else(|| painter(&painted, px));
            let value = layer.map_or(0.0, |layer| self.patterns[layer].values[px]);
            two.copy_from_slice(&to_u16(value).to_be_bytes());
        }
    }

    /// The pattern of layer `only`, or of the layer that is visible at each px, not rounded; 0 where there is none.
    pub fn values(&self, only: Option<usize>, values: &mut [f32]) {
        let painted = self.painted();
        for (px, value) in values.iter_mut().enumerate() {
            let layer = only.or_else(|| painter(&painted, px));
            *value = layer.map_or(0.0, |layer| self.patterns[layer].values[px]);
        }
    }

    /// Writes for each px the layer whose mark covers it: 1 = the lowest, 0 = none.
    pub fn labels(&self, labels: &mut [u8]) {
        let painted = self.painted();
        for (px, label) in labels.iter_mut().enumerate() {
            let layer = painter(&painted, px).filter(|layer| self.patterns[*layer].values[px] >= EDGE);
            // A document has at most 255 layers.
            *label = layer.map_or(0, |layer| (layer + 1) as u8);
        }
    }
}
