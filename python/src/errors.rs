//! Errors of the engine as exceptions: `dapple.Error` with `place`, `found` and `allowed` where they are known.

use dapple::document::with_causes;
use dapple::{DocumentError, GrowError};
use pyo3::create_exception;
use pyo3::exceptions::{PyException, PyKeyboardInterrupt};
use pyo3::prelude::*;

create_exception!(dapple, Error, PyException, "What cannot be done, with the place, what was found and what is allowed.");

/// Why work on another thread has failed.
pub enum Failure {
    /// A document does not grow.
    Growth(GrowError),
    /// Anything else, in words.
    Other(String),
}

impl From<Failure> for PyErr {
    fn from(failure: Failure) -> Self {
        grow_error(failure)
    }
}

/// An exception with this message.
pub fn error(message: &str, place: Option<&str>) -> PyErr {
    with(message.to_owned(), [place.map(str::to_owned), None, None])
}

fn with(message: String, [place, found, allowed]: [Option<String>; 3]) -> PyErr {
    Python::attach(|py| {
        let raised = Error::new_err(message);
        let value = raised.value(py);
        for (name, text) in [("place", place), ("found", found), ("allowed", allowed)] {
            if let Err(error) = value.setattr(name, text) {
                return error;
            }
        }
        raised
    })
}

/// The exception of a document that cannot be read.
pub fn document_error(error: DocumentError) -> PyErr {
    let parts = match &error {
        DocumentError::Content { problem, .. } => {
            [&problem.place, &problem.found, &problem.allowed].map(|text| Some(text.clone()))
        }
        _ => [None, None, None],
    };
    with(with_causes(&error), parts)
}

/// The exception of a growth that has failed.
pub fn grow_error(failure: Failure) -> PyErr {
    match failure {
        Failure::Growth(GrowError::Cancelled(_)) => PyKeyboardInterrupt::new_err(()),
        Failure::Growth(GrowError::Document(error)) => document_error(error),
        Failure::Growth(error) => with(with_causes(&error), [None, None, None]),
        Failure::Other(message) => with(message, [None, None, None]),
    }
}
