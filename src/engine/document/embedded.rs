//! The document inside a picture that was grown from it.
//!
//! A PNG holds two texts (iTXt): under `dapple` the document as its file would hold it, with the seed that was used, and
//! under `dapple-grown`, where they are not the document's, the size of the canvas and the scale:
//! `{"size": [1024, 512], "scale": 2}`.

use crate::document::node::visible;
use crate::document::{Document, DocumentError, Problem, limits};
use crate::export::png_text;
use serde_json::{Value, json};
use std::io::{BufRead, Read, Seek};

/// The key of the document.
const DOCUMENT: &str = "dapple";
/// The key of the size and the scale, which the document does not hold.
const GROWN: &str = "dapple-grown";
/// The largest scale that a picture has.
pub const MAX_SCALE: u32 = 64;

/// Size of the canvas and scale of a grown picture, as far as its document does not hold them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// The canvas, px, where it is not the document's.
    pub size: Option<[u32; 2]>,
    /// px of the picture along each px of the canvas.
    pub scale: u32,
}

impl Default for Extent {
    fn default() -> Self {
        Self { size: None, scale: 1 }
    }
}

/// The texts that restore `document` from its picture.
#[must_use]
pub fn embedded(document: &Document, extent: Extent) -> Vec<(&'static str, String)> {
    let mut texts = vec![(DOCUMENT, document.to_json())];
    let size = extent.size.filter(|size| *size != document.size);
    if size.is_some() || extent.scale != 1 {
        let size = size.unwrap_or(document.size);
        texts.push((GROWN, json!({"size": size, "scale": extent.scale}).to_string()));
    }
    texts
}

/// The document in a picture that is read from a stream; `None` if it is not a PNG, or a PNG without a document, such as a photo.
/// Messages call it `file`.
///
/// # Errors
/// The stream cannot be read, the PNG is damaged, or its document is not valid.
pub fn in_stream(
    mut stream: impl BufRead + Seek,
    file: &str,
) -> Result<Option<(Document, Extent)>, DocumentError> {
    let unreadable = |source| DocumentError::Unreadable { file: file.to_owned(), source };
    let mut first = Vec::new();
    stream.by_ref().take(png_text::SIGNATURE.len() as u64).read_to_end(&mut first).map_err(unreadable)?;
    if first != png_text::SIGNATURE {
        return Ok(None);
    }
    let mut text = |key| {
        stream.rewind().map_err(unreadable)?;
        let found = png_text::read(&mut stream, key, limits::MAX_FILE);
        found.map_err(|source| DocumentError::Damaged { file: file.to_owned(), source })
    };
    let Some(document) = text(DOCUMENT)? else { return Ok(None) };
    let document = Document::parse(&document, &format!("{file} (its document)"))?;
    let extent = text(GROWN)?.map_or(Ok(Extent::default()), |text| extent(&text));
    Ok(Some((document, extent.map_err(|problem| problem.in_file(file))?)))
}

fn extent(text: &str) -> Result<Extent, Problem> {
    let problem = || {
        let allowed = format!("sides of 1 to {} px, a scale of 1 to {MAX_SCALE}", limits::MAX_SIDE);
        Problem::new(GROWN, visible(text, 80), allowed)
    };
    let value: Value = serde_json::from_str(text).map_err(|_| problem())?;
    let number = |value: &Value, most: u32| {
        let number = value.as_u64().and_then(|number| u32::try_from(number).ok());
        number.filter(|number| (1..=most).contains(number)).ok_or_else(problem)
    };
    let side = |axis: usize| number(&value["size"][axis], limits::MAX_SIDE);
    Ok(Extent { size: Some([side(0)?, side(1)?]), scale: number(&value["scale"], MAX_SCALE)? })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::png::{Header, Samples, write};
    use std::io::Cursor;

    /// Found by fuzzing: the text in the picture was quoted unescaped.
    #[test]
    fn a_quoted_size_of_a_picture_is_escaped() {
        let document = r#"{"format": "dapple", "version": 1, "size": [64, 64], "layers": [{"strokes": [
            {"kind": "ellipse", "center": [32, 32], "radii": [6, 6]}]}]}"#;
        let texts = [(DOCUMENT, document.to_owned()), (GROWN, "{\u{1b}[2J\r\n".to_owned())];
        let mut png = Vec::new();
        write(&mut png, Header { texts: &texts, ..Header::new([1, 1], Samples::Gray8) }, |_, _| Ok(()))
            .unwrap();
        let message = in_stream(Cursor::new(png), "a.png").unwrap_err().to_string();
        assert!(message.starts_with("a.png: dapple-grown: found {"), "{message}");
        assert!(!message.contains(char::is_control), "{message:?}");
    }
}
