//! A grown texture.

use crate::arrays::shaped;
use crate::errors::{Failure, error};
use crate::watched::watched;
use dapple::document::{Document, with_causes};
use dapple::engine::export::material::{Set, name};
use dapple::engine::export::maps::Surface;
use dapple::engine::document::embedded::MAX_SCALE;
use dapple::engine::export::has_ending;
use dapple::engine::export::outline::FORMATS;
use dapple::engine::synth::render::painting::{Channel, Making, Painting, usual_relief};
use dapple::{SaveTexture, files};
use dapple::files::SavePicture;
use pyo3::prelude::*;
use std::path::PathBuf;

/// A grown texture.
#[pyclass(frozen, module = "dapple")]
pub struct Grown(dapple::Grown);

impl From<dapple::Grown> for Grown {
    fn from(grown: dapple::Grown) -> Self {
        Self(grown)
    }
}

impl Grown {
    fn painting(&self, scale: u32) -> Painting<'_> {
        Painting::new(&self.0.document, &self.0, scale as usize)
    }

    /// Width and height of the canvas, px.
    fn sides(&self) -> [usize; 2] {
        self.0.size.map(|side| side as usize)
    }
}

#[pymethods]
impl Grown {
    #[getter]
    fn size(&self) -> (u32, u32) {
        (self.0.size[0], self.0.size[1])
    }

    #[getter]
    fn rgb<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let [width, height] = self.sides();
        let rgb = py.detach(|| self.painting(1).rgb());
        shaped(py, rgb, [height, width, 3])
    }

    #[getter]
    fn rgba<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let [width, height] = self.sides();
        let rgba = py.detach(|| self.painting(1).rgba());
        shaped(py, rgba, [height, width, 4])
    }

    #[getter]
    fn pattern<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.values(py, None)
    }

    fn layer_pattern<'py>(&self, py: Python<'py>, layer: usize) -> PyResult<Bound<'py, PyAny>> {
        let layers = self.0.layers.len();
        if layer >= layers {
            let message = format!("layer: found {layer}; allowed: 0 to {}", layers.saturating_sub(1));
            return Err(error(&message, Some("layer")));
        }
        self.values(py, Some(layer))
    }

    #[getter]
    fn labels<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let [width, height] = self.sides();
        let labels = py.detach(|| {
            let mut labels = vec![0; width * height];
            self.painting(1).band(0..height).labels(&mut labels);
            labels
        });
        shaped(py, labels, [height, width])
    }

    #[getter]
    fn mask<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let [width, height] = self.sides();
        let mask = py.detach(|| self.painting(1).mask());
        shaped(py, mask, [height, width])
    }

    /// The report, as JSON text.
    fn report_text(&self, py: Python<'_>) -> PyResult<String> {
        py.detach(|| serde_json::to_string(&self.0.report())).map_err(|why| error(&why.to_string(), None))
    }

    /// The document, as JSON text.
    fn document_text(&self) -> String {
        self.0.document.to_json()
    }

    #[pyo3(signature = (path, scale=1))]
    fn save(&self, py: Python<'_>, path: PathBuf, scale: u32) -> PyResult<()> {
        let saved = watched(py, None, |watch| {
            if FORMATS.iter().any(|ending| has_ending(&path, ending)) {
                return self.0.save_scaled(&path, scale);
            }
            let scale = scale.clamp(1, MAX_SCALE);
            self.painting(scale).prepare(&path, Channel::Texture, &self.0.style(scale), watch)?.keep()
        })?;
        saved.map_err(|why| error(&with_causes(&why), None))
    }

    /// The outlines of the marks as SVG, in mm by the document's dpi.
    #[pyo3(signature = (scale=1))]
    fn outlines(&self, py: Python<'_>, scale: u32) -> PyResult<String> {
        let drawn = py.detach(|| {
            let mut out = Vec::new();
            let written = self.0.write_outlines(&mut out, false, scale);
            written.map(|()| String::from_utf8_lossy(&out).into_owned()).map_err(|why| why.to_string())
        });
        drawn.map_err(|why| error(&why, None))
    }

    #[pyo3(signature = (folder, name="dapple", relief=None, scale=1))]
    fn material(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        name: &str,
        relief: Option<f64>,
        scale: u32,
    ) -> PyResult<()> {
        let named = name_of(name);
        let made = watched(py, None, |watch| {
            let painting = self.painting(scale);
            let style = self.0.style(scale);
            let set = Set {
                name: &named,
                size: painting.size,
                deep: style.deep,
                transparent: !painting.is_opaque(),
                anisotropic: painting.is_anisotropic(),
                dpi: Some(style.dpi),
            };
            let making = Making {
                surface: surface(&self.0.document, relief),
                scale: scale as usize,
                edges: self.0.document.edges,
                transparent_ground: false,
            };
            let wrong = |why: dapple::ExportError| Failure::Other(with_causes(&why));
            files::make_folder(&folder).map_err(wrong)?;
            let files = painting.prepare_material(&folder, &set, &making, watch).map_err(wrong)?;
            dapple::files::keep_all(files).map_err(wrong)
        })?;
        made.map_err(PyErr::from)
    }
}

fn name_of(text: &str) -> String {
    name(text)
}

/// Marks of this relief, px; by default that of the finish.
pub fn surface(document: &Document, relief: Option<f64>) -> Surface {
    let relief = relief.map_or_else(|| usual_relief(document), |relief| vec![relief]);
    Surface { relief, ..Surface::default() }
}

impl Grown {
    fn values<'py>(&self, py: Python<'py>, layer: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        let [width, height] = self.sides();
        let values = py.detach(|| {
            let mut values = vec![0.0_f32; width * height];
            self.painting(1).band(0..height).values(layer, &mut values);
            values
        });
        shaped(py, values, [height, width])
    }
}
