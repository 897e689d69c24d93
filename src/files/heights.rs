//! Pictures of heights in files.

use std::io::BufReader;
use std::path::Path;
use std::sync::Arc;

use crate::document::{Document, ParametricSurface};
use crate::machine::fs::File;
use crate::photo::{decode_stored, heights};

/// Reads the heights that a document in the file `document` names. Where that fails, the document keeps the reason,
/// which is reported when the document is grown.
pub fn read_heights(document: &mut Document, file: &Path) {
    let Some(ParametricSurface::Heights(relief)) = &mut document.parametric else { return };
    let path = file.parent().unwrap_or(Path::new("")).join(&relief.path);
    let shown = path.display();
    relief.heights = (|| {
        let opened = File::open(&path).map_err(|error| format!("{shown}, which cannot be read ({error})"))?;
        let decoded = decode_stored(&mut BufReader::new(opened))
            .map_err(|error| format!("{shown}, which cannot be read as a picture ({error})"))?;
        if let Some(note) = decoded.notes.first() {
            return Err(format!(
                "{shown}, whose heights would be changed by reading it ({note}): save it as 16-bit gray"
            ));
        }
        let found =
            heights(&decoded).ok_or_else(|| format!("{shown}, some of whose heights are not numbers"))?;
        Ok(Arc::new(found))
    })();
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Relief;
    use crate::grid::Edges;
    use image::{ImageBuffer, Luma};

    #[test]
    fn heights_of_low_contrast_are_not_stretched() {
        let folder = tempfile::tempdir().unwrap();
        let low: ImageBuffer<Luma<u16>, Vec<u16>> = ImageBuffer::from_fn(64, 2, |x, _| Luma([20 * x as u16]));
        low.save(folder.path().join("low.png")).unwrap();
        let surface = ParametricSurface::Heights(Relief::new("low.png".to_owned(), 100.0));
        let mut document = Document { parametric: Some(surface), ..Document::default() };
        read_heights(&mut document, &folder.path().join("a.dapple"));
        let heights = document.parametric.as_ref().and_then(ParametricSurface::relief).expect("heights");
        let [rise, _] = heights.heights().expect("a picture").rise([9, 0], Edges::Closed);
        assert!((rise - 20.0 / 65_535.0).abs() < 1e-7, "{rise}");
    }
}
