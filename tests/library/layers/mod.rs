//! Layers: the relation of each to the marks beneath, by its `after`.

mod between;
mod crossing;
mod inside;
mod regrown;
mod sparse;

use dapple::document::{After, Document, Layer, LayerOptions, Stroke};
use dapple::document::{Ellipse, Line};
use dapple_engine::grid::{Edges, Field};
use dapple_engine::synth::Growth;
use dapple_engine::synth::{GrowError, Grown, Options};

/// A layer with four spots with this area, aspect, angle and spacing, somewhere on a canvas of 360 px.
fn spots(area: f64, aspect: f64, angle: f64, spacing: f64) -> Layer {
    let high = spacing * 0.75f64.sqrt();
    let center = |[x, y]: [f64; 2]| [150.0 + x * spacing, 150.0 + y * high];
    let places = [[0.0, 0.0], [1.0, 0.0], [0.5, 1.0], [1.5, 1.0]];
    let stroke = |place| Stroke::Ellipse(Ellipse::from_area(center(place), area, aspect, angle));
    // The drawn marks are not kept, because all marks are counted here.
    let options = LayerOptions { keep: Some(false), ..LayerOptions::default() };
    Layer { strokes: places.map(stroke).into(), options, ..Layer::default() }
}

/// A layer with a stripe of this width and angle.
fn stripes(width: f64, angle: f64) -> Layer {
    let [x, y] = [angle.to_radians().cos(), angle.to_radians().sin()].map(|part| 60.0 * part);
    let line = Line { from: [180.0 - x, 180.0 - y], to: [180.0 + x, 180.0 + y], width };
    let options = LayerOptions { keep: Some(false), ..LayerOptions::default() };
    Layer { strokes: vec![Stroke::Line(line)], options, ..Layer::default() }
}

fn cascade(edges: Edges, seed: u64, layers: Vec<Layer>) -> Document {
    Document { size: [360, 360], edges, seed, layers, ..Document::default() }
}

fn after(after: After, layer: Layer) -> Layer {
    Layer { after, ..layer }
}

fn try_grow(document: &Document) -> Result<Grown, GrowError> {
    Growth::begin(document, &Options { source: "test", ..Options::default() }, None).run()
}

fn grown(document: &Document) -> Grown {
    try_grow(document).unwrap_or_else(|error| panic!("{error}"))
}

/// The pattern of each layer, two points for each px.
fn patterns(grown: &Grown) -> Vec<Field> {
    let [width, height] = grown.size.map(|side| 2 * side as usize);
    grown.layers.iter().map(|layer| layer.pattern().field(width, height)).collect()
}

/// For each px, whether marks of the layer cover it.
fn covered(pattern: &Field) -> Vec<bool> {
    pattern.values.iter().map(|value| *value >= 0.5).collect()
}
