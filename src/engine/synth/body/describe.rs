//! What `check` says of a document on a model.

use std::fmt::Write as _;

use serde_json::{Map, Value, json};

use crate::document::Document;
use crate::synth::body::asked::Asked;
use crate::synth::body::growth::asked_of_all;
use crate::synth::body::needs;
use crate::synth::body::placed::Placed;
use crate::synth::body::plan::cell;
use crate::synth::body::refusals;
use crate::synth::error::{GrowError, LayerError};
use crate::synth::options::Options;

/// What a growth on a model will be.
pub struct DescribedBody {
    /// Lines for a terminal.
    pub text: String,
    /// Keys and values for programs.
    pub json: Map<String, Value>,
    /// What the user should know.
    pub notes: Vec<String>,
    /// Why it cannot be grown; `None` where it can.
    pub refusal: Option<GrowError>,
}

/// Plans a document that has a model as far as its growth is known before the model is remeshed.
///
/// # Errors
/// Why it cannot be planned.
pub fn describe(
    document: &Document,
    model: Option<&[u8]>,
    options: &Options,
) -> Result<DescribedBody, GrowError> {
    let Options { source, training, .. } = *options;
    let body = refusals::check(document, source)?;
    let placed = Placed::read(body, model, source)?.with_coordinates(document, source)?;
    let in_layer = |error: LayerError| error.in_layer(source, 1);
    let asked = asked_of_all(document, body, &placed, options).map_err(in_layer)?;
    let cells: Vec<f64> = asked
        .iter()
        .map(|asked| cell(document, asked, training).map_err(in_layer))
        .collect::<Result<_, GrowError>>()?;
    let area = placed.mesh.area();
    let finish = document.finish.as_ref().map(|finishing| finishing.finish);
    let refusal = needs::check(area, &cells, finish, options).err().map(in_layer);
    let name = body.source.name();
    let mut text =
        format!("model:   {name}, {} px along its longest side, {area:.0} px² to grow on\n", body.px);
    let mut layers = Vec::new();
    for (Asked { layer, choice, .. }, cell) in asked.iter().zip(&cells) {
        let vertices = needs::vertices(area, &[*cell]);
        let system = choice.description();
        let _ = writeln!(
            text,
            "  layer {} ({}): about {vertices:.0} vertices, {cell:.2} px a cell",
            layer + 1,
            system.title
        );
        layers.push(json!({"system": system.name, "vertices": vertices.round(), "cell": cell}));
    }
    let json = json!({"model": name, "px": body.px, "area": area, "layers": layers});
    let mut notes = placed.notes();
    notes.extend(refusals::notes(document));
    let json = json.as_object().cloned().unwrap_or_default();
    Ok(DescribedBody { text, json, notes, refusal })
}
