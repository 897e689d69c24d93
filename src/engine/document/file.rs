//! The bytes of `.dapple` files.

use crate::document::node::Node;
use crate::document::{Document, DocumentError, limits, migrate, reader, syntax, writer};
use crate::photo::foreign;

impl Document {
    /// Reads the bytes of a file; errors call it `source_name`.
    ///
    /// # Errors
    /// They are more than a document may have, or not a valid document.
    pub fn from_bytes(bytes: &[u8], source_name: &str) -> Result<Self, DocumentError> {
        if bytes.len() as u64 > limits::MAX_FILE {
            return Err(DocumentError::TooLarge { file: source_name.to_owned(), limit: limits::MAX_FILE });
        }
        if let Some(found) = foreign(bytes).filter(|found| !bytes.is_empty() && !found.is_text()) {
            return Err(DocumentError::Foreign { file: source_name.to_owned(), found });
        }
        let text = syntax::text(bytes).map_err(|problem| problem.in_file(source_name))?;
        Self::parse(text, source_name)
    }

    /// Parses the text of a file; errors call it `source_name`.
    ///
    /// ```
    /// use dapple_engine::document::Document;
    ///
    /// let text = r#"{"format": "dapple", "version": 2, "size": [96, 96], "layers": [
    ///     {"strokes": [{"kind": "ellipse", "center": [30, 30], "radii": [8, 5], "angle": 30}]}]}"#;
    /// let document = Document::parse(text, "spots.dapple")?;
    /// assert_eq!(document.size, [96, 96]);
    /// assert_eq!(Document::parse(&document.to_json(), "written")?, document);
    /// # Ok::<(), dapple_engine::document::DocumentError>(())
    /// ```
    ///
    /// # Errors
    /// The text is not a valid document.
    pub fn parse(text: &str, source_name: &str) -> Result<Self, DocumentError> {
        let value = syntax::json(text).map_err(|problem| problem.in_file(source_name))?;
        let value = migrate::to_newest(value, source_name)?;
        reader::document(&Node::root(&value)).map_err(|problem| problem.in_file(source_name))
    }

    /// The text of its file: complete, easy to read, and the same for equal documents.
    #[must_use]
    pub fn to_json(&self) -> String {
        writer::text(&writer::value(self))
    }

    /// Checks a document that was put together in code by the rules for files; a NaN is reported as `null`.
    ///
    /// ```
    /// use dapple_engine::document::{Document, Layer, Stroke};
    ///
    /// let flat = Document::new([96, 96]).with_layer(Layer::new([Stroke::ellipse([30.0, 30.0], [8.0, 0.0], 0.0)]));
    /// let error = flat.check("sketch").unwrap_err().to_string();
    /// assert!(error.contains("layers[0].strokes[0]"), "{error}");
    /// ```
    ///
    /// # Errors
    /// The first value that a file may not hold; the error calls the document `source_name`.
    pub fn check(&self, source_name: &str) -> Result<(), DocumentError> {
        let value = writer::value(self);
        reader::document(&Node::root(&value)).map(drop).map_err(|problem| problem.in_file(source_name))
    }
}
