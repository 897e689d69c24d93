//! A random sketch of one layer.

use std::fmt;

use dapple::document::{Document, Edges, Layer, LayerOptions, Stroke, SystemChoice};
use dapple_engine::synth::GrownLayer;

/// Lines of one direction that lie side by side.
#[derive(Clone, Copy, Debug)]
pub struct Lines {
    /// Direction, degrees in [0, 180).
    pub angle: f64,
    /// Width of the lines, px.
    pub width: f64,
    /// Distance from one line to the next, px.
    pub period: f64,
}

impl Lines {
    /// `count` lines side by side, each `long` px long, about `center`.
    pub fn strokes(self, [x, y]: [f64; 2], count: usize, long: f64) -> Vec<Stroke> {
        let (s, c) = libm::sincos(self.angle.to_radians());
        let line = |k: usize| {
            let off = (k as f64 - 0.5 * (count as f64 - 1.0)) * self.period;
            let at = |along: f64| [x + along * c - off * s, y + along * s + off * c];
            Stroke::line(at(-0.5 * long), at(0.5 * long), self.width)
        };
        (0..count).map(line).collect()
    }
}

/// A sketch.
#[derive(Clone, Debug)]
pub struct Sketch {
    /// Side of the canvas, px.
    pub side: f64,
    /// Its edges.
    pub edges: Edges,
    /// The system that grows it.
    pub system: SystemChoice,
    /// The strokes.
    pub strokes: Vec<Stroke>,
    /// Options of the layer.
    pub options: LayerOptions,
    /// The lines that should grow.
    pub lines: Vec<Lines>,
    /// For cells: area (px²), aspect, gap (px).
    pub cells: [f64; 3],
}

impl Sketch {
    /// The document with this seed.
    pub fn document(&self, seed: u64) -> Document {
        let layer = Layer::new(self.strokes.clone()).with_system(self.system).with_options(self.options);
        Document::new([self.side as u32; 2]).with_edges(self.edges).with_seed(seed).with_layer(layer)
    }
}

impl fmt::Display for Sketch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} px {:?}", self.side, self.edges)?;
        let [area, aspect, gap] = self.cells;
        if area > 0.0 {
            return write!(f, ", {area:.0} px², aspect {aspect:.2}, gap {gap:.1} px");
        }
        self.lines.iter().try_for_each(|lines| {
            write!(f, ", {:.0}° {:.1}/{:.1} px", lines.angle, lines.width, lines.period)
        })
    }
}

/// The notes of the growth on the layer as a whole.
pub fn notes(layer: &GrownLayer) -> Vec<String> {
    layer.pairs().map(|grown| grown.plan.notes.clone()).unwrap_or_default()
}
