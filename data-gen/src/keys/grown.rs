//! A document, grown: its picture and what is measured on it.

use dapple::document::Document;
use dapple_engine::export::body::View;
use dapple_engine::grid::Field;
use dapple_engine::synth::body::BodyGrowth;
use dapple_engine::synth::layer_report::report;
use dapple_engine::synth::render::painting::Painting;
use dapple_engine::synth::{Growth, Options};
use serde_json::{Value, json};

/// A grown document.
pub struct Grown {
    /// Width and height of its picture, px.
    pub size: [usize; 2],
    /// Red, green, blue a px.
    pub rgb: Vec<u8>,
    /// Its report.
    pub report: Value,
    /// The pattern of each layer; none on a model.
    pub patterns: Vec<Field>,
    /// The layer whose mark covers each px, 0 = none; none on a model.
    pub labels: Vec<u8>,
}

/// The model that documents of the table name, beside those that are built in: two boxes, its groups `left` and `right`.
const BOXES: (&str, &[u8]) = ("boxes.obj", include_bytes!("boxes.obj"));
/// From where models are seen: azimuth and elevation, degrees.
const VIEW: [f64; 2] = [-20.0, 12.0];
/// Width and height of the pictures of models, px.
const SIDE: u32 = 160;

impl Grown {
    /// Grows a document.
    pub fn new(document: &Document) -> Result<Self, String> {
        if document.model.is_some() { Self::on_model(document) } else { Self::on_canvas(document) }
    }

    fn on_canvas(document: &Document) -> Result<Self, String> {
        let grown = Growth::begin(document, &Options::default(), None).run();
        let grown = grown.map_err(|error| error.to_string())?;
        let size = document.size.map(|side| side as usize);
        let painting = Painting::new(document, &grown, 1);
        let band = painting.band(0..size[1]);
        let pattern = |layer: usize| {
            let mut values = vec![0.0; size[0] * size[1]];
            band.values(Some(layer), &mut values);
            Field { width: size[0], height: size[1], cell: [1.0, 1.0], edges: document.edges, values }
        };
        let patterns = (0..grown.layers.len()).map(pattern).collect();
        let mut labels = vec![0; size[0] * size[1]];
        band.labels(&mut labels);
        let report = json!(report(document, &document.name, &grown, 0.0));
        Ok(Self { size, rgb: painting.rgb(), report, patterns, labels })
    }

    fn on_model(document: &Document) -> Result<Self, String> {
        let growth = BodyGrowth::begin(document, model_file(document), &Options::default())
            .map_err(|error| error.to_string())?;
        let grown = growth.run().map_err(|error| error.to_string())?;
        let [azimuth, elevation] = VIEW;
        let rgb = grown.picture(&View::new(azimuth, elevation, [SIDE; 2])).rgb();
        let report = json!(grown.report(&document.name, 0.0));
        Ok(Self { size: [SIDE as usize; 2], rgb, report, patterns: Vec::new(), labels: Vec::new() })
    }
}

/// The bytes of the file of the document's model, if it has one.
fn model_file(document: &Document) -> Option<&'static [u8]> {
    let (name, bytes) = BOXES;
    document.model.as_ref().filter(|body| body.source.name() == name).map(|_| bytes)
}
