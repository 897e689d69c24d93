//! A painting with its finish: the whole picture in one piece, since hairs and marks reach over any band of rows.

use std::ops::Range;
use std::sync::OnceLock;

use crate::document::Document;
use crate::export::png::Samples;
use crate::finish::{Finish, Finished, Flow, Source};
use crate::grid::{Edges, to_u16};
use crate::synth::render::painting::fine::{Colours, to_u8};
use crate::synth::render::painting::{Painting, flow};

/// Rows of the unfinished picture that are painted together.
const ROWS: usize = 256;

/// The finish of a painting.
pub(super) struct Applied {
    finish: Finish,
    flow: Flow,
    edges: Edges,
    seed: u64,
    /// The finished picture, once it is needed, with its size.
    done: OnceLock<Finished>,
}

impl Applied {
    /// The finish of `document` on a canvas of `canvas` px, if it has one.
    pub fn of(document: &Document, canvas: [f64; 2]) -> Option<Self> {
        let finishing = document.finish.as_ref()?;
        Some(Self {
            finish: finishing.finish,
            flow: flow::of(document, &finishing.flow, canvas),
            edges: document.edges,
            seed: document.seed,
            done: OnceLock::new(),
        })
    }
}

impl Painting<'_> {
    /// The painting without the finish of its document.
    #[must_use]
    pub fn unfinished(self) -> Self {
        Self { finish: None, ..self }
    }

    /// The painting with the finish of `document`, if that has one: also of a pattern that still grows.
    #[must_use]
    pub fn with_finish(self, document: &Document) -> Self {
        Self { finish: Applied::of(document, self.canvas), ..self }
    }

    /// Whether it has a finish.
    #[must_use]
    pub fn has_finish(&self) -> bool {
        self.finish.is_some()
    }

    /// The finished picture, if the document has a finish. It is computed when it is needed first.
    pub(super) fn finished(&self) -> Option<&Finished> {
        let applied = self.finish.as_ref()?;
        Some(applied.done.get_or_init(|| {
            let canvas = self.canvas.map(|side| (side.round() as usize).max(1));
            // A picture that is smaller than the canvas shows the mean of its px.
            let is_small = (0..2).any(|axis| self.size[axis] < canvas[axis]);
            let size = if is_small { canvas } else { self.size };
            let labels = self.plain_labels(size);
            let finish = applied.finish;
            let reach = match size == canvas {
                true => finish.reach(&labels, canvas, applied.edges),
                false => finish.reach(&self.plain_labels(canvas), canvas, applied.edges),
            };
            let rgb = self.plain_rgb(size);
            let finished = finish.paint(&Source {
                size,
                canvas: canvas.map(|side| side as f32),
                edges: applied.edges,
                rgb: &rgb,
                labels: &labels,
                flow: &applied.flow,
                reach: &reach,
                seed: applied.seed,
            });
            if is_small { finished.reduced(self.size) } else { finished }
        }))
    }

    /// For each px, row by row, the layer whose mark covers it after the finish; without one its label.
    #[must_use]
    pub fn mask(&self) -> Vec<u8> {
        if let Some(finished) = self.finished() {
            return finished.mask.clone();
        }
        let mut labels = vec![0; self.size[0] * self.size[1]];
        self.band(0..self.size[1]).labels(&mut labels);
        labels
    }

    /// Whether its reflections have a direction: those of hair.
    #[must_use]
    pub fn is_anisotropic(&self) -> bool {
        self.finish.as_ref().is_some_and(|applied| applied.finish.kind.stretch().is_some())
    }

    /// The direction of reflections in `rows`: across the hair, since its normals differ across it and not along it. Red, green,
    /// blue a px as [`crate::export::material::Map::Anisotropy`] says.
    pub(super) fn anisotropy(&self, rows: Range<usize>, bytes: &mut [u8]) {
        let Some(applied) = &self.finish else { return };
        let stretch = applied.finish.kind.stretch().unwrap_or(0);
        let width = self.size[0];
        let px_a_px = [0, 1].map(|axis| (self.canvas[axis] / self.size[axis] as f64) as f32);
        for (out, px) in bytes.chunks_exact_mut(3).zip(rows.start * width..) {
            let point = [(px % width) as f32 + 0.5, (px / width) as f32 + 0.5];
            let [x, y] = applied.flow.at([point[0] * px_a_px[0], point[1] * px_a_px[1]]);
            // A quarter turn; y of the canvas points down, that of the map up.
            let across = [y, x];
            out.copy_from_slice(&[to_u8(0.5 + 0.5 * across[0]), to_u8(0.5 + 0.5 * across[1]), stretch]);
        }
    }

    /// px of the picture along each px of the document.
    pub(super) fn px_a_px(&self) -> f32 {
        (self.size[0] as f64 / self.canvas[0]) as f32
    }

    /// The colours without a finish, at `size` px: red, green, blue a px.
    fn plain_rgb(&self, size: [usize; 2]) -> Vec<u8> {
        let mut rgb = vec![0; 3 * size[0] * size[1]];
        let colours = (!self.is_opaque_without_finish()).then(|| Colours::new(self, false));
        for (band, bytes) in rgb.chunks_mut(3 * ROWS * size[0]).enumerate() {
            let first = band * ROWS;
            let band = self.band_at(first..size[1].min(first + ROWS), size);
            match &colours {
                None => band.paint(bytes),
                Some(colours) => band.paint_fine(colours, Samples::Rgb8, bytes),
            }
        }
        rgb
    }

    /// The labels at `size` px.
    fn plain_labels(&self, size: [usize; 2]) -> Vec<u8> {
        let mut labels = vec![0; size[0] * size[1]];
        for (band, bytes) in labels.chunks_mut(ROWS * size[0]).enumerate() {
            let first = band * ROWS;
            self.band_at(first..size[1].min(first + ROWS), size).labels(bytes);
        }
        labels
    }
}

/// Writes the colours of `finished` px from `first` on in the format of `samples`: in the light, or without.
pub(super) fn encode(finished: &Finished, first: usize, lit: bool, samples: Samples, bytes: &mut [u8]) {
    let deep = matches!(samples, Samples::Rgb16 | Samples::Rgba16);
    for (out, surfel) in bytes.chunks_exact_mut(samples.bytes()).zip(&finished.surfels[first..]) {
        let [red, green, blue] = if lit { surfel.lit() } else { surfel.albedo() };
        // Samples without opacity have one channel less.
        let values = [red, green, blue, 1.0];
        if deep {
            for (two, value) in out.chunks_exact_mut(2).zip(values) {
                two.copy_from_slice(&to_u16(value).to_be_bytes());
            }
        } else {
            out.iter_mut().zip(values).for_each(|(out, value)| *out = to_u8(value));
        }
    }
}
