//! The pictures of a growth: the texture, the pattern, the labels.

use super::Args;
use crate::cli::Error;
use crate::colour::{Bend, Gradient, Painted, Stop, Table, paint_rows, painter};
use crate::export::png::{self, Header, Samples};
use crate::export::{self, Prepared, Stopped};
use crate::field::{Edges, Field, to_u16};
use crate::synth::beneath::COVERED;
use crate::synth::inside::is_replaced;
use crate::synth::pattern::Pattern;
use crate::synth::recipe::{Colours, Document};
use crate::synth::{Grown, GrownLayer, Stage, Watch};
use std::ops::Range;
use std::path::Path;

/// Writes all pictures that were asked for, none of which has its name yet.
pub fn prepare(
    args: &Args,
    document: &Document,
    grown: &Grown,
    watch: &Watch,
) -> Result<Vec<Prepared>, Error> {
    let canvas = Canvas::of(document, grown, grown.size.map(|side| side as usize * args.scale as usize));
    let dpi = Some(document.dpi * f64::from(args.scale));
    let picture = |path: &Path, samples: Samples, fill: &dyn Fn(&Band, &mut [u8])| {
        let header = Header { size: canvas.size, samples, dpi };
        export::prepare(path, |out| {
            png::write(out, header, |rows, bytes| {
                let done = rows.start as f64 / canvas.size[1] as f64;
                watch.step(Stage::Write, done).map_err(|_| Stopped::Cancelled)?;
                fill(&canvas.band(rows), bytes);
                Ok(())
            })
        })
        .map_err(Error::exported)
    };
    let mut pictures = vec![picture(&args.output, Samples::Rgb8, &|band, bytes| band.paint(bytes))?];
    if let Some(path) = &args.pattern {
        let only = args.layer.map(|layer| layer as usize - 1);
        pictures.push(picture(path, Samples::Gray16, &|band, bytes| band.pattern(only, bytes))?);
    }
    if let Some(path) = &args.labels {
        pictures.push(picture(path, Samples::Gray8, &|band, bytes| band.labels(bytes))?);
    }
    Ok(pictures)
}

/// The texture at `size` px: red, green, blue a px, row by row from the top.
#[must_use]
pub fn texture(document: &Document, grown: &Grown, size: [usize; 2]) -> Vec<u8> {
    let mut rgb = vec![0; 3 * size[0] * size[1]];
    Canvas::of(document, grown, size).band(0..size[1]).paint(&mut rgb);
    rgb
}

/// What is painted, at the size of the pictures.
struct Canvas<'a> {
    size: [usize; 2],
    layers: Vec<Pattern<'a>>,
    tables: Vec<Table>,
    visible: Vec<bool>,
    /// Which stand only for the places of the next, and cover nothing.
    replaced: Vec<bool>,
}

impl<'a> Canvas<'a> {
    fn of(document: &Document, grown: &'a Grown, size: [usize; 2]) -> Self {
        let tables = document.layers.iter().enumerate().map(|(index, layer)| {
            let gradient = layer.colours.as_ref().map(gradient);
            gradient.unwrap_or_else(|| Gradient::default_for_layer(index)).table()
        });
        Self {
            size,
            layers: grown.layers.iter().map(GrownLayer::pattern).collect(),
            tables: tables.collect(),
            visible: document
                .layers
                .iter()
                .enumerate()
                .map(|(index, layer)| layer.visible && !is_replaced(document, index))
                .collect(),
            replaced: (0..document.layers.len()).map(|index| is_replaced(document, index)).collect(),
        }
    }

    fn band(&self, rows: Range<usize>) -> Band<'_> {
        let [width, height] = self.size;
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
                *left &= *value < COVERED;
            }
        }
        Band { canvas: self, patterns, free }
    }
}

fn gradient(colours: &Colours) -> Gradient {
    Gradient {
        stops: colours.stops.iter().map(|stop| Stop { at: stop.at as f32, colour: stop.colour }).collect(),
        bends: colours.bends.iter().map(|bend| Bend(*bend)).collect(),
    }
}

/// Some rows of the pictures: the pattern of each layer there.
struct Band<'a> {
    canvas: &'a Canvas<'a>,
    patterns: Vec<Field>,
    /// Where each was free to grow: the marks of those beneath are frozen.
    free: Vec<Vec<bool>>,
}

impl Band<'_> {
    fn painted(&self) -> Vec<Painted<'_>> {
        let layers = self.patterns.iter().zip(&self.free).zip(&self.canvas.tables).zip(&self.canvas.visible);
        layers
            .map(|(((pattern, free), table), visible)| Painted {
                pattern,
                free: Some(free),
                table,
                visible: *visible,
            })
            .collect()
    }

    fn paint(&self, rgb: &mut [u8]) {
        let rows = self.patterns.first().map_or(0, |pattern| pattern.height);
        paint_rows(&self.painted(), self.canvas.size[0], 0..rows, rgb);
    }

    /// The pattern of layer `only`, or of the layer that painted each px; ground where none did.
    fn pattern(&self, only: Option<usize>, gray: &mut [u8]) {
        let painted = self.painted();
        for (px, two) in gray.chunks_exact_mut(2).enumerate() {
            let layer = only.or_else(|| painter(&painted, px));
            let value = layer.map_or(0.0, |layer| self.patterns[layer].values[px]);
            two.copy_from_slice(&to_u16(value).to_be_bytes());
        }
    }

    fn labels(&self, labels: &mut [u8]) {
        let painted = self.painted();
        for (px, label) in labels.iter_mut().enumerate() {
            let layer = painter(&painted, px).filter(|layer| self.patterns[*layer].values[px] >= COVERED);
            // A document has at most 255 layers.
            *label = layer.map_or(0, |layer| (layer + 1) as u8);
        }
    }
}
