//! JSON of the table → a document that can be grown.

use dapple::document::Document;
use dapple_engine::document::ParametricSurface;
use serde_json::Value;

use super::pictures::heights;

/// The document of this JSON, with the heights that it names.
pub fn parsed(json: &Value, name: &str) -> Result<Document, String> {
    let mut document = Document::parse(&json.to_string(), name).map_err(|error| error.to_string())?;
    if let Some(ParametricSurface::Heights(relief)) = &mut document.parametric {
        relief.heights = heights(&relief.path).ok_or_else(|| format!("there is no picture {}", relief.path));
    }
    Ok(document)
}
