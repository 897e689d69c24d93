//! Measuring pictures, sketches of photographs, and lookup of parameters.

use crate::errors::error;
use crate::watched::abandoned;
use dapple::document::with_causes;
use dapple::engine::export::png;
use dapple::engine::grid::{Edges, Field};
use dapple::engine::synth::import::measured_picture::{Framing, measure_stream};
use dapple::engine::synth::import::photo::{PhotoOptions, import_photo};
use dapple::lookup::{Attributes, LookedUp, Spots, Stripes, System, Training};
use dapple::output::{Picture, picture};
use dapple::free_memory;
use numpy::{PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;
use serde_json::{Map, Value, json};
use std::io::Cursor;
use std::path::Path;

/// The name of an array in messages.
const ARRAY: &str = "the array";

/// A pattern (2-D, float32) or a picture (height × width × 3, uint8).
#[derive(FromPyObject)]
pub enum Raster<'py> {
    Pattern(PyReadonlyArray2<'py, f32>),
    Colours(PyReadonlyArray3<'py, u8>),
}

/// The PNG of a picture.
fn encoded(colours: &PyReadonlyArray3<u8>) -> PyResult<Vec<u8>> {
    let &[height, width, 3] = colours.shape() else {
        let message = format!("{ARRAY}: found the shape {:?}; allowed: (height, width, 3)", colours.shape());
        return Err(error(&message, None));
    };
    let rgb: Vec<u8> = colours.as_array().iter().copied().collect();
    let mut out = Vec::new();
    png::rgb8(&mut out, [width, height], None, &rgb).map_err(|why| error(&why.to_string(), None))?;
    Ok(out)
}

/// The attributes of spots or stripes, as JSON text.
#[pyfunction]
pub fn measure(py: Python<'_>, raster: Raster<'_>, invert: bool) -> PyResult<String> {
    let found = match raster {
        Raster::Pattern(pattern) => {
            let &[height, width] = pattern.shape() else { return Err(error("the array has no rows", None)) };
            let sign = if invert { -1.0 } else { 1.0 };
            let values = pattern.as_array().iter().map(|value| sign * (value - 0.5)).collect();
            let field = Field { width, height, cell: [1.0, 1.0], edges: Edges::Closed, values };
            let found = abandoned(py, None, move |_| picture(&field, 0.0))?;
            found.ok_or_else(|| error(&format!("{ARRAY}: found neither spots nor stripes above 0.5"), None))?
        }
        Raster::Colours(colours) => {
            let bytes = encoded(&colours)?;
            let framing = Framing { invert, ..Framing::default() };
            let path = Path::new(ARRAY);
            let found =
                abandoned(py, None, move |_| measure_stream(Cursor::new(bytes), path, &framing, Some(free_memory())))?;
            found.map_err(|why| error(&with_causes(&why), None))?.picture
        }
    };
    Ok(measured(&found).to_string())
}

/// The keys of `dapple measure --json`.
fn measured(found: &Picture) -> Value {
    let object = match found {
        Picture::Spots { marks, got, spread, raggedness } => {
            let spread: Map<String, Value> =
                spread.named().into_iter().map(|(key, value)| (key.name().to_owned(), json!(value))).collect();
            json!({"kind": "spots", "marks": marks, "area": got.area, "aspect": got.aspect, "angle": got.angle,
                "spacing": got.spacing, "spread": spread, "raggedness": raggedness})
        }
        Picture::Stripes { marks, got } => json!({"kind": "stripes", "marks": marks, "width": got.width,
            "angle": got.angle, "wavelength": got.wavelength, "coherence": got.coherence}),
    };
    let Value::Object(entries) = object else { return Value::Null };
    Value::Object(entries.into_iter().filter(|(_, value)| !value.is_null()).collect())
}

/// A sketch of the marks of a photograph: the document, as JSON text.
#[pyfunction]
pub fn photo(py: Python<'_>, colours: PyReadonlyArray3<'_, u8>, invert: bool) -> PyResult<String> {
    let bytes = encoded(&colours)?;
    let options =
        PhotoOptions { framing: Framing { invert, ..Framing::default() }, ..PhotoOptions::default() };
    let path = Path::new(ARRAY);
    let made = abandoned(py, None, move |_| import_photo(Cursor::new(bytes), path, &options, Some(free_memory())))?;
    Ok(made.map_err(|why| error(&with_causes(&why), None))?.document.to_json())
}

/// The parameters that grow marks of these attributes, as JSON text.
#[pyfunction]
#[pyo3(signature = (system, angle, area=None, aspect=None, spacing=None, width=None, wavelength=None))]
pub fn lookup(
    system: &str,
    angle: f64,
    area: Option<f64>,
    aspect: Option<f64>,
    spacing: Option<f64>,
    width: Option<f64>,
    wavelength: Option<f64>,
) -> PyResult<String> {
    let names = System::ALL.iter().map(|system| system.name()).collect::<Vec<_>>().join(", ");
    let wrong = |found: &str| error(&format!("system: found {found:?}; allowed: {names}"), Some("system"));
    let system = System::named(system).ok_or_else(|| wrong(system))?;
    let wanted = match (area, aspect, width) {
        (Some(area), Some(aspect), None) => Attributes::Spots(Spots { area, aspect, angle, spacing }),
        (None, None, Some(width)) => Attributes::Stripes(Stripes { width, angle, wavelength }),
        _ => return Err(error("found other attributes; allowed: area and aspect of spots, or width of stripes", None)),
    };
    let looked = LookedUp::new(Training::built_in(), system, &wanted).map_err(|why| error(&with_causes(&why), None))?;
    let answer = looked.predict();
    let named = |attributes: &Attributes| -> Map<String, Value> {
        attributes.listed().into_iter().map(|(key, value)| (key.name().to_owned(), json!(value))).collect()
    };
    let mut parameters: Map<String, Value> =
        answer.parameters.named().into_iter().map(|(key, value)| (key.to_owned(), json!(value))).collect();
    parameters.insert("cell".to_owned(), json!(looked.cell));
    let object = json!({"system": system.name(), "asked": named(&wanted), "parameters": parameters,
        "predicted": named(&answer.predicted), "coverage": answer.coverage.to_string(),
        "nearest": named(&answer.nearest)});
    Ok(object.to_string())
}
