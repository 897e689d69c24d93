//! Growing on a model.

use crate::grown::surface;
use crate::errors::{Failure, document_error, error};
use crate::watched::{abandoned, watched};
use dapple::document::{BodySource, Document, with_causes};
use dapple::engine::export::has_ending;
use dapple::engine::export::material::name;
use dapple::engine::synth::body::{BodyGrowth, GrownBody};
use dapple::files::{self, Prepared, TexturedBody, keep_all, read_model};
use dapple::{ExportError, Options, ReadFile, Watch, free_memory};
use pyo3::prelude::*;
use std::path::{Path, PathBuf};

/// Endings of the files that `save` writes.
const ENDINGS: &str = ".glb, .obj or .ply";

/// What has grown on a model.
#[pyclass(frozen, module = "dapple")]
pub struct GrownModel {
    grown: GrownBody,
    source: String,
}

/// Grows a document that has a model; `beside` is the path of its file, where it has one, and `model` another file of the model.
#[pyfunction]
#[pyo3(signature = (text, source, beside=None, model=None, seed=None, threads=None, progress=None))]
pub fn grow_model(
    py: Python<'_>,
    text: &str,
    source: &str,
    beside: Option<PathBuf>,
    model: Option<PathBuf>,
    seed: Option<u64>,
    threads: Option<usize>,
    progress: Option<Py<PyAny>>,
) -> PyResult<GrownModel> {
    let read = match &beside {
        Some(path) => Document::read(path),
        None => Document::parse(text, source),
    };
    let mut document = read.map_err(document_error)?;
    document.seed = seed.unwrap_or(document.seed);
    let Some(body) = &mut document.model else {
        let allowed = "a document with one, such as {\"model\": {\"file\": \"torus\"}}; grow grows the others";
        return Err(error(&format!("{source}: model: found none; allowed: {allowed}"), Some("model")));
    };
    let file = read_model(beside.as_deref().unwrap_or(Path::new("")), body, model.as_deref());
    let file = file.map_err(document_error)?;
    if let Some(path) = &model {
        body.source = BodySource::File { path: path.display().to_string(), sha256: None };
    }
    let named = source.to_owned();
    let grown = abandoned(py, progress, move |watch| {
        let options = Options { source: &named, memory: Some(free_memory()), watch: *watch, ..Options::default() };
        let bytes = file.as_ref().map(|file| file.bytes.as_slice());
        let grow = || {
            let growth = BodyGrowth::begin(&document, bytes, &options).map_err(dapple::GrowError::from)?;
            growth.run()
        };
        dapple::machine::threads::with(threads, grow).map_err(Failure::Growth)
    })?;
    Ok(GrownModel { grown: grown?, source: source.to_owned() })
}

#[pymethods]
impl GrownModel {
    /// The report, as JSON text.
    fn report_text(&self, py: Python<'_>) -> PyResult<String> {
        let text = py.detach(|| serde_json::to_string(&self.grown.report(&self.source, 0.0)));
        text.map_err(|why| error(&why.to_string(), None))
    }

    /// Why a texture cannot be on the texture coordinates of the model's file; `None` if it can.
    fn unfit(&self, py: Python<'_>) -> Option<String> {
        py.detach(|| self.grown.own_atlas().err().map(|unfit| unfit.to_string()))
    }

    #[pyo3(signature = (path, size=None, relief=None))]
    fn save(&self, py: Python<'_>, path: PathBuf, size: Option<[u32; 2]>, relief: Option<f64>) -> PyResult<()> {
        self.written(py, |watch| {
            if has_ending(&path, "ply") {
                Ok(vec![files::prepare(&path, |out| self.grown.write_ply(out)).map_err(words)?])
            } else if has_ending(&path, "obj") {
                self.textured(size, relief)?.prepare_obj(&path, watch).map_err(words)
            } else if has_ending(&path, "glb") {
                // A model without texture coordinates has colours by vertex, which are too coarse for a finish.
                let is_textured = self.grown.document.finish.is_some() || self.grown.own_atlas().is_ok();
                let file = match is_textured {
                    true => self.textured(size, relief)?.prepare_glb(&path, watch),
                    false => files::prepare(&path, |out| self.grown.write_glb(out)),
                };
                Ok(vec![file.map_err(words)?])
            } else {
                Err(Failure::Other(format!("path: found {}; allowed: {ENDINGS}", path.display())))
            }
        })
    }

    #[pyo3(signature = (folder, name="dapple", size=None, relief=None))]
    fn material(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        name: &str,
        size: Option<[u32; 2]>,
        relief: Option<f64>,
    ) -> PyResult<()> {
        let named = valid(name);
        self.written(py, |watch| {
            self.textured(size, relief)?.prepare_material(&folder, &named, watch).map_err(words)
        })
    }
}

fn valid(text: &str) -> String {
    name(text)
}

fn words(why: ExportError) -> Failure {
    Failure::Other(with_causes(&why))
}

impl GrownModel {
    /// The model with its texture, on automatic coordinates where those of its file are unfit.
    fn textured(&self, size: Option<[u32; 2]>, relief: Option<f64>) -> Result<TexturedBody<'_>, Failure> {
        let laid = self.grown.lay_out().map_err(|why| Failure::Other(why.to_string()))?;
        Ok(TexturedBody {
            grown: &self.grown,
            atlas: laid.atlas,
            surface: surface(&self.grown.document, relief),
            size: size.unwrap_or(TexturedBody::SIZE).map(|side| side as usize),
            deep: false,
        })
    }

    /// Makes files and keeps them: all or none.
    fn written(
        &self,
        py: Python<'_>,
        make: impl FnOnce(&Watch) -> Result<Vec<Prepared>, Failure> + Send,
    ) -> PyResult<()> {
        let made = watched(py, None, |watch| make(watch).and_then(|made| keep_all(made).map_err(words)))?;
        made.map_err(PyErr::from)
    }
}
