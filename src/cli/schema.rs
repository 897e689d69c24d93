//! `dapple schema`: the JSON Schema of documents.

use super::{Error, print};
use crate::document;

/// Prints the schema.
///
/// # Errors
/// Stdout is closed or full.
pub fn run() -> Result<(), Error> {
    print(&document::schema())
}
