//! `dapple._dapple`: the engine of dapple for Python. The package `dapple` beside it gives it names, defaults and documentation.
//!
//! Documents come as JSON text, so that there is one reader and one set of messages. Arrays are moved to NumPy, not copied.

mod arrays;
mod errors;
mod grown;
mod items;
mod model;
mod pictures;
mod watched;

use pyo3::prelude::*;

#[pymodule]
mod _dapple {
    use super::*;
    use dapple::document::Document;
    use dapple::engine::synth::check::check as check_growth;
    use dapple::{Growth, Options, ReadFile, free_memory};
    use errors::{Failure, document_error, grow_error};
    use std::path::PathBuf;

    #[pymodule_export]
    use errors::Error;
    #[pymodule_export]
    use grown::Grown;
    #[pymodule_export]
    use items::{Item, item};
    #[pymodule_export]
    use model::{GrownModel, grow_model};
    #[pymodule_export]
    use pictures::{lookup, measure, photo};

    /// The text of the document in a file: a `.dapple` file, or a PNG that dapple wrote.
    #[pyfunction]
    fn read(path: PathBuf) -> PyResult<String> {
        let (document, _) = dapple::files::open(&path).map_err(document_error)?;
        Ok(document.to_json())
    }

    /// The text of a document as dapple writes it; an error names what is wrong in it.
    #[pyfunction]
    fn formatted(text: &str, source: &str) -> PyResult<String> {
        Ok(Document::parse(text, source).map_err(document_error)?.to_json())
    }

    /// The JSON Schema of documents.
    #[pyfunction]
    fn schema() -> String {
        dapple::document::schema()
    }

    /// What is known of a document before it grows, one text a layer; an error says why it cannot be grown.
    #[pyfunction]
    fn check(py: Python<'_>, text: &str, source: &str) -> PyResult<Vec<Vec<String>>> {
        let document = Document::parse(text, source).map_err(document_error)?;
        let source = source.to_owned();
        let checked = watched::abandoned(py, None, move |watch| {
            let options = Options { source: &source, memory: Some(free_memory()), watch: *watch, ..Options::default() };
            let checked = check_growth(&document, &options).map_err(Failure::Growth)?;
            let notes = checked.layers.into_iter().map(|layer| layer.notes).collect();
            checked.refusal.map_or(Ok(notes), |refusal| Err(Failure::Growth(refusal)))
        })?;
        checked.map_err(PyErr::from)
    }

    /// Grows a document; `beside` is the path of its file, where it has one.
    #[pyfunction]
    #[pyo3(signature = (text, source, beside=None, size=None, seed=None, threads=None, progress=None))]
    fn grow(
        py: Python<'_>,
        text: &str,
        source: &str,
        beside: Option<PathBuf>,
        size: Option<[u32; 2]>,
        seed: Option<u64>,
        threads: Option<usize>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Grown> {
        // From its file, pictures of heights beside it are read, too.
        let read = match beside {
            Some(path) => Document::read(path),
            None => Document::parse(text, source),
        };
        let document = read.map_err(document_error)?;
        let document = Document { seed: seed.unwrap_or(document.seed), ..document };
        if document.model.is_some() {
            let wrong = "found a document with a model; allowed: one without, or grow_on_model";
            return Err(errors::error(&format!("{source}: model: {wrong}"), Some("model")));
        }
        let source = source.to_owned();
        let grown = watched::abandoned(py, progress, move |watch| {
            let source = source.as_str();
            let options =
                Options { size, source, memory: Some(free_memory()), watch: *watch, ..Options::default() };
            let grow = || Growth::begin(&document, &options, None).run();
            dapple::machine::threads::with(threads, grow).map_err(Failure::Growth)
        })?;
        grown.map(Grown::from).map_err(grow_error)
    }
}
